#pragma once

#include "core/engine/grid/all_grids.hpp"
#include "core/engine/mesher/recorder.hpp"

// Instantiates the advancers and their parts. Each of these templates is defined in a source file of its
// own that ends with one of these macros.

// The arguments are names of templates and classes, which cannot be in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define FOREFRONT_INSTANTIATE_GRID(Template, Grid) template class Template<Grid>;
#define FOREFRONT_INSTANTIATE_GRID_AND_TRACES(Template, Grid)                                                          \
    template class Template<Grid, NoTrace>;                                                                            \
    template class Template<Grid, Recorder>;
// NOLINTEND(bugprone-macro-parentheses)

/// Template<Grid> for every background grid.
#define FOREFRONT_INSTANTIATE_FOR_GRIDS(Template) FOREFRONT_FOR_EACH_GRID(FOREFRONT_INSTANTIATE_GRID, Template)
/// Template<Grid, Trace> for every background grid, with and without recording.
#define FOREFRONT_INSTANTIATE_FOR_GRIDS_AND_TRACES(Template)                                                           \
    FOREFRONT_FOR_EACH_GRID(FOREFRONT_INSTANTIATE_GRID_AND_TRACES, Template)
