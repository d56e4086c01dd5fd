#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <vector>

namespace forefront {

/// Returns a site for each edge on a periodic part that is clearly shorter than the spacing there, because the other
/// part is divided more finely: the sizes inside must grow from it. `gradation`: growth of the size from them.
std::vector<SizeSite> periodicSites(const DiscreteDomain &boundary, const PeriodicSides &sides,
                                    const SpacingField &spacing, double gradation);

} // namespace forefront
