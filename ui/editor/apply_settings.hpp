#pragma once

#include "ui/parts/settings.hpp"

namespace forefront {

struct Shell;

/// Applies the loaded settings to the layers, panels, shortcuts and snapping. Called once, when all of them exist.
void applySettings(Shell &context);
/// Returns the settings, including those changed outside the preferences: layers, panels, snapping. Changes by an open
/// lesson are left out.
Settings settingsToSave(const Shell &context);

} // namespace forefront
