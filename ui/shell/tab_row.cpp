#include "ui/dialogs/tab_commands.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {

namespace {

constexpr double kWidest = 220.0, kNarrowest = 112.0; // of a tab, design pixels
constexpr double kCloseButton = 24.0, kRowButton = 26.0, kMoreButton = 44.0;

enum class TabRequest : std::uint8_t { Show, Close };

/// Which tabs have room, and their width in pixels.
struct TabRoom {
    std::size_t first = 0, count = 0;
    float width = 0.0F;
};

/// The tabs share the row; if they get too narrow to be read, only those up to the active one are shown.
TabRoom roomFor(const Shell &context, float row) {
    const std::size_t tabs = context.tabs.size();
    const float least = context.px(kNarrowest);
    const float room = row - context.px(kRowButton + 8.0);
    const auto fitting = static_cast<std::size_t>(std::max(1.0F, room / least));
    if (tabs <= fitting) {
        return {0, tabs, std::max(1.0F, std::min(context.px(kWidest), room / static_cast<float>(tabs)))};
    }
    const float less = std::max(least, room - context.px(kMoreButton));
    const auto count = static_cast<std::size_t>(std::max(1.0F, less / least));
    const std::size_t active = context.tabs.active();
    return {active < count ? 0 : active + 1 - count, count, std::max(1.0F, less / static_cast<float>(count))};
}

/// Draws a tab at the cursor, `width` pixels wide. Returns what the user wants of it.
std::optional<TabRequest> drawTab(Shell &context, std::size_t tab, float width, float height) {
    const TabCaption caption = captionOf(context, tab);
    const bool active = tab == context.tabs.active();
    const std::string name = "tab/" + std::to_string(tab);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float close = context.px(kCloseButton);
    std::optional<TabRequest> request;
    ImGui::PushID(name.c_str());
    if (ui::hitArea("##tab", width - close, height)) {
        request = TabRequest::Show;
    }
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) {
        request = TabRequest::Close;
    }
    ui::mark(context, name);
    std::string about = caption.path.empty() ? caption.title + ", not in a file" : caption.path.string();
    ui::tooltip(context, about + (caption.dirty ? " (unsaved changes)" : ""));
    const Theme &theme = context.theme;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + width, at.y + height};
    if (active || hovered) {
        list.AddRectFilled(at, end, active ? theme.raised : theme.hovered);
    }
    if (active) {
        list.AddRectFilled({at.x, end.y - context.px(2)}, end, theme.accent);
    }
    const std::string dot = caption.dirty ? "\xe2\x80\xa2 " : "";
    const float left = at.x + context.px(10), dotWidth = ImGui::CalcTextSize(dot.c_str()).x;
    const float room = width - close - context.px(14) - dotWidth;
    const float y = at.y + (height - ImGui::GetFontSize()) / 2;
    list.AddText({left, y}, theme.accent, dot.c_str());
    if (caption.dirty) {
        ui::markPart(context, name + "/unsaved", {left, y, dotWidth, ImGui::GetFontSize()});
    }
    list.AddText({left + dotWidth, y}, active ? theme.text : theme.muted,
                 ui::withoutMiddle(caption.title, std::max(0.0F, room)).c_str());
    ImGui::SameLine(0, 0);
    ImGui::SetCursorScreenPos({end.x - close, at.y + (height - close) / 2});
    if (ui::iconButton(context, name + "/close", icon::kCross, "Close (Ctrl+W)", false, true,
                       static_cast<float>(kCloseButton))) {
        request = TabRequest::Close;
    }
    list.AddLine({end.x - 1, at.y + context.px(6)}, {end.x - 1, end.y - context.px(6)}, theme.line);
    ImGui::PopID();
    return request;
}

/// Draws the button that lists all tabs, since not all of them have room.
void drawMore(Shell &context, std::size_t hidden) {
    if (ui::button(context, "tab/more", "+" + std::to_string(hidden), ui::ButtonKind::Quiet, true,
                   static_cast<float>(kMoreButton))) {
        ContextGroup all;
        for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
            const TabCaption caption = captionOf(context, tab);
            ContextItem item =
                commandOf("tab" + std::to_string(tab), (caption.dirty ? "\xe2\x80\xa2 " : "") + caption.title,
                          [tab](Shell &c) { showTab(c, tab); });
            item.checked = tab == context.tabs.active();
            all.push_back(std::move(item));
        }
        context.menu.open({std::move(all)});
    }
    ui::tooltip(context, "All tabs");
}

} // namespace

void drawTabs(Shell &context, const PixelRect &rect) {
    if (rect.height <= 0.0) {
        return;
    }
    beginRegion("##tabs", rect, context.theme.panel, 0, 0);
    const float height = static_cast<float>(rect.height);
    const TabRoom room = roomFor(context, static_cast<float>(rect.width));
    std::optional<std::pair<std::size_t, TabRequest>> request;
    for (std::size_t k = 0; k < room.count; ++k) {
        ImGui::SetCursorPos({static_cast<float>(k) * room.width, 0});
        if (const auto wanted = drawTab(context, room.first + k, room.width, height)) {
            request = {room.first + k, *wanted};
        }
    }
    float x = static_cast<float>(room.count) * room.width + context.px(4);
    if (room.count < context.tabs.size()) {
        ImGui::SetCursorPos({x, (height - ImGui::GetFrameHeight()) / 2});
        drawMore(context, context.tabs.size() - room.count);
        x += context.px(kMoreButton);
    }
    ImGui::SetCursorPos({x, (height - context.px(kRowButton)) / 2});
    const bool adds = ui::iconButton(context, "tab/new", icon::kPlus, "New tab (Ctrl+T)", false, true,
                                     static_cast<float>(kRowButton));
    const float y = static_cast<float>(rect.y + rect.height) - 1.0F;
    ImGui::GetWindowDrawList()->AddLine({0, y}, {static_cast<float>(rect.width), y}, context.theme.line);
    ImGui::End();
    if (adds) {
        newTab(context);
    } else if (request) { // now that no tab is drawn any more
        request->second == TabRequest::Show ? showTab(context, request->first) : closeTab(context, request->first);
    }
}

} // namespace forefront::shell
