#pragma once

#include "ui/input/keys.hpp"

#include <functional>
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
    bool separatorBefore = false;
    bool repeats = false; ///< its shortcut repeats while held
};

class ActionRegistry {
  public:
    /// Adds an action; menus list actions in the order they were added. An action with an existing id replaces it.
    void add(Action action);
    const Action *find(std::string_view id) const;
    const std::vector<Action> &all() const { return actions_; }
    /// Runs the enabled action with this shortcut. Returns false if there is none.
    bool runShortcut(Shortcut shortcut, bool repeated, Shell &context) const;
    /// Returns true if an action has this shortcut, enabled or not.
    bool knows(Shortcut shortcut) const;
    /// Returns true if a shortcut with this key repeats while held.
    bool repeats(int key) const;
    bool run(std::string_view id, Shell &context) const;

  private:
    std::vector<Action> actions_;
};

} // namespace forefront
