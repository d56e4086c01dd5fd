#pragma once

#include "core/drawing/document/document.hpp"

#include <array>
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
    /// Of a linear dimension: the ends of the lines on which `from` and `to` lie; twice the point where that is no
    /// line.
    std::array<Vec2, 2> fromLine{}, toLine{};
    /// Of a linear dimension: how far its shapes reach outward, and the other way, from the middle of what is measured.
    double clear = 0.0, clearBehind = 0.0;
    bool diameter = false;
    /// Of an angle: direction of the first leg and signed turn to the second. Of a radius or diameter: direction from
    /// the centre to the start of the arc and signed turn to its end; of a whole circle a full turn. In radians.
    double begin = 0.0, sweep = 0.0;

    /// Returns the place of a text with an offset, see SketchConstraint::label.
    Vec2 placeOf(Vec2 offset) const;
    /// Returns the offset of a text at a place.
    Vec2 offsetOf(Vec2 place) const;
    /// Returns the direction in which a share of the arc, 0 to 1, lies from the centre or apex, of length 1.
    Vec2 wayAt(double share) const;
    /// Returns the direction from the centre to the point of the arc that is nearest in direction, of length 1.
    Vec2 wayOnArc(Vec2 way) const;
};

/// Returns the figure of a dimension; none for other constraints, parts that do not exist and parallel legs.
std::optional<DimensionFigure> dimensionFigure(const Document &document, const SketchConstraint &constraint);

} // namespace forefront
