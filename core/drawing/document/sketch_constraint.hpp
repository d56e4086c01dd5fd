#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/vec2.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// The kind of a part of a drawing that a constraint refers to.
enum class SketchPartKind : std::uint8_t {
    Node,         ///< a handle of a shape, see handlesOf()
    Segment,      ///< a part that can have a tag, see taggedSegments(); 0 for a circle or an ellipse
    Centre,       ///< of a segment of a path that is an arc of a circle
    StartControl, ///< control point beside the start of a Bézier segment of a path
    EndControl,   ///< control point beside its end
    Origin,       ///< of the drawing
    XAxis,        ///< of the drawing
    YAxis         ///< of the drawing
};

template <>
struct EnumWords<SketchPartKind> {
    static constexpr auto kLast = SketchPartKind::YAxis;
    static constexpr std::array<std::string_view, 8> kList = {"node",       "segment", "centre", "startControl",
                                                              "endControl", "origin",  "xAxis",  "yAxis"};
};

/// A reference to a part of a drawing. In project files: "shape/ID/node/K", "shape/ID/segment/K", and so on; "origin",
/// "xAxis" and "yAxis" belong to no shape. Indices count from 0.
struct SketchPart {
    std::uint32_t shape = 0; ///< Shape::id; 0 for the origin and the axes
    SketchPartKind kind = SketchPartKind::Node;
    std::uint32_t index = 0;

    friend constexpr auto operator<=>(const SketchPart &, const SketchPart &) = default;
};

/// Returns the part that a text of a project file stands for; none for an invalid text.
std::optional<SketchPart> parseSketchPart(std::string_view text);
/// Returns the text of a part in project files.
std::string toString(const SketchPart &part);

/// What a constraint demands; its word is the one in project files. After each, its parts in order.
enum class ConstraintKind : std::uint8_t {
    Coincident,         ///< two points
    OnCurve,            ///< a point, and a line (also beyond its ends), circle, ellipse or Bézier curve
    Midpoint,           ///< a point, and a line or two points that it lies halfway between
    Horizontal,         ///< a line or two points
    Vertical,           ///< a line or two points
    Parallel,           ///< two lines
    Perpendicular,      ///< two lines
    Collinear,          ///< two lines
    Tangent,            ///< two curves or a line and a curve; then, if they meet at ends, the node of each
    Equal,              ///< the lengths of two lines or the radii of two circles
    Concentric,         ///< two circles or ellipses
    Symmetric,          ///< two points, and the line or point that they mirror each other in
    Fixed,              ///< a point, line or circle that stays where it is
    Length,             ///< two points: the ends of a segment, and their distance
    Distance,           ///< two points, a point and a line, or two parallel lines
    HorizontalDistance, ///< two points
    VerticalDistance,   ///< two points
    Angle,              ///< two lines
    Radius,             ///< a circle or the rounded corners of a rectangle
    Diameter            ///< the same
};

template <>
struct EnumWords<ConstraintKind> {
    static constexpr auto kLast = ConstraintKind::Diameter;
    static constexpr std::array<std::string_view, 20> kList = {
        "coincident",         "onCurve",          "midpoint",  "horizontal", "vertical",
        "parallel",           "perpendicular",    "collinear", "tangent",    "equal",
        "concentric",         "symmetric",        "fixed",     "length",     "distance",
        "horizontalDistance", "verticalDistance", "angle",     "radius",     "diameter"};
};

/// Returns true for a dimension: a constraint with a value.
constexpr bool isDimension(ConstraintKind kind) {
    return kind >= ConstraintKind::Length;
}

/// A relation between parts of a drawing that holds through edits, or a dimension that drives it. Immutable once in a
/// Document. Which of several solutions is meant is stored when the constraint is made, so that solving keeps it.
struct SketchConstraint {
    std::uint32_t id = 0; ///< unique among the constraints of the document, never reused
    ConstraintKind kind = ConstraintKind::Coincident;
    std::string name; ///< such as "Length 1"
    std::vector<SketchPart> parts;
    double value = 0.0; ///< of a dimension: a length > 0, or an angle in degrees
    /// Side of a line that a point or centre lies on, 1 for left; sign of a difference of coordinates or of an angle;
    /// sign of the first radius where circles touch.
    int side = 1;
    int otherSide = 1; ///< sign of the second radius where circles touch
    /// Turn in degrees from the first direction to the second: 0 or 180 if parallel, 90 or -90 if perpendicular; for an
    /// angle 0 or 180, to which side·value is added.
    int turn = 0;
    /// Where the text of a dimension lies; none: beside what it measures. Of a length: from the middle of what is
    /// measured, first along the direction from the first part to the second, then to the left of it. Of a radius,
    /// diameter or angle: from the centre or apex.
    std::optional<Vec2> label{};

    friend bool operator==(const SketchConstraint &, const SketchConstraint &) = default;
};

} // namespace forefront
