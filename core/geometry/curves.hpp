#pragma once

#include "core/base/vec2.hpp"

#include <vector>

namespace forefront {

/// Curves become polylines whose nodes lie on the curve and whose segments leave it by no more than `tolerance` (domain
/// units, > 0). Each function appends the nodes after the start up to the end, which is appended exactly; a node equal
/// to the one before it is left out. At most kMostCurveSegments segments a curve, whatever the tolerance; a curve with
/// non-finite data becomes its end point alone.
inline constexpr int kMostCurveSegments = 10000;

void flattenQuadratic(Vec2 start, Vec2 control, Vec2 end, double tolerance, std::vector<Vec2> &nodes);
void flattenCubic(Vec2 start, Vec2 control1, Vec2 control2, Vec2 end, double tolerance, std::vector<Vec2> &nodes);

/// An elliptical arc between two given points as the path command A of SVG has it.
struct EllipticalArc {
    double radiusX = 0.0; ///< the sign is ignored; 0: a straight line; grown in proportion when too small
    double radiusY = 0.0;
    double rotationDegrees = 0.0; ///< of the ellipse's x axis
    bool largeArc = false;
    bool sweep = false; ///< in the direction of increasing angle
};
void flattenArc(Vec2 start, const EllipticalArc &arc, Vec2 end, double tolerance, std::vector<Vec2> &nodes);

/// A regular polygon inscribed in the circle, counter-clockwise, its first node at `onCircle`; at least `leastSegments`
/// (>= 3) segments.
std::vector<Vec2> circlePolygon(Vec2 centre, Vec2 onCircle, double tolerance, int leastSegments = 8);

} // namespace forefront
