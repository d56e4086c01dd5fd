#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"

namespace forefront {

/// Fraction of the drawing's size within which nodes are the same: the error of computing with relative path data.
inline constexpr double kSameNode = 1e-6;

/// Closes a path that ends where it begins: within kSameNode, or within the rounding of its data if that is at most
/// 1e-4 of the drawing's size and a twentieth of the extent of the last part of the path. Otherwise a tiny side would
/// close it, and the mesh would be refined around that. `size`: the drawing's size.
void joinEnds(SvgPath &path, double size);

} // namespace forefront
