#include "core/engine/geometry/polygon.hpp"

#include "core/engine/geometry/predicates.hpp"

namespace forefront {

double signedArea(std::span<const Vec2> polygon) {
    if (polygon.size() < 3) {
        return 0.0;
    }
    const Vec2 origin = polygon[0];
    CompensatedSum twice;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - origin, b = polygon[i + 1] - origin;
        twice.add(cross(a, b));
    }
    return 0.5 * twice.value();
}

double perimeter(std::span<const Vec2> polygon) {
    CompensatedSum sum;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        sum.add(distance(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]));
    }
    return sum.value();
}

PointPlace locate(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const bool upward = a.y <= p.y && b.y > p.y, downward = b.y <= p.y && a.y > p.y;
        if (upward || downward) {
            const int side = orientation(a, b, p);
            if (side == 0) {
                return PointPlace::OnBoundary;
            }
            if ((side > 0) == upward) { // the ray to the right meets the edge
                inside = !inside;
            }
        } else if (onSegment(a, b, p)) {
            return PointPlace::OnBoundary;
        }
    }
    return inside ? PointPlace::Inside : PointPlace::Outside;
}

double distanceToSegment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 along = b - a;
    const double square = lengthSquared(along);
    const double t = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return distance(p, lerp(a, b, t));
}

} // namespace forefront
