#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace forefront::shell {

namespace {

constexpr double kBelowHeading = 32.0, kBelowPad = 12.0; // design pixels

/// Draws the heading of the panel, which folds it.
void belowHeading(Shell &context, const Panel &panel, bool open) {
    const std::string name = std::string("panel/") + panel.id();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = context.px(kBelowHeading);
    if (ui::hitArea(name.c_str(), ImGui::GetContentRegionAvail().x, height)) {
        setFolded(context, panel.id(), open);
    }
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(context.fonts.heading);
    const float y = at.y + (height - ImGui::GetFontSize()) / 2;
    list.AddText({at.x - context.px(2), y}, hovered ? context.theme.text : context.theme.muted,
                 open ? icon::kDown : icon::kRight);
    list.AddText({at.x + context.px(18), y}, context.theme.text, panel.title());
    ImGui::PopFont();
}

} // namespace

void drawBelow(Shell &context, const PixelRect &rect) {
    const auto panel = std::find_if(context.panels.begin(), context.panels.end(),
                                    [](const auto &each) { return each->place() == PanelPlace::Below; });
    if (rect.height < 1.0 || rect.width < 1.0 || panel == context.panels.end()) {
        context.probe.walks = false;
        return;
    }
    beginRegion("##below", rect, context.theme.panel, context.px(kBelowPad), 0);
    const float x = static_cast<float>(rect.x), y = static_cast<float>(rect.y);
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x + static_cast<float>(rect.width), y}, context.theme.line);
    const bool open = !isFolded(context, (*panel)->id());
    belowHeading(context, **panel, open);
    if (open) {
        ImGui::SetCursorPosY(context.px(kBelowHeading));
        (*panel)->draw(context);
    } else {
        context.probe.walks = false;
    }
    ui::markWindow(context, "below");
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && ImGui::IsMouseClicked(ImGuiMouseButton_Right) &&
        !context.menu.opens) {
        std::vector<ContextGroup> groups = (*panel)->menu(context);
        const std::string id = (*panel)->id();
        groups.push_back(
            {commandOf("panel/fold", open ? "Fold" : "Unfold", [id, open](Shell &c) { setFolded(c, id, open); })});
        context.menu.open(std::move(groups));
    }
    ImGui::End();
}

} // namespace forefront::shell
