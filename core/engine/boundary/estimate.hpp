#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

/// Estimates the number of elements that the spacing calls for: ∫ 4/(√3·ρ²) dA over the domain, within about 10 % for
/// ordinary spacings; at least 1. Takes a few milliseconds for any size.
double estimateElements(const DiscreteDomain &domain, const SpacingField &spacing);

} // namespace forefront
