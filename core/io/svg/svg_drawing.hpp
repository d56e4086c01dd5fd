#pragma once

#include "core/base/result.hpp"
#include "core/base/vec2.hpp"
#include "core/geometry/curve.hpp"
#include "core/io/source/source.hpp"
#include "core/io/svg/svg_paint.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace forefront {

/// A polyline of a drawing in the coordinates of the domain, with the curves that it follows.
struct SvgPath {
    std::vector<Vec2> nodes;
    std::vector<Curve> curves;
    std::vector<CurveStretch> stretches; ///< per segment between consecutive nodes
    bool closed = false;
    bool isLine = false; ///< of a <line> or <polyline>
    SvgPaint paint;
    std::size_t element = 0; ///< number of the element that it is a subpath of
    std::string name;
    std::size_t offset = 0; ///< of its element in the text
};

struct SvgPaths {
    std::vector<SvgPath> paths;
    double size = 0.0; ///< diagonal of the drawing's box
};

/// Returns the visible shapes of an SVG drawing as polylines, those drawn by <use> included, in the order of painting.
/// Notes name everything left out.
Result<SvgPaths> drawnPaths(const SourceText &source);

} // namespace forefront
