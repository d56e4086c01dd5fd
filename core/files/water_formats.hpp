#pragma once

#include "core/files/format.hpp"
#include "core/files/hydro/hydro.hpp"

namespace forefront {

/// The grid of ADCIRC, fort.14.
inline constexpr Format kAdcircFormat = {
    .about = {.id = "adcirc",
              .name = "ADCIRC grid",
              .extension = ".14",
              .readsDomain = true,
              .readsMesh = true,
              .writesMesh = true,
              .readsFields = true,
              .counterClockwise = true,
              .holds = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3},
              .dropsInnerEdges = true,
              .dropsBoundaryNames = true,
              .dropsRegionNames = true,
              .hasOpenBoundaries = true,
              .holdsElevations = true,
              .program = "ADCIRC",
              .keeps = "Keeps triangles and the boundary as chains of open parts, land (20) and islands (21), whose "
                       "names are read as open_1, ..., land and island. Depths are elevations with the other sign."},
    .readMesh = readHydro,
    .readFields = readHydroFields,
    .writeWith = writeAdcirc,
    .noteChanges = noteDepths};

/// The grid of SCHISM, hgrid.gr3.
inline constexpr Format kSchismFormat = {
    .about = {.id = "gr3",
              .name = "SCHISM grid",
              .extension = ".gr3",
              .readsDomain = true,
              .readsMesh = true,
              .writesMesh = true,
              .readsFields = true,
              .counterClockwise = true,
              .holds = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3, CellKind::Quadrilateral4},
              .dropsInnerEdges = true,
              .dropsBoundaryNames = true,
              .dropsRegionNames = true,
              .hasOpenBoundaries = true,
              .holdsElevations = true,
              .program = "SCHISM",
              .keeps = "Keeps elements and the boundary as chains of open parts, land (0) and islands (1), whose "
                       "names are read as open_1, ..., land and island. Depths are elevations with the other sign."},
    .readMesh = readHydro,
    .readFields = readHydroFields,
    .writeWith = writeSchism,
    .noteChanges = noteDepths};

} // namespace forefront
