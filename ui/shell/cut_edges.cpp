#include "ui/shell/cut_edges.hpp"

#include "ui/style/theme.hpp"
#include "ui/widgets/widget_context.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront::shell {

void shadeCutEdges(const WidgetContext &context) {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const float depth = std::min(context.px(20), 0.5F * size.y),
                right = at.x + size.x - ImGui::GetStyle().ScrollbarSize;
    const ImU32 whole = context.theme.panel, none = fade(context.theme.panel, 0.0);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    if (ImGui::GetScrollY() + 1.0F < ImGui::GetScrollMaxY()) {
        const float bottom = at.y + size.y;
        list.AddRectFilledMultiColor({at.x, bottom - depth}, {right, bottom}, none, none, whole, whole);
    }
    if (ImGui::GetScrollY() > 1.0F) {
        list.AddRectFilledMultiColor(at, {right, at.y + depth}, whole, whole, none, none);
    }
}

} // namespace forefront::shell
