#pragma once

#include "core/base/result.hpp"
#include "core/io/source/source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace forefront {

/// A polyline of a drawing in the coordinates of the domain.
struct SvgPath {
    std::vector<Vec2> nodes;
    bool closed = false;
    std::string name;
    std::size_t offset = 0; ///< of its element in the text
};

struct SvgPaths {
    std::vector<SvgPath> paths;
    double size = 0.0; ///< diagonal of the drawing's box
};

/// Returns the visible shapes of an SVG drawing as polylines, those drawn by <use> included, in the order of painting.
/// What shapes are made from is not judged: fill and stroke do not matter. Notes name whatever is left out.
Result<SvgPaths> drawnPaths(const SourceText &source);

} // namespace forefront
