#pragma once

#include "core/geometry/plane_sweep.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The connected faces that edges cut out of the plane. Face 0 is the unbounded one; the others are numbered by their
/// least points (by x, then y), so the numbers depend on the geometry alone.
struct Faces {
    std::uint32_t count = 1;
    std::vector<std::uint32_t> left;    ///< per edge: the face left of a->b
    std::vector<std::uint32_t> right;   ///< likewise on the right
    std::vector<std::uint32_t> ofPoint; ///< per point without edges and not on one: the face it lies in; else kNoIndex
};

/// Faces of edges that meet nowhere but in common ends (sweep.droppedCount == 0). Loops that touch in a node, edges
/// that end freely, components inside of others and isolated points are all allowed. Exact; O(n log n) with the sweep.
Faces findFaces(std::span<const Vec2> points, std::span<const PlaneEdge> edges, const PlaneSweepResult &sweep);

} // namespace forefront
