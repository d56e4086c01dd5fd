#include "core/edit/slot.hpp"

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

} // namespace forefront
