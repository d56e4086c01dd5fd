#pragma once

#include "core/improve/workspace.hpp"

#include <vector>

namespace forefront {

/// Splits a list of elements into batches whose elements may be repaired at the same time: nothing that the repair of
/// one changes (nodes of the element and of those beside it, the elements around these nodes) is read by another's.
/// Batches hold positions in the list; the split depends on the list and the mesh only.
std::vector<std::vector<std::uint32_t>> independentBatches(const ImproveWorkspace &work,
                                                           const std::vector<std::uint32_t> &elements);

} // namespace forefront
