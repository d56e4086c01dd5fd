#pragma once

#include "core/engine/mesh/cell_set.hpp"

namespace forefront {

// The kinds of cells that formats hold.

inline constexpr CellSet kFirstOrder = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3,
                                        CellKind::Quadrilateral4};
inline constexpr CellSet kTriangleGrid = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3};
// GMF has a keyword for quadrilaterals of 9 nodes, but none for those of 8.
inline constexpr CellSet kMeditCells = {CellKind::Point,         CellKind::Edge2,     CellKind::Edge3,
                                        CellKind::Triangle3,     CellKind::Triangle6, CellKind::Quadrilateral4,
                                        CellKind::Quadrilateral9};
// Abaqus has no plane element of 9 nodes. Edges are sides of elements, with the middle nodes of those.
inline constexpr CellSet kAbaqusCells = {CellKind::Point,         CellKind::Edge2,     CellKind::Edge3,
                                         CellKind::Triangle3,     CellKind::Triangle6, CellKind::Quadrilateral4,
                                         CellKind::Quadrilateral8};
// The middle nodes of edges are those of the triangles beside them.
inline constexpr CellSet kTriangleCells = {CellKind::Point, CellKind::Edge2, CellKind::Edge3, CellKind::Triangle3,
                                           CellKind::Triangle6};
// No quadrilaterals of 9 nodes.
inline constexpr CellSet kEightNodes = {CellKind::Point,         CellKind::Edge2,     CellKind::Edge3,
                                        CellKind::Triangle3,     CellKind::Triangle6, CellKind::Quadrilateral4,
                                        CellKind::Quadrilateral8};

} // namespace forefront
