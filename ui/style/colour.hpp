#pragma once

#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace forefront {

/// A colour with straight alpha, 8 bits per channel. Converts to the packed form of Dear ImGui, red in the lowest byte.
/// Transparent black by default.
struct Colour : glm::u8vec4 {
    constexpr Colour() : glm::u8vec4(0, 0, 0, 0) {}
    constexpr Colour(const glm::u8vec4 &channels) : glm::u8vec4(channels) {}
    /// Rounds channels in [0, 255] to the nearest integers.
    static constexpr Colour rounded(const glm::dvec4 &channels) { return glm::u8vec4(channels + 0.5); }

    operator std::uint32_t() const { return glm::packUint4x8(*this); }
    /// Returns the channels in [0, 1], as OpenGL expects them.
    glm::vec4 channels() const { return glm::vec4(*this) / 255.0F; }
};
static_assert(sizeof(Colour) == 4, "arrays of colours are uploaded to the GPU");

/// Returns a colour given as 0xRRGGBB and an opacity in [0, 1].
constexpr Colour rgb(std::uint32_t hex, double alpha = 1.0) {
    return Colour::rounded({(hex >> 16) & 0xffU, (hex >> 8) & 0xffU, hex & 0xffU, alpha * 255.0});
}

/// Multiplies the opacity of a colour by `alpha`.
inline Colour fade(const Colour &colour, double alpha) {
    return Colour::rounded(glm::min(glm::dvec4(colour) * glm::dvec4(1.0, 1.0, 1.0, alpha), 255.0));
}

/// Interpolates channel by channel from a at t = 0 to b at t = 1.
inline Colour mix(const Colour &a, const Colour &b, double t) {
    const glm::dvec4 from(a), to(b);
    return Colour::rounded(from + t * (to - from));
}

} // namespace forefront
