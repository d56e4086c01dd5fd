#pragma once

#include "core/drawing/colour_outline/region_outlines.hpp"
#include "core/drawing/document/shape.hpp"
#include "core/drawing/shapes/plane_map.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/geometry/curve.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

/// Smooth outlines of a region of pixels, in pixels from the lower left corner of the picture.
struct OutlineFit {
    std::vector<std::vector<Curve>> loops; ///< closed; the one around the region, then its holes
    std::size_t dropped = 0;               ///< holes that are too small for the smoothness

    std::size_t nodes() const;
};

/// Fits curves to outlines that do not cross each other: see fitStroke(). They pass within `smoothness` (> 0, pixels)
/// of the outlines, or closer where they would cross, and neither cross nor touch. Holes with an area of less than
/// (4·smoothness)² are dropped. Empty if there is no outline, or it was cancelled.
OutlineFit fitOutlines(const std::vector<PixelLoop> &outlines, double smoothness, const Progress &progress = {});

/// Returns closed boundaries along the outlines, in the plane. `map`: from pixels to the plane.
std::vector<Shape> boundariesAlong(const OutlineFit &fit, const PlaneMap &map);

} // namespace forefront
