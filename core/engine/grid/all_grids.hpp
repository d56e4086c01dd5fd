#pragma once

#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/grid/hierarchical_grid.hpp"
#include "core/engine/grid/no_grid.hpp"
#include "core/engine/grid/uniform_grid.hpp"

/// Expands apply(argument, Grid) for every background grid. To add a grid: write its class with the members of NoGrid,
/// add its kind and word to grid_kind.hpp, and add the class to this list.
#define FOREFRONT_FOR_EACH_GRID(apply, argument)                                                                       \
    apply(argument, NoGrid) apply(argument, UniformGrid) apply(argument, HierarchicalGrid)
