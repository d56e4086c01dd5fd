#include "ui/shell/main_window.hpp"
#include "ui/shell/workspace_options.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace forefront::shell {

namespace {

constexpr const char *kOverflow = "##moreoptions";
constexpr double kOptionGap = 14.0, kBarPad = 12.0; // design pixels

/// Draws the icon and the name of the active tool.
void drawToolName(Shell &context, const Tool &tool, const PixelRect &rect) {
    const float y = static_cast<float>(rect.height);
    ImGui::SetCursorPos({context.px(kBarPad), (y - ImGui::GetFontSize()) / 2});
    ImGui::PushFont(context.fonts.heading);
    constexpr double kNamed = 900.0; // width of a window with room for the name, in design pixels
    const bool named = rect.width >= static_cast<double>(context.px(kNamed));
    ImGui::TextUnformatted(named ? (std::string(tool.icon()) + "   " + tool.name()).c_str() : tool.icon());
    ImGui::PopFont();
    ui::mark(context, "options/tool");
    if (!named) {
        ui::tooltip(context, tool.name());
    }
    ImGui::SameLine(0, context.px(kOptionGap));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = static_cast<float>(rect.y) + y / 2, half = context.px(8);
    ImGui::GetWindowDrawList()->AddLine({at.x, middle - half}, {at.x, middle + half}, context.theme.line);
    ImGui::SetCursorScreenPos({at.x + context.px(kOptionGap), at.y});
}

/// Begins the window for the options that do not fit into the bar. It is out of sight while it is closed, since its
/// fields can be filled by keys; then it opens.
void placeOverflow(Shell &context, const PixelRect &rect) {
    const bool open = context.plates.options;
    const float right = static_cast<float>(rect.x + rect.width), below = static_cast<float>(rect.y + rect.height);
    const float hidden = -4.0F * static_cast<float>(rect.width);
    ImGui::SetNextWindowPos({open ? right - context.px(kBarPad) : hidden, below + context.px(4)}, ImGuiCond_Always,
                            {1.0F, 0.0F});
    const ui::PopupStyle style(context, 12, 10);
    ImGui::Begin(kOverflow, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    if (open) {
        ui::markWindow(context, "options/rest");
    }
    const ImGuiWindow *const active = ImGui::GetCurrentContext()->ActiveIdWindow;
    if (!open && active != nullptr && active->RootWindow == ImGui::GetCurrentWindow()) {
        context.plates.options = true;
        context.animate();
    }
    ImGui::End();
}

/// Draws the button that opens and closes the drawer of options. A press outside of the drawer closes it.
void drawOverflowButton(Shell &context, const PixelRect &rect) {
    ImGui::SetCursorPos({static_cast<float>(rect.width) - context.px(kBarPad + 28), context.px(5)});
    if (ui::iconButton(context, "options/more", "\xe2\x80\xa6", "More options", context.plates.options, true, 26.0F)) {
        context.plates.options = !context.plates.options;
        context.animate();
    }
    const WidgetRegistry::Widget *const drawer = context.widgets.find("options/rest");
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const bool outside = drawer != nullptr && !drawer->rect.contains({pointer.x, pointer.y}) &&
                         !ImGui::IsItemHovered() && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && outside) {
        context.plates.options = false;
        context.animate();
    }
}

/// Draws what a click does where there is room for it, after the options.
void drawHint(Shell &context, const Tool &tool, float room) {
    std::string hint = tool.statusText(context);
    const std::string typing = tool.typingHint(context);
    const auto widthOf = [](const std::string &text) { return ImGui::CalcTextSize(text.c_str()).x; };
    if (!hint.empty() && !typing.empty() && widthOf(hint + ". " + typing) < room) {
        hint += ". " + typing;
    }
    // What does not fit is left out from the end, a sentence at a time.
    while (!hint.empty() && widthOf(hint) >= room) {
        const std::size_t stop = hint.rfind(". ");
        hint.erase(stop == std::string::npos ? 0 : stop);
    }
    if (!hint.empty()) {
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
        ImGui::TextUnformatted(hint.c_str());
        ImGui::PopStyleColor();
        ui::mark(context, "options/hint");
    }
}

} // namespace

void drawOptionsBar(Shell &context, const PixelRect &rect) {
    Tool &tool = context.tools.current();
    placeOverflow(context, rect);
    beginRegion("##options", rect, context.theme.panel, context.px(kBarPad), 0);
    drawToolName(context, tool, rect);
    const float row = (static_cast<float>(rect.height) - ImGui::GetFrameHeight()) / 2;
    ImGui::SetCursorPosY(row);
    const float left = ImGui::GetCursorPosX();
    const float room = std::max(1.0F, static_cast<float>(rect.width) - left - context.px(kBarPad + 36));
    bool overflows = false;
    float used = 0.0F;
    // In a workspace with options of its own, the selection has those of the inspector.
    const bool ofWorkspace = hasWorkspaceOptions(context);
    const bool ofTool = tool.hasOptions(context) && !(ofWorkspace && std::string_view(tool.id()) == "select");
    ImGui::BeginGroup();
    if (ofTool || ofWorkspace) {
        ui::Flow flow(context, room, context.px(kOptionGap), kOverflow);
        if (ofTool) {
            tool.drawOptions(context, flow);
        }
        if (ofWorkspace) {
            drawWorkspaceOptions(context, flow);
        }
        flow.finish();
        overflows = flow.overflows();
        used = flow.used();
    }
    ImGui::EndGroup();
    if (overflows) {
        drawOverflowButton(context, rect);
    } else {
        context.plates.options = false;
        const float gap = used > 0.0F ? context.px(24) : 0.0F;
        ImGui::SetCursorPos({left + used + gap, row});
        drawHint(context, tool, room - used - gap);
    }
    const float y = static_cast<float>(rect.y + rect.height) - 1.0F;
    ImGui::GetWindowDrawList()->AddLine({0, y}, {static_cast<float>(rect.width), y}, context.theme.line);
    ui::markWindow(context, "options");
    ImGui::End();
}

} // namespace forefront::shell
