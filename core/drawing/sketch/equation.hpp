#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// The role of an unknown of a sketch, which says how it is scaled.
enum class UnknownKind : std::uint8_t {
    X,        ///< of a point
    Y,        ///< of a point
    Length,   ///< such as a radius
    Offset,   ///< a component of a vector, such as a semi-axis of an ellipse or the handle of a Bézier curve
    Parameter ///< of a point on a curve; has no unit
};

/// A point of a sketch: the indices of its unknowns. Points may share unknowns, as the corners of a rectangle do.
struct SketchPoint {
    std::uint32_t x = 0;
    std::uint32_t y = 0;

    friend bool operator==(const SketchPoint &, const SketchPoint &) = default;
};

/// The form of an equation of a sketch. After each, its unknowns in order; p, q, a, b, c are points, u, v vectors.
enum class EquationKind : std::uint8_t {
    Value,          ///< x: x = value
    Equal,          ///< x, y: x = y
    Difference,     ///< x, y: y - x = side·value
    Sum,            ///< x, y, u: x = y + u, where u is an offset
    Mean,           ///< x, y, z: x = (y + z)/2
    PointLine,      ///< p, a, b: distance of p to the left of the line ab = side·value
    TangentLine,    ///< c, a, b, r: distance of c to the left of the line ab = side·r
    Distance,       ///< p, q: |pq| = value
    OnCircle,       ///< p, c, r: |pc| = r
    EqualLength,    ///< a, b, p, q: |ab| = |pq|
    Angle,          ///< a, b, p, q: angle from ab to pq = value, modulo a turn
    TangentCircles, ///< p, q, r, s: |pq| = side·r + otherSide·s
    MirrorAcross,   ///< p, q, a, b: the middle of pq lies on the line ab
    MirrorAlong,    ///< p, q, a, b: pq is perpendicular to ab
    OnEllipse,      ///< p, c, u, v: p lies on the ellipse about c with the conjugate semi-axes u and v
    TangentEllipse, ///< a, b, c, u, v: the ellipse touches the line ab and lies to its left if side = 1
    OnCubic         ///< x, t, x0, u0, u3, x3: a coordinate of the point at t of a cubic, whose handles are offsets
};

/// Maximum number of unknowns of an equation.
inline constexpr std::size_t kEquationUnknowns = 10;

/// One equation of a sketch. Which of several solutions is meant (side of a line, inside or outside, direction) is
/// stored in it, so that solving keeps it: with equations that leave it open, every sixth sketch flips a corner.
struct SketchEquation {
    EquationKind kind = EquationKind::Value;
    std::array<std::uint32_t, kEquationUnknowns> unknowns{}; ///< the first unknownCount(kind) are used
    double value = 0.0;                                      ///< a length, coordinate or angle in radians
    double side = 1.0;                                       ///< 1 or -1
    double otherSide = 1.0;                                  ///< 1 or -1
    std::uint32_t constraint = 0; ///< id of the constraint it belongs to; 0: the form of a shape

    std::span<const std::uint32_t> used() const;
};

/// Returns the number of unknowns of an equation.
std::size_t unknownCount(EquationKind kind);
/// Returns true if the value of an equation is a length or a coordinate, which scales with the sketch.
bool hasLength(EquationKind kind);

/// Returns the residual of an equation, 0 where it holds. `values` are those of its unknowns, in order; `slopes`, if
/// not null, becomes the derivative by each. Angles are in radians, so that rows compare in a sketch of size 1. A line
/// without length has a residual, but no direction.
double residualOf(const SketchEquation &equation, const double *values, double *slopes);

/// Makes equations; see EquationKind.
SketchEquation makeValue(std::uint32_t x, double value);
SketchEquation makeEqual(std::uint32_t x, std::uint32_t y);
SketchEquation makeDifference(std::uint32_t x, std::uint32_t y, double value, double side);
SketchEquation makeSum(std::uint32_t x, std::uint32_t y, std::uint32_t offset);
SketchEquation makeMean(std::uint32_t x, std::uint32_t y, std::uint32_t z);
SketchEquation makePointLine(SketchPoint p, SketchPoint a, SketchPoint b, double value, double side);
SketchEquation makeTangentLine(SketchPoint centre, std::uint32_t radius, SketchPoint a, SketchPoint b, double side);
SketchEquation makeDistance(SketchPoint p, SketchPoint q, double value);
SketchEquation makeOnCircle(SketchPoint p, SketchPoint centre, std::uint32_t radius);
SketchEquation makeEqualLength(SketchPoint a, SketchPoint b, SketchPoint p, SketchPoint q);
SketchEquation makeAngle(SketchPoint a, SketchPoint b, SketchPoint p, SketchPoint q, double angle);
SketchEquation makeTangentCircles(SketchPoint p, std::uint32_t r, double side, SketchPoint q, std::uint32_t s,
                                  double otherSide);
SketchEquation makeMirrorAcross(SketchPoint p, SketchPoint q, SketchPoint a, SketchPoint b);
SketchEquation makeMirrorAlong(SketchPoint p, SketchPoint q, SketchPoint a, SketchPoint b);
SketchEquation makeOnEllipse(SketchPoint p, SketchPoint centre, SketchPoint u, SketchPoint v);
SketchEquation makeTangentEllipse(SketchPoint a, SketchPoint b, SketchPoint centre, SketchPoint u, SketchPoint v,
                                  double side);

} // namespace forefront
