#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/platform/platform.hpp"

namespace forefront::ui {

/// Where the explanation of a widget goes: outside of the panel, bar or plate that the widget stands in, so that it
/// hides neither the widget nor its neighbours; within the display. Above the widget where there is no room for that.
/// Pixels; `x`: of the pointer.
PixelRect placeTooltip(const PixelRect &widget, const PixelRect &window, Vec2 size, PixelSize display, double x,
                       double gap);

} // namespace forefront::ui
