#pragma once

namespace forefront {

struct WidgetContext;

namespace shell {

/// Shades the lower edge of the current window where content goes on below it, and the upper edge where it goes on
/// above, so that a row that is cut looks like one to scroll to.
void shadeCutEdges(const WidgetContext &context);

} // namespace shell
} // namespace forefront
