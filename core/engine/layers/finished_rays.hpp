#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/layers/layer_heights.hpp"
#include "core/engine/layers/layer_rays.hpp"

#include <vector>

namespace forefront {

/// The rays of all walls, with the numbers of layers that they can have, and the heights of these.
struct FinishedRays {
    std::vector<RayChain> chains;
    std::vector<LayerHeights> heights; ///< by specification
};

/// Finds the rays of layers on a discretised boundary. Errors: too-many-elements, cancelled.
Result<FinishedRays> finishedRays(const LayerRequest &request, const DiscreteDomain &boundary,
                                  const Progress &progress);

/// Returns the report on rays, without elements. `boundary`: that they start from, also once it is cut where they
/// slide.
LayerReport reportOf(const FinishedRays &rays, const DiscreteDomain &boundary);

} // namespace forefront
