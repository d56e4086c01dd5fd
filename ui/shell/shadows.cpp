#include "ui/shell/main_window.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <array>

namespace forefront::shell {

void drawShadows(const WidgetContext &context) {
    constexpr std::array<double, 4> kOpacity = {0.30, 0.19, 0.10, 0.04}; // of rings 2 pixels wide, from the edge out
    constexpr double kRing = 2.0, kDrop = 1.0;
    const double strength = context.theme.kind == ThemeKind::Dark ? 1.0 : 0.4; // a light ground shows more of it
    constexpr ImGuiWindowFlags kAbove = ImGuiWindowFlags_Popup | ImGuiWindowFlags_Modal | ImGuiWindowFlags_Tooltip;
    for (const ImGuiWindow *const window : ImGui::GetCurrentContext()->Windows) {
        if (!window->Active || window->Hidden || (window->Flags & kAbove) == 0) {
            continue;
        }
        ImDrawList &list = *window->DrawList;
        list.PushClipRectFullScreen();
        for (std::size_t k = 0; k < kOpacity.size(); ++k) {
            const float out = context.px(kRing * (static_cast<double>(k) + 0.5)), drop = context.px(kDrop);
            const ImVec2 min{window->Pos.x - out, window->Pos.y - out + drop};
            const ImVec2 max{window->Pos.x + window->Size.x + out, window->Pos.y + window->Size.y + out + drop};
            list.AddRect(min, max, rgb(0x000000, strength * kOpacity[k]), window->WindowRounding + out, 0,
                         context.px(kRing));
        }
        list.PopClipRect();
    }
}

} // namespace forefront::shell
