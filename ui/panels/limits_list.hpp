#pragma once

namespace forefront {

struct Shell;

/// Draws the fields of the limits that a mesh must meet, with the verdict on each for the mesh shown and links to the
/// worst places; and the faults of a mesh that was read from a file.
void drawLimits(Shell &context);

} // namespace forefront
