#pragma once

#include "core/teaching/markup/math_layout.hpp"
#include "ui/widgets/widget_context.hpp"

struct ImVec2;

namespace forefront::ui {

/// Sets a formula in the fonts of the program, in pixels.
MathLayout setMath(const WidgetContext &context, const MathNode &formula, bool display);
/// Draws a formula with the left end of its baseline at a place of the screen.
void drawMath(const WidgetContext &context, const MathLayout &formula, ImVec2 baseline, Colour colour);

} // namespace forefront::ui
