#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/quads/quad_watch.hpp"
#include "core/engine/quads/quad_workspace.hpp"

#include <vector>

namespace forefront {

/// Mends elements that are flat, not convex or clockwise after the clean-up. The nodes around such an element move if
/// that makes all elements there convex. Otherwise the pocket of elements around it is filled anew between the nodes of
/// its outline, with more triangles only where that takes no others or `elements` allows them. Other elements stay.
/// Since those of the front cover each face once, they do so again when all of them are convex.
///
/// Returns the places where triangles are left for this. Ends early when cancelled; the mesh may then still have such
/// elements. `watch`: learns of each change; null: none.
std::vector<Vec2> refillPockets(QuadWorkspace &mesh, Elements elements, const Progress &progress = {},
                                QuadWatch *watch = nullptr);

} // namespace forefront
