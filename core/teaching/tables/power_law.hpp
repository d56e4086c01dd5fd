#pragma once

#include "core/engine/base/vec2.hpp"

#include <optional>
#include <span>

namespace forefront {

/// y = factor·x^exponent.
struct PowerLaw {
    double factor = 1.0;
    double exponent = 1.0;
    double at(double x) const;
};

/// Fits by least squares on the logarithms. Returns std::nullopt for fewer than two different x or a coordinate <= 0.
std::optional<PowerLaw> fitPowerLaw(std::span<const Vec2> points);

} // namespace forefront
