#pragma once

#include "core/engine/mesh/placed_cell.hpp"

#include <optional>

namespace forefront {

/// Returns a place where the map from the reference element to an element of second order is not one to one: its
/// Jacobian determinant is zero or negative there, or exceeds zero by less than a billionth. Empty if the determinant
/// is positive everywhere, which its Bernstein coefficients prove on parts of the element that are divided where they
/// leave it open (A. Johnen, J.-F. Remacle, C. Geuzaine, Geometrical validity of curvilinear finite elements, 2013).
std::optional<Vec2> foldIn(const PlacedCell &cell);

/// Returns the minimum over an element of second order of its Jacobian determinant divided by that for straight edges,
/// to 1e-6, by the same bound. The polygon of its corners must be convex.
double leastJacobianRatio(const PlacedCell &cell);

/// Returns the minimum of the Jacobian determinant over an element of second order, divided by its maximum, to 1e-6, by
/// the same bound: 1 for a triangle or parallelogram with straight edges. The maximum must be positive.
double jacobianUniformity(const PlacedCell &cell);

/// Returns the same for the element with straight edges that has the corners of `cell`; not positive if it is not
/// convex, 0 if it is a point.
double straightUniformity(const PlacedCell &cell);

/// Returns the Jacobian determinant of an element of second order at a place of the reference element, for checks: the
/// triangle (0,0), (1,0), (0,1) or the square [0,1]².
double jacobianAt(const PlacedCell &cell, Vec2 reference);

} // namespace forefront
