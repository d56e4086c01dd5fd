#pragma once

#include "core/engine/boundary/discretise.hpp"

namespace forefront::testing {

/// Checks that the discrete domain is simple and that each side of a segment has the region given by the faces of the
/// segments.
void checkRegions(const Domain &domain, const DiscreteDomain &discrete);

/// Checks the areas of the regions.
void checkAreas(const DiscreteDomain &discrete);

} // namespace forefront::testing
