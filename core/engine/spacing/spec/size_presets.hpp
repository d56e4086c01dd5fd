#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/result.hpp"

#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// Returns the expression of one or more rules for sizes of coastal meshes, of which the smallest size counts. A rule
/// is written as its word, a colon, and keys with values, such as "wavelength:depth=sea,period=44714,elements=30":
///
/// - wavelength: `elements` per length of a long wave of the given period in seconds, h = T·sqrt(g·d)/N with
///   the phase speed of shallow water (linear wave theory, g = 9.81 m/s²; Le Provost and Vincent 1986 for tides).
/// - slope: `elements` along the topographic length scale, h = 2π/N·d/|∇d| (Hannah and Wright 1995).
/// - shore: h = size + growth·(distance to the boundary, or to `part`).
///
/// Lengths are in metres. `depth` names a raster of depths; `elevation`, in its place, one of elevations, whose sign is
/// changed. Depths below `least` (default 1) count as that. Each rule takes `min` and `max`, bounds of its size; slope
/// needs a max, for flat beds. The expression can be edited like any other.
///
/// Error: bad-preset, with the rule, the key and what was expected.
Result<std::string> presetExpression(std::span<const std::string> rules);

/// The depth that a rule takes its sizes from.
struct PresetDepth {
    std::string rule;   ///< as it was written
    std::string raster; ///< name
    bool negative;      ///< the raster has elevations: the depth is its value with the other sign
};
/// Returns the depths of valid rules, in order.
std::vector<PresetDepth> presetDepths(std::span<const std::string> rules);
/// Returns true if one of some valid rules counts the whole boundary as shore, open parts too.
bool countsAllAsShore(std::span<const std::string> rules);

/// Returns the rules with their keys, for help texts.
std::string sizePresetHelp();

} // namespace forefront
