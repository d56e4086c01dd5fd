#pragma once

namespace forefront {

struct Shell;

/// Applies the loaded settings to the layers, panels, shortcuts and snapping. Called once, when all of them exist.
void applySettings(Shell &context);
/// Updates the settings with what the user changes elsewhere: layers, panels, snapping.
void collectSettings(Shell &context);

} // namespace forefront
