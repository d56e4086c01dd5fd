#pragma once

#include "core/improve/workspace.hpp"

namespace forefront {

/// Fills twin, start and fixed of a workspace whose arrays have their sizes. Half-edges wait in a list at the lower
/// node of their edge until the other one comes; first within blocks of elements, several blocks at once, then what is
/// left over. About 30 ns per element where elements lie in memory near their neighbours. After a stop the arrays are
/// not fit for use.
void joinElements(ImproveWorkspace &work, const std::stop_token &stop);

} // namespace forefront
