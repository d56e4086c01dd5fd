#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

namespace forefront {

/// Adds sites that put `across` elements between the sides of narrow places, growing by `gradation` beyond them. Places
/// wider than `across` elements of size `longest`, the maximum spacing, need none. Tips of less than 20 degrees are
/// followed down to 1/8 of `longest`, other corners are left alone. Incomplete after a stop request.
void addGapSites(const Domain &domain, const LazyFaces &faces, double across, double longest, double minimum,
                 double gradation, const Progress &progress, SiteSet &sites);

} // namespace forefront
