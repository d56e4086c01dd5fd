#include "ui/parts/action.hpp"

#include "ui/parts/shell.hpp"

#include <algorithm>

namespace forefront {

namespace {

struct KeyName {
    int key;
    const char *name;
};
constexpr KeyName kNames[] = {
    {key::kSpace, "Space"},   {key::kEscape, "Esc"},  {key::kEnter, "Enter"},   {key::kTab, "Tab"},
    {key::kHome, "Home"},     {key::kEnd, "End"},     {key::kInsert, "Insert"}, {key::kBackspace, "Backspace"},
    {key::kDelete, "Delete"}, {key::kLeft, "Left"},   {key::kRight, "Right"},   {key::kUp, "Up"},
    {key::kDown, "Down"},     {key::kPageUp, "PgUp"}, {key::kPageDown, "PgDn"},
};

/// Returns the name of a key; empty for keys that cannot be in a shortcut.
std::string nameOf(int code) {
    for (const KeyName &known : kNames) {
        if (known.key == code) {
            return known.name;
        }
    }
    if (code >= key::kF1 && code < key::kF1 + 12) {
        return "F" + std::to_string(code - key::kF1 + 1);
    }
    return code > ' ' && code < 127 ? std::string(1, static_cast<char>(code)) : std::string();
}

} // namespace

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
    return text + nameOf(shortcut.key);
}

std::optional<Shortcut> parseShortcut(std::string_view text) {
    constexpr int kLastKey = key::kF1 + 11;
    for (int code = key::kSpace; code <= kLastKey; ++code) {
        for (std::uint8_t bits = 0; bits < 8; ++bits) {
            const Shortcut candidate{code, {bits}};
            if (!nameOf(code).empty() && toString(candidate) == text) {
                return candidate;
            }
        }
    }
    return std::nullopt;
}

void ActionRegistry::add(Action action) {
    action.defaults = action.shortcuts;
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
    if (action == nullptr || !action->run || (action->enabled && !action->enabled(context))) {
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

void ActionRegistry::explain(std::string_view id, std::string needs) {
    const auto action = std::find_if(actions_.begin(), actions_.end(), [&](const Action &a) { return a.id == id; });
    if (action != actions_.end()) {
        action->needs = std::move(needs);
    }
}

const Action *ActionRegistry::waiting(Shortcut shortcut, const Shell &context) const {
    const auto action = std::find_if(actions_.begin(), actions_.end(), [&](const Action &a) {
        return !a.needs.empty() && a.enabled && !a.enabled(context) &&
               std::find(a.shortcuts.begin(), a.shortcuts.end(), shortcut) != a.shortcuts.end();
    });
    return action == actions_.end() ? nullptr : &*action;
}

bool ActionRegistry::repeats(int key) const {
    return std::any_of(actions_.begin(), actions_.end(), [key](const Action &a) {
        return a.repeats && std::any_of(a.shortcuts.begin(), a.shortcuts.end(),
                                        [key](const Shortcut &shortcut) { return shortcut.key == key; });
    });
}

void ActionRegistry::rebind(std::string_view id, std::optional<Shortcut> shortcut) {
    for (Action &action : actions_) {
        if (action.id == id) {
            action.shortcuts = shortcut ? std::vector<Shortcut>{*shortcut} : std::vector<Shortcut>();
        }
    }
}

void ActionRegistry::resetShortcuts(std::string_view id) {
    for (Action &action : actions_) {
        if (action.id == id) {
            action.shortcuts = action.defaults;
        }
    }
}

std::vector<const Action *> ActionRegistry::conflicts(const Action &action) const {
    std::vector<const Action *> found;
    for (const Action &other : actions_) {
        const bool shares = std::any_of(action.shortcuts.begin(), action.shortcuts.end(), [&](const Shortcut &s) {
            return std::find(other.shortcuts.begin(), other.shortcuts.end(), s) != other.shortcuts.end();
        });
        if (shares && other.id != action.id) {
            found.push_back(&other);
        }
    }
    return found;
}

bool ActionRegistry::canRun(Shortcut shortcut, const Shell &context) const {
    return std::any_of(actions_.begin(), actions_.end(), [&](const Action &action) {
        return std::find(action.shortcuts.begin(), action.shortcuts.end(), shortcut) != action.shortcuts.end() &&
               (!action.enabled || action.enabled(context));
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
