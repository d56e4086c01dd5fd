#include "core/drawing/shapes/shape_geometry.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/domain/element_places.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

/// Tolerance of the chords of paths for contains(), relative to their size.
constexpr double kFineChords = 1e-4;

constexpr std::size_t kSides = 4; ///< of a rectangle

} // namespace

std::size_t taggedSegments(const Shape &shape) {
    const std::size_t n = shape.nodes.size();
    return shape.visit(
        [n](const PathForm &path) {
            const bool loop = path.closed && (n > 2 || !path.curves.empty());
            return loop ? n : n - std::min<std::size_t>(n, 1);
        },
        [](const RectangleForm &rectangle) { return rectangle.radius > 0.0 ? 2 * kSides : kSides; },
        [](const CircleForm &) { return std::size_t{1}; }, [](const PointForm &) { return std::size_t{0}; },
        [](const EllipseForm &) { return std::size_t{1}; }, [](const SlotForm &) { return std::size_t{4}; });
}

std::int32_t segmentTag(const Shape &shape, std::size_t part) {
    const std::vector<std::int32_t> &tags = shape.segmentTags;
    if (isRoundedCorner(shape, part) && tags.size() == kSides) {
        part -= kSides; // older drawings have a tag for each side with the arc after it
    }
    return part < tags.size() && !isRound(shape) ? tags[part] : shape.tag;
}

std::vector<std::int32_t> segmentTagsOf(const Shape &shape) {
    std::vector<std::int32_t> tags(taggedSegments(shape));
    for (std::size_t part = 0; part < tags.size(); ++part) {
        tags[part] = segmentTag(shape, part);
    }
    return tags;
}

bool isRoundedCorner(const Shape &shape, std::size_t part) {
    return shape.is<RectangleForm>() && part >= kSides && part < 2 * kSides;
}

std::set<std::uint32_t> handlesOfPart(const Shape &shape, std::uint32_t part) {
    const auto count = std::max(1U, static_cast<std::uint32_t>(handleCount(shape)));
    std::set<std::uint32_t> handles;
    if (isRoundedCorner(shape, part)) {
        handles.insert((part + 1) % count);
        return handles;
    }
    const bool whole = isRound(shape) || shape.is<SlotForm>();
    for (std::uint32_t k = 0; k < (whole ? count : 2); ++k) {
        handles.insert((part + k) % count);
    }
    return handles;
}

std::vector<Vec2> handlesOf(const Shape &shape) {
    const std::vector<Vec2> &nodes = shape.nodes;
    const auto plain = [&](const auto &) { return nodes; };
    return shape.visit(
        [&](const PathForm &path) { return plain(path); },
        [&](const RectangleForm &form) {
            if (nodes.size() != 2) {
                return plain(form);
            }
            const Vec2 a = nodes[0], c = nodes[1];
            return std::vector<Vec2>{a, {c.x, a.y}, c, {a.x, c.y}};
        },
        [&](const CircleForm &form) { return plain(form); }, [&](const PointForm &form) { return plain(form); },
        [&](const EllipseForm &form) { return plain(form); },
        [&](const SlotForm &form) {
            return nodes.size() == 2 ? std::vector<Vec2>{nodes[0], nodes[1], slotSide(shape)} : plain(form);
        });
}

std::size_t handleCount(const Shape &shape) {
    const std::size_t n = shape.nodes.size();
    return shape.visit([n](const PathForm &) { return n; }, [n](const RectangleForm &) { return n == 2 ? 4 : n; },
                       [n](const CircleForm &) { return n; }, [n](const PointForm &) { return n; },
                       [n](const EllipseForm &) { return n; }, [n](const SlotForm &) { return n == 2 ? 3 : n; });
}

bool isCentre(const Shape &shape, std::uint32_t handle) {
    return shape.visit([](const PathForm &) { return false; }, [](const RectangleForm &) { return false; },
                       [=](const CircleForm &) { return handle == 0; }, [](const PointForm &) { return false; },
                       [=](const EllipseForm &) { return handle == 0; }, [=](const SlotForm &) { return handle < 2; });
}

bool isPath(const Shape &shape) {
    return shape.is<PathForm>();
}

bool isRound(const Shape &shape) {
    return shape.is<CircleForm>() || shape.is<EllipseForm>();
}

bool isClosed(const Shape &shape) {
    return !shape.isPolyline() && !shape.is<PointForm>();
}

double circleRadius(const Shape &shape) {
    return shape.is<CircleForm>() && shape.nodes.size() == 2 ? distance(shape.nodes[0], shape.nodes[1]) : 0.0;
}

namespace {

/// Returns the box of the nodes of a shape, with a margin.
Box2 boxOfNodes(const Shape &shape, double margin = 0.0) {
    Box2 box;
    for (const Vec2 node : shape.nodes) {
        box.add(boxAround(node, margin));
    }
    return box;
}

} // namespace

Box2 boundsOf(const Shape &shape) {
    const std::vector<Vec2> &nodes = shape.nodes;
    return shape.visit(
        [&](const PathForm &path) {
            Box2 box = boxOfNodes(shape);
            for (const Curve &curve : path.curves) {
                if (curve.kind() != CurveKind::Line) {
                    box.add(curve.bounds());
                }
            }
            return box;
        },
        [&](const RectangleForm &) { return boxOfNodes(shape); },
        [&](const CircleForm &) {
            return nodes.size() == 2 ? boxAround(nodes[0], circleRadius(shape)) : boxOfNodes(shape);
        },
        [&](const PointForm &) { return boxOfNodes(shape); },
        [&](const EllipseForm &) {
            if (nodes.size() != 3) {
                return boxOfNodes(shape);
            }
            const Vec2 u = nodes[1] - nodes[0], v = nodes[2] - nodes[0];
            const Vec2 reach{std::hypot(u.x, v.x), std::hypot(u.y, v.y)};
            return Box2{nodes[0] - reach, nodes[0] + reach};
        },
        [&](const SlotForm &slot) { return boxOfNodes(shape, slot.radius); });
}

double largestRounding(const Shape &rectangle) {
    const Vec2 size = boundsOf(rectangle).size();
    return 0.5 * std::min(size.x, size.y);
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
    if (shape.is<CircleForm>() && shape.nodes.size() == 2) {
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
    if (shape.is<CircleForm>()) {
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
    if (shape.is<CircleForm>()) {
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
    if (PathForm *const path = std::get_if<PathForm>(&shape.form)) {
        for (Curve &curve : path->curves) {
            curve = curve.kind() == CurveKind::Line ? Curve() : moved(curve, by);
        }
    }
}

void scaleShape(Shape &shape, double factor) {
    const auto scaled = [factor](Vec2 p) { return factor * p; };
    for (Vec2 &node : shape.nodes) {
        node = scaled(node);
    }
    shape.visit(
        [&](PathForm &path) {
            for (Curve &curve : path.curves) {
                curve = curve.mapped(scaled);
            }
        },
        [&](RectangleForm &rectangle) { rectangle.radius *= std::fabs(factor); }, [](CircleForm &) {},
        [](PointForm &) {}, [](EllipseForm &) {}, [&](SlotForm &slot) { slot.radius *= std::fabs(factor); });
    for (auto &[node, part] : shape.nodeSizes) {
        part.size *= std::fabs(factor);
    }
    for (auto &[segment, size] : shape.segmentSizes) {
        size.size *= std::fabs(factor);
    }
}

void becomePath(Shape &shape) {
    if (isPath(shape) || shape.is<PointForm>()) {
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
    if (isRound(before) && !shape.segmentSizes.empty()) { // in parts of equal parameters, as the path has
        const SegmentSize whole = shape.segmentSizes.begin()->second;
        const auto parts = static_cast<std::uint32_t>(outline.segmentCount());
        for (std::uint32_t k = 0; k < parts; ++k) {
            SegmentSize &size = shape.segmentSizes[k] = whole;
            size.elements = (whole.elements + parts - 1 - k) / parts; // their sum is that of the whole
            size.elements = whole.elements > 0 ? std::max(size.elements, 1U) : 0U;
            size.bias = partOf(whole.bias, 1.0 / parts);
        }
    } else {
        shape.segmentSizes = sizesOfOutline(before);
    }
    shape.form = PathForm{.closed = true, .curves = std::move(outline.curves)};
    shape.nodes = std::move(outline.nodes);
    shape.cuts.clear();
    moveNodeSizes(shape, before); // that of a rounded corner goes to the ends of its arc
}

void moveNodes(Shape &shape, std::vector<Vec2> places) {
    const Outline before = outlineOf(shape);
    const Outline after{std::move(places), before.closed, before.curves, {}};
    for (std::size_t k = 0; k < before.segmentCount(); ++k) {
        if (before.isCurved(k) && (before.from(k) != after.from(k) || before.to(k) != after.to(k))) {
            shape.path().curves[k] = joining(before.curves[k], after.from(k), after.to(k));
            if (k < shape.cuts.size()) {
                shape.cuts[k].clear();
            }
        }
    }
    shape.nodes = after.nodes;
}

std::string kindName(const Shape &shape) {
    return isSlot(shape) ? "slot" : std::string(wordOf(shape.kind()));
}

std::string displayName(const Shape &shape) {
    return shape.name.empty() ? kindName(shape) + ' ' + std::to_string(shape.id) : shape.name;
}

} // namespace forefront
