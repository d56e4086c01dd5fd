#pragma once

namespace forefront {

struct Shell;

/// Gives the layers, panels, shortcuts and snapping the settings that were loaded. Called once, when all are there.
void applySettings(Shell &context);
/// Takes into the settings what the user changes elsewhere: layers, panels, snapping.
void takeSettings(Shell &context);

} // namespace forefront
