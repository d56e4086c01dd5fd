#pragma once

#include "ui/parts/settings.hpp"

namespace forefront {

struct Shell;

/// Applies the loaded settings to the layers, panels, shortcuts and snapping. Called once, when all of them exist.
void applySettings(Shell &context);
/// Returns the settings with what the user changes elsewhere: layers, panels, snapping. What an open lesson has changed
/// is left out.
Settings settingsToSave(const Shell &context);

} // namespace forefront
