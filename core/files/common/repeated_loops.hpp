#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Returns, per loop of nodes, 1 if an earlier one has the same nodes within a tolerance (domain units), from whichever
/// node and in whichever direction it was drawn.
std::vector<std::uint8_t> findRepeatedLoops(const std::vector<std::span<const Vec2>> &loops, double tolerance);

} // namespace forefront
