#pragma once

#include "ui/widgets/widget_context.hpp"

#include <string>
#include <string_view>

namespace forefront::ui {

/// Draws a line of text at a pixel, with an ellipsis where it would reach beyond `right`.
void shortened(const WidgetContext &context, Pixel at, float right, std::string_view text, Colour colour);

/// Returns a text, in the current font, with an ellipsis instead of its middle if it is wider than `width` pixels.
std::string withoutMiddle(const std::string &text, float width);

} // namespace forefront::ui
