#include "ui/canvas/ruler_scale.hpp"

#include "core/drawing/picking/pointer_snap.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {
namespace {

/// Returns the exponent of the power of ten at or below a step of 1, 2 or 5 times such a power.
double exponentOf(double step) {
    return std::floor(std::log10(step) + 1e-9);
}

} // namespace

RulerScale rulerScale(double unitsPerPixel, double minLabel, double minMark) {
    RulerScale scale{gridPitch(unitsPerPixel, minLabel)};
    const int digit = static_cast<int>(std::lround(scale.major / std::pow(10.0, exponentOf(scale.major))));
    // The divisions that give steps of 1, 2 or 5 again.
    static constexpr std::array<int, 4> kOfOne{10, 5, 2, 1}, kOfTwo{10, 4, 2, 1}, kOfFive{10, 5, 1, 1};
    for (const int divisions : digit == 1 ? kOfOne : digit == 2 ? kOfTwo : kOfFive) {
        scale.divisions = divisions;
        if (scale.minor() >= minMark * unitsPerPixel) {
            break;
        }
    }
    return scale;
}

Multiples multiplesWithin(double low, double high, double step) {
    constexpr double kMaxCount = 1e4;
    const double first = std::ceil(low / step), count = std::floor(high / step) - first + 1.0;
    return count >= 1.0 ? Multiples{first, static_cast<int>(std::min(count, kMaxCount))} : Multiples{};
}

std::string rulerText(double value, double major) {
    constexpr int kMaxDecimals = 9;
    constexpr double kMaxPlain = 1e9; // larger numbers are written with an exponent
    const int decimals = std::max(0, -static_cast<int>(exponentOf(major)));
    if (value == 0.0) {
        return "0";
    }
    if (decimals <= kMaxDecimals && std::abs(value) < kMaxPlain) {
        return ui::format("%.*f", decimals, value);
    }
    const double digits = std::ceil(std::log10(std::abs(value) / major) - 1e-9) + 1.0;
    return ui::format("%.*g", static_cast<int>(std::clamp(digits, 1.0, 17.0)), value);
}

} // namespace forefront
