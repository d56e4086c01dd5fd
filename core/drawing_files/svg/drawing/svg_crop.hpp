#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"

#include <vector>

namespace forefront {

// Crops paths to a box around the page. Without this, shapes far larger than the page would be divided and joined with
// the fine tolerance of the page along their whole length. Curves that meet the box are kept where they do; they may
// leave it by up to its diagonal. `tolerance` is the maximum deviation of chords from curves.

/// Crops a closed path, or an open one that its last and first node close. Outside, it then runs along the sides of the
/// box, so that it winds around every place inside as before. If it winds around none, fewer than three nodes may be
/// left.
void cropArea(SvgPath &path, const Box2 &box, double tolerance);

/// Returns the parts of a path that lie in the box, as open paths without a fill.
std::vector<SvgPath> croppedLines(const SvgPath &path, const Box2 &box, double tolerance);

} // namespace forefront
