#pragma once

#include <algorithm>
#include <cstdint>

namespace forefront {

/// A colour with straight alpha, packed as in Dear ImGui: red in the lowest byte.
using Colour = std::uint32_t;

/// Rounds a channel in [0, 255] to the nearest integer. std::lround is not constexpr before C++23.
constexpr std::uint32_t roundChannel(double value) {
    return static_cast<std::uint32_t>(value + 0.5); // NOLINT(bugprone-incorrect-roundings): never negative
}

/// Packs a colour given as 0xRRGGBB and an opacity in [0, 1].
constexpr Colour rgb(std::uint32_t hex, double alpha = 1.0) {
    const auto a = roundChannel(alpha * 255.0);
    return ((hex >> 16) & 0xffU) | (hex & 0xff00U) | ((hex & 0xffU) << 16) | (a << 24);
}

/// Multiplies the opacity of a colour by `alpha`.
constexpr Colour fade(Colour colour, double alpha) {
    const auto a = roundChannel(static_cast<double>(colour >> 24) * alpha);
    return (colour & 0x00ffffffU) | (std::min<std::uint32_t>(a, 255U) << 24);
}

/// Interpolates channel by channel from a at t = 0 to b at t = 1.
constexpr Colour mix(Colour a, Colour b, double t) {
    Colour result = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const double u = (a >> shift) & 0xffU, v = (b >> shift) & 0xffU;
        result |= roundChannel(u + (v - u) * t) << shift;
    }
    return result;
}

} // namespace forefront
