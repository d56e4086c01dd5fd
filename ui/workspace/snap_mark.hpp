#pragma once

namespace forefront {

class CanvasPainter;
struct Snapped;
struct Workspace;

/// Draws the glyph of a snapped place and the words for it; each kind of snap has its own glyph.
void drawSnapMark(CanvasPainter &painter, const Workspace &context, const Snapped &snapped);

} // namespace forefront
