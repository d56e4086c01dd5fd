#pragma once

#include "core/drawing/document/document.hpp"

#include <string>

namespace forefront {

/// Adds the movement of a shape, size source or region marker to the formulas of its coordinates: "w" becomes "w + 2".
/// The item must have been moved as a whole; `prefix` is that of its addresses, such as "shape/3/".
void shiftFormulas(Document &document, const std::string &prefix, Vec2 by);

} // namespace forefront
