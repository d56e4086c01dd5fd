#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
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

/// Returns true if each segment of a path has a sound curve, or none has one.
bool hasSoundCurves(const Shape &shape, const PathForm &path) {
    const Outline outline = outlineOf(shape);
    if (path.curves.empty() || path.curves.size() != outline.segmentCount()) {
        return path.curves.empty();
    }
    for (std::size_t k = 0; k < path.curves.size(); ++k) {
        if (!isSound(path.curves[k], outline.from(k), outline.to(k))) {
            return false;
        }
    }
    return true;
}

/// Returns true if a path has enough nodes; one or two enclose an area only with curves.
bool hasSoundNodes(const Shape &shape, const PathForm &path) {
    const std::size_t n = shape.nodes.size();
    const auto curved = [](const Curve &curve) { return curve.kind() != CurveKind::Line; };
    return path.closed ? n >= 3 || (n >= 1 && std::any_of(path.curves.begin(), path.curves.end(), curved)) : n >= 2;
}

/// Returns true if a shape has the nodes of its form, and none of its measures is 0.
bool hasSoundNodes(const Shape &shape) {
    const std::vector<Vec2> &nodes = shape.nodes;
    const std::size_t n = nodes.size();
    return shape.visit(
        [&](const PathForm &path) { return hasSoundNodes(shape, path); },
        [&](const RectangleForm &) { return n == 2 && nodes[0].x != nodes[1].x && nodes[0].y != nodes[1].y; },
        [&](const CircleForm &) { return n == 2 && nodes[0] != nodes[1] && std::isfinite(circleRadius(shape)); },
        [&](const PointForm &) { return n == 1; },
        [&](const EllipseForm &) { return n == 3 && cross(nodes[1] - nodes[0], nodes[2] - nodes[0]) != 0.0; },
        [&](const SlotForm &) { return isSoundSlot(shape); });
}

/// Returns true if the curves or radius of a shape are valid.
bool hasSoundCurves(const Shape &shape) {
    const auto sound = [](double radius) { return std::isfinite(radius) && radius >= 0.0; };
    return shape.visit([&](const PathForm &path) { return hasSoundCurves(shape, path); },
                       [&](const RectangleForm &rectangle) { return sound(rectangle.radius); },
                       [](const CircleForm &) { return true; }, [](const PointForm &) { return true; },
                       [](const EllipseForm &) { return true; },
                       [&](const SlotForm &slot) { return sound(slot.radius); });
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
    if (!hasSoundNodes(shape)) {
        return error("bad-shape", std::string(wordOf(shape.kind())) + " is degenerate",
                     "a polygon needs three nodes, a polyline two; the sides of a rectangle, the radius of a circle, "
                     "the semi-axes of an ellipse and the length and width of a slot must not be 0");
    }
    if (Diagnostics faults = checkNodeSizes(shape); !faults.empty()) {
        return faults;
    }
    if (Diagnostics faults = checkSegmentSizes(shape); !faults.empty()) {
        return faults;
    }
    if (!hasSoundCurves(shape)) {
        return error("bad-curve", "a curve of " + displayName(shape) + " does not begin and end at its nodes",
                     "let it begin and end at the nodes, with nonzero radii");
    }
    return {};
}

} // namespace forefront
