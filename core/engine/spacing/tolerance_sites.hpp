#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

namespace forefront {

class SpacingField;

/// Adds the sites of the curve tolerance: along each curve the size of the longest chord that Domain::curveTolerance
/// allows, raised to `minimum` and growing by `gradation`. Left out are sites that are nowhere finer than `others`, the
/// spacing by all other rules, curves with a number of elements of their own, and bends too small to be seen, which are
/// corners. Incomplete after a stop request.
void addToleranceSites(const Domain &domain, const SpacingField &others, double minimum, double gradation,
                       const Progress &progress, SiteSet &sites);

} // namespace forefront
