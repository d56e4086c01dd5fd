#include "ui/dialogs/key_list.hpp"

#include "core/engine/base/letter_case.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>

namespace forefront {
namespace {

std::string labelOf(const Action &action) {
    return action.menu.empty() ? action.title : action.menu + "  \xe2\x80\xba  " + action.title;
}

bool contains(std::string_view text, std::string_view word) {
    return lowerCase(text).find(lowerCase(word)) != std::string::npos;
}

std::string keysOf(const Action &action) {
    std::string text;
    for (const Shortcut &shortcut : action.shortcuts) {
        text += (text.empty() ? "" : "   ") + toString(shortcut);
    }
    return text.empty() ? "\xe2\x80\x93" : text;
}

/// Returns the key pressed in this frame with its modifiers, if it can be a shortcut.
std::optional<Shortcut> pressedShortcut() {
    const ImGuiIO &io = ImGui::GetIO();
    const Modifiers held{static_cast<std::uint8_t>((io.KeyShift ? Modifiers::kShift : 0) |
                                                   (io.KeyCtrl ? Modifiers::kControl : 0) |
                                                   (io.KeyAlt ? Modifiers::kAlt : 0))};
    for (int code = key::kSpace; code < key::kLeftShift; ++code) {
        const Shortcut shortcut{code, held};
        if (imgui::keyPressed(code, false) && parseShortcut(toString(shortcut)) == shortcut) {
            return shortcut;
        }
    }
    return std::nullopt;
}

/// Rebinds an action and saves that in the settings, unless the keys are the default ones.
void rebind(Shell &context, const std::string &action, std::optional<Shortcut> shortcut) {
    context.actions.rebind(action, shortcut);
    context.settings.keys[action] = shortcut ? toString(*shortcut) : std::string();
}

void reset(Shell &context, const std::string &action) {
    context.actions.resetShortcuts(action);
    context.settings.keys.erase(action);
}

/// Says which of the actions with the same key it runs: the first one that is possible, in their order in the list.
void drawConflict(Shell &context, const Action &action, const std::vector<const Action *> &others) {
    const std::vector<Action> &all = context.actions.all();
    const auto first = std::find_if(all.begin(), all.end(), [&](const Action &candidate) {
        return candidate.id == action.id || candidate.id == others.front()->id;
    });
    const bool wins = first->id == action.id;
    const std::string more = others.size() > 1 ? " and " + std::to_string(others.size() - 1) + " more" : "";
    const std::string name = "dialog/preferences/conflict/" + action.id;
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.warn);
    ImGui::TextUnformatted(
        (wins ? "wins over " + others.front()->title + more : "loses to " + others.front()->title).c_str());
    ImGui::PopStyleColor();
    ui::mark(context, name);
    ui::mark(context, name + (wins ? "/wins" : "/loses"));
    ui::tooltip(context, "The key runs " + first->title + " whenever that is possible. Give one of them another key.");
}

} // namespace

/// Assigns the next key pressed: Esc cancels, Backspace removes the key.
void KeyList::capture(Shell &context) {
    context.animate();
    if (justBegun_) {
        justBegun_ = false; // the key that pressed the button
        return;
    }
    const std::optional<Shortcut> pressed = pressedShortcut();
    if (!pressed) {
        return;
    }
    if (*pressed == Shortcut{key::kBackspace, {}}) {
        rebind(context, capturing_, std::nullopt);
    } else if (!(*pressed == Shortcut{key::kEscape, {}})) {
        rebind(context, capturing_, pressed);
    }
    capturing_.clear();
}

void KeyList::drawRow(Shell &context, const Action &action) {
    const std::string name = "dialog/preferences/key/" + action.id;
    const bool waits = capturing_ == action.id;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(labelOf(action).c_str());
    ImGui::SameLine(context.px(290));
    const std::string keys = waits ? std::string("press a key\xe2\x80\xa6") : keysOf(action);
    if (ui::button(context, name, keys, waits ? ui::ButtonKind::Primary : ui::ButtonKind::Plain, true, 130.0F)) {
        capturing_ = waits ? std::string() : action.id;
        justBegun_ = true;
    }
    ui::tooltip(context, "Click, then press a key. Backspace: no key. Esc: cancel.");
    ImGui::SameLine(0, context.px(8));
    const std::vector<const Action *> others = context.actions.conflicts(action);
    const bool changed = context.settings.keys.contains(action.id);
    if (changed && ui::button(context, "dialog/preferences/reset/" + action.id, "Reset", ui::ButtonKind::Quiet)) {
        reset(context, action.id);
    }
    if (!others.empty()) {
        if (changed) {
            ImGui::SameLine(0, context.px(8));
        }
        drawConflict(context, action, others);
    } else if (!changed) {
        ImGui::NewLine();
    }
}

void KeyList::draw(Shell &context) {
    if (capturing()) {
        capture(context);
    }
    ui::inputText(context, "dialog/preferences/keys/find", query_, "Find a command", 420.0F);
    ImGui::SameLine(0, context.px(8));
    if (ui::button(context, "dialog/preferences/keys/reset", "Reset all", ui::ButtonKind::Plain,
                   !context.settings.keys.empty())) {
        while (!context.settings.keys.empty()) {
            reset(context, std::string(context.settings.keys.begin()->first));
        }
    }
    ui::small(context,
              "Fixed: arrows move the selection, Enter finishes, Esc cancels, Backspace removes the last node, Tab "
              "goes to the next number, and X, Y, D, Q and the first letters of parameters open a number while you "
              "draw.",
              true);
    ImGui::Dummy({0, context.px(4)});
    ImGui::BeginChild("keys", {0, 0}, false, ImGuiWindowFlags_NoNav);
    for (const Action &action : context.actions.all()) {
        if (query_.empty() || contains(labelOf(action) + ' ' + keysOf(action), query_)) {
            drawRow(context, action);
        }
    }
    ImGui::EndChild();
}

} // namespace forefront
