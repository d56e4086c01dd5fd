#pragma once

namespace forefront {

struct Shell;

/// Sets the shape of the pointer: that of the active tool on the canvas, that of the widget elsewhere. `panning`: the
/// view is being moved.
void applyCursor(Shell &context, bool panning);

} // namespace forefront
