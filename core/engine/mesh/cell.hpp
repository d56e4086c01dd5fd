#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace FOREFRONT_API forefront {

/// The kinds of cells that a mesh is made of, after their shape and number of nodes.
enum class CellKind : std::uint8_t {
    Point,
    Edge2,
    Edge3,
    Triangle3,
    Triangle6,
    Quadrilateral4,
    Quadrilateral8,
    Quadrilateral9
};

/// The words are keys in JSON and arguments of options.
template <>
struct EnumWords<CellKind> {
    static constexpr auto kLast = CellKind::Quadrilateral9;
    static constexpr std::array<std::string_view, 8> kList = {
        "point", "edge2", "edge3", "triangle3", "triangle6", "quadrilateral4", "quadrilateral8", "quadrilateral9"};
};

/// The largest numbers of nodes and corners of a cell.
inline constexpr std::size_t kMaxCellNodes = 9;
inline constexpr std::size_t kMaxCellCorners = 4;

/// The properties of a kind of cell. A cell lists its corners counter-clockwise, then, if it is of second order, the
/// middle nodes of its edges in their order, then a node in its centre if it has one. Edge k joins the corners k and
/// (k+1) mod `corners`. That is the order of Gmsh and VTK too.
struct CellTraits {
    const char *name;   ///< "triangle of 6 nodes"
    const char *plural; ///< "triangles of 6 nodes"
    std::uint8_t dimension;
    std::uint8_t order; ///< 1, or 2 with nodes in the middles of edges
    std::uint8_t nodes;
    std::uint8_t corners; ///< and edges, of cells with an area
    int gmsh;             ///< the number of its type in MSH files
    int vtk;              ///< the number of its type in VTK files; also in SU2 files for cells of first order
    const char *medit;    ///< its keyword in MEDIT files; null: MEDIT has none
    const char *abaqus;   ///< the type in Abaqus files that is written for it; null: none
    /// For each of its nodes in the order of Netgen's .vol files, and of Triangle's .ele files, the node here. Both put
    /// the middle of the edge opposite to corner k of a triangle at 3 + k. Netgen lists the middles of the edges 0, 2,
    /// 3 and 1 of a quadrilateral.
    std::array<std::uint8_t, kMaxCellNodes> opposite;
};

inline constexpr std::array<std::uint8_t, kMaxCellNodes> kSameOrder = {0, 1, 2, 3, 4, 5, 6, 7, 8};
inline constexpr std::array<std::uint8_t, kMaxCellNodes> kOppositeOrder = {0, 1, 2, 4, 5, 3, 6, 7, 8};
inline constexpr std::array<std::uint8_t, kMaxCellNodes> kNetgenQuadOrder = {0, 1, 2, 3, 4, 6, 7, 5, 8};

/// The table of all kinds of cells, by CellKind. A new kind is a new row.
inline constexpr std::array<CellTraits, wordsOf<CellKind>().size()> kCellTraits = {{
    {"point", "points", 0, 1, 1, 1, 15, 1, nullptr, nullptr, kSameOrder},
    {"edge of 2 nodes", "edges of 2 nodes", 1, 1, 2, 2, 1, 3, "Edges", "T3D2", kSameOrder},
    {"edge of 3 nodes", "edges of 3 nodes", 1, 2, 3, 2, 8, 21, "EdgesP2", "T3D3", kSameOrder},
    {"triangle", "triangles", 2, 1, 3, 3, 2, 5, "Triangles", "CPS3", kSameOrder},
    {"triangle of 6 nodes", "triangles of 6 nodes", 2, 2, 6, 3, 9, 22, "TrianglesP2", "CPS6", kOppositeOrder},
    {"quadrilateral", "quadrilaterals", 2, 1, 4, 4, 3, 9, "Quadrilaterals", "CPS4", kSameOrder},
    {"quadrilateral of 8 nodes", "quadrilaterals of 8 nodes", 2, 2, 8, 4, 16, 23, nullptr, "CPS8", kNetgenQuadOrder},
    {"quadrilateral of 9 nodes", "quadrilaterals of 9 nodes", 2, 2, 9, 4, 10, 28, "QuadrilateralsQ2", nullptr,
     kSameOrder},
}};

/// Returns the properties of a kind of cell.
constexpr const CellTraits &traitsOf(CellKind kind) {
    return kCellTraits[static_cast<std::size_t>(kind)];
}

/// The kinds of cells with an area: the elements of a mesh.
inline constexpr std::array<CellKind, 5> kElementKinds = {CellKind::Triangle3, CellKind::Triangle6,
                                                          CellKind::Quadrilateral4, CellKind::Quadrilateral8,
                                                          CellKind::Quadrilateral9};

} // namespace forefront
