#pragma once

#include "core/drawing/arrangement/arrangement.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Finds shapes that a larger shape covers completely; under a background, they are most of a drawing. A shape counts
/// if its box, grown by `reach`, lies in the area of one of the 64 largest shapes and meets none of that shape's
/// outlines. So a few covered shapes may be missed. Returns 1 per covered shape; an empty list with several features,
/// because covered shapes may then remain as regions, and with fewer than two shapes.
std::vector<std::uint8_t> findHiddenShapes(const ArrangementInput &input, double reach);

} // namespace forefront
