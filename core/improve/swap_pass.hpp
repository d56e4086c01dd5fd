#pragma once

#include "core/base/progress.hpp"
#include "core/improve/swap.hpp"

#include <cstddef>

namespace forefront {

/// Turns edges wherever the rule says so, then again around the changes, a few times. α must be up to date and is kept
/// so. The result is that of turning them one by one in the order of their half-edges, whatever the number of threads.
/// Returns the number of swaps. After a stop rings are no longer those of the mesh.
std::size_t swapEdges(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress);

} // namespace forefront
