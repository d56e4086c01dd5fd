#include "core/edit/shape_geometry.hpp"

#include <numbers>

namespace forefront {
namespace {

constexpr std::size_t kMinCorners = 8;
constexpr std::size_t kMaxCorners = 4096;

Outline circleOutline(const Shape &shape, double tolerance) {
    Outline outline;
    outline.closed = true;
    const Vec2 centre = shape.nodes[0];
    const Vec2 arm = shape.nodes[1] - centre;
    if (!(lengthSquared(arm) > 0.0)) {
        // One segment of zero length, which validation reports with its place.
        outline.nodes = {centre, centre};
        return outline;
    }
    const std::size_t corners = circleCorners(tolerance);
    outline.nodes.reserve(corners);
    for (std::size_t k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
        const double c = std::cos(angle), s = std::sin(angle);
        outline.nodes.push_back(k == 0 ? shape.nodes[1]
                                       : Vec2{centre.x + arm.x * c - arm.y * s, centre.y + arm.x * s + arm.y * c});
    }
    return outline;
}

} // namespace

std::size_t circleCorners(double tolerance) {
    if (!(tolerance > 0.0)) {
        return kMaxCorners;
    }
    if (tolerance >= 1.0) {
        return kMinCorners;
    }
    // Sagitta of a chord over the angle 2π/n: r·(1 − cos(π/n)).
    const double corners = std::ceil(std::numbers::pi / std::acos(1.0 - tolerance));
    if (!(corners < static_cast<double>(kMaxCorners))) {
        return kMaxCorners;
    }
    return std::max(kMinCorners, (static_cast<std::size_t>(corners) + 3) / 4 * 4);
}

Outline outlineOf(const Shape &shape, double circleTolerance) {
    const std::vector<Vec2> &nodes = shape.nodes;
    switch (shape.kind) {
    case ShapeKind::Rectangle:
        if (nodes.size() == 2) {
            return {{nodes[0], {nodes[1].x, nodes[0].y}, nodes[1], {nodes[0].x, nodes[1].y}}, true};
        }
        break;
    case ShapeKind::Circle:
        if (nodes.size() == 2) {
            return circleOutline(shape, circleTolerance);
        }
        break;
    case ShapeKind::Polygon:
        return {nodes, true};
    case ShapeKind::Polyline:
    case ShapeKind::Point:
        break;
    }
    return {nodes, false};
}

std::size_t taggedSegments(const Shape &shape) {
    switch (shape.kind) {
    case ShapeKind::Rectangle:
        return 4;
    case ShapeKind::Circle:
        return 1;
    case ShapeKind::Point:
        return 0;
    case ShapeKind::Polygon:
    case ShapeKind::Polyline:
        break;
    }
    const std::size_t n = shape.nodes.size();
    return n < 2 ? 0 : shape.kind == ShapeKind::Polygon && n > 2 ? n : n - 1;
}

std::int32_t segmentTag(const Shape &shape, std::size_t segment) {
    if (shape.segmentTags.empty() || shape.kind == ShapeKind::Circle) {
        return shape.tag;
    }
    return segment < shape.segmentTags.size() ? shape.segmentTags[segment] : shape.tag;
}

std::vector<Vec2> handlesOf(const Shape &shape) {
    return shape.kind == ShapeKind::Rectangle ? outlineOf(shape, 1.0).nodes : shape.nodes;
}

std::size_t handleCount(const Shape &shape) {
    return shape.kind == ShapeKind::Rectangle && shape.nodes.size() == 2 ? 4 : shape.nodes.size();
}

bool isClosed(const Shape &shape) {
    return shape.kind == ShapeKind::Polygon || shape.kind == ShapeKind::Rectangle || shape.kind == ShapeKind::Circle;
}

double circleRadius(const Shape &shape) {
    return shape.kind == ShapeKind::Circle && shape.nodes.size() == 2 ? distance(shape.nodes[0], shape.nodes[1]) : 0.0;
}

Box2 boundsOf(const Shape &shape) {
    if (shape.kind == ShapeKind::Circle && shape.nodes.size() == 2) {
        return boxAround(shape.nodes[0], circleRadius(shape));
    }
    Box2 box;
    for (const Vec2 node : shape.nodes) {
        box.add(node);
    }
    return box;
}

Box2 boundsOf(const Document &document) {
    Box2 box;
    for (const auto &shape : document.shapes) {
        box.add(boundsOf(*shape));
    }
    return box;
}

bool contains(const Shape &shape, Vec2 p) {
    if (!isClosed(shape)) {
        return false;
    }
    if (shape.kind == ShapeKind::Circle && shape.nodes.size() == 2) {
        return distanceSquared(shape.nodes[0], p) <= distanceSquared(shape.nodes[0], shape.nodes[1]);
    }
    const Outline outline = outlineOf(shape, 1.0);
    bool inside = false;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        const Vec2 a = outline.from(k), b = outline.to(k);
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) {
            inside = !inside;
        }
    }
    return inside;
}

double areaOf(const Shape &shape) {
    if (!isClosed(shape)) {
        return 0.0;
    }
    if (shape.kind == ShapeKind::Circle) {
        const double radius = circleRadius(shape);
        return std::numbers::pi * radius * radius;
    }
    const Outline outline = outlineOf(shape, 1.0);
    double twice = 0.0;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        twice += cross(outline.from(k) - outline.nodes[0], outline.to(k) - outline.nodes[0]);
    }
    return 0.5 * std::abs(twice);
}

double lengthOf(const Shape &shape) {
    if (shape.kind == ShapeKind::Circle) {
        return 2.0 * std::numbers::pi * circleRadius(shape);
    }
    const Outline outline = outlineOf(shape, 1.0);
    double sum = 0.0;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        sum += distance(outline.from(k), outline.to(k));
    }
    return sum;
}

std::string displayName(const Shape &shape) {
    return shape.name.empty() ? std::string(wordOf(shape.kind)) + ' ' + std::to_string(shape.id) : shape.name;
}

} // namespace forefront
