#pragma once

#include "core/drawing/document/document.hpp"

#include <optional>
#include <vector>

namespace forefront {

/// A place of a drawing beside which the glyph of a constraint belongs.
struct GlyphAnchor {
    SketchPart part;
    Vec2 at;    ///< the point itself, or the middle of a line or curve
    Vec2 along; ///< direction of the line or curve there, of length 1; along x for a point
};

/// Returns the anchors of a constraint, one for each place where its glyph is to be drawn. Empty if its parts do not
/// exist.
std::vector<GlyphAnchor> glyphAnchors(const Document &document, const SketchConstraint &constraint);

/// What the lines of a dimension are drawn from.
struct DimensionFigure {
    enum class Form : std::uint8_t {
        Linear, ///< a line between two extension lines
        Radial, ///< a line from the centre, or from one side of the circle to the other
        Angular ///< an arc between two legs
    };
    Form form = Form::Linear;
    Vec2 from; ///< one end of what is measured; the centre; the apex of the angle
    Vec2 to;   ///< the other end; a point of the circle; the middle of the shorter leg
    /// Direction in which a linear dimension measures, of length 1, so that to - from has no negative part along it.
    Vec2 along{1.0, 0.0};
    Vec2 outward{0.0, 1.0}; ///< normal of `along` that leads away from the shape
    bool diameter = false;
    double begin = 0.0; ///< of an angle: direction of the first leg, radians
    double sweep = 0.0; ///< of an angle: signed turn from the first leg to the second, radians

    /// Returns the place of a text with an offset, see SketchConstraint::label.
    Vec2 placeOf(Vec2 offset) const;
    /// Returns the offset of a text at a place.
    Vec2 offsetOf(Vec2 place) const;
};

/// Returns the figure of a dimension; none for other constraints, parts that do not exist and parallel legs.
std::optional<DimensionFigure> dimensionFigure(const Document &document, const SketchConstraint &constraint);

} // namespace forefront
