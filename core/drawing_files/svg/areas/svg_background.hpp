#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/files/source/source.hpp"

#include <vector>

namespace forefront {

/// Reports a filled rectangle that covers everything else in a drawing, such as the white background that plotting
/// programs draw: merged with it, all other filled shapes would vanish, and outlines would become lines inside it.
/// Returns a box well within the rectangle; empty if there is none, or a clip limits it.
Box2 noteBackground(const SourceText &source, const std::vector<SvgPath> &paths, const std::vector<SvgClip> &clips);

} // namespace forefront
