#pragma once

#include "core/base/vec2.hpp"

#include <optional>
#include <span>

namespace forefront {

/// y = factor·x^exponent.
struct PowerLaw {
    double factor = 1.0;
    double exponent = 1.0;
    double at(double x) const;
};

/// Least squares on the logarithms; nothing for fewer than two different x or where a coordinate is not positive.
std::optional<PowerLaw> fitPowerLaw(std::span<const Vec2> points);

} // namespace forefront
