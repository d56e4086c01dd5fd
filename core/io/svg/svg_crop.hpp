#pragma once

#include "core/io/svg/svg_drawing.hpp"

namespace forefront {

/// Replaces what a path does outside of a box by lines along the sides of the box, so that it winds around every place
/// inside as before. Without this, shapes far larger than the page would be joined and divided to the fine tolerance of
/// the page in all their length. Curves that meet the box are kept, also where they leave it by up to its diagonal.
/// `tolerance`: of the chords of curves. A path of which nothing is left has less than two nodes.
void crop(SvgPath &path, const Box2 &box, double tolerance);

} // namespace forefront
