#pragma once

#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/quads/quad_cell.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// Quadrilaterals and triangles with the index of their face each.
struct PairedCells {
    std::vector<Vec2> nodes;
    std::vector<QuadCell> cells;
    std::vector<std::uint32_t> faces; ///< empty if there is one face
};

/// Joins the triangles of a two-coloured front over their edges between nodes of one colour. A triangle whose nodes all
/// have one colour gets a node of the other one in its middle; with `keepTriangles`, it is joined to one neighbour
/// instead, or stays. `kept`: pairs of nodes, as pairKey() makes them, ascending, whose edges stay.
PairedCells pairTriangles(TriMesh &&mesh, std::vector<std::uint8_t> colours, std::vector<std::uint32_t> faces,
                          const std::vector<std::uint64_t> &kept, bool keepTriangles);

} // namespace forefront
