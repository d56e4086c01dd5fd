#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Where a segment lies along the chain of segments that it belongs to. Chains pass through the nodes at which exactly
/// two segments meet.
struct ChainPlace {
    std::uint32_t chain = kNoIndex;
    double start = 0.0;             ///< distance from the beginning of the chain
    double loop = 0.0;              ///< length of the chain if it is closed; else 0
    bool along = true;              ///< the segment runs in the direction of the chain
    double length = 0.0;            ///< of the chain
    std::uint32_t first = kNoIndex; ///< node at which an open chain begins
    std::uint32_t last = kNoIndex;  ///< node at which it ends

    /// Returns the distance of a place on the segment from the beginning of the chain.
    double at(const PlacedSegment &segment, Vec2 p) const { return start + distance(along ? segment.a : segment.b, p); }
    /// Returns the direction of the chain along the segment, as long as the segment.
    Vec2 direction(const PlacedSegment &segment) const { return along ? segment.b - segment.a : segment.a - segment.b; }
};

/// A way from one place to another along chains, and the directions in which it leaves the one and reaches the other.
struct ChainWay {
    double length = 0.0;
    Vec2 from, to; ///< as long as the segments
};

/// Returns the places of segments. Those whose index is not one of Domain::segments, lone points, belong to no chain.
std::vector<ChainPlace> chainPlaces(const Domain &domain, std::span<const PlacedSegment> segments);

/// Returns the distance between two places along a chain, the shorter way around a closed one.
double distanceAlong(const ChainPlace &first, double from, double to);

/// Calls visit(way) for the ways between two places on segments: along their common chain, and through each node at
/// which both of their chains end.
template <class Visit>
void forEachWay(const ChainPlace &own, const PlacedSegment &segment, Vec2 p, const ChainPlace &far,
                const PlacedSegment &wall, Vec2 q, const Visit &visit) {
    const double from = own.at(segment, p), to = far.at(wall, q);
    const Vec2 u = own.direction(segment), v = far.direction(wall);
    if (own.chain == far.chain && own.chain != kNoIndex) {
        visit(ChainWay{distanceAlong(own, from, to), u, v});
    }
    for (const bool ownLast : {false, true}) {
        for (const bool farLast : {false, true}) {
            const std::uint32_t node = ownLast ? own.last : own.first;
            if (node != kNoIndex && node == (farLast ? far.last : far.first)) {
                visit(ChainWay{(ownLast ? own.length - from : from) + (farLast ? far.length - to : to),
                               ownLast ? u : -1.0 * u, farLast ? -1.0 * v : v});
            }
        }
    }
}

} // namespace forefront
