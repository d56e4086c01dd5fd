#pragma once

namespace forefront {
class CanvasPainter;
struct Shell;
} // namespace forefront

namespace forefront::shell {

/// Draws the mesh of a compared file, coloured by the measure of the canvas.
void drawMeshBeside(Shell &context, CanvasPainter &painter);

/// Draws the table of the figures of both meshes.
void drawMeshTable(Shell &context);

} // namespace forefront::shell
