#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/edge_swap.hpp"

#include <cstddef>

namespace forefront {

/// Swaps the edges that the rule selects, in the order of their half-edges, then looks again around the swaps, up to
/// six rounds in all. α must be up to date and is kept up to date. Returns the number of swaps. After cancellation the
/// rings are out of date.
std::size_t swapEdges(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress);

} // namespace forefront
