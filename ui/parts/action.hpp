#pragma once

#include "ui/input/keys.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

struct Shell;

struct Shortcut {
    int key = 0; ///< 0: none
    Modifiers modifiers;
    friend bool operator==(Shortcut, Shortcut) = default;
};
/// Returns the text shown for a shortcut: "Ctrl+Shift+Z", "Space", ".".
std::string toString(Shortcut shortcut);

/// Parses a shortcut as toString() writes it; std::nullopt if the text is not a shortcut.
std::optional<Shortcut> parseShortcut(std::string_view text);

/// An entry of a submenu.
struct MenuEntry {
    std::string id; ///< of the widget "menu/ACTION/ID"
    std::string title;
    std::string detail{}; ///< shown in grey at the right
    std::function<void(Shell &)> run;
};

/// A command of the program, run from a menu, the palette, a shortcut or a script.
struct Action {
    std::string id;                    ///< "file.save"; its menu entry is the widget "menu/file.save"
    std::string menu;                  ///< "File", "Edit", "View", "Mesh", "Learn", "Help"; empty: palette only
    std::string title;                 ///< "Save"
    std::vector<Shortcut> shortcuts{}; ///< the first is shown
    std::function<void(Shell &)> run;
    std::function<bool(const Shell &)> enabled{};        ///< absent: always
    std::function<bool(const Shell &)> checked{};        ///< absent: no check mark
    std::function<std::string(const Shell &)> dynamic{}; ///< title that depends on the state, such as "Undo move node"
    std::function<std::vector<MenuEntry>(const Shell &)> entries{}; ///< absent: a plain item; else its submenu
    bool separatorBefore = false;
    bool repeats = false;             ///< its shortcut repeats while held
    std::vector<Shortcut> defaults{}; ///< the shortcuts it was added with; set by ActionRegistry::add()
    std::string needs{};              ///< what it waits for while it is not enabled; set by ActionRegistry::explain()
};

class ActionRegistry {
  public:
    /// Adds an action; menus list actions in the order they were added. An action with an existing id replaces it.
    void add(Action action);
    const Action *find(std::string_view id) const;
    const std::vector<Action> &all() const { return actions_; }
    /// Runs the enabled action with this shortcut. Returns false if there is none.
    bool runShortcut(Shortcut shortcut, bool repeated, Shell &context) const;
    /// Returns true if an action that is enabled now has this shortcut.
    bool canRun(Shortcut shortcut, const Shell &context) const;
    /// Returns true if an action has this shortcut, enabled or not.
    bool knows(Shortcut shortcut) const;
    /// Says what an action needs to be enabled, such as "select two shapes": a tip of its menu item, and the answer to
    /// its shortcut.
    void explain(std::string_view id, std::string needs);
    /// Returns the first action with this shortcut that is not enabled and says what it needs; null if there is none.
    const Action *waiting(Shortcut shortcut, const Shell &context) const;
    /// Returns true if a shortcut with this key repeats while held.
    bool repeats(int key) const;
    bool run(std::string_view id, Shell &context) const;
    /// Gives an action another shortcut, none, or its default ones again.
    void rebind(std::string_view id, std::optional<Shortcut> shortcut);
    void resetShortcuts(std::string_view id);
    /// Returns the other actions that share a shortcut with this one. The first of them that is enabled runs.
    std::vector<const Action *> conflicts(const Action &action) const;

  private:
    std::vector<Action> actions_;
};

} // namespace forefront
