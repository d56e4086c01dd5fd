#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace FOREFRONT_API forefront {

/// An element with the places of its nodes.
struct PlacedCell {
    CellKind kind = CellKind::Triangle3;
    std::array<Vec2, kMaxCellNodes> nodes; ///< in the order of CellTraits

    PlacedCell() = default;
    PlacedCell(const MeshView::Block &block, std::size_t k, std::span<const Vec2> places) : kind(block.kind) {
        const std::span<const NodeId> ids = block.nodesOf(k);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            nodes[i] = places[index(ids[i])];
        }
    }
    PlacedCell(const MeshView &mesh, std::size_t element)
        : PlacedCell(mesh.blockOf(element), element - mesh.blockOf(element).first, mesh.nodes) {}

    const CellTraits &traits() const { return traitsOf(kind); }
    /// Returns the corners, counter-clockwise.
    std::span<const Vec2> corners() const { return {nodes.data(), traits().corners}; }
    Vec2 cornerBefore(std::size_t k) const { return nodes[k == 0 ? traits().corners - 1U : k - 1U]; }
    Vec2 cornerAfter(std::size_t k) const { return nodes[k + 1 == traits().corners ? 0 : k + 1]; }
    /// Returns the node in the middle of edge k of an element of second order.
    Vec2 middle(std::size_t k) const { return nodes[traits().corners + k]; }

    /// Returns true if the edges are straight with their nodes in their middles, within rounding, and a node in the
    /// centre lies in the mean of the corners: then the map of the element is the one of its corners.
    bool isStraight() const;
    /// Returns where the map of the element takes the centre of the reference element. It lies inside a valid element;
    /// for triangles with straight edges it is the centroid.
    Vec2 centre() const;
};

/// Calls visit(const PlacedCell &, element) for each element of a mesh, in order.
template <class Visit>
void forEachCell(const MeshView &mesh, Visit &&visit) {
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0, count = block.size(); k < count; ++k) {
            visit(PlacedCell(block, k, mesh.nodes), block.first + k);
        }
    }
}

/// Returns true if the middle node of an edge is the middle of its chord, within rounding.
bool isMiddleOfChord(Vec2 a, Vec2 b, Vec2 middle);

/// Returns the length of an edge, along its curve if its middle node is off its chord. `middle`: kNoNode if it has
/// none.
double edgeLength(std::span<const Vec2> nodes, NodeId a, NodeId middle, NodeId b);

/// Returns twice the area of an element, exact for its curved edges but for rounding: negative if it is clockwise.
double twiceArea(const PlacedCell &cell);

/// Returns the shape factor α of an element, from its corners. For a quadrilateral: the minimum of α over the four
/// triangles of a corner and its two neighbours, times 2/√3: 1 for a square, 2r/(1 + r²) for a rectangle of sides 1 and
/// r, 0 if a corner is flat, negative if one is reflex.
double shapeFactor(const PlacedCell &cell);

/// The smallest and the largest angle at the corners of an element, in degrees, between the chords of its edges.
struct AngleRange {
    double smallest = 0.0, largest = 180.0;
};
/// Returns the extreme angles; 0 and 180 for an element that is flat, inverted or not convex.
AngleRange anglesOf(const PlacedCell &cell);

/// Returns the aspect ratio of an element, from its corners. For a quadrilateral: the longer distance between middles
/// of opposite edges over the shorter, as the sides of a rectangle. For a triangle: the longest edge over the height
/// above it, times √3/2: 1 if it is equilateral. Infinity if it is flat.
double aspectRatio(const PlacedCell &cell);

/// Returns the scaled Jacobian of an element: the minimum over its corners of the cross product of the two edges there,
/// divided by their lengths; times 2/√3 for triangles. It is 1 for squares and equilateral triangles, 0 if a corner is
/// flat, and not positive if the map of the element is not one to one (The Verdict Library Reference Manual, C. J.
/// Stimpson et al., 2007). For second order: the value of the chords times the minimum over the element of the Jacobian
/// determinant relative to straight edges, 1 at most; see leastJacobianRatio().
double scaledJacobian(const PlacedCell &cell);

} // namespace forefront
