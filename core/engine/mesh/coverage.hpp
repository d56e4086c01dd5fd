#pragma once

#include "core/engine/mesh/half_edges.hpp"

#include <optional>
#include <vector>

namespace forefront {

/// A node that lies inside a boundary edge, not at one of its ends.
struct HangingNode {
    NodeId node = kNoNode;
    NodeId edgeA = kNoNode, edgeB = kNoNode;
};

/// The result of a sweep over the boundary of a mesh.
struct Coverage {
    std::optional<Vec2> overlap; ///< a place where elements overlap, the first from the left
    std::vector<HangingNode> hanging;
};

/// Decides whether the elements of a conforming mesh overlap anywhere, from its boundary alone: where all elements are
/// counter-clockwise, the number of elements over a point is the winding number of the mesh's boundary about it,
/// because inner edges cancel. Curved edges count as their chords. A plane sweep (M. I. Shamos, D. Hoey, Geometric
/// intersection problems, 1976) with exact predicates finds that number between any two neighbouring edges; it must be
/// 0 or 1. O(b log b) for b boundary edges. `boundary`: the half-edges whose edge has one element, of `sides`.
Coverage coverage(const MeshView &mesh, const HalfEdges &sides, const std::vector<HalfEdge> &boundary);

} // namespace forefront
