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
    double start = 0.0; ///< distance from the beginning of the chain
    double loop = 0.0;  ///< length of the chain if it is closed; else 0
    bool along = true;  ///< the segment runs in the direction of the chain

    /// Returns the distance of a place on the segment from the beginning of the chain.
    double at(const PlacedSegment &segment, Vec2 p) const { return start + distance(along ? segment.a : segment.b, p); }
    /// Returns the direction of the chain along the segment, as long as the segment.
    Vec2 direction(const PlacedSegment &segment) const { return along ? segment.b - segment.a : segment.a - segment.b; }
};

/// Returns the places of segments. Those whose index is not one of Domain::segments, lone points, belong to no chain.
std::vector<ChainPlace> chainPlaces(const Domain &domain, std::span<const PlacedSegment> segments);

/// Returns the distance between two places along a chain, the shorter way around a closed one.
double distanceAlong(const ChainPlace &first, double from, double to);

} // namespace forefront
