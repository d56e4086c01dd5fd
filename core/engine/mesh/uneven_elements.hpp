#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/second_order.hpp"

#include <optional>
#include <vector>

namespace forefront {

/// Returns the elements of second order whose Jacobian determinant falls below kReportedUniformity of its maximum, the
/// worst first, equal ones by number. Triangles with straight edges never do.
std::vector<UnevenElement> unevenElements(const MeshView &mesh);

/// Returns the least ratio of the minimum of the Jacobian determinant to its maximum among the elements of second
/// order; nothing if there are none.
std::optional<double> leastJacobianUniformity(const MeshView &mesh);

} // namespace forefront
