#pragma once

#include "core/spacing/sites/site_set.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

#include <span>

namespace forefront {

/// Adds one site per size source that is neither graded nor a box, raised to `minimum` and growing by at most
/// `gradation` (infinity: no limit).
void addSourceSites(std::span<const SizeSource> sources, double minimum, double gradation, SiteSet &sites);

} // namespace forefront
