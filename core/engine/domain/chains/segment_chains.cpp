#include "core/engine/domain/chains/segment_chains.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <span>

namespace forefront {
namespace {

class SegmentChainer {
  public:
    SegmentChainer(const Domain &domain, SegmentRole role) : domain_(domain), role_(role) {
        around_ = Rows<std::uint32_t>(domain.nodes.size(), [&](const auto &add) {
            for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
                if (takes(domain.segments[s])) {
                    add(domain.segments[s].a, s);
                    add(domain.segments[s].b, s);
                }
            }
        });
        used_.assign(domain.segments.size(), false);
    }

    std::vector<SegmentChain> chains() {
        std::vector<SegmentChain> result;
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            const DomainSegment &segment = domain_.segments[s];
            if (!takes(segment)) {
                continue;
            }
            if (!used_[s] && degree(segment.a) != 2) {
                result.push_back(walk(s, segment.a));
            }
            if (!used_[s] && degree(segment.b) != 2) {
                result.push_back(walk(s, segment.b));
            }
        }
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            if (takes(domain_.segments[s]) && !used_[s]) {
                result.push_back(walk(s, domain_.segments[s].a));
            }
        }
        return result;
    }

  private:
    bool takes(const DomainSegment &segment) const {
        return segment.role == role_ && segment.a < domain_.nodes.size() && segment.b < domain_.nodes.size();
    }
    std::size_t degree(std::uint32_t node) const { return around_[node].size(); }

    SegmentChain walk(std::uint32_t segment, std::uint32_t from) {
        SegmentChain chain;
        chain.nodes.push_back(from);
        std::uint32_t at = from;
        while (segment != kNoIndex) {
            used_[segment] = true;
            const DomainSegment &s = domain_.segments[segment];
            at = s.a == at ? s.b : s.a;
            chain.segments.push_back(segment);
            chain.nodes.push_back(at);
            segment = kNoIndex;
            if (degree(at) == 2) {
                const std::span<const std::uint32_t> here = around_[at];
                const auto unused =
                    std::find_if(here.begin(), here.end(), [&](std::uint32_t other) { return !used_[other]; });
                segment = unused != here.end() ? *unused : kNoIndex;
            }
        }
        if (at == from && chain.segments.size() > 2) {
            chain.closed = true;
            chain.nodes.pop_back();
        }
        return chain;
    }

    const Domain &domain_;
    SegmentRole role_;
    Rows<std::uint32_t> around_; ///< segments by node
    std::vector<bool> used_;
};

} // namespace

std::vector<SegmentChain> segmentChains(const Domain &domain, SegmentRole role) {
    return SegmentChainer(domain, role).chains();
}

} // namespace forefront
