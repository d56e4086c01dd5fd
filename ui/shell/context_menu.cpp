#include "ui/shell/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <string>
#include <utility>

namespace forefront::shell {
namespace {

constexpr const char *kPrefix = "contextmenu/"; ///< of the names of widgets

void ownItem(Shell &context, const ContextItem &item) {
    const std::string name = kPrefix + item.own.id;
    ImGui::PushID(name.c_str());
    ImGui::PushStyleColor(ImGuiCol_TextDisabled, context.theme.muted);
    const bool chosen = ImGui::MenuItem(item.own.title.c_str(), item.own.detail.c_str(), item.checked);
    ImGui::PopStyleColor();
    ui::mark(context, name);
    ImGui::PopID();
    if (chosen) {
        item.own.run(context);
        context.animate();
    }
}

/// Draws the groups. Actions that cannot run now are left out.
void drawItems(Shell &context) {
    bool first = true;
    for (const ContextGroup &group : context.menu.shown) {
        bool begun = false;
        for (const ContextItem &item : group) {
            const Action *const action = item.action.empty() ? nullptr : context.actions.find(item.action);
            const bool missing = action == nullptr || (action->enabled && !action->enabled(context));
            if (missing && !item.action.empty()) {
                continue;
            }
            if (!std::exchange(begun, true) && !std::exchange(first, false)) {
                ImGui::Separator();
            }
            if (action == nullptr) {
                ownItem(context, item);
            } else {
                action->entries ? submenu(context, *action, kPrefix) : actionItem(context, *action, kPrefix);
            }
        }
    }
}

} // namespace

void drawContextMenu(Shell &context) {
    constexpr const char *kPopup = "##contextmenu";
    ContextMenu &menu = context.menu;
    if (std::exchange(context.contextMenu, false)) {
        const Vec2 place = context.view.pointer.value_or(context.view.camera.centre);
        std::vector<ContextGroup> groups = context.tools.current().menu(context, place);
        for (ContextGroup &group : selectionMenu()) {
            groups.push_back(std::move(group));
        }
        menu.open(std::move(groups));
    }
    if (std::exchange(menu.opens, false)) {
        menu.shown = std::exchange(menu.wanted, {});
        menu.at = {ImGui::GetMousePos().x, ImGui::GetMousePos().y};
        ImGui::OpenPopup(kPopup);
        context.animate();
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(6), context.px(6)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(10), context.px(7)));
    if (ImGui::BeginPopup(kPopup)) {
        ui::markWindow(context, "contextmenu");
        menu.running = true;
        drawItems(context);
        menu.running = false;
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

} // namespace forefront::shell
