#pragma once

#include "core/base/diagnostic.hpp"

namespace forefront {

struct AppContext;

/// Returns true if "Repair drawing" removes faults of this kind.
bool repairable(const Diagnostic &fault);
/// Returns true if any of the faults is repairable.
bool anyRepairable(const Diagnostics &faults);

/// Repairs the drawing as one command and reports every change, with its place, in the log. Shapes become polygons and
/// polylines; spacing, names and options stay.
void repairDrawing(AppContext &context);

} // namespace forefront
