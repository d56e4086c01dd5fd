#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/layers/layer_rays.hpp"

#include <span>
#include <vector>

namespace forefront {

/// Lowers numbers of layers until the layers are exactly right: every element is convex and counter-clockwise, no node
/// of the boundary and no constraint point lies in one, and their tops meet nothing but at common nodes. The numbers
/// only fall, so that it ends. They are level before and after. Returns false when cancelled.
bool repairLayers(const DiscreteDomain &boundary, std::span<const LayerHeights> heights, std::vector<RayChain> &chains,
                  const Progress &progress = {});

} // namespace forefront
