#include "ui/dialogs/preferences_dialog.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
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

/// Returns the tools of the workspace.
std::vector<const Tool *> stripTools(const Shell &context) {
    std::vector<const Tool *> tools;
    for (const auto &tool : context.tools.tools) {
        if (isInStrip(context, *tool)) {
            tools.push_back(tool.get());
        }
    }
    return tools;
}

constexpr double kGap = 3.0, kPadX = 6.0, kPadY = 8.0, kButton = 34.0, kMinButton = 27.0; // design pixels

} // namespace

double Strip::width() const {
    return 2.0 * kPadX + columns * (button + kGap) - kGap;
}

Strip stripOf(const Shell &context, double height) {
    const auto count = static_cast<int>(stripTools(context).size());
    const double room = height / static_cast<double>(context.scale) - 2.0 * kPadY + kGap;
    Strip strip{.columns = 1, .rows = count, .button = kButton};
    for (;; ++strip.columns) {
        strip.rows = (count + strip.columns - 1) / strip.columns;
        strip.button = std::min(kButton, std::floor(room / strip.rows - kGap));
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
    const std::vector<const Tool *> tools = stripTools(context);
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Tool &tool = *tools[i];
        std::string tip = tool.name();
        const Action *const action = context.actions.find(std::string("tool.") + tool.id());
        if (action != nullptr && !action->shortcuts.empty()) {
            tip += "  (" + toString(action->shortcuts.front()) + ")";
        }
        if (i % static_cast<std::size_t>(strip.columns) != 0) {
            ImGui::SameLine();
        }
        if (ui::iconButton(context, std::string("tool/") + tool.id(), tool.icon(), tip,
                           &tool == &context.tools.current(), true, static_cast<float>(strip.button))) {
            context.tools.choose(tool.id(), context);
        }
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
            openToolMenu(context, tool);
        }
    }
    ImGui::PopStyleVar();
    const float x = static_cast<float>(rect.x + rect.width) - 1.0F;
    ImGui::GetWindowDrawList()->AddLine({x, static_cast<float>(rect.y)}, {x, static_cast<float>(rect.y + rect.height)},
                                        context.theme.line);
    ImGui::End();
}

} // namespace forefront::shell
