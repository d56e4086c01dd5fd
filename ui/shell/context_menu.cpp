#include "ui/shell/main_window.hpp"
#include "ui/shell/menu_choice.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {
namespace {

constexpr const char *kPrefix = "contextmenu/"; ///< of the names of widgets

void headingItem(Shell &context, const ContextItem &item) {
    ImGui::PushFont(context.fonts.heading);
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    ImGui::TextUnformatted(item.own.title.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void ownItem(Shell &context, const ContextItem &item) {
    const std::string name = kPrefix + item.own.id;
    ImGui::PushID(name.c_str());
    ImGui::PushStyleColor(ImGuiCol_TextDisabled, context.theme.muted);
    const bool chosen = ImGui::MenuItem(item.own.title.c_str(), item.own.detail.c_str(), item.checked);
    ImGui::PopStyleColor();
    noteMenuItem(context, item.own.title, true);
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
                item.own.run ? ownItem(context, item) : headingItem(context, item);
            } else {
                action->entries ? submenu(context, *action, kPrefix) : actionItem(context, *action, kPrefix);
            }
        }
    }
}

/// Returns the menu of a text field. Its commands change the whole text at once, since the field loses the focus to the
/// menu.
std::vector<ContextGroup> fieldMenu(const FieldFocus::Clicked &field) {
    const std::string head = field.text.substr(0, field.begin), tail = field.text.substr(field.end);
    const std::string chosen = field.text.substr(field.begin, field.end - field.begin);
    const auto replaceBy = [name = field.name](std::string text) {
        return [name, text = std::move(text)](Shell &c) { c.widgets.fields.replace(name, text); };
    };
    ContextGroup edit, whole;
    if (!chosen.empty()) {
        edit.push_back(commandOf(
            "field/cut", "Cut",
            [chosen, cut = replaceBy(head + tail)](Shell &c) {
                c.platform.setClipboard(chosen);
                cut(c);
            },
            "Ctrl+X"));
        edit.push_back(commandOf(
            "field/copy", "Copy", [chosen](Shell &c) { c.platform.setClipboard(chosen); }, "Ctrl+C"));
    }
    edit.push_back(commandOf(
        "field/paste", "Paste",
        [name = field.name, head, tail](Shell &c) {
            std::string pasted = c.platform.clipboard();
            std::erase_if(pasted, [](char letter) { return letter == '\n' || letter == '\r'; });
            c.widgets.fields.replace(name, head + pasted + tail);
        },
        "Ctrl+V"));
    whole.push_back(commandOf(
        "field/selectAll", "Select all", [name = field.name](Shell &c) { c.widgets.fields.request(name); }, "Ctrl+A"));
    if (!field.value.empty()) {
        whole.push_back(commandOf("field/value", "Replace with its value", replaceBy(field.value), field.value));
    }
    return {std::move(edit), std::move(whole)};
}

} // namespace

void drawContextMenu(Shell &context) {
    constexpr const char *kPopup = "##contextmenu";
    ContextMenu &menu = context.menu;
    const std::optional<FieldFocus::Clicked> field = std::exchange(context.widgets.fields.clicked, std::nullopt);
    if (field && !context.dialogs.any()) { // a menu would close the dialog around the field
        std::vector<ContextGroup> groups = menu.opens ? std::move(menu.wanted) : std::vector<ContextGroup>();
        for (ContextGroup &group : fieldMenu(*field)) { // below the menu of its row, if that has one
            groups.push_back(std::move(group));
        }
        menu.open(std::move(groups));
    }
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
        endMenuItems(context);
        menu.running = false;
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

} // namespace forefront::shell
