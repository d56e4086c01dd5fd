#pragma once

#include "core/engine/geometry/curve.hpp"

namespace forefront {

/// Returns the parameter that halves the length of a curve between two parameters, to about 12 digits of that length;
/// the same bits for either order of the parameters.
double halfLength(const Curve &curve, double t0, double t1);

} // namespace forefront
