#pragma once

namespace forefront {

struct Shell;

/// Repairs the drawing as one command and reports each kind of change, with its first place, in the log. Shapes that
/// the repair changes become polygons and polylines.
void repairDrawing(Shell &context);

} // namespace forefront
