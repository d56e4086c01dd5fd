#pragma once

#include "core/base/diagnostic.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

namespace forefront {

/// All faults of the numbers in a specification at once. Codes: bad-size (size, limits, gradation), bad-source,
/// bad-paint, bad-background; sources and elements by index in `ids`, with a place where there is one.
Diagnostics checkSpec(const SpacingSpec &spec);

} // namespace forefront
