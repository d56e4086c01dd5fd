#pragma once

#include "ui/parts/dialog.hpp"

#include <memory>

namespace forefront {

/// Shows all keyboard shortcuts.
std::unique_ptr<Dialog> makeShortcutSheet();
/// Finds an action by a part of its name and runs it.
std::unique_ptr<Dialog> makePalette();
/// Sets the scale of the interface.
std::unique_ptr<Dialog> makeScaleDialog();
std::unique_ptr<Dialog> makeAbout();

} // namespace forefront
