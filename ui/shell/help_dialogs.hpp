#pragma once

#include "ui/parts/dialog.hpp"

#include <memory>

namespace forefront {

/// Shows all keyboard shortcuts.
std::unique_ptr<Dialog> makeShortcutSheet();
/// Shows the version and the licence.
std::unique_ptr<Dialog> makeAbout();

} // namespace forefront
