#pragma once

#include "ui/input/pixels.hpp"

#include <optional>

namespace forefront {

/// What the keyboard asks of the menus, for the next frame that draws them.
struct MenuKeys {
    char mnemonic = 0;       ///< capital letter of the menu of the bar that opens; 0: none
    int step = 0;            ///< -1, 1: the menu to the left or right of the open one opens
    char letter = 0;         ///< capital letter; the next item of the open menu that begins with it is chosen
    bool highlights = false; ///< a key has opened the menu, so its first item is chosen
    bool onSubmenu = false;  ///< the chosen item opens a submenu, to which the right arrow key goes
    bool open = false;       ///< a menu was open when the last frame ended, so keys are for it

    /// An item of the menu that is being drawn.
    struct Item {
        unsigned id = 0;
        PixelRect at; ///< in its window
    };
    std::optional<Item> first; ///< that begins with the letter
    bool passed = false;       ///< the chosen item is drawn
};

} // namespace forefront
