#include "ui/dialogs/preferences_dialog.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/tool_slots.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace forefront::shell {

namespace {

/// Opens the menu of a tool's button.
void openToolMenu(Shell &context, const Tool &tool) {
    const std::string id = tool.id(), action = "tool." + id;
    const Action *const known = context.actions.find(action);
    const std::string keys =
        known != nullptr && !known->shortcuts.empty() ? toString(known->shortcuts.front()) : std::string();
    context.menu.open({{headingOf(tool.name()),
                        commandOf(
                            "tool/choose", "Choose this tool", [id](Shell &c) { c.tools.choose(id, c); }, keys)},
                       {commandOf("tool/key", "Change key\xe2\x80\xa6",
                                  [title = std::string("Tool: ") + tool.name()](Shell &c) {
                                      c.dialogs.open(std::make_unique<PreferencesDialog>(title));
                                  }),
                        actionOf("help.shortcuts")}});
}

constexpr double kGap = 2.0, kPadX = 6.0, kPadY = 8.0, kButton = 32.0, kMinButton = 26.0; // design pixels
constexpr double kLine = 9.0; ///< height of a hairline with the room around it

/// Returns the name of a tool and its key.
std::string tipOf(const Shell &context, const Tool &tool) {
    const Action *const action = context.actions.find(std::string("tool.") + tool.id());
    const bool hasKey = action != nullptr && !action->shortcuts.empty();
    return tool.name() + (hasKey ? "  (" + toString(action->shortcuts.front()) + ")" : std::string());
}

/// Draws the button of a place in the strip. A corner shows that there are more tools behind it.
void drawToolButton(const Shell &context, const Tool &tool, bool active, bool flyout, ImVec2 at, float side) {
    const Theme &theme = context.theme;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + side, at.y + side};
    if (active || ImGui::IsItemHovered()) {
        list.AddRectFilled(at, end, active ? theme.selectedRow : theme.hovered, context.px(4));
    }
    ImFont *const font = context.fonts.icons;
    const float icon = font->CalcTextSizeA(imgui::lineOf(*font), 1e9F, 0.0F, tool.icon()).x;
    const ImVec2 place{std::round(at.x + 0.5F * (side - icon)),
                       std::round(at.y + 0.5F * (side - imgui::lineOf(*font)))};
    list.AddText(font, imgui::lineOf(*font), place, theme.text, tool.icon());
    const std::string nodes = nodesOf(tool.icon());
    if (active && imgui::holds(*font, static_cast<unsigned>(codeOf(nodes.c_str())))) {
        list.AddText(font, imgui::lineOf(*font), place, theme.accent, nodes.c_str()); // not every icon has squares
    }
    if (flyout) {
        const float corner = context.px(5), edge = context.px(2);
        list.AddTriangleFilled({end.x - edge, end.y - edge - corner}, {end.x - edge, end.y - edge},
                               {end.x - edge - corner, end.y - edge}, theme.muted);
    }
}

/// Draws the tools behind a place of the strip as a menu beside it.
void drawFlyout(Shell &context, const ToolSlot &slot, const char *popup, ImVec2 at) {
    ImGui::SetNextWindowPos(at);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(4), context.px(4)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    if (ImGui::BeginPopup(popup)) {
        for (const std::size_t k : slot.tools) {
            const Tool &tool = *context.tools.tools[k];
            const std::string name = std::string("flyout/") + tool.id();
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            const float side = context.px(kButton);
            ImGui::PushID(tool.id());
            const bool clicked = ui::hitArea("tool", context.px(200), side);
            ImGui::PopID();
            ui::mark(context, name);
            if (ImGui::IsItemHovered()) {
                ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                          context.theme.hovered, context.px(4));
            }
            drawToolButton(context, tool, k == context.tools.active, false, corner, side);
            const float y = std::round(corner.y + 0.5F * (side - ImGui::GetFontSize()));
            ImGui::GetWindowDrawList()->AddText({corner.x + side + context.px(8), y}, context.theme.text,
                                                tipOf(context, tool).c_str());
            if (clicked) {
                context.tools.choose(tool.id(), context);
                ImGui::CloseCurrentPopup();
            }
        }
        ui::markWindow(context, "flyout");
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

/// Draws a place of the strip. A click chooses the tool that is shown; one on the corner, or on the active tool, opens
/// the others.
void drawSlot(Shell &context, const ToolSlot &slot, float side) {
    const std::size_t shown = shownTool(context.tools, slot);
    const Tool &tool = *context.tools.tools[shown];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(context.tools.tools[slot.tools.front()]->id());
    const bool active = shown == context.tools.active;
    const bool clicked = ui::hitArea("slot", side, side);
    for (const std::size_t k : slot.tools) { // lessons can point to a tool behind this one
        ui::mark(context, std::string("tool/") + context.tools.tools[k]->id(), k == shown);
    }
    drawToolButton(context, tool, active, slot.hasFlyout(), at, side);
    if (clicked) {
        const ImVec2 pointer = ImGui::GetIO().MouseClickedPos[0];
        const float corner = context.px(9);
        if (slot.hasFlyout() && (active || (pointer.x > at.x + side - corner && pointer.y > at.y + side - corner))) {
            ImGui::OpenPopup("##flyout");
        } else {
            context.tools.choose(tool.id(), context);
        }
    }
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        openToolMenu(context, tool);
    }
    ui::tooltip(context, tipOf(context, tool) + (slot.hasFlyout() ? "\nClick the corner for more shapes" : ""));
    drawFlyout(context, slot, "##flyout", {at.x + side + context.px(kPadX), at.y});
    ImGui::PopID();
}

} // namespace

double Strip::width() const {
    return 2.0 * kPadX + columns * (button + kGap) - kGap;
}

Strip stripOf(const Shell &context, double height) {
    const std::vector<ToolSlot> slots = toolSlots(context);
    const auto count = static_cast<int>(slots.size());
    const auto lines = std::count_if(slots.begin(), slots.end(), [](const ToolSlot &slot) { return slot.begins; });
    const double room = height / static_cast<double>(context.scale) - 2.0 * kPadY + kGap;
    Strip strip{.columns = 1, .rows = count, .button = kButton};
    for (;; ++strip.columns) {
        strip.rows = (count + strip.columns - 1) / strip.columns;
        strip.lines = strip.columns == 1;
        const double left = room - (strip.lines ? kLine * static_cast<double>(lines) : 0.0);
        strip.button = std::min(kButton, std::floor(left / strip.rows - kGap));
        if (strip.button >= kMinButton || strip.rows == 1) {
            strip.button = std::max(strip.button, kMinButton);
            return strip;
        }
    }
}

void drawToolStrip(Shell &context, const PixelRect &rect) {
    const Strip strip = stripOf(context, rect.height);
    beginRegion("##tools", rect, context.theme.panel, context.px(kPadX), context.px(kPadY));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(kGap), context.px(kGap)));
    const std::vector<ToolSlot> slots = toolSlots(context);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (i % static_cast<std::size_t>(strip.columns) != 0) {
            ImGui::SameLine();
        } else if (strip.lines && slots[i].begins) {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float y = std::round(at.y + context.px(0.5 * (kLine - kGap)));
            list.AddLine({at.x + context.px(4), y}, {at.x + context.px(strip.button - 4.0), y}, context.theme.line);
            ImGui::SetCursorScreenPos({at.x, at.y + context.px(kLine)});
        }
        drawSlot(context, slots[i], context.px(strip.button));
    }
    ImGui::PopStyleVar();
    const float x = static_cast<float>(rect.x + rect.width) - 1.0F;
    list.AddLine({x, static_cast<float>(rect.y)}, {x, static_cast<float>(rect.y + rect.height)}, context.theme.line);
    ImGui::End();
}

} // namespace forefront::shell
