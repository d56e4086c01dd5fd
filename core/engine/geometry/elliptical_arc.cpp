#include "core/engine/geometry/elliptical_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

// From end points to centre: W3C, Scalable Vector Graphics 1.1, appendix F.6.5 and F.6.6.
Curve curveOf(Vec2 start, const EllipticalArc &arc, Vec2 end) {
    const double phi = arc.rotationDegrees * (std::numbers::pi / 180.0);
    const Vec2 along{std::cos(phi), std::sin(phi)};
    const Vec2 half = 0.5 * (start - end);
    const double rx = std::fabs(arc.radiusX), ry = std::fabs(arc.radiusY);
    const Vec2 unit{dot(along, half) / rx, cross(along, half) / ry}; // half the chord, where the ellipse is a circle
    const double square = lengthSquared(unit);
    if (!std::isfinite(square) || !(square > 0.0)) {
        return Curve::line(start, end);
    }
    const double growth = std::max(1.0, std::sqrt(square));
    const Vec2 chord = (1.0 / growth) * unit;
    const double away = std::sqrt(std::max(0.0, 1.0 / lengthSquared(chord) - 1.0));
    const Vec2 centre = (arc.largeArc != arc.sweep ? 1.0 : -1.0) * away * Vec2{chord.y, -chord.x};
    const auto angleOf = [](Vec2 v) { return std::atan2(v.y, v.x); };
    const double first = angleOf(chord - centre);
    double turn = angleOf(Vec2{0.0, 0.0} - chord - centre) - first;
    if (arc.sweep && turn < 0.0) {
        turn += 2.0 * std::numbers::pi;
    } else if (!arc.sweep && turn > 0.0) {
        turn -= 2.0 * std::numbers::pi;
    }
    const Vec2 u = growth * rx * along, v = growth * ry * leftNormal(along);
    const Curve curve = Curve::arc(midpoint(start, end) + centre.x * u + centre.y * v, u, v, first, turn);
    return curve.finite() ? curve : Curve::line(start, end);
}

} // namespace forefront
