#pragma once

#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/layers/layer_rays.hpp"

#include <vector>

namespace forefront {

/// Lowers the numbers of layers where they end along periodic parts, so that the layers at a place and at its image are
/// as many, and as high. Layers that end along one part alone get none there. Returns false if nothing had to be
/// lowered.
bool matchPeriodicEnds(const PeriodicSides &sides, const Domain &domain, std::vector<RayChain> &chains);

} // namespace forefront
