#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/sketch/sketch_system.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>

namespace forefront {

/// A number of a shape that is an unknown of a sketch.
struct ShapeUnknown {
    enum class Role : std::uint8_t {
        X,       ///< of a node: see Shape::nodes
        Y,       ///< of a node
        AxisX,   ///< of the semi-axis of an ellipse that ends at a node, from the centre
        AxisY,   ///< of this semi-axis
        Radius,  ///< of a circle, a slot, the corners of a rectangle, or a segment that is an arc
        CentreX, ///< of a segment that is an arc
        CentreY, ///< of this arc
        StartX,  ///< of the first control point of a Bézier segment, from the node where it starts
        StartY,  ///< of this control point
        EndX,    ///< of the second control point of a Bézier segment, from the node where it ends
        EndY     ///< of this control point
    };

    std::uint32_t shape = 0; ///< Shape::id
    Role role = Role::X;
    std::uint32_t index = 0; ///< of the node or segment; 0 for a number that the shape has once

    friend constexpr auto operator<=>(const ShapeUnknown &, const ShapeUnknown &) = default;
};

/// Returns how an unknown is scaled.
UnknownKind kindOf(ShapeUnknown::Role role);

/// Returns the value of an unknown; none if the shape has no such number.
std::optional<double> valueOf(const Shape &shape, ShapeUnknown::Role role, std::uint32_t index);

/// Sets unknowns of a shape, which has them all. Curves whose ends move and that are not set themselves move with their
/// ends.
void setUnknowns(Shape &shape, const std::map<ShapeUnknown, double> &values);

} // namespace forefront
