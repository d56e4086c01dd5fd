#pragma once

#include "core/engine/mesher/front_rules.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/view/step_text.hpp"

#include <string>

namespace forefront::shell {

/// Scale of the interface while presenting, relative to the usual one: legible from the back of a lecture hall.
inline constexpr double kPresentedScale = 1.5;

/// Shows only the canvas, the timeline with its caption, and the ten steps as pseudo-code, or goes back to what was
/// shown before.
void togglePresentation(Shell &context);

/// Returns the line of the program for a step, as the panel Steps words it where the front is one of quadrilaterals.
/// `rules`: of the classic method; null for others.
std::string presentedLine(Step step, const FrontRules *rules, bool quads);

/// Draws the ten steps as pseudo-code with the values of the advance shown.
void drawPresentedSteps(Shell &context, const PixelRect &rect);

} // namespace forefront::shell
