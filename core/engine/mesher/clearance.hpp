#pragma once

#include "core/engine/geometry/predicates.hpp"

namespace forefront {

/// Returns true if p is nearer to the segment ab than the square root of `distance2`. Does not divide.
inline bool nearSegment(Vec2 p, Vec2 a, Vec2 b, double distance2) {
    const Vec2 d = b - a;
    const Vec2 q = p - a;
    const double along = dot(q, d);
    const double length2 = lengthSquared(d);
    if (along <= 0.0) {
        return lengthSquared(q) < distance2;
    }
    if (along >= length2) {
        return distanceSquared(p, b) < distance2;
    }
    const double side = cross(d, q);
    return side * side < distance2 * length2;
}

/// Returns true if the closed segments pq and ab have a common point (exact). a may equal b; the boxes of the segments
/// must overlap.
inline bool segmentsMeet(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
    const int a1 = orientation(p, q, a);
    const int b1 = orientation(p, q, b);
    if (a1 * b1 > 0) {
        return false;
    }
    const int p1 = orientation(a, b, p);
    const int q1 = orientation(a, b, q);
    if (p1 * q1 > 0) {
        return false;
    }
    // Each meets the line of the other. Collinear segments meet since their boxes overlap.
    return true;
}

/// Returns true if p lies in or on the triangle abc (exact).
inline bool insideOrOn(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
    return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

} // namespace forefront
