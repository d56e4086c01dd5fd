#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

/// The input from which a background grid is built.
struct GridRequest {
    const DiscreteDomain &domain;
    const SpacingField &spacing;
    int columns = 0, rows = 0;  ///< cells of a uniform grid; 0: automatic
    double cellPerLength = 1.0; ///< see HierarchicalGrid
};

} // namespace forefront
