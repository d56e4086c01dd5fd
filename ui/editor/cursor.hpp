#pragma once

namespace forefront {

struct Shell;

/// Sets the shape of the pointer: the active tool decides on the canvas, the widget elsewhere. `panning`: the view is
/// being moved.
void applyCursor(Shell &context, bool panning);

} // namespace forefront
