#include "ui/shell/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <array>
#include <utility>

namespace forefront::shell {
namespace {

constexpr const char *kPrefix = "contextmenu/"; ///< of the names of widgets

/// The actions of the menu in groups. Those that cannot run now are left out.
constexpr std::array<std::array<const char *, 7>, 5> kGroups{
    {{"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete"},
     {"path.corner", "path.smooth", "path.symmetric", "path.line", "path.curve", "path.split", "path.join"},
     {"shape.transform", "shape.mirrorX", "shape.mirrorY", "shape.arrange", "shape.linearArray", "shape.polarArray"},
     {"shape.fillet", "shape.chamfer", "shape.offset", "edit.union", "edit.difference", "edit.toPath"},
     {"shape.hide", "shape.isolate", "shape.lock", "shape.showAll", "shape.unlockAll", "edit.selectAll", "view.fit"}}};

void drawItems(Shell &context) {
    bool first = true;
    for (const auto &group : kGroups) {
        bool begun = false;
        for (const char *id : group) {
            const Action *const action = id == nullptr ? nullptr : context.actions.find(id);
            if (action == nullptr || (action->enabled && !action->enabled(context))) {
                continue;
            }
            if (!std::exchange(begun, true) && !std::exchange(first, false)) {
                ImGui::Separator();
            }
            action->entries ? submenu(context, *action, kPrefix) : actionItem(context, *action, kPrefix);
        }
    }
}

} // namespace

void drawContextMenu(Shell &context) {
    constexpr const char *kPopup = "##contextmenu";
    if (std::exchange(context.contextMenu, false)) {
        ImGui::OpenPopup(kPopup);
        context.animate();
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(6), context.px(6)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(10), context.px(7)));
    if (ImGui::BeginPopup(kPopup)) {
        ui::markWindow(context, "contextmenu");
        drawItems(context);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

} // namespace forefront::shell
