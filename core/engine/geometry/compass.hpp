#pragma once

#include "core/engine/base/vec2.hpp"

#include <array>
#include <numbers>

namespace forefront {

/// The eight unit vectors at multiples of 45 degrees, counter-clockwise from the x axis: the directions of a pattern
/// search for a better place of a node.
inline constexpr std::array<Vec2, 8> kCompass = {{{1, 0},
                                                  {0.5 * std::numbers::sqrt2, 0.5 * std::numbers::sqrt2},
                                                  {0, 1},
                                                  {-0.5 * std::numbers::sqrt2, 0.5 * std::numbers::sqrt2},
                                                  {-1, 0},
                                                  {-0.5 * std::numbers::sqrt2, -0.5 * std::numbers::sqrt2},
                                                  {0, -1},
                                                  {0.5 * std::numbers::sqrt2, -0.5 * std::numbers::sqrt2}}};

} // namespace forefront
