#pragma once

#include "core/engine/improve/improve_workspace.hpp"

namespace forefront {

/// Fills twin, start and fixed of a workspace, whose arrays must already have the right sizes. A half-edge waits in a
/// list at the lower node of its edge until its partner comes: first within blocks of elements, in parallel, then
/// across blocks. Takes about 30 ns per element where elements lie in memory close to their neighbours. After a stop
/// the arrays are unusable.
void joinElements(ImproveWorkspace &work, const std::stop_token &stop);

} // namespace forefront
