#pragma once

#include "core/geometry/plane_sweep.hpp"
#include "core/geometry/predicates.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Two edges, first < second, that meet in another way than in a common end.
struct EdgeMeeting {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    SegmentMeeting kind = SegmentMeeting::Crossing; ///< Crossing, Touching or Overlapping
};

struct EdgeMeetings {
    std::vector<EdgeMeeting> list; ///< by (first, second)
    bool complete = true;          ///< false: the search was given up at the limit
};

/// All meetings of the edges in `queries` with any edge (exact). Edges without length stand for points. At most `most`
/// are listed, and no more than 2·10⁷ pairs are tested.
EdgeMeetings findMeetings(std::span<const Vec2> points, std::span<const PlaneEdge> edges,
                          std::span<const std::uint32_t> queries, std::size_t most);

/// The common point of two edges that cross, rounded.
Vec2 crossingPoint(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

} // namespace forefront
