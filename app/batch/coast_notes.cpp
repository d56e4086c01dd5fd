#include "app/batch/coast_notes.hpp"

#include "app/batch/output_formats.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/spacing/spec/size_presets.hpp"
#include "core/files/elevations.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace forefront {

namespace {

/// The part of the nodes, in per cent, above which a domain counts as dry.
constexpr std::size_t kDryPercent = 90;

} // namespace

Diagnostics dryPresets(std::span<const std::string> presets, const SpacingSpec &spacing, const MeshView &mesh) {
    Diagnostics warnings;
    for (const PresetDepth &depth : presetDepths(presets)) {
        const auto raster = spacing.rasters.find(depth.raster);
        if (raster == spacing.rasters.end() || mesh.nodes.empty()) {
            continue;
        }
        const auto dry = static_cast<std::size_t>(std::count_if(mesh.nodes.begin(), mesh.nodes.end(), [&](Vec2 node) {
            return !((depth.negative ? -1.0 : 1.0) * raster->second->at(node) > 0.0);
        }));
        const std::size_t percent = 100 * dry / mesh.nodes.size();
        if (percent >= kDryPercent) {
            const std::string other = (depth.negative ? "depth=" : "elevation=") + depth.raster;
            warnings.push_back(warningOf("dry-domain",
                                         "--size-preset " + depth.rule + ": " + std::to_string(percent) +
                                             " % of the nodes are above the sea; they have the sizes of the "
                                             "least depth",
                                         "if the raster has the other sign, write " + other));
        }
    }
    return warnings;
}

Diagnostics openShore(std::span<const std::string> presets, std::span<const std::string> open) {
    if (open.empty() || !countsAllAsShore(presets)) {
        return {};
    }
    return {warningOf("open-shore", "--size-preset shore: elements are small along the open boundary, too",
                      "add part=NAME with the part of the boundary that is the shore")};
}

Diagnostics dryElevations(std::span<const double> elevations, const std::vector<Output> &outputs) {
    return anyHas(outputs, &FileFormat::hasOpenBoundaries) ? warnOfDryElevations(elevations) : Diagnostics();
}

Diagnostics otherSystem(const std::string &file, const MapSystem &raster, const MapSystem &map) {
    const bool differs = map.centre ? raster.known() : !raster.code.empty() && raster.code != map.code;
    if (!map.known() || !differs) {
        return {};
    }
    const std::string its = raster.code.empty() ? "a system of its own" : raster.code;
    return {warningOf("raster-system",
                      file + " is in " + its + " and the map in " +
                          (map.centre         ? "metres about its middle"
                           : map.code.empty() ? "longitudes and latitudes"
                                              : map.code) +
                          "; the raster is used in its own coordinates",
                      map.code.empty() ? "--projection EPSG:n converts both"
                                       : "--projection " + map.code + " converts it")};
}

} // namespace forefront
