#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_workspace.hpp"

#include <cstddef>

namespace forefront {

/// Moves free nodes to where the product of α of the elements around each is greatest, without regard to the spacing.
/// Smoothing comes near that in regular parts of a mesh; where fixed nodes lie on both sides of a narrow part, this
/// raises the geometric mean of α by .002 to .007. No α falls below `floor`, and those below it do not fall.
///
/// Visits the nodes in their order, so the result does not depend on threads, in at most 50 sweeps; above 40,000 nodes
/// in fewer.
/// Returns the number of moves. Updates the workspace except α. When cancelled, the moves made so far remain.
std::size_t polishShapes(ImproveWorkspace &work, double floor, const Progress &progress);

} // namespace forefront
