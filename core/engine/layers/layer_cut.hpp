#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/layers/layer_rays.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A discretised boundary with the nodes of the layers that slide along it.
struct CutBoundary {
    DiscreteDomain domain;
    std::vector<std::uint8_t> besideLayers; ///< per segment: it is the end of a layer
};

/// Divides the segments of the domain along which rays slide: by the layers as far as these reach, by the spacing
/// beyond. Updates the numbers of nodes and segments in the chains. `periodic`: second parts get the images of the
/// nodes on the first ones; null: none. Errors: too-many-nodes, periodic-layers (the layers at an image are of other
/// heights), cancelled.
Result<CutBoundary> cutWhereSliding(const DiscreteDomain &boundary, std::span<const LayerHeights> heights,
                                    const SpacingField &spacing, const PeriodicSides *periodic,
                                    std::vector<RayChain> &chains, const Progress &progress);

} // namespace forefront
