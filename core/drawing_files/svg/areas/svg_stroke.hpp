#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/engine/geometry/path_bands.hpp"

#include <vector>

namespace forefront {

/// Returns outlines whose union is the area painted by the stroke of a path, in domain coordinates: bands along its
/// segments or dashes, with the joins and caps of its line style. A path with a single node is a dot. More than 20,000
/// dashes become a solid line.
std::vector<BandPart> strokeParts(const SvgPath &path);

} // namespace forefront
