#pragma once

#include "core/boundary/discretise.hpp"
#include "core/spacing/spacing_field.hpp"

namespace forefront {

/// About how many elements the node spacing asks for: ∫ 4/(√3·ρ²) dA over the domain, within some 10 % on ordinary
/// spacings; at least 1. Takes some milliseconds whatever the size.
double estimateElements(const DiscreteDomain &domain, const SpacingField &spacing);

} // namespace forefront
