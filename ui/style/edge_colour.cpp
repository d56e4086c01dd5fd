#include "ui/style/edge_colour.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

constexpr double kContrast = 3.3;
/// Luminance of a face on which black and white stand out equally.
constexpr double kMiddle = 0.18;
constexpr double kFlare = 0.05; ///< of a screen, as WCAG assumes it

double toLight(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double toChannel(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

} // namespace

Colour edgeOn(Colour face) {
    const glm::dvec4 channels = glm::dvec4(face) / 255.0;
    const double light = glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722),
                                  glm::dvec3(toLight(channels.r), toLight(channels.g), toLight(channels.b)));
    const double wanted =
        light < kMiddle ? kContrast * (light + kFlare) - kFlare : (light + kFlare) / kContrast - kFlare;
    const double grey = 255.0 * toChannel(std::clamp(wanted, 0.0, 1.0));
    return Colour::rounded({grey, grey, grey, 255.0});
}

} // namespace forefront
