#pragma once

#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront::ui {

/// The look of windows that lie over the others, for those begun while it exists: padding and rounding in design
/// pixels.
class PopupStyle {
  public:
    PopupStyle(const WidgetContext &context, double padX, double padY, double rounding = 6.0, double opacity = 1.0) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(padX), context.px(padY)));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(rounding));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
        ImGui::PushStyleColor(ImGuiCol_WindowBg, fade(context.theme.popup, opacity));
    }
    ~PopupStyle() {
        ImGui::PopStyleColor();
        ImGui::PopStyleVar(3);
    }
    PopupStyle(const PopupStyle &) = delete;
    PopupStyle &operator=(const PopupStyle &) = delete;
};

} // namespace forefront::ui
