#include "core/drawing/shapes/shape_commands.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

namespace forefront {
namespace {

Diagnostics noSuch(const char *what) {
    return error(std::string("no-such-") + what, std::string(what) + " not found");
}

/// Lets the curves of a path join its nodes; removes them if all segments are straight.
void tidyCurves(std::vector<Curve> &curves, const Outline &outline) {
    for (std::size_t k = 0; k < curves.size(); ++k) {
        curves[k] = curves[k].kind() == CurveKind::Cubic  ? joining(curves[k], outline.from(k), outline.to(k))
                    : curves[k].kind() == CurveKind::Line ? Curve()
                                                          : curves[k];
    }
    if (std::all_of(curves.begin(), curves.end(), [](const Curve &curve) { return curve == Curve(); })) {
        curves.clear();
    }
}

/// Normalises the lists of a shape: one tag per segment, or none if all segments have the tag of the shape; one curve
/// per segment, from node to node, or none if all are straight.
void tidy(Shape &shape) {
    if (!shape.segmentTags.empty()) {
        shape.segmentTags = segmentTagsOf(shape);
    }
    if (std::all_of(shape.segmentTags.begin(), shape.segmentTags.end(),
                    [&](std::int32_t tag) { return tag == shape.tag; })) {
        shape.segmentTags.clear();
    }
    std::erase_if(shape.nodeSizes, [&](const auto &entry) { return !canHaveSize(shape, entry.first); });
    std::erase_if(shape.segmentSizes,
                  [parts = taggedSegments(shape)](const auto &entry) { return entry.first >= parts; });
    const Outline outline = outlineOf(shape);
    if (isPath(shape)) {
        tidyCurves(shape.path().curves, outline);
        if (shape.path().curves.empty()) {
            shape.cuts.clear();
        }
    }
    if (!shape.cuts.empty()) {
        shape.cuts.resize(outline.segmentCount());
    }
}

using Change = std::function<Status(Shape &)>;

/// Who moves the sizes of nodes to their new indices when the list of nodes changes.
enum class SizeOwner : std::uint8_t {
    Here,  ///< changeShapes(), by place, unless the change has altered them
    Callee ///< the change itself
};

/// Applies `change` to a copy of each shape and replaces the originals, if all copies are valid.
Result<Document> changeShapes(const Document &document, const std::set<std::uint32_t> &ids, const Change &change,
                              SizeOwner owner = SizeOwner::Here) {
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
        if (owner == SizeOwner::Here && shape.nodeSizes == pointer->nodeSizes &&
            handleCount(shape) != handleCount(*pointer)) {
            keepNodeSizes(shape, *pointer);
        }
        if (Diagnostics faults = checkShape(shape); !faults.empty()) {
            return faults;
        }
        tidy(shape);
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

/// Moves the end of a half-axis of an ellipse. Perpendicular axes stay perpendicular: the first axis turns the second
/// with it; the second only changes its length.
void placeAxis(Shape &shape, std::uint32_t handle, Vec2 to) {
    constexpr double kPerpendicular = 1e-9;
    std::vector<Vec2> &nodes = shape.nodes;
    const Vec2 u = nodes[1] - nodes[0], v = nodes[2] - nodes[0], arm = to - nodes[0];
    const double side = cross(u, v) < 0.0 ? -1.0 : 1.0;
    if (std::fabs(dot(u, v)) > kPerpendicular * length(u) * length(v)) {
        nodes[handle] = to;
    } else if (handle == 1 && length(arm) > 0.0) {
        nodes[1] = to;
        nodes[2] = nodes[0] + (side * length(v) / length(arm)) * leftNormal(arm);
    } else if (handle == 2) {
        const Vec2 across = (1.0 / length(u)) * leftNormal(u);
        nodes[2] = nodes[0] + dot(arm, across) * across;
    }
}

/// Returns the segment of a part of an outline that is nearest to a point.
std::uint32_t nearestSegment(const Outline &outline, std::uint32_t part, Vec2 at) {
    std::uint32_t best = 0;
    double limit = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < outline.segmentCount(); ++k) {
        const Curve curve = outline.curve(k);
        const double d = distance(curve.point(curve.nearest(at)), at);
        if (outline.part(k) == part && d < limit) {
            best = k;
            limit = d;
        }
    }
    return best;
}

/// Divides the curve of a segment for a new node; a straight segment stays straight on both sides.
void splitCurve(Shape &shape, std::uint32_t segment, Vec2 at) {
    std::vector<Curve> &curves = shape.path().curves;
    if (curves.empty()) {
        return;
    }
    shape.cuts.clear();
    const Outline outline = outlineOf(shape);
    curves.insert(curves.begin() + segment, Curve());
    if (outline.isCurved(segment)) {
        const Curve &curve = outline.curves[segment];
        const double t = curve.nearest(at);
        curves[segment] = joining(curve.part(0.0, t), outline.from(segment), at);
        curves[segment + 1] = joining(curve.part(t, 1.0), at, outline.to(segment));
    }
}

} // namespace

Result<Document> addShape(const Document &document, Shape shape) {
    return addShapes(document, {std::move(shape)});
}

Result<Document> addShapes(const Document &document, std::vector<Shape> shapes) {
    Document next = document;
    for (Shape &shape : shapes) {
        if (Diagnostics faults = checkShape(shape); !faults.empty()) {
            return faults;
        }
        tidy(shape);
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

Result<Document> replaceShapes(const Document &document, std::vector<Shape> shapes) {
    std::map<std::uint32_t, Shape *> byId;
    std::set<std::uint32_t> ids;
    for (Shape &shape : shapes) {
        byId.emplace(shape.id, &shape);
        ids.insert(shape.id);
    }
    const auto replace = [&](Shape &place) -> Status {
        place = std::move(*byId.at(place.id));
        return {};
    };
    return changeShapes(document, ids, replace, SizeOwner::Callee);
}

Result<Document> replaceShape(const Document &document, Shape shape) {
    return changeShape(document, shape.id, [&](Shape &place) -> Status {
        std::swap(place, shape);
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
    if (isPath(shape)) {
        std::vector<Vec2> places = nodes;
        places[handle] = to;
        moveNodes(shape, std::move(places)); // dropping the cuts of the segments that change
        return;
    }
    if (isRound(shape) && handle == 0) {
        moveShape(shape, to - nodes[0]);
    }
    shape.visit([](const PathForm &) {},
                [&](const RectangleForm &) {
                    // Corners 0 and 2 are the nodes; corner 1 shares y with 0 and x with 2, corner 3 the reverse.
                    nodes[handle == 1 || handle == 2 ? 1 : 0].x = to.x;
                    nodes[handle == 2 || handle == 3 ? 1 : 0].y = to.y;
                },
                [&](const CircleForm &) { nodes[handle] = to; }, [&](const PointForm &) { nodes[handle] = to; },
                [&](const EllipseForm &) { handle == 0 ? void(nodes[0] = to) : placeAxis(shape, handle, to); },
                [&](const SlotForm &) { placeSlotHandle(shape, handle, to); });
    shape.cuts.clear();
}

Result<Document> setRadius(const Document &document, std::uint32_t circle, double radius) {
    return changeShape(document, circle, [&](Shape &shape) -> Status {
        if (!shape.is<CircleForm>()) {
            return error("not-possible", displayName(shape) + " is not a circle");
        }
        if (!(radius > 0.0) || !std::isfinite(radius)) {
            return error("bad-number", "invalid radius; expected a number above 0");
        }
        const Vec2 arm = shape.nodes[1] - shape.nodes[0];
        shape.nodes[1] = shape.nodes[0] + (radius / length(arm)) * arm;
        shape.cuts.clear();
        return {};
    });
}

Result<Document> setSegmentLength(const Document &document, SegmentRef segment, double target) {
    return changeShape(document, segment.shape, [&](Shape &shape) -> Status {
        const std::vector<Vec2> handles = handlesOf(shape);
        if (isRound(shape) || segment.segment >= taggedSegments(shape)) {
            return noSuch("segment");
        }
        if (isRoundedCorner(shape, segment.segment)) {
            return error("not-possible", "the length of a rounded corner follows from its radius", "change the radius");
        }
        if (!shape.is<RectangleForm>() && outlineOf(shape).isCurved(segment.segment)) {
            return isPath(shape)
                       ? error("not-possible", "the length of a curved segment follows from its handles",
                               "move them, or make the segment straight")
                       : error("not-possible", "the length of a slot's end follows from its width", "change the width");
        }
        const bool slot = shape.is<SlotForm>(); // each side is as long as the way between the centres
        const std::uint32_t begin = slot ? 0 : segment.segment;
        const auto end = static_cast<std::uint32_t>((begin + 1) % handles.size());
        const Vec2 from = handles[begin], arm = handles[end] - from;
        if (!(target > 0.0) || !std::isfinite(target) || !(length(arm) > 0.0)) {
            return error("bad-number", "invalid length; expected a number above 0");
        }
        placeHandle(shape, end, from + (target / length(arm)) * arm);
        return {};
    });
}

Result<Document> setArcRadius(const Document &document, SegmentRef segment, double radius) {
    return changeShape(document, segment.shape, [&](Shape &shape) -> Status {
        PathForm *const path = std::get_if<PathForm>(&shape.form);
        if (path == nullptr || segment.segment >= path->curves.size() || !radiusOf(path->curves[segment.segment])) {
            return error("not-possible", "the segment is not an arc of a circle", "select an arc");
        }
        Curve &arc = path->curves[segment.segment];
        const double half = 0.5 * distance(arc.point(0.0), arc.point(1.0));
        constexpr double kRounding = 1e-9;
        if (!(radius >= (1.0 - kRounding) * half) || !(radius > 0.0) || !std::isfinite(radius)) {
            return error("bad-number",
                         "invalid radius " + numberText(radius, 6) + "; the ends of the arc are " +
                             numberText(2.0 * half, 6) + " apart",
                         "enter at least half of that");
        }
        arc = withRadius(arc, radius);
        shape.cuts.clear();
        return {};
    });
}

Result<Document> insertNode(const Document &document, SegmentRef segment, Vec2 at) {
    return changeShape(document, segment.shape, [&](Shape &shape) -> Status {
        if (isRound(shape)) {
            return error("not-possible", "a " + std::string(wordOf(shape.kind())) + " has no corners",
                         "convert it to a path first");
        }
        if (segment.segment >= taggedSegments(shape)) {
            return noSuch("segment");
        }
        std::uint32_t k = segment.segment;
        if (!isPath(shape)) {
            k = nearestSegment(outlineOf(shape), segment.segment, at);
            becomePath(shape);
        }
        if (!shape.segmentTags.empty()) {
            shape.segmentTags.resize(taggedSegments(shape), shape.tag);
            const std::int32_t tag = shape.segmentTags[k];
            shape.segmentTags.insert(shape.segmentTags.begin() + k, tag);
        }
        shape.segmentSizes.clear(); // the segments take those at their places
        splitCurve(shape, k, at);
        shape.nodes.insert(shape.nodes.begin() + k + 1, at);
        return {};
    });
}

Result<Document> convertToPath(const Document &document, std::uint32_t id) {
    return changeShape(document, id, [&](Shape &shape) -> Status {
        if (isPath(shape) || shape.is<PointForm>()) {
            return error("not-possible", displayName(shape) + " is not a rectangle, circle, ellipse or slot");
        }
        becomePath(shape);
        return {};
    });
}

Result<Document> convertToPaths(const Document &document, const std::set<std::uint32_t> &ids) {
    Result<Document> next = document;
    Diagnostics faults;
    bool any = false;
    for (const std::uint32_t id : ids) {
        Result<Document> changed = convertToPath(*next, id);
        if (changed) {
            next = std::move(changed);
            any = true;
        } else {
            faults = changed.faults();
        }
    }
    return any || faults.empty() ? next : faults;
}

Result<Document> toggleClosed(const Document &document, std::uint32_t id) {
    return changeShape(document, id, [&](Shape &shape) -> Status {
        if (shape.isPolygon()) {
            shape.nodes.push_back(shape.nodes.front());
            shape.path().closed = false;
            return {};
        }
        if (!shape.isPolyline()) {
            return error("not-possible",
                         displayName(shape) + " can be neither opened nor closed; expected a polygon or polyline");
        }
        // A polyline that ends at its start closes there; another one gets one more segment.
        PathForm &path = shape.path();
        const bool curved = !path.curves.empty();
        if (shape.nodes.size() > (curved ? 1U : 3U) && shape.nodes.front() == shape.nodes.back()) {
            shape.nodes.pop_back();
        } else if (curved) {
            path.curves.emplace_back();
            shape.cuts.clear();
        }
        path.closed = true;
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
        shape.segmentTags = segmentTagsOf(shape);
        for (auto ref = segments.lower_bound({shape.id, 0}); ref != segments.end() && ref->shape == shape.id; ++ref) {
            if (ref->segment >= shape.segmentTags.size()) {
                return noSuch("segment");
            }
            shape.segmentTags[ref->segment] = tag;
        }
        if (isRound(shape)) {
            shape.tag = tag;
        }
        return {};
    });
}

Result<Document> setShapeName(const Document &document, std::uint32_t id, std::string name) {
    return changeShape(document, id, [&](Shape &shape) -> Status {
        shape.name.swap(name);
        return {};
    });
}

Result<Document> setHidden(const Document &document, const std::set<std::uint32_t> &ids, bool hidden) {
    return changeShapes(document, ids, [&](Shape &shape) -> Status {
        shape.hidden = hidden;
        return {};
    });
}

Result<Document> setLocked(const Document &document, const std::set<std::uint32_t> &ids, bool locked) {
    return changeShapes(document, ids, [&](Shape &shape) -> Status {
        shape.locked = locked;
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
