#include "core/engine/geometry/unit_vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace forefront {

Vec2 unitVector(double degrees) {
    const double turn = std::fmod(degrees, 360.0), quarters = turn / 90.0;
    if (quarters == std::floor(quarters)) {
        constexpr std::array<Vec2, 4> kAxes = {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
        return kAxes[static_cast<std::size_t>(static_cast<int>(quarters) + 4) % 4];
    }
    const double angle = turn * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

} // namespace forefront
