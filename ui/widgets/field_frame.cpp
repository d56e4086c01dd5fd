#include "ui/widgets/field_frame.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront::ui {

FieldFrame::FieldFrame(const WidgetContext &context) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0F, std::round(context.scale)));
    ImGui::PushStyleColor(ImGuiCol_Border, context.theme.fieldBorder);
}

FieldFrame::~FieldFrame() {
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

void drawFocus(const WidgetContext &context) {
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), context.theme.accent,
                                        ImGui::GetStyle().FrameRounding, 0, context.px(1.5));
}

} // namespace forefront::ui
