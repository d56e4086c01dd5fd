#pragma once

#include "ui/widgets/widget_context.hpp"

#include <string_view>

namespace forefront::ui {

/// Draws a fault as small text in lines as wide as the rest of the row.
void faultText(WidgetContext &context, std::string_view text);

} // namespace forefront::ui
