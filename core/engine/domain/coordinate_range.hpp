#pragma once

#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forefront {

/// Maximum magnitude of a coordinate; beyond it, products of areas overflow.
inline constexpr double kMaxCoordinate = 1e60;
/// Minimum extent of a domain; below it, products of areas underflow.
inline constexpr double kMinExtent = 1e-60;
/// Minimum extent in units of the last place of the coordinates; below it there is no room for nodes.
inline constexpr double kMinSteps = 1e4;

/// Returns true if a coordinate is beyond the maximum.
inline bool tooLarge(Vec2 p) {
    return std::max(std::fabs(p.x), std::fabs(p.y)) > kMaxCoordinate;
}
/// Returns true if a box of more than one point is below the minimum extent.
inline bool tooSmall(const Box2 &box) {
    return !box.empty() && box.min != box.max && std::max(box.size().x, box.size().y) < kMinExtent;
}
/// Returns true if a box is so far from the origin that its nodes differ only in the last digits of their coordinates.
inline bool tooFarAway(const Box2 &box) {
    if (box.empty() || box.min == box.max) {
        return false;
    }
    const double magnitude =
        std::max({std::fabs(box.min.x), std::fabs(box.max.x), std::fabs(box.min.y), std::fabs(box.max.y)});
    return std::max(box.size().x, box.size().y) < kMinSteps * std::numeric_limits<double>::epsilon() * magnitude;
}

} // namespace forefront
