#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <map>

namespace forefront {

/// Adds one site for each segment and constraint point whose tag has a size, raised to `minimum` and growing by at most
/// `gradation` (infinity: no limit). A curve is represented by its chords.
void addPartSizeSites(const Domain &domain, const std::map<std::int32_t, PartSize> &sizes, double minimum,
                      double gradation, SiteSet &sites);

} // namespace forefront
