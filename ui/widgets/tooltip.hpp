#pragma once

#include "ui/input/pixels.hpp"
#include "ui/platform/platform.hpp"

namespace forefront::ui {

/// Returns the position of a widget's tooltip within the display: outside the panel, bar or plate of the widget, so
/// that it hides neither the widget nor its neighbours; above the widget if there is no room outside. All values are in
/// pixels; `x` is the pointer's.
PixelRect placeTooltip(const PixelRect &widget, const PixelRect &window, Pixel size, PixelSize display, double x,
                       double gap);
/// Returns the position of the note on a fault of a field: below the field, or above it if there is no room, within the
/// panel or dialog, so that it covers nothing on the canvas.
PixelRect placeFaultNote(const PixelRect &field, const PixelRect &window, Pixel size, PixelSize display, double gap);

} // namespace forefront::ui
