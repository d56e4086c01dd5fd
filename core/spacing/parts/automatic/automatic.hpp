#pragma once

#include "core/base/progress.hpp"
#include "core/domain/domain.hpp"
#include "core/spacing/sites/site_set.hpp"

namespace forefront {

/// Spacing chosen from the domain alone.
struct AutomaticSpacing {
    double greatest = 1.0; ///< nowhere more, from the size of the domain
    SiteSet sites;
};

/// Short segments are respected (they stay in the mesh), long ones are cut so that the domain is about 45 elements
/// across; all of it graded.
AutomaticSpacing automaticSpacing(const Domain &domain, const Box2 &box, double minimum, double gradation,
                                  const Progress &progress = {});

} // namespace forefront
