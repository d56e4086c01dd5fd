#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {

/// What a part of a drawing is to a constraint.
enum class PartForm : std::uint8_t {
    None,     ///< the part does not exist or cannot be constrained
    Point,    ///< a node, a corner of a rectangle, a centre, the end of a semi-axis, a control point or the origin
    Line,     ///< a straight segment, a side of a rectangle or slot, or an axis
    Circle,   ///< a circle, an arc of a circle, or an end of a slot
    Rounding, ///< a rounded corner of a rectangle, of which only the radius can be constrained
    Ellipse,  ///< a whole ellipse
    Cubic     ///< a Bézier segment
};

PartForm formOfPart(const Document &document, const SketchPart &part);

/// Returns the place of a part that is a point; none for others.
std::optional<Vec2> placeOfPart(const Document &document, const SketchPart &part);

/// Returns why a constraint of a kind cannot have these parts; empty if it can. Every part must exist.
std::string partsFault(const Document &document, ConstraintKind kind, std::span<const SketchPart> parts);

/// Returns parts in the order that a constraint of a kind has them: points before lines before curves.
std::vector<SketchPart> inOrder(const Document &document, std::vector<SketchPart> parts);

} // namespace forefront
