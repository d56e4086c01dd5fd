#pragma once

#include "core/drawing/document/shape.hpp"

#include <cstddef>
#include <optional>

namespace forefront {

/// Returns true if a closed shape with straight sides has become its mirror image.
bool isTurnedOver(const Shape &before, const Shape &after);

/// Returns the first segment of a path or rectangle that has lost its length.
std::optional<std::size_t> vanishedSegment(const Shape &before, const Shape &after);

} // namespace forefront
