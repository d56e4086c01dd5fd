#include "core/drawing/shapes/dimensions.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace forefront {
namespace {

/// Angles nearer than this to a multiple of 90 degrees count as equal to it.
constexpr double kAngleTolerance = 0.01;

/// Returns twice the signed area of the polygon of an outline's nodes; positive if they are counter-clockwise.
double turnOf(const Outline &outline) {
    double sum = 0.0;
    for (std::size_t k = 1; k + 1 < outline.nodes.size(); ++k) {
        sum += cross(outline.nodes[k] - outline.nodes[0], outline.nodes[k + 1] - outline.nodes[0]);
    }
    return sum;
}

void addRoundShape(const Shape &shape, std::vector<Dimension> &found) {
    const Vec2 centre = shape.nodes[0];
    if (shape.is<CircleForm>()) {
        const double radius = circleRadius(shape);
        const Vec2 rim = centre + radius * std::numbers::sqrt2 / 2.0 * Vec2{1.0, 1.0};
        found.push_back({DimensionKind::Radius, shape.id, centre, rim, radius, 2.0 * radius});
        return;
    }
    const double rx = distance(centre, shape.nodes[1]), ry = distance(centre, shape.nodes[2]);
    found.push_back({DimensionKind::RadiusX, shape.id, centre, shape.nodes[1], rx, 2.0 * rx});
    found.push_back({DimensionKind::RadiusY, shape.id, centre, shape.nodes[2], ry, 2.0 * ry});
}

/// Adds the radius of an arc if it is that of a circle.
void addArcOfCircle(const Shape &shape, const Curve &curve, std::vector<Dimension> &found) {
    if (const std::optional<double> radius = radiusOf(curve)) {
        const auto numbers = curve.numbers();
        found.push_back({DimensionKind::Radius,
                         shape.id,
                         {numbers[0], numbers[1]},
                         curve.point(0.5),
                         *radius,
                         std::fabs(numbers[7]) * *radius});
    }
}

/// Adds the length and the radius of a slot, once each.
void addSlot(const Shape &shape, std::vector<Dimension> &found) {
    const Outline outline = outlineOf(shape);
    const double size = distance(shape.nodes[0], shape.nodes[1]);
    found.push_back({DimensionKind::Length, shape.id, outline.from(0), outline.to(0), size, size});
    addArcOfCircle(shape, outline.curve(1), found);
}

void addSegments(const Shape &shape, const Outline &outline, double turn, std::vector<Dimension> &found) {
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.isCurved(k)) {
            addArcOfCircle(shape, outline.curve(k), found);
            continue;
        }
        Vec2 from = outline.from(k), to = outline.to(k);
        if (outline.closed ? turn < 0.0 : to.x > from.x) {
            std::swap(from, to);
        }
        const double size = distance(from, to);
        found.push_back({DimensionKind::Length, shape.id, from, to, size, size});
    }
}

/// Adds the angle at the node between two segments.
void addCorner(const Shape &shape, const Outline &outline, std::size_t before, std::size_t after, double turn,
               std::vector<Dimension> &found) {
    const Vec2 corner = outline.from(after);
    Vec2 right = outline.to(after) - corner, left = outline.from(before) - corner;
    const double room = std::min(length(right), length(left));
    if (outline.isCurved(before) || outline.isCurved(after) || !(room > 0.0)) {
        return;
    }
    if (outline.closed ? turn < 0.0 : cross(right, left) < 0.0) {
        std::swap(right, left);
    }
    double degrees = std::atan2(cross(right, left), dot(right, left)) * 180.0 / std::numbers::pi;
    degrees += degrees < 0.0 ? 360.0 : 0.0;
    if (std::fabs(std::remainder(degrees, 90.0)) > kAngleTolerance) {
        const Vec2 leg = corner + room / length(right) * right;
        found.push_back({DimensionKind::Angle, shape.id, corner, leg, degrees, room});
    }
}

void addCorners(const Shape &shape, const Outline &outline, double turn, std::vector<Dimension> &found) {
    const std::size_t segments = outline.segmentCount();
    for (std::size_t k = outline.closed ? 0 : 1; k < segments; ++k) {
        addCorner(shape, outline, (k + segments - 1) % segments, k, turn, found);
    }
}

} // namespace

std::vector<Dimension> dimensionsOf(const Document &document) {
    std::vector<Dimension> found;
    for (const auto &shape : document.shapes) {
        if (shape->hidden || shape->is<PointForm>()) {
            continue;
        }
        if (isRound(*shape)) {
            addRoundShape(*shape, found);
            continue;
        }
        if (shape->is<SlotForm>()) {
            addSlot(*shape, found);
            continue;
        }
        const Outline outline = outlineOf(*shape);
        const double turn = turnOf(outline);
        addSegments(*shape, outline, turn, found);
        addCorners(*shape, outline, turn, found);
    }
    return found;
}

} // namespace forefront
