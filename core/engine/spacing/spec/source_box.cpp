#include "core/engine/spacing/spec/source_box.hpp"

#include "core/engine/geometry/unit_vector.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

/// Returns the point whose coordinate along a direction is that of `first`, and across it that of `second`.
Vec2 between(Vec2 first, Vec2 second, Vec2 along) {
    if (along.y == 0.0) {
        return {first.x, second.y};
    }
    const Vec2 across = leftNormal(along);
    return first + dot(second - first, across) * across;
}

} // namespace

SourceBox::SourceBox(const SizeSource &source) : along_(unitVector(boxAngle(source.angle))) {
    const Vec2 diagonal = source.b - source.a;
    corners_ = {source.a, between(source.b, source.a, along_), source.b, between(source.a, source.b, along_)};
    half_ = 0.5 * Vec2{std::fabs(dot(diagonal, along_)), std::fabs(cross(along_, diagonal))};
}

double SourceBox::distanceTo(Vec2 p) const {
    const Vec2 d = p - centre();
    return std::hypot(std::max(0.0, std::fabs(dot(d, along_)) - half_.x),
                      std::max(0.0, std::fabs(cross(along_, d)) - half_.y));
}

void moveCorner(SizeSource &source, std::size_t corner, Vec2 to) {
    if (corner % 2 == 0) {
        (corner == 0 ? source.a : source.b) = to;
        return;
    }
    const Vec2 along = unitVector(boxAngle(source.angle)), fixed = SourceBox(source).corners()[4 - corner];
    const Vec2 first = between(fixed, to, along), second = between(to, fixed, along);
    source.a = corner == 1 ? first : second;
    source.b = corner == 1 ? second : first;
}

Vec2 boxExtent(const SizeSource &source) {
    const Vec2 along = unitVector(source.angle), diagonal = source.b - source.a;
    return {std::fabs(dot(diagonal, along)), std::fabs(cross(along, diagonal))};
}

void resizeBox(SizeSource &source, Vec2 extent) {
    const Vec2 along = unitVector(source.angle), diagonal = source.b - source.a;
    source.b = source.a + std::copysign(extent.x, dot(diagonal, along)) * along +
               std::copysign(extent.y, cross(along, diagonal)) * leftNormal(along);
}

void turnBox(SizeSource &source, double degrees) {
    const Vec2 turn = unitVector(degrees - source.angle), centre = midpoint(source.a, source.b);
    for (Vec2 *const corner : {&source.a, &source.b}) {
        const Vec2 arm = *corner - centre;
        *corner = centre + arm.x * turn + arm.y * leftNormal(turn);
    }
    source.angle = degrees;
}

double boxAngle(double degrees) {
    const double turn = std::remainder(degrees, 90.0); // in [-45, 45]
    return turn == -45.0 ? 45.0 : turn;
}

} // namespace forefront
