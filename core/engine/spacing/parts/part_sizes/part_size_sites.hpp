#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace forefront {

/// Adds one site for each segment and constraint point whose tag has a size, raised to `minimum` and growing by at most
/// `gradation` (infinity: no limit), except segments with a size in `ofSegments` (see PlacedSizes::segments). A curve
/// is represented by its chords.
void addPartSizeSites(const Domain &domain, const std::map<std::int32_t, PartSize> &sizes,
                      const std::vector<PartSize> &ofSegments, double minimum, double gradation, SiteSet &sites);

/// Adds one site for each segment that has a size of its own, limited in the same way; along one with a bias, sites for
/// its elements, or for groups of them if there are many.
void addSegmentSizeSites(const Domain &domain, const PlacedSizes &placed, double minimum, double gradation,
                         SiteSet &sites);

} // namespace forefront
