#pragma once

#include "core/engine/geometry/curve.hpp"

#include <span>
#include <vector>

namespace forefront {

/// Fits curves to a stroke drawn by hand: lines where it is straight, elsewhere cubics, each from the end of the one
/// before. They pass within `tolerance` (> 0) of the points, begin at the first point and end at the last, or at the
/// first again if `closed`. They have a corner where the stroke turns sharply within a few tolerances, and join
/// smoothly elsewhere. Empty for less than two different points. Method: P. J. Schneider, "An algorithm for
/// automatically fitting digitized curves", Graphics Gems, 1990, with corners found beforehand and tangents taken over
/// several points, since pointer positions are whole pixels.
std::vector<Curve> fitStroke(std::span<const Vec2> points, double tolerance, bool closed);

} // namespace forefront
