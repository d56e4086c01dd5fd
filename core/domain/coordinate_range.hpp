#pragma once

#include "core/base/vec2.hpp"

namespace forefront {

/// Beyond it products of areas overflow.
inline constexpr double kGreatestCoordinate = 1e60;
/// Below it they vanish.
inline constexpr double kLeastExtent = 1e-60;
/// Steps of the coordinates' last digit that a domain extends over at least; with fewer there is no room for nodes.
inline constexpr double kLeastSteps = 1e4;

inline bool tooLarge(Vec2 p) {
    return std::max(std::fabs(p.x), std::fabs(p.y)) > kGreatestCoordinate;
}
/// For a box of more than one point.
inline bool tooSmall(const Box2 &box) {
    return !box.empty() && box.min != box.max && std::max(box.size().x, box.size().y) < kLeastExtent;
}
/// Likewise: so far from the origin that few digits of the coordinates tell the nodes apart.
inline bool tooFarAway(const Box2 &box) {
    if (box.empty() || box.min == box.max) {
        return false;
    }
    const double magnitude =
        std::max({std::fabs(box.min.x), std::fabs(box.max.x), std::fabs(box.min.y), std::fabs(box.max.y)});
    return std::max(box.size().x, box.size().y) < kLeastSteps * std::numeric_limits<double>::epsilon() * magnitude;
}

} // namespace forefront
