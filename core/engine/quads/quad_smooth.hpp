#pragma once

#include "core/engine/quads/quad_workspace.hpp"

namespace forefront {

/// Returns the place where a node would make its elements square and as large as the node spacing asks. `spring`: the
/// weight of the spacing against the shapes.
Vec2 squaringPlace(const QuadWorkspace &mesh, std::uint32_t node, double spring);

/// Moves all free nodes to their squaring places, one after the other, so many times.
void smoothFreely(QuadWorkspace &mesh, unsigned sweeps, double spring);
/// The same, but no move lowers the minimum scaled Jacobian around its node below `limit`.
void smoothGuarded(QuadWorkspace &mesh, unsigned sweeps, double spring, double limit);
/// Moves a free node to where the minimum scaled Jacobian around it is highest, by a pattern search that ends at
/// `limit`. Returns true if it moved.
bool polishNode(QuadWorkspace &mesh, std::uint32_t node, double limit);
/// Moves free nodes whose minimum scaled Jacobian is below `limit` by polishNode().
void polishShapes(QuadWorkspace &mesh, double limit, unsigned rounds);

} // namespace forefront
