#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace forefront {

/// A measure of a segment, such as its radius.
struct SegmentMeasure {
    std::string_view name;
    double value = 0.0;
    bool isAngle = false; ///< in degrees; otherwise in domain units
};

/// Measures a segment: length and direction of a line; radius, diameter, arc length and angle of an arc of a circle;
/// circumference and area of a circle; semi-axes of an arc of an ellipse; length of any other curve.
std::vector<SegmentMeasure> measureCurve(const Curve &curve);

/// Returns the angle between two directions in degrees, from 0 to 180; 0 if one of them is zero.
double angleBetween(Vec2 u, Vec2 v);

/// The size of a face of a drawing.
struct FaceMeasure {
    double area = 0.0;
    double perimeter = 0.0;              ///< including its holes
    std::vector<std::uint32_t> segments; ///< of the domain, around the face
};

/// Measures the face around a point: the part of the plane that the segments of a domain bound there, inside the domain
/// or in a hole. Follows the curves exactly. Returns nothing outside all loops, on a segment, and where segments cross.
std::optional<FaceMeasure> measureFace(const Domain &domain, Vec2 at);

} // namespace forefront
