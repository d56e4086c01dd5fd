#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

struct Document;

/// The quantity that a Dimension gives.
enum class DimensionKind : std::uint8_t {
    Length,  ///< of a straight segment
    Radius,  ///< of a circle or of an arc of a circle
    RadiusX, ///< first semi-axis of an ellipse
    RadiusY, ///< second semi-axis
    Angle    ///< between two straight segments, in degrees; inside the shape if it is closed, else less than 180
};

/// A length, radius or angle of a shape and its place, for drawing.
struct Dimension {
    DimensionKind kind = DimensionKind::Length;
    std::uint32_t shape = 0; ///< Shape::id
    /// The ends of a segment, with the outside of a closed shape to the right of the way between them, otherwise the
    /// upper side; the centre and a point of the curve; for an angle, the corner and a point on its right leg.
    Vec2 from, to;
    double value = 0.0;
    double extent = 0.0; ///< maximum length of a text beside it; for an angle, the length of the shorter leg
};

/// Returns the dimensions of the shapes that are not hidden. Right and straight angles have none, nor have cubics and
/// arcs of ellipses in a path.
std::vector<Dimension> dimensionsOf(const Document &document);

} // namespace forefront
