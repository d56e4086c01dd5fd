#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

#include <functional>
#include <span>

namespace forefront {

/// Fills in the size at each of many positions.
using SizesAt = std::function<void(std::span<const Vec2>, std::span<double>)>;

/// Adds the places from which a spacing grows by `gradation` because it is steeper. They are found on a grid that is
/// refined to a fraction of the spacing, so the limited spacing is within about 2 % of exact.
void addSteepSites(const SizesAt &rho, const SiteLabel &label, const Box2 &box, double gradation, SiteSet &sites,
                   const Progress &progress);

} // namespace forefront
