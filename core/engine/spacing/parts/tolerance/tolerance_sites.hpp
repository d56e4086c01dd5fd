#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

#include <functional>

namespace forefront {

/// The spacing by all other rules.
struct OtherSizes {
    std::function<double(Vec2)> at;
    double largest = 0.0; ///< its maximum over the domain's box
};

/// Adds the sites of the curve tolerance: along each curve the size of the longest chord that Domain::curveTolerance
/// allows, raised to `minimum` and growing by `gradation`. Left out are sites that are nowhere finer than `others`, the
/// spacing by all other rules, curves with a number of `elements`, and bends too small to be seen, which are
/// corners. Incomplete after a stop request.
void addToleranceSites(const Domain &domain, SegmentElements elements, const OtherSizes &others, double minimum,
                       double gradation, const Progress &progress, SiteSet &sites);

} // namespace forefront
