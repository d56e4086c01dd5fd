#pragma once

#include "ui/input/pixels.hpp"
#include "ui/parts/action.hpp"

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// A command of a context menu: an action of the program, or one for what was clicked.
struct ContextItem {
    std::string action{}; ///< id of an action, shown with its key; left out of the menu while it is disabled
    MenuEntry own{};      ///< if `action` is empty; without `run`, a heading
    bool checked = false; ///< of `own`
};

/// Commands that belong together; a line separates them from the next group.
using ContextGroup = std::vector<ContextItem>;

/// The menu that opens at the pointer when something is clicked with the right button.
struct ContextMenu {
    std::vector<ContextGroup> wanted; ///< to be opened after this frame's widgets
    std::vector<ContextGroup> shown;
    bool opens = false;
    Pixel at{};           ///< where it was opened
    bool running = false; ///< a command of it runs now

    void open(std::vector<ContextGroup> groups) {
        wanted = std::move(groups);
        opens = true;
    }
};

/// Returns the item of an action.
inline ContextItem actionOf(std::string id) {
    return {.action = std::move(id)};
}

/// Returns a group of actions.
inline ContextGroup actionsOf(std::initializer_list<const char *> ids) {
    ContextGroup group;
    for (const char *id : ids) {
        group.push_back(actionOf(id));
    }
    return group;
}

/// Returns the item of a command for what was clicked. Its widget is "contextmenu/ID".
inline ContextItem commandOf(std::string id, std::string title, std::function<void(Shell &)> run,
                             std::string detail = {}) {
    return {.own = {std::move(id), std::move(title), std::move(detail), std::move(run)}};
}

/// Returns a heading for the commands below it; it cannot be chosen.
inline ContextItem headingOf(std::string title) {
    return {.own = {{}, std::move(title), {}, {}}};
}

/// Returns the item of a command that copies a text to the clipboard.
ContextItem copyCommand(std::string id, std::string title, std::string text, std::string detail = {});

/// Returns the item of a switch.
inline ContextItem switchOf(std::string id, std::string title, bool on, std::function<void(Shell &)> run) {
    return {.own = {std::move(id), std::move(title), {}, std::move(run)}, .checked = on};
}

/// Returns the commands on the selection, and those on the drawing and the view.
std::vector<ContextGroup> selectionMenu();

} // namespace forefront
