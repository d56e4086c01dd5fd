#pragma once

#include "ui/dialogs/dialog.hpp"

#include <memory>

namespace forefront {

/// All shortcuts on one page.
std::unique_ptr<Dialog> makeShortcutSheet();
/// Every action by name: type a part of it, Enter runs it.
std::unique_ptr<Dialog> makePalette();
/// The user's scale of the interface.
std::unique_ptr<Dialog> makeScaleDialog();
std::unique_ptr<Dialog> makeAbout();

} // namespace forefront
