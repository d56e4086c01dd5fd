#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace forefront {
namespace {

/// Returns false for a curve that is not finite, is a point, or does not begin and end at its nodes.
bool isSound(const Curve &curve, Vec2 from, Vec2 to) {
    if (curve.kind() == CurveKind::Line) {
        return true;
    }
    const std::array<double, 8> n = curve.numbers();
    const bool round = curve.kind() == CurveKind::Arc;
    const bool bends =
        round ? cross({n[2], n[3]}, {n[4], n[5]}) != 0.0 && n[7] != 0.0 : curve.bounds().diagonal() > 0.0;
    return curve.finite() && bends && joins(curve, from, to);
}

bool hasSoundCurves(const Shape &shape) {
    if (!std::isfinite(shape.radius) || shape.radius < 0.0) {
        return false;
    }
    if (shape.curves.empty()) {
        return true;
    }
    const Outline outline = outlineOf(shape);
    if (!isPath(shape) || shape.curves.size() != outline.segmentCount()) {
        return false;
    }
    for (std::size_t k = 0; k < shape.curves.size(); ++k) {
        if (!isSound(shape.curves[k], outline.from(k), outline.to(k))) {
            return false;
        }
    }
    return true;
}

/// Returns true if a closed path encloses an area: one or two nodes need curves.
bool isLoopSound(const Shape &shape) {
    const std::size_t n = shape.nodes.size();
    const auto curved = [](const Curve &curve) { return curve.kind() != CurveKind::Line; };
    return n >= 3 || (n >= 1 && std::any_of(shape.curves.begin(), shape.curves.end(), curved));
}

} // namespace

Diagnostics checkShape(const Shape &shape) {
    for (const Vec2 node : shape.nodes) {
        if (!isFinite(node)) {
            return error("bad-number", "invalid coordinate; expected a finite number", "enter a number such as 12.5");
        }
    }
    const std::int32_t smallest = std::accumulate(shape.segmentTags.begin(), shape.segmentTags.end(), shape.tag,
                                                  [](std::int32_t a, std::int32_t b) { return std::min(a, b); });
    if (smallest < 1) {
        return error("bad-tag", "invalid tag " + std::to_string(smallest) + "; expected 1 or more");
    }
    const std::size_t n = shape.nodes.size();
    bool sound = true;
    switch (shape.kind) {
    case ShapeKind::Polygon:
        sound = isLoopSound(shape);
        break;
    case ShapeKind::Polyline:
        sound = n >= 2;
        break;
    case ShapeKind::Rectangle:
        sound = n == 2 && shape.nodes[0].x != shape.nodes[1].x && shape.nodes[0].y != shape.nodes[1].y;
        break;
    case ShapeKind::Circle:
        sound = n == 2 && shape.nodes[0] != shape.nodes[1] && std::isfinite(circleRadius(shape));
        break;
    case ShapeKind::Point:
        sound = n == 1;
        break;
    case ShapeKind::Ellipse:
        sound = n == 3 && cross(shape.nodes[1] - shape.nodes[0], shape.nodes[2] - shape.nodes[0]) != 0.0;
        break;
    case ShapeKind::Slot:
        sound = isSoundSlot(shape);
        break;
    }
    if (!sound) {
        return error("bad-shape", std::string(wordOf(shape.kind)) + " is degenerate",
                     "a polygon needs three nodes, a polyline two; the sides of a rectangle, the radius of a circle, "
                     "the semi-axes of an ellipse and the length and width of a slot must not be 0");
    }
    if (Diagnostics faults = checkNodeSizes(shape); !faults.empty()) {
        return faults;
    }
    if (!hasSoundCurves(shape)) {
        return error("bad-curve", "a curve of " + displayName(shape) + " does not begin and end at its nodes",
                     "let it begin and end at the nodes, with nonzero radii");
    }
    return {};
}

} // namespace forefront
