#include "core/edit/slot.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

Shape slotAround(Vec2 a, Vec2 b, double radius) {
    Shape shape;
    if (a == b) {
        shape.kind = ShapeKind::Circle;
        shape.nodes = {a, a + Vec2{radius, 0.0}};
        return shape;
    }
    const Vec2 along = (radius / distance(a, b)) * (b - a), left = leftNormal(along);
    shape.kind = ShapeKind::Polygon;
    shape.nodes = {a - left, b - left, b + left, a + left};
    shape.curves = {Curve(), Curve::arc(b, -1.0 * left, along, 0.0, std::numbers::pi), Curve(),
                    Curve::arc(a, left, -1.0 * along, 0.0, std::numbers::pi)};
    return shape;
}

bool isSlot(const Shape &shape) {
    if (shape.kind != ShapeKind::Polygon || shape.nodes.size() != 4 || shape.curves.size() != 4) {
        return false;
    }
    constexpr double kSame = 1e-6; // relative: transformed slots keep their form only nearly
    const auto isArc = [&](std::size_t k) { return shape.curves[k].kind() == CurveKind::Arc; };
    const std::size_t first = isArc(0) ? 0 : 1;
    for (const std::size_t k : {first, first + 2}) {
        const Vec2 from = shape.nodes[k], to = shape.nodes[(k + 1) % 4];
        const Vec2 centre = midpoint(from, to), across = to - from;
        const Vec2 opposite = midpoint(shape.nodes[(k + 2) % 4], shape.nodes[(k + 3) % 4]);
        const double radius = 0.5 * length(across), limit = kSame * radius;
        const Vec2 along = (1.0 / distance(centre, opposite)) * (centre - opposite);
        if (!isArc(k) || shape.curves[(k + 1) % 4].kind() != CurveKind::Line ||
            !(std::fabs(dot(along, across)) <= limit) ||
            !(distance(shape.curves[k].point(0.5), centre + radius * along) <= limit) ||
            !(std::fabs(distance(shape.curves[k].point(0.25), centre) - radius) <= limit)) {
            return false;
        }
    }
    return std::fabs(distance(shape.nodes[0], shape.nodes[1]) - distance(shape.nodes[2], shape.nodes[3])) <=
           kSame * distance(shape.nodes[0], shape.nodes[2]);
}

} // namespace forefront
