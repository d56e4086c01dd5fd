#pragma once

#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/quads/even_boundary.hpp"
#include "core/engine/quads/quad_cell.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// The triangles of a two-coloured front, halves of squares.
struct ColouredTriangles {
    TriMesh mesh;                      ///< nodes and elements alone
    std::vector<std::uint8_t> colours; ///< per node
    std::vector<std::uint32_t> faces;  ///< as FrontState::elementFaces
};

/// Quadrilaterals and triangles with the index of their face each.
struct PairedCells {
    std::vector<Vec2> nodes;
    std::vector<QuadCell> cells;
    std::vector<std::uint32_t> faces; ///< empty if there is one face
};

/// What becomes of a triangle whose nodes all have one colour.
enum class OneColoured : std::uint8_t {
    Divide, ///< it gets a node of the other colour in its middle
    Join,   ///< it is joined to one neighbour, or stays
    Leave   ///< it stays, and so do its edges
};

/// Joins the triangles of a two-coloured front over their edges between nodes of one colour. `kept`: pairs of nodes, as
/// pairKey() makes them, ascending, whose edges stay.
PairedCells pairTriangles(ColouredTriangles &&triangles, const std::vector<std::uint64_t> &kept, OneColoured rule);

/// Returns the edges of a boundary that join nodes of one colour, as pairKey() makes them, ascending.
std::vector<std::uint64_t> oneColouredEdges(const ColouredBoundary &boundary);

} // namespace forefront
