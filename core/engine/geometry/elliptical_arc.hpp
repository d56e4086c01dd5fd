#pragma once

#include "core/engine/geometry/curve.hpp"

namespace forefront {

/// An elliptical arc between two given points, as in the path command A of SVG.
struct EllipticalArc {
    double radiusX = 0.0; ///< the sign is ignored; 0: a straight line; radii too small for the chord are scaled up
    double radiusY = 0.0;
    double rotationDegrees = 0.0; ///< of the ellipse's x axis
    bool largeArc = false;
    bool sweep = false; ///< in the direction of increasing angle
};

/// Returns the arc as a curve: a line if it has no radius or is not finite.
Curve curveOf(Vec2 start, const EllipticalArc &arc, Vec2 end);

} // namespace forefront
