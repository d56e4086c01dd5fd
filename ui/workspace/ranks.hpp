#pragma once

namespace forefront {

struct Workspace;
class CanvasPainter;

/// Numbers the worst parts on the canvas, as in their list; the chosen one has its mark.
void drawRanks(CanvasPainter &painter, const Workspace &context);

} // namespace forefront
