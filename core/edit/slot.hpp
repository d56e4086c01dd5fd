#pragma once

#include "core/edit/document.hpp"

namespace forefront {

/// Returns the closed path around the line from `a` to `b` at a distance, with half circles at its ends; a circle if
/// both are one point.
Shape slotAround(Vec2 a, Vec2 b, double radius);

/// Returns true for a path with the form of a slot: two parallel sides joined by half circles.
bool isSlot(const Shape &shape);

} // namespace forefront
