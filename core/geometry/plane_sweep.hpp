#pragma once

#include "core/base/ids.hpp"
#include "core/base/vec2.hpp"

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

/// What a sweep over points and edges found.
struct PlaneSweepResult {
    /// Per point: the least index of a point with the same coordinates.
    std::vector<std::uint32_t> canonical;
    /// Canonical points by x, then y.
    std::vector<std::uint32_t> order;
    /// Per canonical point: the edge directly below it (kNoIndex: none), edges that end at the point left aside. A
    /// point is above an edge when it lies left of it, seen from that end of the edge that is least by x, then y.
    std::vector<std::uint32_t> below;
    /// Per canonical point without edges: the edge it lies on (kNoIndex: none).
    std::vector<std::uint32_t> on;
    /// Per edge: true if it was left out because it meets another one elsewhere than in a common end. The edges not
    /// dropped are free of such meetings; none is dropped exactly when the whole set is.
    std::vector<std::uint8_t> dropped;
    std::size_t droppedCount = 0;
};

/// Sweeps the plane from left to right after M. I. Shamos and D. Hoey, Geometric intersection problems (1976), with
/// exact predicates. O((n + m) log(n + m)) for any input: an edge found to meet another one is dropped and the sweep
/// goes on. All points finite; an edge between equal points and a second edge between the same points are dropped.
/// Given up when asked to stop: the result then means nothing.
PlaneSweepResult sweepPlane(std::span<const Vec2> points, std::span<const PlaneEdge> edges, std::stop_token stop = {});

} // namespace forefront
