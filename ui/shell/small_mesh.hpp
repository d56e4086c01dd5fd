#pragma once

#include "ui/canvas/canvas_painter.hpp"
#include "ui/style/theme.hpp"

#include <cstddef>

namespace forefront::shell {

/// Maximum number of elements drawn one by one in a view beside the canvas; of larger meshes, only lines are shown.
inline constexpr std::size_t kMaxSmallMesh = 12'000;

/// Draws a filled element and its edges.
inline void drawElement(CanvasPainter &painter, const Theme &theme, Vec2 a, Vec2 b, Vec2 c, Colour fill) {
    painter.triangle(a, b, c, fill);
    painter.line(a, b, theme.mesh, 1.0);
    painter.line(b, c, theme.mesh, 1.0);
    painter.line(c, a, theme.mesh, 1.0);
}

} // namespace forefront::shell
