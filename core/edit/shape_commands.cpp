#include "core/edit/shape_commands.hpp"

#include "core/edit/shape_geometry.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace forefront {
namespace {

Diagnostics noSuch(const char *what) {
    return error(std::string("no-such-") + what, std::string(what) + " not found");
}

/// Keeps one tag per segment, or none if all segments have the tag of the shape.
void tidyTags(Shape &shape) {
    if (!shape.segmentTags.empty()) {
        shape.segmentTags.resize(taggedSegments(shape), shape.tag);
    }
    if (std::all_of(shape.segmentTags.begin(), shape.segmentTags.end(),
                    [&](std::int32_t tag) { return tag == shape.tag; })) {
        shape.segmentTags.clear();
    }
}

using Change = std::function<Status(Shape &)>;

/// Applies `change` to a copy of each shape and replaces the originals, if all copies are valid.
Result<Document> changeShapes(const Document &document, const std::set<std::uint32_t> &ids, const Change &change) {
    Document next = document;
    std::size_t found = 0;
    for (auto &pointer : next.shapes) {
        if (!ids.contains(pointer->id)) {
            continue;
        }
        ++found;
        Shape shape = *pointer;
        if (Status status = change(shape); !status.empty()) {
            return status;
        }
        if (Diagnostics faults = checkShape(shape); !faults.empty()) {
            return faults;
        }
        tidyTags(shape);
        pointer = std::make_shared<const Shape>(std::move(shape));
    }
    if (found < ids.size()) {
        return noSuch("shape");
    }
    return next;
}

Result<Document> changeShape(const Document &document, std::uint32_t id, const Change &change) {
    return changeShapes(document, {id}, change);
}

Status becomePolygon(Shape &shape, double circleTolerance) {
    if (shape.kind == ShapeKind::Rectangle || shape.kind == ShapeKind::Circle) {
        shape.nodes = outlineOf(shape, circleTolerance).nodes;
        shape.kind = ShapeKind::Polygon;
        return {};
    }
    return error("not-possible", displayName(shape) + " is not a rectangle or circle");
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
        sound = n >= 3;
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
    }
    if (!sound) {
        return error("bad-shape", std::string(wordOf(shape.kind)) + " is degenerate",
                     "a polygon needs three nodes, a polyline two, a rectangle two sides, a circle a radius");
    }
    return {};
}

Result<Document> addShape(const Document &document, Shape shape) {
    return addShapes(document, {std::move(shape)});
}

Result<Document> addShapes(const Document &document, std::vector<Shape> shapes) {
    Document next = document;
    for (Shape &shape : shapes) {
        if (Diagnostics faults = checkShape(shape); !faults.empty()) {
            return faults;
        }
        tidyTags(shape);
        shape.id = next.nextId++;
        next.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
    }
    return next;
}

Document removeShapes(const Document &document, const std::set<std::uint32_t> &ids) {
    Document next = document;
    std::erase_if(next.shapes, [&](const auto &shape) { return ids.contains(shape->id); });
    return next;
}

Result<Document> replaceShape(const Document &document, Shape shape) {
    return changeShape(document, shape.id, [&](Shape &place) -> Status {
        place = std::move(shape);
        return {};
    });
}

Result<Document> setHandle(const Document &document, NodeRef node, Vec2 to) {
    return changeShape(document, node.shape, [&](Shape &shape) -> Status {
        if (node.node >= handleCount(shape)) {
            return noSuch("node");
        }
        placeHandle(shape, node.node, to);
        return {};
    });
}

void placeHandle(Shape &shape, std::uint32_t handle, Vec2 to) {
    std::vector<Vec2> &nodes = shape.nodes;
    if (shape.kind == ShapeKind::Rectangle) {
        // Corners 0 and 2 are the nodes; corner 1 shares y with 0 and x with 2, corner 3 the reverse.
        nodes[handle == 1 || handle == 2 ? 1 : 0].x = to.x;
        nodes[handle == 2 || handle == 3 ? 1 : 0].y = to.y;
    } else if (shape.kind == ShapeKind::Circle && handle == 0) {
        nodes[1] += to - nodes[0];
        nodes[0] = to;
    } else {
        nodes[handle] = to;
    }
}

Result<Document> setRadius(const Document &document, std::uint32_t circle, double radius) {
    return changeShape(document, circle, [&](Shape &shape) -> Status {
        if (shape.kind != ShapeKind::Circle) {
            return error("not-possible", displayName(shape) + " is not a circle");
        }
        if (!(radius > 0.0) || !std::isfinite(radius)) {
            return error("bad-number", "invalid radius; expected a number above 0");
        }
        const Vec2 arm = shape.nodes[1] - shape.nodes[0];
        shape.nodes[1] = shape.nodes[0] + (radius / length(arm)) * arm;
        return {};
    });
}

Result<Document> setSegmentLength(const Document &document, SegmentRef segment, double target) {
    return changeShape(document, segment.shape, [&](Shape &shape) -> Status {
        const Outline outline = outlineOf(shape, document.circleTolerance);
        if (shape.kind == ShapeKind::Circle || segment.segment >= outline.segmentCount()) {
            return noSuch("segment");
        }
        const Vec2 from = outline.from(segment.segment), arm = outline.to(segment.segment) - from;
        if (!(target > 0.0) || !std::isfinite(target) || !(length(arm) > 0.0)) {
            return error("bad-number", "invalid length; expected a number above 0");
        }
        const auto end = static_cast<std::uint32_t>((segment.segment + 1) % outline.nodes.size());
        placeHandle(shape, end, from + (target / length(arm)) * arm);
        return {};
    });
}

Result<Document> insertNode(const Document &document, SegmentRef segment, Vec2 at) {
    return changeShape(document, segment.shape, [&](Shape &shape) -> Status {
        if (shape.kind == ShapeKind::Circle) {
            return error("not-possible", "a circle has no corners", "convert it to a polygon first");
        }
        if (segment.segment >= taggedSegments(shape)) {
            return noSuch("segment");
        }
        if (shape.kind == ShapeKind::Rectangle) {
            becomePolygon(shape, document.circleTolerance);
        }
        if (!shape.segmentTags.empty()) {
            shape.segmentTags.resize(taggedSegments(shape), shape.tag);
            const std::int32_t tag = shape.segmentTags[segment.segment];
            shape.segmentTags.insert(shape.segmentTags.begin() + segment.segment, tag);
        }
        shape.nodes.insert(shape.nodes.begin() + segment.segment + 1, at);
        return {};
    });
}

Result<Document> convertToPolygon(const Document &document, std::uint32_t id) {
    return changeShape(document, id, [&](Shape &shape) { return becomePolygon(shape, document.circleTolerance); });
}

Result<Document> toggleClosed(const Document &document, std::uint32_t id) {
    return changeShape(document, id, [&](Shape &shape) -> Status {
        if (shape.kind == ShapeKind::Polygon) {
            shape.nodes.push_back(shape.nodes.front());
            shape.kind = ShapeKind::Polyline;
            return {};
        }
        if (shape.kind != ShapeKind::Polyline) {
            return error("not-possible",
                         displayName(shape) + " can be neither opened nor closed; expected a polygon or polyline");
        }
        // A polyline that ends at its start closes there; another one gets one more segment.
        if (shape.nodes.size() > 3 && shape.nodes.front() == shape.nodes.back()) {
            shape.nodes.pop_back();
        }
        shape.kind = ShapeKind::Polygon;
        return {};
    });
}

Result<Document> setShapeTag(const Document &document, const std::set<std::uint32_t> &ids, std::int32_t tag) {
    return changeShapes(document, ids, [&](Shape &shape) -> Status {
        shape.tag = tag;
        shape.segmentTags.clear();
        return {};
    });
}

Result<Document> setSegmentTag(const Document &document, const std::set<SegmentRef> &segments, std::int32_t tag) {
    std::set<std::uint32_t> ids;
    for (const SegmentRef segment : segments) {
        ids.insert(segment.shape);
    }
    return changeShapes(document, ids, [&](Shape &shape) -> Status {
        shape.segmentTags.resize(taggedSegments(shape), shape.tag);
        for (auto ref = segments.lower_bound({shape.id, 0}); ref != segments.end() && ref->shape == shape.id; ++ref) {
            if (ref->segment >= shape.segmentTags.size()) {
                return noSuch("segment");
            }
            shape.segmentTags[ref->segment] = tag;
        }
        if (shape.kind == ShapeKind::Circle) {
            shape.tag = tag;
        }
        return {};
    });
}

Result<Document> setShapeName(const Document &document, std::uint32_t id, std::string name) {
    return changeShape(document, id, [&](Shape &shape) -> Status {
        shape.name = std::move(name);
        return {};
    });
}

Result<Document> setShapeUse(const Document &document, const std::set<std::uint32_t> &ids, ShapeUse use) {
    return changeShapes(document, ids, [&](Shape &shape) -> Status {
        shape.use = use;
        return {};
    });
}

} // namespace forefront
