#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/menu_choice.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/tooltip.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::shell {

namespace {

constexpr std::array<const char *, 7> kMenus{"File", "Edit", "Shape", "View", "Mesh", "Learn", "Help"};
constexpr std::string_view kMnemonics = "FESVMNH"; ///< letters that open the menus with Alt; Alt+L unlocks shapes

/// Returns what an action that is not enabled needs, as a sentence.
std::string tipOf(const Action &action) {
    std::string tip = action.needs;
    if (!tip.empty()) {
        tip.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(tip.front())));
    }
    return tip;
}

} // namespace

void actionItem(Shell &context, const Action &action, std::string_view prefix) {
    const bool enabled = !action.enabled || action.enabled(context);
    const bool checked = action.checked && action.checked(context);
    const std::string title = action.dynamic ? action.dynamic(context) : action.title;
    const std::string shortcut = action.shortcuts.empty() ? std::string() : toString(action.shortcuts.front());
    const std::string name = std::string(prefix) + action.id;
    ImGui::PushID(name.c_str());
    ImGui::PushStyleColor(ImGuiCol_TextDisabled, context.theme.muted); // the colour of the shortcut, not of the item
    const bool chosen = ImGui::MenuItem(title.c_str(), shortcut.c_str(), checked, enabled);
    ImGui::PopStyleColor();
    noteMenuItem(context, title, enabled);
    ui::mark(context, name, enabled);
    if (!enabled) {
        ui::tooltip(context, tipOf(action));
    }
    ImGui::PopID();
    if (chosen) {
        action.run(context);
    }
}

void submenu(Shell &context, const Action &action, std::string_view prefix) {
    const std::vector<MenuEntry> entries = action.entries(context);
    const std::string name = std::string(prefix) + action.id;
    const bool open = ImGui::BeginMenu(action.title.c_str(), !entries.empty());
    if (!open) {
        noteMenuItem(context, action.title, !entries.empty(), true);
    }
    ui::mark(context, name, !entries.empty());
    if (entries.empty()) {
        ui::tooltip(context, tipOf(action));
    }
    if (!open) {
        return;
    }
    const MenuEntry *chosen = nullptr;
    for (const MenuEntry &entry : entries) {
        const std::string id = name + '/' + entry.id;
        ImGui::PushID(id.c_str());
        ImGui::PushStyleColor(ImGuiCol_TextDisabled, context.theme.muted);
        chosen = ImGui::MenuItem(entry.title.c_str(), entry.detail.c_str()) ? &entry : chosen;
        ImGui::PopStyleColor();
        noteMenuItem(context, entry.title, true);
        ui::mark(context, id);
        ImGui::PopID();
    }
    ImGui::EndMenu();
    if (chosen != nullptr) {
        chosen->run(context);
    }
}

namespace {

void drawMenu(Shell &context, const char *menu) {
    bool first = true;
    for (const Action &action : context.actions.all()) {
        if (action.menu != menu) {
            continue;
        }
        if (action.separatorBefore && !first) {
            ImGui::Separator();
        }
        first = false;
        action.entries ? submenu(context, action) : actionItem(context, action);
    }
    endMenuItems(context);
}

std::string popupOf(const char *menu) {
    return std::string("##menu") + menu;
}

/// Returns the menu that a key opens: by its letter, or beside the open one; null if there is none.
const char *menuByKey(MenuKeys &keys) {
    const char mnemonic = std::exchange(keys.mnemonic, 0);
    const int step = std::exchange(keys.step, 0);
    if (const std::size_t at = kMnemonics.find(mnemonic); mnemonic != 0 && at != std::string_view::npos) {
        return kMenus[at];
    }
    const bool intoSubmenu = step > 0 && keys.onSubmenu;
    if (step == 0 || intoSubmenu || ImGui::GetCurrentContext()->OpenPopupStack.Size != 1) {
        return nullptr;
    }
    for (std::size_t k = 0; k < kMenus.size(); ++k) {
        if (ImGui::IsPopupOpen(popupOf(kMenus[k]).c_str())) {
            return kMenus[(k + kMenus.size() + static_cast<std::size_t>(step)) % kMenus.size()];
        }
    }
    return nullptr;
}

/// Underlines the letter of a menu while Alt is held.
void underlineMnemonic(const char *menu, char mnemonic) {
    if (!ImGui::GetIO().KeyAlt) {
        return;
    }
    const std::string_view title = menu;
    const auto at = std::find_if(title.begin(), title.end(), [mnemonic](char letter) {
        return letter == mnemonic || letter - 'a' + 'A' == mnemonic;
    });
    const float from = ImGui::GetItemRectMin().x + ImGui::GetStyle().FramePadding.x;
    const float left = from + ImGui::CalcTextSize(title.data(), at).x;
    const float right = from + ImGui::CalcTextSize(title.data(), at + 1).x;
    const float y = ImGui::GetItemRectMax().y - ImGui::GetStyle().FramePadding.y;
    ImGui::GetWindowDrawList()->AddLine({left, y}, {right, y}, ImGui::GetColorU32(ImGuiCol_Text));
}

constexpr double kLeastTitle = 64.0; ///< width of a title without its middle that can be read, in design pixels

/// Draws the title of the document in the middle between two places, without its middle if it does not fit, and not at
/// all if too little of it would be left; the dot of unsaved changes stays.
void drawTitle(Workspace &context, const PixelRect &rect, float from, float to) {
    const std::string dot = context.document.dirty() ? " \xe2\x80\xa2" : "";
    const float room = to - from - ImGui::CalcTextSize(dot.c_str()).x;
    const std::string &whole = context.document.title();
    const bool readable = room >= std::min(ImGui::CalcTextSize(whole.c_str()).x, context.px(kLeastTitle));
    const std::string title = (readable ? ui::withoutMiddle(whole, room) : std::string()) + dot;
    const ImVec2 size = ImGui::CalcTextSize(title.c_str());
    if (title.empty() || size.x > to - from) {
        return;
    }
    const float x = std::max(from, (from + to - size.x) / 2);
    const float y = (static_cast<float>(rect.height) - size.y) / 2;
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    ImGui::GetWindowDrawList()->AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), title.c_str());
    ImGui::PopStyleColor();
    ui::markRect(context, "menu/title", {x, y, std::min(size.x, to - x), size.y});
    if (!dot.empty()) {
        const double width = ImGui::CalcTextSize(dot.c_str()).x;
        ui::markRect(context, "menu/unsaved", {x + size.x - width, y, width, size.y});
    }
    ui::tooltipOver(context, {x, y, size.x, size.y}, context.document.title());
}

/// Draws the switch between the workspaces, in the middle of the bar if the menus leave room. Returns its right end.
float drawWorkspaces(Shell &context, const PixelRect &rect, float from, float to) {
    std::array<const char *, kWorkspaceKinds.size()> names{}, tips{};
    std::array<std::string, kWorkspaceKinds.size()> texts;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const WorkspacePreset &preset = presetOf(kWorkspaceKinds[k]);
        const Action *const action = context.actions.find(std::string("workspace.") + preset.word);
        names[k] = preset.name;
        texts[k] = preset.about;
        if (action != nullptr && !action->shortcuts.empty()) {
            texts[k] += " (" + toString(action->shortcuts.front()) + ")";
        }
        tips[k] = texts[k].c_str();
    }
    constexpr double kMostSwitch = 380.0, kLeastSwitch = 250.0; // design pixels
    const bool narrow = to - from < context.px(kLeastSwitch);
    const float width = narrow ? std::max(1.0F, std::min(to - from, context.px(84)))
                               : std::clamp((to - from) * 0.6F, context.px(kLeastSwitch), context.px(kMostSwitch));
    const float x = std::max(from, std::min((static_cast<float>(rect.width) - width) / 2, to - width));
    ImGui::SetCursorPos({x, (static_cast<float>(rect.height) - ImGui::GetFrameHeight()) / 2});
    int chosen = static_cast<int>(context.settings.workspace);
    if (narrow ? ui::combo(context, "workspace", names, chosen, width / context.scale)
               : ui::segmented(context, "workspace", names, chosen, width / context.scale, tips)) {
        chooseWorkspace(context, static_cast<WorkspaceKind>(chosen));
    }
    ui::markRect(context, "workspace", {static_cast<double>(x), rect.y, static_cast<double>(width), rect.height});
    return x + width;
}

constexpr double kExportButton = 84.0; // design pixels

/// Draws the button at the right end of the bar that exports the mesh.
void drawExport(Shell &context, const PixelRect &rect) {
    const Action *const action = context.actions.find("file.export");
    const bool enabled = action != nullptr && (!action->enabled || action->enabled(context));
    ImGui::SetCursorPosY((static_cast<float>(rect.height) - ImGui::GetFrameHeight()) / 2);
    if (ui::button(context, "menu/export", "Export", ui::ButtonKind::Primary, enabled,
                   static_cast<float>(kExportButton))) {
        context.actions.run("file.export", context);
    }
    ui::tooltip(context, exportLabel(context) + " (Ctrl+E)");
}

constexpr double kSearchField = 136.0; // design pixels

/// Draws a field that opens the command palette, which takes over its focus, with the key that does the same.
void drawSearch(Shell &context, const PixelRect &rect) {
    const float width = context.px(kSearchField), height = context.px(26);
    ImGui::SetCursorPosY((static_cast<float>(rect.height) - height) / 2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ui::hitArea("##search", width, height)) {
        context.actions.run("view.palette", context);
    }
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, "menu/palette");
    const Theme &theme = context.theme;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + width, at.y + height};
    list.AddRectFilled(at, end, theme.inset, context.px(4));
    list.AddRect(at, end, hovered ? theme.text : theme.fieldBorder, context.px(4));
    const float y = at.y + (height - ImGui::GetFontSize()) / 2;
    list.AddText({at.x + context.px(8), y}, theme.muted, icon::kSearch);
    list.AddText({at.x + context.px(28), y}, theme.placeholder, "Search");
    const Action *const action = context.actions.find("view.palette");
    if (action != nullptr && !action->shortcuts.empty()) {
        const std::string key = toString(action->shortcuts.front());
        list.AddText({end.x - context.px(8) - ImGui::CalcTextSize(key.c_str()).x, y}, theme.muted, key.c_str());
    }
    ui::tooltip(context, "Search all commands");
}

void drawRightEnd(Shell &context, const PixelRect &rect) {
    const float width = static_cast<float>(rect.width), menus = ImGui::GetCursorPosX() + context.px(12);
    const float icon = context.px(26);
    constexpr double kSearchBar = 1240.0; // design pixels; a narrower bar has an icon for the search
    const bool searches = rect.width >= static_cast<double>(context.px(kSearchBar));
    const float count = searches ? 3.0F : 4.0F;
    const float icons = width - context.px(10) - count * icon - (count - 1.0F) * context.px(4);
    float end = icons - context.px(8);
    constexpr double kLeastSwitch = 84.0; // design pixels, that the switch of workspaces keeps
    constexpr double kLeastBar = 880.0;   // design pixels; on a narrower one, the title needs the room
    if (rect.width >= static_cast<double>(context.px(kLeastBar)) &&
        end - menus >= context.px(kExportButton + kLeastSwitch)) {
        end -= context.px(kExportButton);
        ImGui::SetCursorPosX(end);
        drawExport(context, rect);
        end -= context.px(8);
    }
    if (searches) {
        end -= context.px(kSearchField);
        ImGui::SetCursorPosX(end);
        drawSearch(context, rect);
        end -= context.px(8);
    }
    const float used = drawWorkspaces(context, rect, menus, end);
    if (context.tabs.size() < 2) { // else its tab shows it
        drawTitle(context, rect, used + context.px(14), end - context.px(4));
    }
    ImGui::SetCursorPos({icons, (static_cast<float>(rect.height) - icon) / 2});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(4), 0));
    const bool shown = columnShown(context);
    if (ui::iconButton(context, "menu/panels", icon::kPanels, shown ? "Hide panels (Tab)" : "Show panels (Tab)",
                       shown && columnFloats(context), true, 26.0F)) {
        context.actions.run("view.panels", context);
    }
    ImGui::SameLine();
    if (!searches) {
        if (ui::iconButton(context, "menu/palette", icon::kSearch, "Command palette (Ctrl+P)", false, true, 26.0F)) {
            context.actions.run("view.palette", context);
        }
        ImGui::SameLine();
    }
    const bool dark = context.theme.kind == ThemeKind::Dark;
    if (ui::iconButton(context, "menu/theme", icon::kTheme, dark ? "Light theme" : "Dark theme", false, true, 26.0F)) {
        context.actions.run("view.theme", context);
    }
    ImGui::SameLine();
    if (ui::iconButton(context, "menu/shortcuts", icon::kKeyboard, "Keyboard shortcuts (?)", false, true, 26.0F)) {
        context.actions.run("help.shortcuts", context);
    }
    ImGui::PopStyleVar();
}

} // namespace

void drawMenuBar(Shell &context, const PixelRect &rect) {
    beginRegion("##menubar", rect, context.theme.panel, context.px(10), 0);
    const float height = static_cast<float>(rect.height);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(9), context.px(4)));
    const char *const byKey = menuByKey(context.menuKeys);
    for (const char *const &menu : kMenus) {
        const std::string popup = popupOf(menu);
        const bool open = ImGui::IsPopupOpen(popup.c_str());
        ImGui::SetCursorPosY((height - ImGui::GetFrameHeight()) / 2);
        const std::string name = std::string("menu/") + menu;
        ImGui::PushStyleColor(ImGuiCol_Button, open ? context.theme.hovered : Colour());
        const bool pressed = ImGui::Button(menu);
        ImGui::PopStyleColor();
        ui::mark(context, name);
        underlineMnemonic(menu, kMnemonics[static_cast<std::size_t>(&menu - kMenus.data())]);
        const ImVec2 corner{ImGui::GetItemRectMin().x, static_cast<float>(rect.y + rect.height)};
        // Once a menu is open, its neighbours open as the pointer passes over them.
        const bool slides = !open && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId) &&
                            ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup);
        if (pressed || slides || byKey == menu) {
            ImGui::OpenPopup(popup.c_str());
            context.menuKeys.highlights = byKey == menu;
            context.animate();
        }
        ImGui::SetNextWindowPos(corner);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(6), context.px(6)));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(10), context.px(7)));
        if (ImGui::BeginPopup(popup.c_str())) {
            drawMenu(context, menu);
            ImGui::EndPopup();
        }
        ImGui::PopStyleVar(2);
        ImGui::SameLine(0, context.px(2));
    }
    ImGui::PopStyleVar();
    ImGui::SetCursorPosY((height - ImGui::GetFontSize()) / 2);
    drawRightEnd(context, rect);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        context.menu.open({actionsOf({"view.panels", "view.rulers", "view.hints", "view.theme"}),
                           actionsOf({"view.palette", "edit.preferences"})});
    }
    const float y = static_cast<float>(rect.y + rect.height) - 1.0F;
    ImGui::GetWindowDrawList()->AddLine({0, y}, {static_cast<float>(rect.width), y}, context.theme.line);
    ImGui::End();
}

} // namespace forefront::shell
