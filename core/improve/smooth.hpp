#pragma once

#include "core/base/progress.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>

namespace forefront {

/// One sweep of Laplace's smoothing: every free node goes to the mean of its neighbours, all at once. Where an element
/// would thereby fall below `floor` and lose, its nodes stay. Two passes over the elements, no search for rings; 16
/// bytes per node for the time being. Returns the number of nodes moved.
std::size_t smoothNodes(ImproveWorkspace &work, double floor, std::vector<Vec2> &scratch);

} // namespace forefront
