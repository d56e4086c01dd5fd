#include "core/drawing/shapes/plane_map.hpp"

#include <cmath>
#include <numbers>

namespace forefront {
namespace {

/// Returns the map with given images of the axes that leaves a point where it is.
PlaneMap fixing(Vec2 u, Vec2 v, Vec2 point) {
    return {u, v, point - (point.x * u + point.y * v)};
}

} // namespace

PlaneMap PlaneMap::rotation(double degrees, Vec2 about) {
    if (!std::isfinite(degrees)) {
        return {{degrees, degrees}, {degrees, degrees}, about};
    }
    const Vec2 u = unitVector(degrees);
    return fixing(u, leftNormal(u), about);
}

PlaneMap PlaneMap::scaling(Vec2 factors, Vec2 about) {
    return fixing({factors.x, 0.0}, {0.0, factors.y}, about);
}

PlaneMap PlaneMap::reflection(double degrees, Vec2 through) {
    const PlaneMap back = rotation(2.0 * degrees, {});
    return fixing(back.u, {-back.v.x, -back.v.y}, through);
}

PlaneMap PlaneMap::after(const PlaneMap &first) const {
    const auto turned = [this](Vec2 p) { return p.x * u + p.y * v; };
    return {turned(first.u), turned(first.v), (*this)(first.shift)};
}

bool PlaneMap::isSimilarity() const {
    constexpr double kRounding = 1e-12;
    const double size = lengthSquared(u) + lengthSquared(v);
    return std::fabs(dot(u, v)) <= kRounding * size &&
           std::fabs(lengthSquared(u) - lengthSquared(v)) <= kRounding * size;
}

} // namespace forefront
