#pragma once

#include "core/engine/base/vec2.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace forefront {

/// Cap height of the stroke font in its units.
inline constexpr double kCapHeight = 6.0;

/// Returns the width of a text in the stroke font, in its units.
double strokeTextWidth(std::string_view text);

/// Returns the strokes of a text in a plain font of straight lines, in units with y up: the baseline starts at the
/// origin, and capitals are kCapHeight high. The font has ASCII and the symbols of captions (α, δ, ρ, ...); any other
/// character becomes a box.
std::vector<std::array<Vec2, 2>> strokeText(std::string_view text);

} // namespace forefront
