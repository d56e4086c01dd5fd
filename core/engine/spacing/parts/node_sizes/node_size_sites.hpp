#pragma once

#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"

#include <span>

namespace forefront {

/// Adds one site for each size at a node, raised to `minimum` and growing by at most `gradation` (infinity: no limit).
void addNodeSizeSites(std::span<const NodeSize> sizes, double minimum, double gradation, SiteSet &sites);

} // namespace forefront
