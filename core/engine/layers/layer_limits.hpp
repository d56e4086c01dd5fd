#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/layers/layer_rays.hpp"

#include <span>
#include <vector>

namespace forefront {

/// Lowers the numbers of layers near other parts of the boundary and near constraint points.
///
/// A layer of a ray is left out where its distance from its base is more than 0.42 of that distance plus the free
/// distance beyond it to a wall that faces it and has layers, too, or more than 0.6 of it for other parts: between two
/// walls, a gap of about a sixth of their distance is left for one or two elements. Returns false when cancelled; not
/// all numbers are right then.
bool limitByObstacles(const DiscreteDomain &boundary, std::span<const LayerHeights> heights,
                      std::span<const LayerSpec> specs, std::vector<RayChain> &chains, const Progress &progress = {});

/// Lowers the numbers at the ends of chains: to none where the last ray cannot slide, and where it slides so that the
/// layers leave a part of the neighbour free. `domain`: the segments that rays slide along.
void limitAtEnds(const Domain &domain, const DiscreteDomain &boundary, std::span<const LayerHeights> heights,
                 std::vector<RayChain> &chains);

/// Makes the numbers of neighbouring rays differ by one at most, and those of a fan equal, by lowering them.
void levelLayers(RayChain &chain);

} // namespace forefront
