#pragma once

#include "core/drawing/constraints/constraint_figures.hpp"
#include "ui/input/pixels.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Returns the icon of a constraint; for a dimension an empty text, since its value is drawn.
const char *glyphOf(ConstraintKind kind);

/// Returns offsets of glyphs of a size beside an anchor, in design pixels, the best first: rows along the line on both
/// sides of it, so that the glyphs of one anchor form a group. `gap`: between two of them.
std::vector<Pixel> glyphOffsets(const GlyphAnchor &anchor, Pixel size, double gap);

/// Returns the text of a dimension: its value, with the expression that sets it.
std::string dimensionText(const Document &document, const SketchConstraint &constraint);

} // namespace forefront
