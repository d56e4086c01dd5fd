#pragma once

#include "ui/widgets/widget_context.hpp"

namespace forefront::ui {

/// Scope that gives the fields of Dear ImGui drawn in it an edge, so that they do not look like buttons.
class FieldFrame {
  public:
    explicit FieldFrame(const WidgetContext &context);
    ~FieldFrame();
    FieldFrame(const FieldFrame &) = delete;
    FieldFrame &operator=(const FieldFrame &) = delete;
};

/// Draws the edge of the last item of Dear ImGui in the accent, which shows that it has the focus.
void drawFocus(const WidgetContext &context);

} // namespace forefront::ui
