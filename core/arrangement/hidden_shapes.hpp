#pragma once

#include "core/arrangement/arrangement.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns, per shape, whether it certainly lies within another one, at least `reach` from its outlines, so that
/// nothing of it is left: its box is in the area of one of the largest other shapes. Such shapes need not be arranged;
/// under a background, they are most of a drawing. Empty if there is more than one feature, which could show between
/// two shapes.
std::vector<std::uint8_t> findHiddenShapes(const ArrangementInput &input, double reach);

} // namespace forefront
