#pragma once

#include "core/engine/mesh/cell.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace forefront {

/// The element types of universal files that are written: rods, thin shells, as Gmsh and Salome write them. 0: none.
constexpr int unvType(CellKind kind) {
    constexpr std::array<int, kCellTraits.size()> kTypes = {0, 11, 24, 91, 92, 94, 95, 0};
    return kTypes[static_cast<std::size_t>(kind)];
}

/// Returns the kind of cell of an element type of I-DEAS: rods and beams, and the plane elements of plane stress,
/// plane strain, plates, membranes, axisymmetric solids and thin shells.
std::optional<CellKind> unvKind(std::int64_t type);

/// Returns true for the types whose records have a line about the section of a beam.
constexpr bool isUnvBeam(std::int64_t type) {
    return type == 11 || (type >= 21 && type <= 24);
}

/// Returns the place in the order of CellTraits of node k of a cell in a universal file. Nodes of cells of second order
/// run around them: corner, middle, corner, middle.
constexpr std::uint8_t unvNode(const CellTraits &traits, std::size_t k) {
    const bool line = traits.dimension == 1;
    return static_cast<std::uint8_t>(traits.order == 1 ? k : k % 2 == 0 ? k / 2 : line ? 2 : traits.corners + k / 2);
}

} // namespace forefront
