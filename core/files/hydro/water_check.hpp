#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstddef>
#include <optional>

namespace FOREFRONT_API forefront {

/// Limits that models of water set for a mesh, besides MeshLimits. Limits that are not set are not checked.
struct WaterLimits {
    std::optional<double> areaRatio;  ///< of two elements that share a side, the larger to the smaller; >= 1
    std::optional<double> islandArea; ///< the minimum area of an island, in square domain units; > 0

    bool any() const { return areaRatio || islandArea; }
};

/// Returns an error for each place that violates a limit, the worst first, at most `most` for each limit: area-ratio,
/// at the middle of the side, with both elements, and small-island, at the mean of the nodes of its shore. A note then
/// says how many more there are. `numbers`: of the nodes and elements.
Diagnostics checkWater(const MeshView &mesh, const WaterLimits &limits, std::size_t most = 20,
                       const MeshNumbers &numbers = {});

} // namespace forefront
