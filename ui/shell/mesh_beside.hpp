#pragma once

namespace forefront {
class CanvasPainter;
struct Shell;
} // namespace forefront

namespace forefront::shell {

/// Draws the mesh of a file that is compared with the mesh on the canvas, coloured by the same measure.
void drawMeshBeside(Shell &context, CanvasPainter &painter);

/// Draws the table of the figures of both meshes.
void drawMeshTable(Shell &context);

} // namespace forefront::shell
