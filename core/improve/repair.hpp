#pragma once

#include "core/base/progress.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>

namespace forefront {

struct RepairCounts {
    std::size_t swaps = 0;
    std::size_t moves = 0;
};

/// Works on the worst elements only, those with α below `wanted`: turns their edges where that raises the lesser α, and
/// moves their free nodes by a pattern search (R. Hooke, T. A. Jeeves, 1961) that raises the least α around the node.
/// Elements that stay bad are tried again with the nodes of the ring around them, a few times.
RepairCounts repairWorst(ImproveWorkspace &work, double wanted, const Progress &progress);

} // namespace forefront
