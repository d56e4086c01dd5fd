#include "ui/widgets/shortened.hpp"

#include <imgui.h>
#include <imgui_internal.h>

namespace forefront::ui {

void shortened(const WidgetContext &context, Pixel at, float right, std::string_view text, Colour colour) {
    const char *const begin = text.data(), *const end = text.data() + text.size();
    const ImVec2 size = ImGui::CalcTextSize(begin, end);
    const ImVec2 corner{static_cast<float>(at.x), static_cast<float>(at.y)};
    if (right - corner.x < context.px(12)) {
        return; // not even an ellipsis
    }
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), corner, {right, corner.y + size.y}, right, right, begin, end,
                              &size);
    ImGui::PopStyleColor();
}

} // namespace forefront::ui
