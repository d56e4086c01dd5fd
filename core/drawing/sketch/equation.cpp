#include "core/drawing/sketch/equation.hpp"

#include "core/engine/base/vec2.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace forefront {
namespace {

/// A vector with its length and unit vector; the x direction if it has no length, so that a length can grow from 0.
struct Span {
    Vec2 d;
    double length;
    Vec2 unit;

    Span(Vec2 from, Vec2 to)
        : d(to - from), length(forefront::length(d)), unit(length > 0.0 ? (1.0 / length) * d : Vec2{1.0, 0.0}) {}
};

Vec2 leftOf(Vec2 v) {
    return {-v.y, v.x};
}

Vec2 at(const double *values, std::size_t k) {
    return {values[k], values[k + 1]};
}

void put(double *slopes, std::size_t k, Vec2 slope) {
    slopes[k] = slope.x;
    slopes[k + 1] = slope.y;
}

/// The distance of w to the left of a line, with its derivatives by the point and by both ends.
struct LineDistance {
    double distance;
    Vec2 byPoint, byFrom, byTo;

    LineDistance(Vec2 w, Vec2 from, Vec2 to) {
        const Span line(from, to);
        const Vec2 normal = leftOf(line.unit);
        distance = dot(normal, w - from);
        const double foot = line.length > 0.0 ? dot(line.unit, w - from) / line.length : 0.0; // in lengths of the line
        byPoint = normal;
        byFrom = -(1.0 - foot) * normal;
        byTo = -foot * normal;
    }
};

double lineResidual(const SketchEquation &equation, const double *v, double *slopes) {
    const bool tangent = equation.kind == EquationKind::TangentLine;
    const LineDistance line(at(v, 0), at(v, 2), at(v, 4));
    if (slopes != nullptr) {
        put(slopes, 0, line.byPoint);
        put(slopes, 2, line.byFrom);
        put(slopes, 4, line.byTo);
        if (tangent) {
            slopes[6] = -equation.side;
        }
    }
    return line.distance - equation.side * (tangent ? v[6] : equation.value);
}

double distanceResidual(const SketchEquation &equation, const double *v, double *slopes) {
    const Span span(at(v, 0), at(v, 2));
    if (slopes != nullptr) {
        put(slopes, 0, -1.0 * span.unit);
        put(slopes, 2, span.unit);
    }
    switch (equation.kind) {
    case EquationKind::Distance:
        return span.length - equation.value;
    case EquationKind::OnCircle:
        if (slopes != nullptr) {
            slopes[4] = -1.0;
        }
        return span.length - v[4];
    default: // TangentCircles
        if (slopes != nullptr) {
            slopes[4] = -equation.side;
            slopes[5] = -equation.otherSide;
        }
        return span.length - equation.side * v[4] - equation.otherSide * v[5];
    }
}

double equalLengthResidual(const double *v, double *slopes) {
    const Span first(at(v, 0), at(v, 2)), second(at(v, 4), at(v, 6));
    if (slopes != nullptr) {
        put(slopes, 0, -1.0 * first.unit);
        put(slopes, 2, first.unit);
        put(slopes, 4, second.unit);
        put(slopes, 6, -1.0 * second.unit);
    }
    return first.length - second.length;
}

/// The difference of two directions. Products of the vectors would have a false solution, a length of 0, and no slope
/// at a right angle.
double angleResidual(const SketchEquation &equation, const double *v, double *slopes) {
    const Vec2 d = at(v, 2) - at(v, 0), e = at(v, 6) - at(v, 4);
    if (slopes != nullptr) {
        constexpr double kNoLength = 1e-24; // squared, in sizes of the sketch
        const double dd = lengthSquared(d), ee = lengthSquared(e);
        const Vec2 byD = (dd > kNoLength ? 1.0 / dd : 0.0) * leftOf(d);
        const Vec2 byE = (ee > kNoLength ? 1.0 / ee : 0.0) * leftOf(e);
        put(slopes, 0, byD);
        put(slopes, 2, -1.0 * byD);
        put(slopes, 4, -1.0 * byE);
        put(slopes, 6, byE);
    }
    return std::remainder(std::atan2(cross(d, e), dot(d, e)) - equation.value, 2.0 * std::numbers::pi);
}

double mirrorAcrossResidual(const double *v, double *slopes) {
    const LineDistance line(0.5 * (at(v, 0) + at(v, 2)), at(v, 4), at(v, 6));
    if (slopes != nullptr) {
        put(slopes, 0, 0.5 * line.byPoint);
        put(slopes, 2, 0.5 * line.byPoint);
        put(slopes, 4, line.byFrom);
        put(slopes, 6, line.byTo);
    }
    return line.distance;
}

double mirrorAlongResidual(const double *v, double *slopes) {
    const Span line(at(v, 4), at(v, 6));
    const Vec2 between = at(v, 2) - at(v, 0), normal = leftOf(line.unit);
    if (slopes != nullptr) {
        put(slopes, 0, -1.0 * line.unit);
        put(slopes, 2, line.unit);
        const double turn = line.length > 0.0 ? dot(normal, between) / line.length : 0.0;
        put(slopes, 4, -turn * normal);
        put(slopes, 6, turn * normal);
    }
    return dot(line.unit, between);
}

double onEllipseResidual(const double *v, double *slopes) {
    const Vec2 w = at(v, 0) - at(v, 2), u = at(v, 4), z = at(v, 6);
    const double area = cross(u, z), along = cross(w, z) / area, across = cross(u, w) / area; // w = along·u + across·z
    const double reach = length({along, across});
    if (slopes != nullptr) {
        const Vec2 unit = reach > 0.0 ? Vec2{along / reach, across / reach} : Vec2{1.0, 0.0};
        const Vec2 byPoint = (1.0 / area) * Vec2{unit.x * z.y - unit.y * u.y, unit.y * u.x - unit.x * z.x};
        put(slopes, 0, byPoint);
        put(slopes, 2, -1.0 * byPoint);
        put(slopes, 4, -along * byPoint);
        put(slopes, 6, -across * byPoint);
    }
    return reach - 1.0;
}

double tangentEllipseResidual(const SketchEquation &equation, const double *v, double *slopes) {
    const Span line(at(v, 0), at(v, 2));
    const Vec2 w = at(v, 4) - at(v, 0), u = at(v, 6), z = at(v, 8), normal = leftOf(line.unit);
    const double nu = dot(normal, u), nz = dot(normal, z), reach = length({nu, nz});
    if (slopes != nullptr) {
        const Vec2 unit = reach > 0.0 ? Vec2{nu / reach, nz / reach} : Vec2{1.0, 0.0};
        const double turning =
            equation.side * (unit.x * dot(line.unit, u) + unit.y * dot(line.unit, z)) - dot(line.unit, w);
        const Vec2 byTo = (line.length > 0.0 ? turning / line.length : 0.0) * normal;
        put(slopes, 0, -1.0 * (byTo + normal));
        put(slopes, 2, byTo);
        put(slopes, 4, normal);
        put(slopes, 6, -equation.side * unit.x * normal);
        put(slopes, 8, -equation.side * unit.y * normal);
    }
    return dot(normal, w) - equation.side * reach;
}

double onCubicResidual(const double *v, double *slopes) {
    const double t = v[1], s = 1.0 - t;
    const double b0 = s * s * s, b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t, b3 = t * t * t;
    const double x0 = v[2], x1 = x0 + v[3], x3 = v[5], x2 = x3 + v[4];
    if (slopes != nullptr) {
        slopes[0] = 1.0;
        slopes[1] = -3.0 * (s * s * (x1 - x0) + 2.0 * s * t * (x2 - x1) + t * t * (x3 - x2));
        slopes[2] = -b0 - b1;
        slopes[3] = -b1;
        slopes[4] = -b2;
        slopes[5] = -b2 - b3;
    }
    return v[0] - (b0 * x0 + b1 * x1 + b2 * x2 + b3 * x3);
}

/// The residual of an equation that is linear in its unknowns.
double linearResidual(const SketchEquation &equation, const double *v, double *slopes) {
    const auto set = [slopes](std::initializer_list<double> values) {
        if (slopes != nullptr) {
            std::size_t k = 0;
            for (const double value : values) {
                slopes[k++] = value;
            }
        }
    };
    switch (equation.kind) {
    case EquationKind::Value:
        set({1.0});
        return v[0] - equation.value;
    case EquationKind::Equal:
        set({1.0, -1.0});
        return v[0] - v[1];
    case EquationKind::Difference:
        set({-1.0, 1.0});
        return v[1] - v[0] - equation.side * equation.value;
    case EquationKind::Sum:
        set({1.0, -1.0, -1.0});
        return v[0] - v[1] - v[2];
    default: // Mean
        set({1.0, -0.5, -0.5});
        return v[0] - 0.5 * (v[1] + v[2]);
    }
}

SketchEquation made(EquationKind kind, std::initializer_list<std::uint32_t> unknowns, double value = 0.0,
                    double side = 1.0) {
    SketchEquation equation;
    equation.kind = kind;
    std::size_t k = 0;
    for (const std::uint32_t unknown : unknowns) {
        equation.unknowns[k++] = unknown;
    }
    equation.value = value;
    equation.side = side;
    return equation;
}

} // namespace

std::size_t unknownCount(EquationKind kind) {
    constexpr std::array<std::uint8_t, 17> kCounts = {1, 2, 2, 3, 3, 6, 7, 4, 5, 8, 8, 6, 8, 8, 8, 10, 6};
    return kCounts[static_cast<std::size_t>(kind)];
}

std::span<const std::uint32_t> SketchEquation::used() const {
    return std::span(unknowns).first(unknownCount(kind));
}

bool hasLength(EquationKind kind) {
    return kind == EquationKind::Value || kind == EquationKind::Difference || kind == EquationKind::PointLine ||
           kind == EquationKind::Distance;
}

double residualOf(const SketchEquation &equation, const double *values, double *slopes) {
    switch (equation.kind) {
    case EquationKind::Value:
    case EquationKind::Equal:
    case EquationKind::Difference:
    case EquationKind::Sum:
    case EquationKind::Mean:
        return linearResidual(equation, values, slopes);
    case EquationKind::PointLine:
    case EquationKind::TangentLine:
        return lineResidual(equation, values, slopes);
    case EquationKind::Distance:
    case EquationKind::OnCircle:
    case EquationKind::TangentCircles:
        return distanceResidual(equation, values, slopes);
    case EquationKind::EqualLength:
        return equalLengthResidual(values, slopes);
    case EquationKind::Angle:
        return angleResidual(equation, values, slopes);
    case EquationKind::MirrorAcross:
        return mirrorAcrossResidual(values, slopes);
    case EquationKind::MirrorAlong:
        return mirrorAlongResidual(values, slopes);
    case EquationKind::OnEllipse:
        return onEllipseResidual(values, slopes);
    case EquationKind::TangentEllipse:
        return tangentEllipseResidual(equation, values, slopes);
    case EquationKind::OnCubic:
        return onCubicResidual(values, slopes);
    }
    return 0.0;
}

SketchEquation makeValue(std::uint32_t x, double value) {
    return made(EquationKind::Value, {x}, value);
}

SketchEquation makeEqual(std::uint32_t x, std::uint32_t y) {
    return made(EquationKind::Equal, {x, y});
}

SketchEquation makeDifference(std::uint32_t x, std::uint32_t y, double value, double side) {
    return made(EquationKind::Difference, {x, y}, value, side);
}

SketchEquation makeSum(std::uint32_t x, std::uint32_t y, std::uint32_t offset) {
    return made(EquationKind::Sum, {x, y, offset});
}

SketchEquation makeMean(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return made(EquationKind::Mean, {x, y, z});
}

SketchEquation makePointLine(SketchPoint p, SketchPoint a, SketchPoint b, double value, double side) {
    return made(EquationKind::PointLine, {p.x, p.y, a.x, a.y, b.x, b.y}, value, side);
}

SketchEquation makeTangentLine(SketchPoint centre, std::uint32_t radius, SketchPoint a, SketchPoint b, double side) {
    return made(EquationKind::TangentLine, {centre.x, centre.y, a.x, a.y, b.x, b.y, radius}, 0.0, side);
}

SketchEquation makeDistance(SketchPoint p, SketchPoint q, double value) {
    return made(EquationKind::Distance, {p.x, p.y, q.x, q.y}, value);
}

SketchEquation makeOnCircle(SketchPoint p, SketchPoint centre, std::uint32_t radius) {
    return made(EquationKind::OnCircle, {p.x, p.y, centre.x, centre.y, radius});
}

SketchEquation makeEqualLength(SketchPoint a, SketchPoint b, SketchPoint p, SketchPoint q) {
    return made(EquationKind::EqualLength, {a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y});
}

SketchEquation makeAngle(SketchPoint a, SketchPoint b, SketchPoint p, SketchPoint q, double angle) {
    return made(EquationKind::Angle, {a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y}, angle);
}

SketchEquation makeTangentCircles(SketchPoint p, std::uint32_t r, double side, SketchPoint q, std::uint32_t s,
                                  double otherSide) {
    SketchEquation equation = made(EquationKind::TangentCircles, {p.x, p.y, q.x, q.y, r, s}, 0.0, side);
    equation.otherSide = otherSide;
    return equation;
}

SketchEquation makeMirrorAcross(SketchPoint p, SketchPoint q, SketchPoint a, SketchPoint b) {
    return made(EquationKind::MirrorAcross, {p.x, p.y, q.x, q.y, a.x, a.y, b.x, b.y});
}

SketchEquation makeMirrorAlong(SketchPoint p, SketchPoint q, SketchPoint a, SketchPoint b) {
    return made(EquationKind::MirrorAlong, {p.x, p.y, q.x, q.y, a.x, a.y, b.x, b.y});
}

SketchEquation makeOnEllipse(SketchPoint p, SketchPoint centre, SketchPoint u, SketchPoint v) {
    return made(EquationKind::OnEllipse, {p.x, p.y, centre.x, centre.y, u.x, u.y, v.x, v.y});
}

SketchEquation makeTangentEllipse(SketchPoint a, SketchPoint b, SketchPoint centre, SketchPoint u, SketchPoint v,
                                  double side) {
    return made(EquationKind::TangentEllipse, {a.x, a.y, b.x, b.y, centre.x, centre.y, u.x, u.y, v.x, v.y}, 0.0, side);
}

} // namespace forefront
