#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/engine/geometry/path_bands.hpp"

#include <vector>

namespace forefront {

/// Returns outlines whose union is what the stroke of a path paints, in the coordinates of the domain: bands along its
/// segments or dashes, with corners and ends as its line style has them. A path with a single node is a dot. More than
/// 20,000 dashes become a solid line.
std::vector<BandPart> strokeParts(const SvgPath &path);

} // namespace forefront
