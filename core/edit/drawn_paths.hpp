#pragma once

#include "core/geometry/curve.hpp"

#include <span>
#include <vector>

namespace forefront {

/// Returns the cubics of a smooth curve through points in order, one from each to the next, and from the last to the
/// first one if it is closed. A centripetal Catmull-Rom spline: it turns only where the points do, without loops.
/// Consecutive points must differ; a curve through two points is a line.
std::vector<Curve> splineThrough(std::span<const Vec2> points, bool closed);

/// Returns the fewest of the points, the first and the last among them, whose polyline keeps all within `tolerance`, by
/// Douglas and Peucker's method.
std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance);

} // namespace forefront
