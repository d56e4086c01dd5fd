#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Consecutive segments of a domain: from `first` to before `end`.
struct SegmentRun {
    std::uint32_t first = 0, end = 0;
};

/// A line or a part of a curve that two closed shapes have both drawn.
struct NeighbourSide {
    SegmentRun kept, dropped;
    bool within = false; ///< the areas of two boundaries lie on its two sides, so that it is a line within the domain
};

/// Returns the sides that closed shapes have in common, from node to node, where one line does for both: two boundaries
/// with their areas on opposite sides; outlines of regions, beside or within each other; and the outline of a region
/// along a boundary, which stays. What two boundaries trace on one side of both, or more than two, is left out. Curves
/// are the same within `tolerance`.
///
/// `loops`: the segments of each closed shape, in order; each has one role. In the order of the dropped segments.
std::vector<NeighbourSide> neighbourSides(const Domain &domain, std::span<const SegmentRun> loops, double tolerance);

/// Returns the divided segments, by their indices in `given`, of which a part joins the same nodes as another segment
/// although neighbourSides() does not make them one. `given`: see DividedSegments.
std::vector<std::uint32_t> drawnTwice(const Domain &domain, std::span<const SegmentRun> loops,
                                      std::span<const std::uint32_t> given, double tolerance);

} // namespace forefront
