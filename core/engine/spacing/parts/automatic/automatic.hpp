#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

namespace forefront {

/// The spacing chosen from the domain alone.
struct AutomaticSpacing {
    double maximum = 1.0;   ///< upper bound everywhere, from the size of the domain
    double gradation = 0.0; ///< of the sites: the given one, or a gentler one in domains with curves
    SiteSet sites;
};

/// Returns the upper bound of automatic spacing in a domain with this box.
double automaticMaximum(const Box2 &box);

/// Chooses a graded spacing that leaves short segments and curves undivided, makes the domain about 45 elements across,
/// and gives curves `segmentsPerTurn` edges per turn (0: as many as the other rules require). It is finer at sharp
/// corners and lone points, and with `channels` in narrow places, too. Where regions have sizes of up
/// to `largest`, which may exceed the automatic maximum, the rules of the boundary hold for these. Curves with a number
/// of `elements` get no edges per turn.
AutomaticSpacing automaticSpacing(const Domain &domain, const LazyFaces &faces, SegmentElements elements,
                                  const Box2 &box, double minimum, double gradation, double largest,
                                  double segmentsPerTurn, bool channels = true, const Progress &progress = {});

} // namespace forefront
