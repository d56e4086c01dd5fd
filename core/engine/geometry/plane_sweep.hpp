#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace forefront {

/// An undirected edge between two points.
struct PlaneEdge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

/// The result of a sweep over points and edges.
struct PlaneSweepResult {
    /// Per point: the first point with the same coordinates.
    std::vector<std::uint32_t> canonical;
    /// Canonical points by x, then y.
    std::vector<std::uint32_t> order;
    /// Per canonical point: the edge directly below it that does not end there (kNoIndex: none). A point is above an
    /// edge if it lies to its left, seen from the edge's leftmost (then lowest) end.
    std::vector<std::uint32_t> below;
    /// Per canonical point without edges: the edge it lies on (kNoIndex: none).
    std::vector<std::uint32_t> on;
    /// Per edge: true if it was dropped because it meets another edge other than at a common end. The remaining edges
    /// have no such meetings; no edge is dropped if and only if there are none at all.
    std::vector<std::uint8_t> dropped;
    std::size_t droppedCount = 0;
};

/// Sweeps the plane from left to right with exact predicates by the method of M. I. Shamos and D. Hoey, Geometric
/// intersection problems (1976). O((n + m) log(n + m)) for any input: an edge found to meet another edge is dropped and
/// the sweep continues. All points must be finite. Edges between equal points and repeated edges are dropped. After a
/// stop request the result is meaningless.
PlaneSweepResult sweepPlane(std::span<const Vec2> points, std::span<const PlaneEdge> edges,
                            const std::stop_token &stop = {});

} // namespace forefront
