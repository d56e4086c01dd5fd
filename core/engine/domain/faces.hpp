#pragma once

#include "core/engine/geometry/plane_sweep.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The connected faces between edges in the plane. Face 0 is the unbounded one; the others are numbered by their
/// leftmost (then lowest) points, so the numbers depend only on the geometry.
struct Faces {
    std::uint32_t count = 1;
    std::vector<std::uint32_t> left;  ///< per edge: the face left of a->b
    std::vector<std::uint32_t> right; ///< per edge: the face right of a->b
    std::vector<std::uint32_t>
        ofPoint; ///< per isolated point that is not on an edge: the face around it; else kNoIndex
};

/// Finds the faces of edges that meet only at common ends (sweep.droppedCount == 0). Loops may touch at a node, edges
/// may end freely, and components and isolated points may lie inside others. Exact; O(n log n) together with the sweep.
Faces findFaces(std::span<const Vec2> points, std::span<const PlaneEdge> edges, const PlaneSweepResult &sweep);

} // namespace forefront
