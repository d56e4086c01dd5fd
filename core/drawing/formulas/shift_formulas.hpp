#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Adds the movement of a shape, size source or region marker to the formulas of its coordinates: "w" becomes "w + 2".
/// The item must have been moved as a whole.
void shiftFormulas(Document &document, NumberOwner owner, Vec2 by);

} // namespace forefront
