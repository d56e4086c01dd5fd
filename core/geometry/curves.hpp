#pragma once

#include "core/base/vec2.hpp"

#include <vector>

namespace forefront {

// Each function flattens a curve into a polyline whose nodes lie on the curve and whose segments deviate from it by at
// most `tolerance` (domain units, > 0). It appends the nodes after the start; the last one is exactly the end. Nodes
// equal to their predecessor are omitted. A curve with non-finite data becomes its end point alone.

/// Maximum number of segments per curve, for any tolerance.
inline constexpr int kMaxCurveSegments = 10000;

/// Flattens a quadratic Bézier curve.
void flattenQuadratic(Vec2 start, Vec2 control, Vec2 end, double tolerance, std::vector<Vec2> &nodes);
/// Flattens a cubic Bézier curve.
void flattenCubic(Vec2 start, Vec2 control1, Vec2 control2, Vec2 end, double tolerance, std::vector<Vec2> &nodes);

/// An elliptical arc between two given points, as in the path command A of SVG.
struct EllipticalArc {
    double radiusX = 0.0; ///< the sign is ignored; 0: a straight line; radii too small for the chord are scaled up
    double radiusY = 0.0;
    double rotationDegrees = 0.0; ///< of the ellipse's x axis
    bool largeArc = false;
    bool sweep = false; ///< in the direction of increasing angle
};
/// Flattens an elliptical arc.
void flattenArc(Vec2 start, const EllipticalArc &arc, Vec2 end, double tolerance, std::vector<Vec2> &nodes);

/// Returns a regular polygon inscribed in the circle, counter-clockwise, with its first node at `onCircle` and at least
/// `minSegments` (>= 3) segments.
std::vector<Vec2> circlePolygon(Vec2 centre, Vec2 onCircle, double tolerance, int minSegments = 8);

} // namespace forefront
