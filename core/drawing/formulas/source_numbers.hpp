#pragma once

#include "core/drawing/document/number_address.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <optional>

namespace forefront {

/// Returns a number of a source; none if the source has no such number.
std::optional<double> sourceNumber(const SizeSource &source, Quantity what);

/// Sets a number that the source has; the source may become invalid. Error: bad-number.
Status setSourceNumber(SizeSource &source, Quantity what, double value);

} // namespace forefront
