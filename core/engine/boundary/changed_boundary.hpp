#pragma once

#include "core/engine/boundary/discretise.hpp"

namespace forefront {

/// Sums up the areas of the regions of a boundary from its segments. Each region has its own origin, so that neither an
/// offset nor the size of the domain costs digits.
void sumAreas(DiscreteDomain &boundary);

/// Returns true if the segments of a boundary meet only at common ends and have the right faces on either side, as they
/// must after some were divided along their curves. Exact.
bool isProper(const DiscreteDomain &boundary);

} // namespace forefront
