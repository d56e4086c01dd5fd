#pragma once

#include "core/base/progress.hpp"
#include "core/domain/domain.hpp"
#include "core/spacing/sites/site_set.hpp"

namespace forefront {

/// The spacing chosen from the domain alone.
struct AutomaticSpacing {
    double maximum = 1.0; ///< upper bound everywhere, from the size of the domain
    SiteSet sites;
};

/// Chooses a graded spacing that keeps short segments whole and makes the domain about 45 elements across.
AutomaticSpacing automaticSpacing(const Domain &domain, const Box2 &box, double minimum, double gradation,
                                  const Progress &progress = {});

} // namespace forefront
