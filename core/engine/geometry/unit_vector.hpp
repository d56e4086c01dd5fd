#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

namespace FOREFRONT_API forefront {

/// Returns the unit vector at an angle in degrees, counter-clockwise from the x axis; exact for multiples of 90.
Vec2 unitVector(double degrees);

} // namespace forefront
