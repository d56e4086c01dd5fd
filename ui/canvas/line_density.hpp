#pragma once

#include <algorithm>

namespace forefront {

/// Returns the width of lines that are `apart` pixels from each other: at most a twelfth of that, at least 0.75 pixels,
/// never more than `widest`. Dense lines then leave their background visible, whatever the scale of the interface.
inline double densityWidth(double apart, double widest) {
    constexpr double kShare = 1.0 / 12.0, kThinnest = 0.75;
    return std::clamp(kShare * apart, std::min(kThinnest, widest), widest);
}

} // namespace forefront
