#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"

#include <span>

namespace FOREFRONT_API forefront {

/// Returns a warning for each region in which elements of a mesh of the domain exceed the maximum area
/// (large-elements), with their number and the place of the largest; empty if there are none. O(n log n).
Diagnostics largeElements(const MeshView &mesh, const Domain &domain, std::span<const RegionSize> regions);

} // namespace forefront
