#include "ui/shell/menu_choice.hpp"

#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"

#include <imgui.h>
#include <imgui_internal.h>

namespace forefront::shell {
namespace {

/// Highlights an item as the arrow keys do; Enter runs it.
void choose(ImGuiID id, const ImRect &relative) {
    imgui::highlightItem(id, relative.Min, relative.Max);
    ImGui::SetScrollHereY();
}

char capital(char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
}

} // namespace

void noteMenuItem(Shell &context, std::string_view title, bool enabled, bool opensSubmenu) {
    MenuKeys &keys = context.menuKeys;
    const ImGuiContext &gui = *ImGui::GetCurrentContext();
    const ImGuiID id = ImGui::GetItemID();
    const ImGuiWindow &window = *gui.CurrentWindow;
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const ImRect relative{{min.x - window.Pos.x, min.y - window.Pos.y}, {max.x - window.Pos.x, max.y - window.Pos.y}};
    const bool chosen = gui.NavId == id && gui.NavWindow == &window && imgui::anyHighlight();
    keys.onSubmenu = chosen ? opensSubmenu : keys.onSubmenu;
    if (!enabled) {
        return;
    }
    if (keys.highlights) {
        keys.highlights = false;
        choose(id, relative);
        return;
    }
    if (keys.letter == 0 || gui.NavWindow != &window) {
        return;
    }
    const bool begins = !title.empty() && capital(title.front()) == keys.letter;
    if (begins && keys.passed) {
        choose(id, relative);
        keys.letter = 0;
    } else if (begins && !keys.first) {
        keys.first = {id, {min.x - window.Pos.x, min.y - window.Pos.y, max.x - min.x, max.y - min.y}};
    }
    keys.passed = keys.passed || chosen;
}

void endMenuItems(Shell &context) {
    MenuKeys &keys = context.menuKeys;
    if (keys.letter != 0 && keys.first) {
        const PixelRect &at = keys.first->at;
        const auto number = [](double value) { return static_cast<float>(value); };
        choose(keys.first->id, {{number(at.x), number(at.y)}, {number(at.x + at.width), number(at.y + at.height)}});
    }
    keys.letter = 0;
    keys.passed = false;
    keys.first.reset();
}

} // namespace forefront::shell
