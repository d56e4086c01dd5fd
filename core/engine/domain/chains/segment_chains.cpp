#include "core/engine/domain/chains/segment_chains.hpp"

#include "core/engine/base/ids.hpp"

namespace forefront {
namespace {

class SegmentChainer {
  public:
    SegmentChainer(const Domain &domain, SegmentRole role) : domain_(domain), role_(role) {
        starts_.assign(domain.nodes.size() + 1, 0);
        for (const DomainSegment &segment : domain.segments) {
            if (takes(segment)) {
                ++starts_[segment.a + 1];
                ++starts_[segment.b + 1];
            }
        }
        for (std::size_t k = 1; k < starts_.size(); ++k) {
            starts_[k] += starts_[k - 1];
        }
        around_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            if (takes(domain.segments[s])) {
                around_[next[domain.segments[s].a]++] = s;
                around_[next[domain.segments[s].b]++] = s;
            }
        }
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
    std::uint32_t degree(std::uint32_t node) const { return starts_[node + 1] - starts_[node]; }

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
                for (std::uint32_t k = starts_[at]; k < starts_[at + 1]; ++k) {
                    if (!used_[around_[k]]) {
                        segment = around_[k];
                        break;
                    }
                }
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
    std::vector<std::uint32_t> starts_; ///< per node, into around_
    std::vector<std::uint32_t> around_; ///< segments by node
    std::vector<bool> used_;
};

} // namespace

std::vector<SegmentChain> segmentChains(const Domain &domain, SegmentRole role) {
    return SegmentChainer(domain, role).chains();
}

} // namespace forefront
