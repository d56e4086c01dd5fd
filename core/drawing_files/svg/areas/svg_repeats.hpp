#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace forefront {

/// Returns, per path, 1 if it is to be compared and has the same nodes as another path within the same clip, in either
/// direction. Drawings made for cutters and circuit boards often repeat their outlines. Of equal paths, the first one
/// with a name of its own is kept, or else the first. `tolerance` in domain units.
std::vector<std::uint8_t> findRepeatedPaths(const std::vector<SvgPath> &paths,
                                            const std::function<bool(const SvgPath &)> &compares, double tolerance);

/// Returns the number of subpaths of each element.
std::map<std::size_t, std::size_t> subpathsOfElements(const std::vector<SvgPath> &paths);

} // namespace forefront
