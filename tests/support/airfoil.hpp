#pragma once

#include "core/engine/domain/domain.hpp"

#include <numbers>

namespace forefront::testing {

/// Returns a disc of radius 1 about the origin, bounded by one circle.
Domain discDomain();

/// Returns the half-thickness of a NACA 00xx aerofoil of chord 1 at x = s², a polynomial in s. The last coefficient
/// closes the trailing edge (E. N. Jacobs, K. E. Ward, R. M. Pinkerton, NACA Report 460, 1933).
double halfThickness(double s, double thickness = 0.12);

/// Returns the rectangle [-1,2]x[-1,1] around a NACA 0012 aerofoil with a sharp trailing edge at (1, 0), in cubics of
/// equal parts of √x.
Domain airfoilDomain();

} // namespace forefront::testing
