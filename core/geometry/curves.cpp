#include "core/geometry/curves.hpp"

#include <numbers>

namespace forefront {

namespace {

void append(Vec2 p, Vec2 previous, std::vector<Vec2> &nodes) {
    if (p != (nodes.empty() ? previous : nodes.back())) {
        nodes.push_back(p);
    }
}

int clampedCount(double count, int minimum) {
    return count <= minimum            ? minimum
           : count < kMaxCurveSegments ? static_cast<int>(std::ceil(count))
                                       : kMaxCurveSegments;
}

/// Returns the number of segments n for a tolerance: n equal parameter steps deviate from the curve by at most
/// max|second derivative| / (8 n²).
int stepsFor(double secondDerivative, double tolerance) {
    return clampedCount(std::sqrt(secondDerivative / (8.0 * tolerance)), 1);
}

/// Returns the maximum angle per segment so that its sagitta radius·(1 - cos(angle/2)) stays within the tolerance.
double anglePerSegment(double radius, double tolerance) {
    const double ratio = tolerance / radius;
    // acos(1 - ratio) loses all digits for small ratios: 1 - cos u = 2 sin²(u/2).
    return ratio >= 1.0 ? std::numbers::pi : 4.0 * std::asin(std::sqrt(0.5 * ratio));
}

double angleOf(Vec2 v) {
    return std::atan2(v.y, v.x);
}

} // namespace

void flattenQuadratic(Vec2 start, Vec2 control, Vec2 end, double tolerance, std::vector<Vec2> &nodes) {
    const Vec2 bend = start - 2.0 * control + end;
    const int steps = isFinite(start) && isFinite(bend) ? stepsFor(2.0 * length(bend), tolerance) : 1;
    for (int i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        append(lerp(lerp(start, control, t), lerp(control, end, t), t), start, nodes);
    }
    append(end, start, nodes);
}

void flattenCubic(Vec2 start, Vec2 control1, Vec2 control2, Vec2 end, double tolerance, std::vector<Vec2> &nodes) {
    const Vec2 bend1 = start - 2.0 * control1 + control2, bend2 = control1 - 2.0 * control2 + end;
    const bool sound = isFinite(start) && isFinite(bend1) && isFinite(bend2);
    const int steps = sound ? stepsFor(6.0 * std::max(length(bend1), length(bend2)), tolerance) : 1;
    for (int i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec2 a = lerp(start, control1, t), b = lerp(control1, control2, t), c = lerp(control2, end, t);
        append(lerp(lerp(a, b, t), lerp(b, c, t), t), start, nodes);
    }
    append(end, start, nodes);
}

// From end points to centre: W3C, Scalable Vector Graphics 1.1, appendix F.6.5 and F.6.6.
void flattenArc(Vec2 start, const EllipticalArc &arc, Vec2 end, double tolerance, std::vector<Vec2> &nodes) {
    const double phi = arc.rotationDegrees * (std::numbers::pi / 180.0), cosine = std::cos(phi), sine = std::sin(phi);
    double rx = std::fabs(arc.radiusX), ry = std::fabs(arc.radiusY);
    const Vec2 half = 0.5 * (start - end);
    const Vec2 unit{(cosine * half.x + sine * half.y) / rx, (cosine * half.y - sine * half.x) / ry};
    const double square = lengthSquared(unit); // half the chord, where the ellipse is the unit circle
    if (start == end) {
        return;
    }
    if (!std::isfinite(square) || !(square > 0.0)) {
        append(end, start, nodes);
        return;
    }
    const double growth = std::max(1.0, std::sqrt(square));
    rx *= growth;
    ry *= growth;
    const Vec2 chord = (1.0 / growth) * unit;
    const double away = std::sqrt(std::max(0.0, 1.0 / lengthSquared(chord) - 1.0));
    const Vec2 centre = (arc.largeArc != arc.sweep ? 1.0 : -1.0) * away * Vec2{chord.y, -chord.x};
    const double first = angleOf(chord - centre);
    double turn = angleOf(Vec2{0.0, 0.0} - chord - centre) - first;
    if (arc.sweep && turn < 0.0) {
        turn += 2.0 * std::numbers::pi;
    } else if (!arc.sweep && turn > 0.0) {
        turn -= 2.0 * std::numbers::pi;
    }
    const int steps = clampedCount(std::fabs(turn) / std::min(anglePerSegment(std::max(rx, ry), tolerance), 1.6), 1);
    const Vec2 middle = midpoint(start, end);
    for (int i = 1; i < steps; ++i) {
        const double angle = first + turn * i / steps;
        const Vec2 p{rx * (centre.x + std::cos(angle)), ry * (centre.y + std::sin(angle))};
        append(middle + Vec2{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y}, start, nodes);
    }
    append(end, start, nodes);
}

std::vector<Vec2> circlePolygon(Vec2 centre, Vec2 onCircle, double tolerance, int minSegments) {
    const Vec2 arm = onCircle - centre;
    const double full = 2.0 * std::numbers::pi;
    const int count = clampedCount(full / anglePerSegment(length(arm), tolerance), std::max(3, minSegments));
    std::vector<Vec2> polygon{onCircle};
    for (int i = 1; i < count; ++i) {
        const double angle = full * i / count, cosine = std::cos(angle), sine = std::sin(angle);
        polygon.push_back(centre + Vec2{cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y});
    }
    return polygon;
}

} // namespace forefront
