#pragma once

#include "core/engine/mesh/cell.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace forefront {

/// The names of a kind of cells in XDMF, and its number in grids of several kinds. From the XDMF Model and Format,
/// "Topology" (xdmf.org), whose cells list their nodes as CellTraits does.
struct XdmfType {
    CellKind kind;
    const char *name;  ///< as written
    const char *other; ///< a further name in use; null: none
    std::int32_t number;
};

inline constexpr std::array<XdmfType, 8> kXdmfTypes{{
    {CellKind::Point, "Polyvertex", nullptr, 1},
    {CellKind::Edge2, "Polyline", nullptr, 2},
    {CellKind::Triangle3, "Triangle", nullptr, 4},
    {CellKind::Quadrilateral4, "Quadrilateral", nullptr, 5},
    {CellKind::Edge3, "Edge_3", nullptr, 34},
    {CellKind::Quadrilateral9, "Quadrilateral_9", "Quad_9", 35},
    {CellKind::Triangle6, "Triangle_6", "Tri_6", 36},
    {CellKind::Quadrilateral8, "Quadrilateral_8", "Quad_8", 37},
}};

/// Points and lines may have any number of nodes, so that it follows their number in grids of several kinds.
constexpr bool xdmfCounted(CellKind kind) {
    return kind == CellKind::Point || kind == CellKind::Edge2;
}

constexpr const XdmfType &xdmfTypeOf(CellKind kind) {
    std::size_t k = 0;
    while (kXdmfTypes[k].kind != kind) {
        ++k;
    }
    return kXdmfTypes[k];
}

/// Begin the names of <Information> elements that name a tag: "region 3".
inline constexpr std::string_view kXdmfRegion = "region", kXdmfBoundary = "boundary", kXdmfPoints = "points";

} // namespace forefront
