#include "core/engine/spacing/parts/automatic/chain_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace forefront {

namespace {

/// Follows chains from segment to segment.
class Chains {
  public:
    Chains(const Domain &domain, std::span<const PlacedSegment> segments)
        : domain_(domain), segments_(segments), at_(domain.nodes.size(), {kNoIndex, kNoIndex}),
          count_(domain.nodes.size(), 0), places_(segments.size()) {
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            if (segments[i].index < domain.segments.size()) {
                for (const std::uint32_t node : {ends(i).a, ends(i).b}) {
                    if (count_[node] < 2) {
                        at_[node][count_[node]] = i;
                    }
                    ++count_[node];
                }
            }
        }
    }

    std::vector<ChainPlace> run() {
        std::uint32_t chains = 0;
        for (std::uint32_t i = 0; i < segments_.size(); ++i) {
            if (segments_[i].index < domain_.segments.size() && places_[i].chain == kNoIndex) {
                place(chains++, i);
            }
        }
        return std::move(places_);
    }

  private:
    const DomainSegment &ends(std::uint32_t i) const { return domain_.segments[segments_[i].index]; }
    std::uint32_t otherEnd(std::uint32_t i, std::uint32_t node) const {
        return ends(i).a == node ? ends(i).b : ends(i).a;
    }
    /// Returns the segment that continues another one beyond a node; kNoIndex if the chain ends there.
    std::uint32_t beyond(std::uint32_t i, std::uint32_t node) const {
        return count_[node] != 2 ? kNoIndex : at_[node][0] == i ? at_[node][1] : at_[node][0];
    }

    /// Places the segments of the chain through one of them.
    void place(std::uint32_t chain, std::uint32_t through) {
        std::uint32_t first = through, node = ends(through).a; // back to the beginning
        for (std::uint32_t next = beyond(first, node); next != kNoIndex && next != through;
             next = beyond(first, node)) {
            first = next;
            node = otherEnd(first, node);
        }
        const bool closed = beyond(first, node) != kNoIndex;
        const std::uint32_t begin = node;
        std::vector<std::uint32_t> members;
        double length = 0.0;
        for (std::uint32_t i = first; i != kNoIndex && places_[i].chain == kNoIndex; i = beyond(i, node)) {
            places_[i] = {chain, length, 0.0, ends(i).a == node, 0.0, kNoIndex, kNoIndex};
            members.push_back(i);
            length += segments_[i].length();
            node = otherEnd(i, node);
        }
        for (const std::uint32_t i : members) {
            places_[i].loop = closed ? length : 0.0;
            places_[i].length = length;
            if (!closed) {
                places_[i].first = begin;
                places_[i].last = node;
            }
        }
    }

    const Domain &domain_;
    std::span<const PlacedSegment> segments_;
    std::vector<std::array<std::uint32_t, 2>> at_; ///< per node: the first two segments there
    std::vector<std::uint32_t> count_;             ///< per node: number of segments there
    std::vector<ChainPlace> places_;
};

} // namespace

std::vector<ChainPlace> chainPlaces(const Domain &domain, std::span<const PlacedSegment> segments) {
    return Chains(domain, segments).run();
}

double distanceAlong(const ChainPlace &first, double from, double to) {
    const double way = std::fabs(to - from);
    return first.loop > 0.0 ? std::min(way, first.loop - way) : way;
}

} // namespace forefront
