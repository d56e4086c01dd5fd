#include "ui/shell/shell.hpp"
#include "ui/widgets.hpp"

#include <imgui.h>

namespace forefront::shell {

void drawToolStrip(AppContext &context, const PixelRect &rect) {
    beginRegion("##tools", rect, context.theme.panel, context.px(6), context.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, context.px(3)));
    for (std::size_t i = 0; i < context.tools.tools.size(); ++i) {
        const Tool &tool = *context.tools.tools[i];
        std::string tip = tool.name();
        if (tool.key() != 0) {
            tip += std::string("  (") + toString({tool.key(), {}}) + ")";
        }
        if (ui::iconButton(context, std::string("tool/") + tool.id(), tool.icon(), tip, i == context.tools.active, true,
                           34.0F)) {
            context.tools.choose(tool.id(), context);
        }
    }
    ImGui::PopStyleVar();
    const float x = static_cast<float>(rect.x + rect.width) - 1.0F;
    ImGui::GetWindowDrawList()->AddLine({x, static_cast<float>(rect.y)}, {x, static_cast<float>(rect.y + rect.height)},
                                        context.theme.line);
    ImGui::End();
}

void drawToolOptions(AppContext &context, const PixelRect &canvas) {
    Tool &tool = context.tools.current();
    if (!tool.hasOptions(context)) {
        return;
    }
    ImGui::SetNextWindowPos(
        {static_cast<float>(canvas.x) + context.px(12), static_cast<float>(canvas.y) + context.px(12)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(10), context.px(7)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, fade(context.theme.popup, 0.96));
    ImGui::Begin("##tooloptions", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    tool.drawOptions(context);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

} // namespace forefront::shell
