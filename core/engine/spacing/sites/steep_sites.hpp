#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/domain/inside_test.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

#include <functional>
#include <span>

namespace forefront {

/// Fills in the size at each of many positions.
using SizesAt = std::function<void(std::span<const Vec2>, std::span<double>)>;

/// Where steep slopes are looked for.
struct SteepSearch {
    Box2 box;
    const InsideTest *inside = nullptr; ///< only there; null: in all of the box
    double gradation = 1.0;             ///< slopes above it are steep
    bool thorough = true;               ///< false: features finer than 1/1000 of the box are not searched for
};

/// Adds the places inside the domain from which a spacing grows by the gradation because it is steeper. They are found
/// on a grid that is refined to a fraction of the spacing, so that a thoroughly searched one is within about 2 % of
/// exact.
void addSteepSites(const SizesAt &rho, const SiteLabel &label, const SteepSearch &search, SiteSet &sites,
                   const Progress &progress);

} // namespace forefront
