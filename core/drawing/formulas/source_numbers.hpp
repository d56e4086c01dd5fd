#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <optional>
#include <string>

namespace forefront {

// The numbers of a size source by the names that their addresses use; see NumberAddress.

/// Returns a number of a source; none if the source has no such number.
std::optional<double> sourceNumber(const SizeSource &source, const std::string &name);

/// Sets a number that the source has; the source may become invalid. Error: bad-number.
Status setSourceNumber(SizeSource &source, const std::string &name, double value);

} // namespace forefront
