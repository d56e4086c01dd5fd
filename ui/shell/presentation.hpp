#pragma once

#include "ui/parts/shell.hpp"

namespace forefront::shell {

/// Scale of the interface while presenting, relative to the usual one: legible from the back of a lecture hall.
inline constexpr double kPresentedScale = 1.5;

/// Shows only the canvas, the timeline with its caption, and the ten steps as pseudo-code, or goes back to what was
/// shown before.
void togglePresentation(Shell &context);

/// Draws the ten steps as pseudo-code with the values of the advance shown.
void drawPresentedSteps(Shell &context, const PixelRect &rect);

} // namespace forefront::shell
