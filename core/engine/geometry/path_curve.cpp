#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace forefront {
namespace {

Curve withAxes(const std::array<double, 8> &n, Vec2 centre, Vec2 u, Vec2 v) {
    return Curve::arc(centre, u, v, n[6], n[7]);
}

/// Returns the product of two complex numbers.
Vec2 times(Vec2 a, Vec2 b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// Returns the arc along two consecutive arcs if both are of one ellipse.
std::optional<Curve> mergedArc(const Curve &first, const Curve &second) {
    if (first.kind() != CurveKind::Arc || second.kind() != CurveKind::Arc) {
        return std::nullopt;
    }
    constexpr double kSame = 1e-9; // relative
    const std::array<double, 8> a = first.numbers(), b = second.numbers();
    const double size = std::max(std::hypot(a[2], a[3]), std::hypot(a[4], a[5]));
    for (std::size_t k = 0; k < 6; ++k) {
        if (!(std::fabs(a[k] - b[k]) <= kSame * size)) {
            return std::nullopt;
        }
    }
    const double gap = std::remainder(a[6] + a[7] - b[6], 2.0 * std::numbers::pi), sweep = a[7] + b[7];
    if (a[7] * b[7] > 0.0 && std::fabs(gap) <= kSame && std::fabs(sweep) < 2.0 * std::numbers::pi) {
        return Curve::arc({a[0], a[1]}, {a[2], a[3]}, {a[4], a[5]}, a[6], sweep);
    }
    return std::nullopt;
}

/// Points along two curves for a fit, with the fraction of the length as parameter.
struct Samples {
    std::vector<Vec2> points;
    std::vector<double> parameters;

    Samples(const Curve &first, const Curve &second) {
        constexpr int kEach = 24;
        const double lengths[] = {first.length(), second.length()}, whole = lengths[0] + lengths[1];
        double before = 0.0;
        for (const Curve *curve : {&first, &second}) {
            const double own = lengths[curve == &first ? 0 : 1];
            for (int k = 1; k <= kEach; ++k) {
                const double t = static_cast<double>(k) / kEach;
                points.push_back(curve->point(t));
                parameters.push_back((before + curve->length(0.0, t)) / whole);
            }
            before += own;
        }
        points.pop_back(); // the end of both curves
        parameters.pop_back();
    }
};

/// Returns the cubic with given ends and tangents that is nearest to the samples (Schneider, Graphics Gems, 1990).
Curve fitted(const Samples &samples, Vec2 from, Vec2 ahead, Vec2 back, Vec2 to) {
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    for (std::size_t k = 0; k < samples.points.size(); ++k) {
        const double t = samples.parameters[k], s = 1.0 - t;
        const double b0 = s * s * s, b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t, b3 = t * t * t;
        const Vec2 p = b1 * ahead, q = b2 * back;
        const Vec2 rest = samples.points[k] - ((b0 + b1) * from + (b2 + b3) * to);
        c00 += dot(p, p);
        c01 += dot(p, q);
        c11 += dot(q, q);
        x0 += dot(p, rest);
        x1 += dot(q, rest);
    }
    const double determinant = c00 * c11 - c01 * c01;
    const double third = distance(from, to) / 3.0;
    double alpha = third, beta = third;
    if (determinant > 1e-12 * c00 * c11) {
        alpha = (x0 * c11 - x1 * c01) / determinant;
        beta = (x1 * c00 - x0 * c01) / determinant;
    }
    constexpr double kShortest = 1e-3; // a handle in the other direction would make a loop
    alpha = alpha > kShortest * third ? alpha : third;
    beta = beta > kShortest * third ? beta : third;
    return Curve::cubic(from, from + alpha * ahead, to + beta * back, to);
}

} // namespace

Curve moved(const Curve &curve, Vec2 by) {
    const std::array<double, 8> n = curve.numbers();
    const Vec2 first = Vec2{n[0], n[1]} + by;
    switch (curve.kind()) {
    case CurveKind::Arc:
        return withAxes(n, first, {n[2], n[3]}, {n[4], n[5]});
    case CurveKind::Cubic:
        return Curve::cubic(first, Vec2{n[2], n[3]} + by, Vec2{n[4], n[5]} + by, Vec2{n[6], n[7]} + by);
    case CurveKind::Line:
        break;
    }
    return Curve::line(first, Vec2{n[2], n[3]} + by);
}

Curve joining(const Curve &curve, Vec2 from, Vec2 to) {
    const std::array<double, 8> n = curve.numbers();
    const Vec2 start = curve.point(0.0), end = curve.point(1.0);
    switch (curve.kind()) {
    case CurveKind::Cubic:
        return Curve::cubic(from, Vec2{n[2], n[3]} + (from - start), Vec2{n[4], n[5]} + (to - end), to);
    case CurveKind::Arc: {
        const Vec2 chord = end - start;
        const double square = lengthSquared(chord);
        const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
        if (!(square > 1e-24 * (lengthSquared(u) + lengthSquared(v)))) {
            return moved(curve, from - start);
        }
        const Vec2 turn = times(to - from, {chord.x / square, -chord.y / square});
        return withAxes(n, from + times(turn, Vec2{n[0], n[1]} - start), times(turn, u), times(turn, v));
    }
    case CurveKind::Line:
        break;
    }
    return Curve::line(from, to);
}

bool joins(const Curve &curve, Vec2 from, Vec2 to) {
    constexpr double kWritten = 1e-6; // relative to the size; numbers typed by hand or from other programs are rounded
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon(); // relative to the coordinates
    const std::array<double, 8> n = curve.numbers();
    const Vec2 first{n[0], n[1]};
    double size = 0.0, magnitude = 0.0;
    if (curve.kind() == CurveKind::Arc) {
        size = std::max(length({n[2], n[3]}), length({n[4], n[5]}));
        magnitude = length(first) + size;
    } else {
        for (std::size_t k = 0; k < n.size(); k += 2) {
            size = std::max(size, distance({n[k], n[k + 1]}, first));
            magnitude = std::max(magnitude, length({n[k], n[k + 1]}));
        }
    }
    const double tolerance = kWritten * size + kRounding * magnitude;
    return distance(curve.point(0.0), from) <= tolerance && distance(curve.point(1.0), to) <= tolerance;
}

double sectorArea(const Curve &curve, Vec2 from) {
    const Vec2 start = curve.point(0.0) - from, end = curve.point(1.0) - from;
    const std::array<double, 8> n = curve.numbers();
    switch (curve.kind()) {
    case CurveKind::Arc: {
        const Vec2 centre = Vec2{n[0], n[1]} - from;
        return 0.5 * (cross(centre, end - start) + n[7] * cross(Vec2{n[2], n[3]}, Vec2{n[4], n[5]}));
    }
    case CurveKind::Cubic: {
        const Vec2 a = Vec2{n[2], n[3]} - from, b = Vec2{n[4], n[5]} - from;
        return (6.0 * cross(start, a) + 3.0 * cross(start, b) + cross(start, end) + 3.0 * cross(a, b) +
                3.0 * cross(a, end) + 6.0 * cross(b, end)) /
               20.0;
    }
    case CurveKind::Line:
        break;
    }
    return 0.5 * cross(start, end);
}

Curve merged(const Curve &first, const Curve &second) {
    const Vec2 from = first.point(0.0), to = second.point(1.0);
    if (first.kind() == CurveKind::Line && second.kind() == CurveKind::Line) {
        return Curve::line(from, to);
    }
    if (const std::optional<Curve> arc = mergedArc(first, second)) {
        return *arc;
    }
    return fitted(Samples(first, second), from, first.tangent(0.0), -1.0 * second.tangent(1.0), to);
}

Curve cubicAlong(const Curve &arc) {
    const double sweep = arc.numbers()[7];
    const Vec2 from = arc.point(0.0), to = arc.point(1.0);
    if (std::fabs(sweep) > std::numbers::pi) { // the formula below diverges at a full turn
        return fitted(Samples(arc.part(0.0, 0.5), arc.part(0.5, 1.0)), from, arc.tangent(0.0), -1.0 * arc.tangent(1.0),
                      to);
    }
    const double reach = 4.0 / 3.0 * std::tan(0.25 * sweep) / sweep;
    return Curve::cubic(from, from + reach * arc.derivative(0.0), to - reach * arc.derivative(1.0), to);
}

Curve arcThrough(Vec2 from, Vec2 middle, Vec2 to) {
    constexpr double kCollinear = 1e-9;
    const Vec2 p = middle - from, q = to - from;
    const double twice = 2.0 * cross(p, q);
    if (!(std::fabs(twice) > kCollinear * length(p) * length(q))) {
        return Curve::line(from, to);
    }
    const Vec2 offset = (1.0 / twice) * Vec2{q.y * lengthSquared(p) - p.y * lengthSquared(q),
                                             p.x * lengthSquared(q) - q.x * lengthSquared(p)};
    const Vec2 u = -1.0 * offset, end = q - offset;
    const double turn = std::atan2(cross(u, end), dot(u, end));
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double sweep = twice > 0.0 ? (turn > 0.0 ? turn : turn + kTurn) : (turn < 0.0 ? turn : turn - kTurn);
    return Curve::arc(from + offset, u, leftNormal(u), 0.0, sweep);
}

Curve arcOfRadius(Vec2 from, Vec2 to, double radius, Vec2 side) {
    const double half = 0.5 * distance(from, to);
    if (!(half > 0.0) || !(radius > 0.0)) {
        return Curve::line(from, to);
    }
    const Vec2 across = (0.5 / half) * leftNormal(to - from), centre = midpoint(from, to);
    const double height = dot(side - centre, across), reach = std::max(radius, half);
    const double rise = std::sqrt(reach * reach - half * half);
    // The smaller one is reach − rise, which would cancel.
    const double sagitta = std::fabs(height) > half ? reach + rise : half * half / (reach + rise);
    return arcThrough(from, centre + std::copysign(sagitta, height) * across, to);
}

Curve withRadius(const Curve &arc, double radius) {
    const Vec2 from = arc.point(0.0), to = arc.point(1.0), middle = midpoint(from, to);
    const Vec2 bulge = arc.point(0.5) - middle;
    const double chord = distance(from, to), now = radiusOf(arc).value_or(radius);
    constexpr double kRounding = 1e-9;
    if (!(chord > kRounding * now)) { // a loop
        return arc.mapped([&](Vec2 p) { return from + (radius / now) * (p - from); });
    }
    const bool large = length(bulge) > (0.5 + kRounding) * chord;
    // arcOfRadius() takes the large arc for a point that is farther from the chord than half of it.
    const Vec2 side = length(bulge) > 0.0 ? ((large ? 2.0 : 0.25) * chord / length(bulge)) * bulge : Vec2{};
    return arcOfRadius(from, to, radius, middle + side);
}

Curve tangentArc(Vec2 from, Vec2 direction, Vec2 to) {
    const Vec2 chord = to - from, along = (1.0 / length(direction)) * direction, left = leftNormal(along);
    const double reach = length(chord), side = dot(chord, left);
    constexpr double kStraight = 1e-12;
    if (!(std::fabs(side) > kStraight * reach)) {
        return Curve::line(from, to);
    }
    const double radius = 0.5 * reach * reach / side; // signed: positive to the left
    const Vec2 centre = from + radius * left, u = from - centre;
    // The arc turns by twice the angle between the tangent and the chord.
    const double turn = 2.0 * std::atan2(side, dot(chord, along));
    return Curve::arc(centre, u, leftNormal(u), 0.0, turn);
}

std::optional<double> radiusOf(const Curve &curve) {
    const auto numbers = curve.numbers();
    const Vec2 u{numbers[2], numbers[3]}, v{numbers[4], numbers[5]};
    const double radius = length(u), tolerance = 1e-9 * radius;
    const bool round = curve.kind() == CurveKind::Arc && std::fabs(length(v) - radius) <= tolerance &&
                       std::fabs(dot(u, v)) <= tolerance * radius;
    return round ? std::optional(radius) : std::nullopt;
}

} // namespace forefront
