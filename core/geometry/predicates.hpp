#pragma once

#include "core/base/vec2.hpp"

#include <cmath>
#include <limits>

namespace forefront {

/// The evaluation behind the filter; call `orientation`.
int orientationExact(Vec2 a, Vec2 b, Vec2 c);

/// Exact sign (-1, 0, +1) of the orientation of the triangle abc: +1 counter-clockwise, 0 collinear.
/// Correct for all finite doubles, whatever overflows or underflows on the way. A floating-point filter answers nearly
/// all calls; the rest are evaluated with expansions (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and
/// Fast Robust Geometric Predicates, 1997), and with big integers where an expansion would leave the range of doubles.
inline int orientation(Vec2 a, Vec2 b, Vec2 c) {
    // Shewchuk's bound A, and the least normal number for what underflows; NaN and infinity fail both comparisons.
    constexpr double kRelative =
        (3.0 + 8.0 * std::numeric_limits<double>::epsilon()) * 0.5 * std::numeric_limits<double>::epsilon();
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    const double bound = kRelative * (std::fabs(left) + std::fabs(right)) + std::numeric_limits<double>::min();
    if (determinant > bound) {
        return 1;
    }
    if (determinant < -bound) {
        return -1;
    }
    return orientationExact(a, b, c);
}

/// Exact sign: +1 if d lies inside the circle through a, b, c (counter-clockwise), 0 on it, -1 outside. With a, b, c
/// clockwise the sign is opposite. Correct for all finite doubles.
int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// True if p lies on the closed segment ab (exact).
bool onSegment(Vec2 a, Vec2 b, Vec2 p);

/// How two closed segments meet (exact).
enum class SegmentMeeting {
    Apart,      ///< no common point
    Crossing,   ///< one common point, interior to both
    Touching,   ///< one common point that is an end of at least one of them, and not an end of both
    SharedEnd,  ///< one common point, an end of both
    Overlapping ///< infinitely many common points
};
SegmentMeeting meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

} // namespace forefront
