#pragma once

#include "ui/style/colour.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace forefront::test {

/// Returns the light of a colour, linear in [0, 1].
inline glm::dvec3 lightOf(Colour colour) {
    const glm::dvec3 c = glm::dvec3(colour) / 255.0;
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return {linear(c.r), linear(c.g), linear(c.b)};
}

/// Returns the relative luminance of a colour, as WCAG defines it.
inline double luminance(Colour colour) {
    return glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), lightOf(colour));
}

/// Returns the contrast ratio of two opaque colours, as WCAG defines it.
inline double contrast(Colour a, Colour b) {
    const double u = luminance(a), v = luminance(b);
    return (std::max(u, v) + 0.05) / (std::min(u, v) + 0.05);
}

/// Returns a translucent colour over an opaque one.
inline Colour over(Colour colour, Colour ground) {
    return mix(ground, rgb(static_cast<std::uint32_t>(colour.r << 16 | colour.g << 8 | colour.b)), colour.a / 255.0);
}

/// Returns the light that a person without green-sensitive cones would mix up with that of a colour (G. Machado et al.,
/// 2009, deuteranopia).
inline glm::dvec3 deuteranopic(glm::dvec3 light) {
    const glm::dmat3 rows{
        {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
    return glm::clamp(light * rows, 0.0, 1.0);
}

/// Returns the coordinates of light in CIELAB, for daylight D65.
inline glm::dvec3 labOf(glm::dvec3 light) {
    const glm::dmat3 rows{
        {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}};
    const glm::dvec3 xyz = light * rows / glm::dvec3(0.95047, 1.0, 1.08883);
    const auto f = [](double v) { return v > 216.0 / 24389.0 ? std::cbrt(v) : (24389.0 / 27.0 * v + 16.0) / 116.0; };
    const double x = f(xyz.x), y = f(xyz.y), z = f(xyz.z);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Returns how different two colours look (ΔE of 1976) to the people of that vision who see them less apart: normal, or
/// deuteranopic.
inline double apart(Colour a, Colour b) {
    const glm::dvec3 u = lightOf(a), v = lightOf(b);
    return std::min(glm::distance(labOf(u), labOf(v)), glm::distance(labOf(deuteranopic(u)), labOf(deuteranopic(v))));
}

} // namespace forefront::test
