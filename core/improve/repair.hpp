#pragma once

#include "core/base/progress.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>

namespace forefront {

/// What repair wants of each element.
struct ShapeGoal {
    double alpha = 0.8;  ///< least α
    double angle = 35.0; ///< least angle, degrees
    int rounds = 5; ///< how often elements that stay bad are tried, from the second time on with their surroundings
};

struct RepairCounts {
    std::size_t swaps = 0;
    std::size_t moves = 0;
    std::size_t left = 0; ///< elements that still miss the goal
};

/// Works only on elements that miss the goal: turns their edges and moves their free nodes by a pattern search (R.
/// Hooke, T. A. Jeeves, 1961), each where the worst of the elements around comes nearer to the goal; later also the
/// nodes around. No α falls below `leastAlpha` that was not below, and none of those falls. α must be up to date and is
/// kept so. Elements whose surroundings do not touch are repaired at the same time.
RepairCounts repairWorst(ImproveWorkspace &work, const ShapeGoal &goal, double leastAlpha, const Progress &progress);

} // namespace forefront
