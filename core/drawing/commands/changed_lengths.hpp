#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>

namespace forefront {

/// Removes the constraints about the whole length of straight segments of a path that a command has shortened or
/// lengthened on purpose: equal lengths, midpoints and length dimensions. They would move other shapes, or undo it.
void dropChangedLengths(const Document &before, Document &next, std::uint32_t shape);

} // namespace forefront
