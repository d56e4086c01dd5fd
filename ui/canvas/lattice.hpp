#pragma once

#include "ui/canvas/camera.hpp"

#include <cmath>

namespace forefront {

/// Returns the pitch of the drawing lattice at the zoom of a camera: 1, 2 or 5 times a power of ten, at least 18 design
/// pixels on the screen. Every fifth line is a main line.
inline double latticePitch(const Camera &camera, double scale) {
    const double minPitch = camera.length(18.0 * scale);
    const double power = std::pow(10.0, std::floor(std::log10(minPitch)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= minPitch) {
            return digit * power;
        }
    }
    return 10.0 * power;
}

} // namespace forefront
