#pragma once

#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <span>

namespace forefront {

/// Adds one site per size source that is neither graded nor a box, raised to `minimum` and growing by at most
/// `gradation` (infinity: no limit).
void addSourceSites(std::span<const SizeSource> sources, double minimum, double gradation, SiteSet &sites);

} // namespace forefront
