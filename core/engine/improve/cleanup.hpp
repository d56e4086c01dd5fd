#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_workspace.hpp"

#include <cstddef>

namespace forefront {

/// The shape that cleanup aims for in each element.
struct ShapeGoal {
    double alpha = 0.8;  ///< minimum α
    double angle = 35.0; ///< minimum angle, degrees
    int rounds = 5;      ///< maximum attempts per element; from the second on, its surroundings change, too
};

/// The result of a cleanup.
struct CleanupCounts {
    std::size_t swaps = 0;
    std::size_t moves = 0;
    std::size_t attempts = 0; ///< at cleaning up an element
    std::size_t left = 0;     ///< elements that still miss the goal
};

/// Improves the elements that miss the goal: swaps their edges and moves their free nodes by a pattern search (R.
/// Hooke, T. A. Jeeves, 1961) wherever that brings the worst element around closer to the goal; later rounds also move
/// the nodes around. An attempt that changed nothing is not repeated before something around it changes, and the rounds
/// end early where they hardly help. No α falls below `minAlpha`, and no lower α falls further. α must be up to date
/// and is kept up to date. Elements whose surroundings do not touch are cleaned up in parallel.
CleanupCounts cleanUpWorst(ImproveWorkspace &work, const ShapeGoal &goal, double minAlpha, const Progress &progress);

} // namespace forefront
