#pragma once

#include "core/geometry/vec2.hpp"

namespace forefront {

/// Exact sign (-1, 0, +1) of the orientation of the triangle abc: +1 counter-clockwise, 0 collinear.
/// Correct for all finite doubles. A floating-point filter answers nearly all calls; the rest are evaluated with
/// expansions (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
/// 1997).
int orientation(Vec2 a, Vec2 b, Vec2 c);

/// Exact sign: +1 if d lies inside the circle through a, b, c (counter-clockwise), 0 on it, -1 outside.
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
