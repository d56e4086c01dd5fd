#pragma once

#include "core/engine/geometry/curve.hpp"

#include <optional>

namespace forefront {

/// Returns the curve moved by a vector, without rounding its axes.
Curve moved(const Curve &curve, Vec2 by);

/// Returns the curve moved so that it joins two other points. The handles of a cubic move with their ends; an arc is
/// turned and scaled, so that it keeps its shape. One that ends where it begins is only moved.
Curve joining(const Curve &curve, Vec2 from, Vec2 to);

/// Returns true if the curve begins and ends at the two points, up to 1e-6 of its coordinates.
bool joins(const Curve &curve, Vec2 from, Vec2 to);

/// Returns the radius of an arc of a circle; none for other curves.
std::optional<double> radiusOf(const Curve &curve);

/// Returns the signed area between the curve and the lines from a point to its ends, positive where the curve runs
/// counter-clockwise around the point.
double sectorArea(const Curve &curve, Vec2 from);

/// Returns one curve close to two consecutive ones: lines give a line, arcs of one ellipse an arc; otherwise the cubic
/// with their outer ends and tangents that is nearest by least squares.
Curve merged(const Curve &first, const Curve &second);

/// Returns a cubic with the ends and tangents of an arc. Its error is 2.7e-4 of the radius for a quarter turn and 2 %
/// for a half turn; for more than that it is a least-squares fit, which is only a rough approximation.
Curve cubicAlong(const Curve &arc);

/// Returns the arc of a circle from one point through another to a third; a line if the three are collinear.
Curve arcThrough(Vec2 from, Vec2 middle, Vec2 to);
/// Returns an arc of a circle with the given radius between two points, on the side of a third point: more than half a
/// circle if that point is far from their line, exactly half if the radius is too small.
Curve arcOfRadius(Vec2 from, Vec2 to, double radius, Vec2 side);
/// Returns an arc with another radius between the ends of an arc, on the same side and, like it, more than half a
/// circle or not.
Curve withRadius(const Curve &arc, double radius);
/// Returns the arc of a circle between two points that leaves the first one in a direction; a line if the second point
/// is ahead.
Curve tangentArc(Vec2 from, Vec2 direction, Vec2 to);

} // namespace forefront
