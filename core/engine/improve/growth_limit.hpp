#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_workspace.hpp"

#include <cstddef>

namespace forefront {

/// The goal for the area ratios of neighbours, and the shapes that moves must preserve meanwhile.
struct GrowthGoal {
    double growth = 2.0; ///< maximum ratio of the areas of elements that share an edge
    double alpha = 0.85; ///< no α falls below this, and no lower one falls further
    double angle = 39.0; ///< the same for the minimum angle, degrees
};

/// Returns the maximum ratio of the areas of elements that share an edge, also across tagged edges; 1 if none do.
double growthOf(const ImproveWorkspace &work);

/// Moves free nodes where the areas of neighbours, also across tagged edges, differ by more than the goal, by a pattern
/// search (R. Hooke, T. A. Jeeves, 1961), as long as that brings the ratios around a node closer to the goal and the
/// worst of them does not rise. α must be up to date and is kept up to date. Returns the number of moves.
std::size_t limitGrowth(ImproveWorkspace &work, const GrowthGoal &goal, const Progress &progress);

} // namespace forefront
