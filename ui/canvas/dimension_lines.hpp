#pragma once

#include "core/drawing/constraints/constraint_figures.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/dimension_room.hpp"

#include <optional>
#include <string>

namespace forefront {

struct DimensionStyle {
    Colour colour;               ///< of the lines and the text
    Colour plate;                ///< behind the text
    ImFont *font = nullptr;      ///< of the text
    bool chosen = false;         ///< drawn even where it is small
    std::optional<Pixel> kept{}; ///< the offset of the text that drawDimension() has returned, to be kept
};

/// Draws a dimension: extension lines, a line or an arc with arrows, and its text, at `label` if that is given (see
/// SketchConstraint::label), else where it covers nothing, outside of its shapes if possible and clear of the
/// dimensions in `room`, to which it is added. Returns the offset of the text, for DimensionStyle::kept; nothing, and
/// draws nothing, if it is out of view, too small, or there is no room.
std::optional<Pixel> drawDimension(CanvasPainter &painter, DimensionRoom &room, const DimensionFigure &figure,
                                   std::optional<Vec2> label, const std::string &text, const DimensionStyle &style);

} // namespace forefront
