#pragma once

#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <cstdint>

namespace forefront {

namespace morton {

/// Interleaves the lower 16 bits with zeros.
constexpr std::uint32_t spread(std::uint32_t v) {
    v = (v | (v << 8)) & 0x00ff00ffU;
    v = (v | (v << 4)) & 0x0f0f0f0fU;
    v = (v | (v << 2)) & 0x33333333U;
    return (v | (v << 1)) & 0x55555555U;
}

/// Returns the position of the middle of [low, high] within the whole range, in 0..65535. Uses halves and quarters, so
/// that nothing overflows.
inline std::uint32_t step(double low, double high, double wholeLow, double wholeHigh) {
    const double extent = 0.5 * wholeHigh - 0.5 * wholeLow;
    const double part = extent > 0.0 ? (0.25 * low + 0.25 * high - 0.5 * wholeLow) / extent : 0.0;
    return part >= 0.0 ? static_cast<std::uint32_t>(std::min(part, 1.0) * 65535.0) : 0U; // a NaN goes to 0
}

} // namespace morton

/// Returns the number of the cell that holds the middle of a box, on a Morton curve through the 2³² cells of the whole
/// box: nearby numbers are nearby cells.
inline std::uint32_t mortonCode(const Box2 &box, const Box2 &whole) {
    return morton::spread(morton::step(box.min.x, box.max.x, whole.min.x, whole.max.x)) |
           morton::spread(morton::step(box.min.y, box.max.y, whole.min.y, whole.max.y)) << 1;
}

} // namespace forefront
