#pragma once

#include "ui/shell/timeline_marks.hpp"

namespace forefront::shell {

/// Height of the curves above the timeline, in design pixels.
inline constexpr double kPlotHeight = 96.0;

/// Draws the length of the front, the tests per element and α over the run, with the scale of the timeline. A click or
/// drag seeks. `top`: y of its upper edge, in pixels.
void drawRunPlot(Shell &context, const TimeAxis &axis, float top);

} // namespace forefront::shell
