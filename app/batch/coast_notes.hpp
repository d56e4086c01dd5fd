#pragma once

#include "app/batch/outputs.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/map_system.hpp"

#include <span>
#include <string>
#include <vector>

namespace forefront {

// Warnings of sizes and depths of coastal meshes that are probably not what was meant.

/// Warns of rules of --size-preset whose depth is above the sea at nearly all nodes of the mesh: "dry-domain".
Diagnostics dryPresets(std::span<const std::string> presets, const SpacingSpec &spacing, const MeshView &mesh);

/// Warns if a rule of --size-preset counts open parts of the boundary as shore: "open-shore".
Diagnostics openShore(std::span<const std::string> presets, std::span<const std::string> open);

/// Warns if all elevations are above the sea and an output is a file of depths: "dry-elevations".
Diagnostics dryElevations(std::span<const double> elevations, const std::vector<Output> &outputs);

/// Warns if a raster names another reference system than that of the map, also if only the map is converted to metres
/// about its middle: "raster-system". `file`: of the raster.
Diagnostics otherSystem(const std::string &file, const MapSystem &raster, const MapSystem &map);

} // namespace forefront
