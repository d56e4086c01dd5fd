#pragma once

#include "core/mesh/quality.hpp"
#include "ui/style/colour_map.hpp"

namespace forefront {

/// Returns the range of α that shows the differences within a mesh: from the histogram bin that holds the worst
/// hundredth of the elements up to 1. A few bad elements do not widen it; they are hatched anyway.
ColourRange fittedQualityRange(const MeshQuality &quality);

} // namespace forefront
