#pragma once

#include <string_view>

namespace forefront {

struct Shell;

namespace shell {

/// Notes the item of a menu that was just drawn: chooses it if its title begins with the letter that was typed and it
/// is the next one, or the first item if a key has opened the menu.
void noteMenuItem(Shell &context, std::string_view title, bool enabled, bool opensSubmenu = false);
/// Chooses the first item that begins with the letter if none follows the chosen one. Call when all items are drawn.
void endMenuItems(Shell &context);

} // namespace shell
} // namespace forefront
