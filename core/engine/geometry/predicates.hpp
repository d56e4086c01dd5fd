#pragma once

#include "core/engine/base/vec2.hpp"

#include <cmath>
#include <limits>

namespace forefront {

/// Decides the cases that the filter of `orientation` leaves open; call `orientation` instead.
int orientationExact(Vec2 a, Vec2 b, Vec2 c);

/// Returns the exact orientation of the triangle abc: +1 counter-clockwise, 0 collinear, -1 clockwise.
///
/// Correct for all finite doubles, including intermediate overflow and underflow. A floating-point filter decides
/// nearly all calls; the rest are evaluated with expansions (J. R. Shewchuk, Adaptive Precision Floating-Point
/// Arithmetic and Fast Robust Geometric Predicates, 1997), or with big integers where an expansion would overflow or
/// underflow.
inline int orientation(Vec2 a, Vec2 b, Vec2 c) {
    // Shewchuk's bound A, and the smallest normal number in case of underflow; NaN and infinity fail both comparisons.
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

/// Returns +1 if d lies inside the circle through a, b, c (counter-clockwise), 0 on it, -1 outside; the opposite if a,
/// b, c are clockwise. Exact for all finite doubles.
int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Returns true if p lies on the closed segment ab. Exact.
bool onSegment(Vec2 a, Vec2 b, Vec2 p);

/// The ways in which two closed segments can meet.
enum class SegmentMeeting {
    Apart,      ///< no common point
    Crossing,   ///< one common point, interior to both
    Touching,   ///< one common point that is an end of at least one of them, and not an end of both
    SharedEnd,  ///< one common point, an end of both
    Overlapping ///< infinitely many common points
};
/// Returns how the segments ab and cd meet. Exact.
SegmentMeeting meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

} // namespace forefront
