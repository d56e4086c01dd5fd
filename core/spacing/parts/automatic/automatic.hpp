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

/// Chooses a graded spacing that keeps short segments and curves whole, makes the domain about 45 elements across, and
/// gives curves `segmentsPerTurn` edges a turn (0: as many as the rest asks for).
AutomaticSpacing automaticSpacing(const Domain &domain, const Box2 &box, double minimum, double gradation,
                                  double segmentsPerTurn, const Progress &progress = {});

} // namespace forefront
