#pragma once

#include "core/drawing/document/number_address.hpp"
#include "core/drawing/document/shape.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <optional>

namespace forefront {

/// Returns a number of a shape; none if it has no such number.
std::optional<double> shapeNumber(const Shape &shape, const NumberAddress &address);

/// Sets a number that the shape has; the shape may become degenerate. Error: bad-number.
Status setShapeNumber(Shape &shape, const NumberAddress &address, double value);

/// Returns a value as a number of elements. Error: bad-number, unless it is a whole number from 1 to kMaxElementCount.
Result<std::uint32_t> elementsFrom(double value);

} // namespace forefront
