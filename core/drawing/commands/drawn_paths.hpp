#pragma once

#include "core/engine/geometry/curve.hpp"

#include <span>
#include <vector>

namespace forefront {

/// Returns the cubics of a smooth curve through points in order, one from each to the next, and from the last to the
/// first if it is closed. The curve is a centripetal Catmull-Rom spline, which makes no loops or cusps between points.
/// Consecutive points must differ; a curve through two points is a line.
std::vector<Curve> splineThrough(std::span<const Vec2> points, bool closed);

/// Simplifies a polyline by the Douglas–Peucker method: returns a subset of the points, with the first and the last,
/// whose polyline passes within `tolerance` of all points.
std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance);

} // namespace forefront
