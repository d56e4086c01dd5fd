#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/quads/quad_cell.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Elements with their nodes. Refers to its parts.
struct CellView {
    std::span<const Vec2> nodes;
    std::span<const QuadCell> cells;      ///< those without nodes are left out
    std::span<const std::uint32_t> faces; ///< index of each element's face; empty if there is one face
};

/// Returns the number of each node in meshOfCells(): nodes of the boundary keep theirs, and others without an element
/// have none, kNoIndex. `boundaryNodes`: the number of nodes of the boundary, which come first.
std::vector<std::uint32_t> numbersInMesh(const CellView &view, std::size_t boundaryNodes);

/// Returns the mesh of some elements, with the tags and names of its boundary: triangles first, then quadrilaterals.
Mesh meshOfCells(const CellView &view, const DiscreteDomain &boundary);

} // namespace forefront
