#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/names.hpp"
#include "core/files/source/export_options.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A prism over a triangle or a hexahedron over a quadrilateral: the corners of its back, counter-clockwise as seen
/// from the front, then those of its front in the same order.
struct SolidCell {
    std::array<std::uint32_t, 8> corners = {};
    std::uint8_t count = 6; ///< of its corners: 6 or 8
    std::int32_t region = 1;

    std::span<const std::uint32_t> nodes() const { return std::span(corners).first(count); }
};

/// A side of a cell; its normal by the right-hand rule points out of that cell.
struct SolidFace {
    std::array<std::uint32_t, 4> corners = {};
    std::uint8_t count = 4; ///< of its corners: 3 or 4
    std::int32_t tag = 1;
    std::uint32_t cell = 0;
    std::uint8_t side = 0; ///< 0: back, 1: front, 2 + k: over side k of the element

    std::span<const std::uint32_t> nodes() const { return std::span(corners).first(count); }
};

/// A mesh of elements of first order extruded along z from z = 0. Nodes and cells over one node or element follow each
/// other, so that the bandwidth stays small. Tagged edges become faces with their tag, also those inside; all back
/// faces (z = 0) have one tag of their own and all front faces another. Tagged points are left out.
struct SolidMesh {
    SolidMesh(const MeshView &mesh, const Extrusion &extrusion);

    std::vector<std::array<double, 3>> nodes;
    std::vector<SolidCell> cells;
    std::vector<SolidFace> faces; ///< over the tagged edges, in their order; then the back, then the front
    std::int32_t back = 0, front = 0;
    TagList tags;                       ///< tags of faces as `edges`, with their names; regions; no points
    LengthUnit unit = LengthUnit::None; ///< see ExportOptions; set by the caller
};

/// Returns tags that no edge or point of a mesh has: above all of them, or else the lowest ones.
std::vector<std::int32_t> freeTags(const MeshView &mesh, std::size_t count);

} // namespace forefront
