#pragma once

#include "core/drawing/shapes/references.hpp"
#include "ui/panels/form.hpp"

#include <cstdint>

namespace forefront {

struct Shell;

/// Returns the addresses of the coordinates of a handle of a shape.
form::PairAddress handleAddress(const Shape &shape, std::uint32_t handle);

/// Draws the rows of the inspector for the numbers of a shape.
void geometryRows(Shell &context, const Shape &shape);

/// Draws the rows of the inspector for the length and the area of a shape; a point has none.
void extentRows(Shell &context, const Shape &shape);

/// Draws the row of the inspector for the width of a slot.
void slotWidthRow(Shell &context, const Shape &slot);

/// Draws the rows of the inspector for the length and radius of a segment.
void segmentRows(Shell &context, const Shape &shape, SegmentRef ref);

} // namespace forefront
