#include "ui/parts/action.hpp"

#include "ui/parts/shell.hpp"

#include <algorithm>

namespace forefront {

std::string toString(Shortcut shortcut) {
    if (shortcut.key == 0) {
        return {};
    }
    if (shortcut == Shortcut{key::kSlash, {Modifiers::kShift}}) {
        return "?"; // the usual spelling
    }
    std::string text;
    if (shortcut.modifiers.control()) {
        text += "Ctrl+";
    }
    if (shortcut.modifiers.alt()) {
        text += "Alt+";
    }
    if (shortcut.modifiers.shift()) {
        text += "Shift+";
    }
    static constexpr std::pair<int, const char *> kNames[] = {
        {key::kSpace, "Space"},
        {key::kEscape, "Esc"},
        {key::kEnter, "Enter"},
        {key::kTab, "Tab"},
        {key::kHome, "Home"},
        {key::kEnd, "End"},
        {key::kBackspace, "Backspace"},
        {key::kDelete, "Delete"},
        {key::kLeft, "Left"},
        {key::kRight, "Right"},
        {key::kUp, "Up"},
        {key::kDown, "Down"},
        {key::kPageUp, "PgUp"},
        {key::kPageDown, "PgDn"},
    };
    for (const auto &[code, name] : kNames) {
        if (code == shortcut.key) {
            return text + name;
        }
    }
    if (shortcut.key >= key::kF1 && shortcut.key < key::kF1 + 12) {
        return text + "F" + std::to_string(shortcut.key - key::kF1 + 1);
    }
    return text + static_cast<char>(shortcut.key);
}

void ActionRegistry::add(Action action) {
    const auto known =
        std::find_if(actions_.begin(), actions_.end(), [&](const Action &a) { return a.id == action.id; });
    if (known != actions_.end()) {
        *known = std::move(action);
    } else {
        actions_.push_back(std::move(action));
    }
}

const Action *ActionRegistry::find(std::string_view id) const {
    const auto found = std::find_if(actions_.begin(), actions_.end(), [&](const Action &a) { return a.id == id; });
    return found == actions_.end() ? nullptr : &*found;
}

bool ActionRegistry::run(std::string_view id, Shell &context) const {
    const Action *action = find(id);
    if (action == nullptr || (action->enabled && !action->enabled(context))) {
        return false;
    }
    action->run(context);
    return true;
}

bool ActionRegistry::knows(Shortcut shortcut) const {
    return std::any_of(actions_.begin(), actions_.end(), [&](const Action &a) {
        return std::find(a.shortcuts.begin(), a.shortcuts.end(), shortcut) != a.shortcuts.end();
    });
}

bool ActionRegistry::repeats(int key) const {
    return std::any_of(actions_.begin(), actions_.end(), [key](const Action &a) {
        return a.repeats && std::any_of(a.shortcuts.begin(), a.shortcuts.end(),
                                        [key](const Shortcut &shortcut) { return shortcut.key == key; });
    });
}

bool ActionRegistry::runShortcut(Shortcut shortcut, bool repeated, Shell &context) const {
    for (const Action &action : actions_) {
        const bool matches =
            std::find(action.shortcuts.begin(), action.shortcuts.end(), shortcut) != action.shortcuts.end();
        if (matches && (!repeated || action.repeats) && (!action.enabled || action.enabled(context))) {
            action.run(context);
            return true;
        }
    }
    return false;
}

} // namespace forefront
