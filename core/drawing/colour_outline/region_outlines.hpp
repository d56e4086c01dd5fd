#pragma once

#include "core/drawing/colour_outline/colour_region.hpp"
#include "core/engine/base/vec2.hpp"

#include <vector>

namespace forefront {

/// A closed line around a region of pixels or a hole in it, in pixels from the lower left corner of the picture.
using PixelLoop = std::vector<Vec2>;

/// Returns the outlines of a region: first the one around it, counter-clockwise, then those of its holes, clockwise, in
/// the order of their topmost pixels. They run through the middles of the sides between pixels inside and outside, so
/// that they have no steps of whole pixels, and neither cross nor touch. Holes are connected also by corners. Empty if
/// cancelled.
std::vector<PixelLoop> outlinesOf(const ColourRegion &region, const Progress &progress = {});

} // namespace forefront
