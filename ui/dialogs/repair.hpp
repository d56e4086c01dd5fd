#pragma once

namespace forefront {

struct Shell;

/// Repairs the drawing as one command and reports every change, with its place, in the log. Shapes become polygons and
/// polylines; spacing, names and options stay.
void repairDrawing(Shell &context);

} // namespace forefront
