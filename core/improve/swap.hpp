#pragma once

#include "core/base/progress.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>

namespace forefront {

/// Turns the edge at a side of an element to the other diagonal of its two elements. The side must be swappable and the
/// new elements positive.
void turnEdge(ImproveWorkspace &work, std::size_t element, unsigned side);

/// Turns the edge if the lesser α of its two elements grows. Exact signs.
bool turnIfBetter(ImproveWorkspace &work, std::size_t element, unsigned side);

/// Turns edges wherever that raises the lesser α of the two elements and, with `mindValence`, also where it leaves it
/// nearly as it is (and not below the floor) and brings the valences nearer to 6; then again around the changes, a few
/// times. Returns the number of swaps.
std::size_t swapEdges(ImproveWorkspace &work, bool mindValence, const Progress &progress);

} // namespace forefront
