#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/geometry/plane_sweep.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns the region directly above an edge of a discrete domain; for kNoIndex instead of an edge, kOutside.
std::uint32_t regionAbove(const DiscreteDomain &domain, std::uint32_t edge);

/// Finds nodes that are on the wrong side of something: where the regions of the segments around a node disagree, or
/// where the region below a node that is left of all its neighbours is not the one that surrounds it. There are none if
/// and only if the regions of all segments fit those of their faces. The segments are the edges of the sweep, which
/// meet only at common ends. Exact.
std::vector<std::uint32_t> misplacedNodes(const DiscreteDomain &domain, const PlaneSweepResult &sweep);

} // namespace forefront
