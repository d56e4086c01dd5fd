#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <string>

namespace forefront::ui {

bool chip(WidgetContext &context, std::string_view name, std::string_view label, bool chosen) {
    const Theme &theme = context.theme;
    ImGui::PushID(name.data(), name.data() + name.size());
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, chosen ? 0.0F : 1.0F);
    ImGui::PushStyleColor(ImGuiCol_Border, theme.fieldBorder);
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme.accent : fade(theme.raised, 0.0));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen ? mix(theme.accent, theme.text, 0.15) : theme.raised);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, chosen ? mix(theme.accent, theme.text, 0.3) : theme.hovered);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme.onAccent : theme.text);
    const bool pressed = ImGui::Button(std::string(label).c_str());
    ImGui::PopStyleColor(5);
    ImGui::PopStyleVar();
    ImGui::PopID();
    mark(context, name);
    return pressed;
}

} // namespace forefront::ui
