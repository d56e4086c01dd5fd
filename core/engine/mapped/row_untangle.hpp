#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mapped/row_grid.hpp"

namespace forefront {

/// Sets the inner places of a grid whose outline turns inwards, where smoothing leaves inverted cells: those of a grid
/// of half as many rows, made valid the same way, between which the others lie; then places around cells that are
/// inverted, or nearly, move to where the least sine of a corner around them is greatest. Returns true if no cell is
/// inverted; false, too, once cancelled. `triangles`: as for RowGrid::invertedCell().
bool untangleRows(RowGrid &grid, bool triangles, const Progress &progress = {});

} // namespace forefront
