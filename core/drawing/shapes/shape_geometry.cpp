#include "core/drawing/shapes/shape_geometry.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

/// Tolerance of the chords of paths for contains(), relative to their size.
constexpr double kFineChords = 1e-4;

} // namespace

std::size_t taggedSegments(const Shape &shape) {
    switch (shape.kind) {
    case ShapeKind::Rectangle:
    case ShapeKind::Slot:
        return 4;
    case ShapeKind::Circle:
    case ShapeKind::Ellipse:
        return 1;
    case ShapeKind::Point:
        return 0;
    case ShapeKind::Polygon:
    case ShapeKind::Polyline:
        break;
    }
    const std::size_t n = shape.nodes.size();
    const bool loop = shape.kind == ShapeKind::Polygon && (n > 2 || !shape.curves.empty());
    return loop ? n : n - std::min<std::size_t>(n, 1);
}

std::int32_t segmentTag(const Shape &shape, std::size_t part) {
    return part < shape.segmentTags.size() && !isRound(shape) ? shape.segmentTags[part] : shape.tag;
}

std::vector<Vec2> handlesOf(const Shape &shape) {
    if (shape.kind == ShapeKind::Slot && shape.nodes.size() == 2) {
        return {shape.nodes[0], shape.nodes[1], slotSide(shape)};
    }
    if (shape.kind != ShapeKind::Rectangle || shape.nodes.size() != 2) {
        return shape.nodes;
    }
    const Vec2 a = shape.nodes[0], c = shape.nodes[1];
    return {a, {c.x, a.y}, c, {a.x, c.y}};
}

std::size_t handleCount(const Shape &shape) {
    const bool pair = shape.nodes.size() == 2;
    return pair && shape.kind == ShapeKind::Rectangle ? 4
           : pair && shape.kind == ShapeKind::Slot    ? 3
                                                      : shape.nodes.size();
}

bool isCentre(const Shape &shape, std::uint32_t handle) {
    return (isRound(shape) && handle == 0) || (shape.kind == ShapeKind::Slot && handle < 2);
}

bool isPath(const Shape &shape) {
    return shape.kind == ShapeKind::Polygon || shape.kind == ShapeKind::Polyline;
}

bool isRound(const Shape &shape) {
    return shape.kind == ShapeKind::Circle || shape.kind == ShapeKind::Ellipse;
}

bool isClosed(const Shape &shape) {
    return shape.kind != ShapeKind::Polyline && shape.kind != ShapeKind::Point;
}

double circleRadius(const Shape &shape) {
    return shape.kind == ShapeKind::Circle && shape.nodes.size() == 2 ? distance(shape.nodes[0], shape.nodes[1]) : 0.0;
}

Box2 boundsOf(const Shape &shape) {
    if (shape.kind == ShapeKind::Circle && shape.nodes.size() == 2) {
        return boxAround(shape.nodes[0], circleRadius(shape));
    }
    if (shape.kind == ShapeKind::Ellipse && shape.nodes.size() == 3) {
        const Vec2 u = shape.nodes[1] - shape.nodes[0], v = shape.nodes[2] - shape.nodes[0];
        const Vec2 reach{std::hypot(u.x, v.x), std::hypot(u.y, v.y)};
        return {shape.nodes[0] - reach, shape.nodes[0] + reach};
    }
    Box2 box;
    for (const Vec2 node : shape.nodes) {
        box.add(shape.kind == ShapeKind::Slot ? boxAround(node, shape.radius) : Box2{node, node});
    }
    for (const Curve &curve : shape.curves) {
        if (curve.kind() != CurveKind::Line) {
            box.add(curve.bounds());
        }
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
    const Chords chords = chordsOf(shape, outlineOf(shape), kFineChords);
    bool inside = false;
    for (std::size_t k = 0; k < chords.size(); ++k) {
        const Vec2 a = chords.from(k), b = chords.to(k);
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
    const Outline outline = outlineOf(shape);
    double sum = 0.0;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        sum += sectorArea(outline.curve(k), outline.nodes[0]);
    }
    return std::fabs(sum);
}

double lengthOf(const Shape &shape) {
    if (shape.kind == ShapeKind::Circle) {
        return 2.0 * std::numbers::pi * circleRadius(shape);
    }
    const Outline outline = outlineOf(shape);
    double sum = 0.0;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        sum += outline.curve(k).length();
    }
    return sum;
}

void moveShape(Shape &shape, Vec2 by) {
    for (Vec2 &node : shape.nodes) {
        node += by;
    }
    for (Curve &curve : shape.curves) {
        curve = curve.kind() == CurveKind::Line ? Curve() : moved(curve, by);
    }
}

void scaleShape(Shape &shape, double factor) {
    const auto scaled = [factor](Vec2 p) { return factor * p; };
    for (Vec2 &node : shape.nodes) {
        node = scaled(node);
    }
    for (Curve &curve : shape.curves) {
        curve = curve.mapped(scaled);
    }
    shape.radius *= std::fabs(factor);
    for (auto &[node, part] : shape.nodeSizes) {
        part.size *= std::fabs(factor);
    }
}

void becomePath(Shape &shape) {
    if (isPath(shape) || shape.kind == ShapeKind::Point) {
        return;
    }
    const Shape before = shape;
    Outline outline = outlineOf(shape);
    if (isRound(shape) && outline.isCurved(0)) {
        const Curve loop = outline.curves[0];
        constexpr std::size_t kParts = 4;
        outline.nodes.resize(1);
        outline.curves.clear();
        for (std::size_t k = 0; k < kParts; ++k) {
            const double from = static_cast<double>(k) / kParts;
            if (k > 0) {
                outline.nodes.push_back(loop.point(from));
            }
            outline.curves.push_back(loop.part(from, static_cast<double>(k + 1) / kParts));
        }
    }
    if (!shape.segmentTags.empty() && !isRound(shape)) {
        std::vector<std::int32_t> tags;
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            tags.push_back(segmentTag(shape, outline.part(k)));
        }
        shape.segmentTags = std::move(tags);
    }
    shape.kind = ShapeKind::Polygon;
    shape.nodes = std::move(outline.nodes);
    shape.curves = std::move(outline.curves);
    shape.cuts.clear();
    shape.radius = 0.0;
    moveNodeSizes(shape, before); // that of a rounded corner goes to the ends of its arc
}

void moveNodes(Shape &shape, std::vector<Vec2> places) {
    const Outline before = outlineOf(shape);
    const Outline after{std::move(places), before.closed, before.curves, {}};
    for (std::size_t k = 0; k < before.segmentCount(); ++k) {
        if (before.isCurved(k) && (before.from(k) != after.from(k) || before.to(k) != after.to(k))) {
            shape.curves[k] = joining(before.curves[k], after.from(k), after.to(k));
            if (k < shape.cuts.size()) {
                shape.cuts[k].clear();
            }
        }
    }
    shape.nodes = after.nodes;
}

std::string kindName(const Shape &shape) {
    return isSlot(shape) ? "slot" : std::string(wordOf(shape.kind));
}

std::string displayName(const Shape &shape) {
    return shape.name.empty() ? kindName(shape) + ' ' + std::to_string(shape.id) : shape.name;
}

} // namespace forefront
