#pragma once

#include "core/engine/geometry/plane_sweep.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Two edges, first < second, that meet other than at a common end.
struct EdgeMeeting {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    SegmentMeeting kind = SegmentMeeting::Crossing; ///< Crossing, Touching or Overlapping
};

struct EdgeMeetings {
    std::vector<EdgeMeeting> list; ///< by (first, second)
    bool complete = true;          ///< false if the search stopped at its limit
};

/// Finds all meetings of the edges in `queries` with any edge. Exact. An edge of zero length stands for a point. Stops
/// at `limit` meetings or after testing 2·10⁷ pairs.
EdgeMeetings findMeetings(std::span<const Vec2> points, std::span<const PlaneEdge> edges,
                          std::span<const std::uint32_t> queries, std::size_t limit);

/// Returns the common point of two edges that cross, rounded.
Vec2 crossingPoint(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

} // namespace forefront
