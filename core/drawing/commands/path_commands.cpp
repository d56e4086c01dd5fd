#include "core/drawing/commands/path_commands.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

Diagnostics notFound(const char *what) {
    return error(std::string("no-such-") + what, std::string(what) + " not found");
}

Diagnostics notPath(const Shape &shape) {
    return error("not-possible", displayName(shape) + " is not a path", "convert it to a path first");
}

/// The segments that meet at a node; kNone where there is none.
struct Beside {
    std::uint32_t before = kNone, after = kNone;
};

Beside segmentsAt(const Outline &outline, std::uint32_t node) {
    const auto count = static_cast<std::uint32_t>(outline.segmentCount());
    Beside beside;
    if (count == 0) {
        return beside;
    }
    if (outline.closed || node > 0) {
        beside.before = node == 0 ? count - 1 : node - 1;
    }
    if (node < count) {
        beside.after = node;
    }
    return beside;
}

bool isCubic(const Outline &outline, std::uint32_t segment) {
    return segment != kNone && outline.isCurved(segment) && outline.curves[segment].kind() == CurveKind::Cubic;
}

Vec2 controlOf(const Curve &cubic, bool atEnd) {
    const std::array<double, 8> n = cubic.numbers();
    return atEnd ? Vec2{n[4], n[5]} : Vec2{n[2], n[3]};
}

Curve withControl(const Curve &cubic, bool atEnd, Vec2 to) {
    const Vec2 other = controlOf(cubic, !atEnd);
    return Curve::cubic(cubic.point(0.0), atEnd ? other : to, atEnd ? to : other, cubic.point(1.0));
}

/// Returns a segment as a cubic: unchanged, close to an arc, or straight.
Curve asCubic(const Outline &outline, std::uint32_t segment) {
    const Curve curve = outline.curve(segment);
    const Vec2 from = outline.from(segment), to = outline.to(segment);
    switch (curve.kind()) {
    case CurveKind::Cubic:
        return curve;
    case CurveKind::Arc:
        return joining(cubicAlong(curve), from, to);
    case CurveKind::Line:
        break;
    }
    return Curve::cubic(from, lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to);
}

/// Returns the number of cubics for a segment: one for each quarter turn of an arc, where its error is 2.7e-4 of the
/// radius.
std::uint32_t cubicsFor(const Outline &outline, std::uint32_t segment) {
    const Curve curve = outline.curve(segment);
    constexpr double kQuarter = 0.5 * std::numbers::pi, kRounding = 1e-9;
    return curve.kind() == CurveKind::Arc
               ? static_cast<std::uint32_t>(std::ceil(std::fabs(curve.numbers()[7]) / kQuarter - kRounding))
               : 1;
}

/// Divides a segment into pieces of equal length in its curve's parameter.
Result<Document> divided(const Document &document, SegmentRef segment, std::uint32_t pieces) {
    const Curve curve = outlineOf(*findShape(document, segment.shape)).curve(segment.segment);
    Result<Document> next = document;
    for (std::uint32_t k = pieces - 1; k > 0 && next; --k) {
        next = insertNode(*next, segment, curve.point(static_cast<double>(k) / pieces));
    }
    return next;
}

/// Prepares the list of curves of a path for a change.
void openCurves(Shape &shape) {
    PathForm &path = shape.path();
    if (path.curves.empty()) {
        // Without the list, a closed path of two straight segments would count as one segment.
        path.curves.resize(path.closed ? shape.nodes.size() : shape.nodes.size() - 1);
    }
    shape.cuts.clear();
}

/// Replaces one path of a document by another if the new one is valid; `more`, if given, gets a new id and is inserted
/// after it.
Result<Document> replacePath(const Document &document, Shape shape, std::optional<Shape> more = {}) {
    Result<Document> next = replaceShape(document, std::move(shape));
    if (next && more) {
        next = addShape(*next, *std::move(more));
    }
    return next;
}

/// Returns the kind of a node of an outline.
NodeKind kindOf(const Outline &outline, std::uint32_t node) {
    const Beside beside = segmentsAt(outline, node);
    if (!isCubic(outline, beside.before) || !isCubic(outline, beside.after)) {
        return NodeKind::Corner;
    }
    constexpr double kAlmost = 1e-6; // relative to the distances; the accuracy of drawing by hand
    const Vec2 back = controlOf(outline.curves[beside.before], true) - outline.nodes[node];
    const Vec2 ahead = controlOf(outline.curves[beside.after], false) - outline.nodes[node];
    const double reach = length(back) * length(ahead);
    if (!(reach > 0.0) || dot(back, ahead) > 0.0 || std::fabs(cross(back, ahead)) > kAlmost * reach) {
        return NodeKind::Corner;
    }
    return std::fabs(length(back) - length(ahead)) <= kAlmost * length(back) ? NodeKind::Symmetric : NodeKind::Smooth;
}

void makeCorner(Shape &shape, const Outline &outline, std::uint32_t node) {
    const Beside beside = segmentsAt(outline, node);
    if (isCubic(outline, beside.before)) {
        shape.path().curves[beside.before] = withControl(shape.path().curves[beside.before], true, outline.nodes[node]);
    }
    if (isCubic(outline, beside.after)) {
        shape.path().curves[beside.after] = withControl(shape.path().curves[beside.after], false, outline.nodes[node]);
    }
}

void makeSmooth(Shape &shape, const Outline &outline, std::uint32_t node, NodeKind kind) {
    const Beside beside = segmentsAt(outline, node);
    if (beside.before == kNone || beside.after == kNone) {
        return; // an end has only one side
    }
    const Vec2 at = outline.nodes[node], before = outline.from(beside.before), after = outline.to(beside.after);
    const double span = distance(before, after);
    if (!(span > 0.0)) {
        return;
    }
    const Vec2 along = (1.0 / span) * (after - before);
    double back = distance(before, at) / 3.0, ahead = distance(at, after) / 3.0;
    if (kind == NodeKind::Symmetric) {
        back = ahead = 0.5 * (back + ahead);
    }
    const auto bend = [&](std::uint32_t segment, bool atEnd, Vec2 to) {
        const Outline now = outlineOf(shape);
        shape.path().curves[segment] = withControl(asCubic(now, segment), atEnd, to);
    };
    bend(beside.before, true, at - back * along);
    bend(beside.after, false, at + ahead * along);
}

} // namespace

std::vector<Control> controlsOf(const Document &document, const Selection &selection) {
    std::set<ControlRef> refs;
    for (const NodeRef node : selection.nodes) {
        const Shape *shape = findShape(document, node.shape);
        if (shape == nullptr || !isPath(*shape) || node.node >= shape->nodes.size()) {
            continue;
        }
        const Beside beside = segmentsAt(outlineOf(*shape), node.node);
        for (const std::uint32_t segment : {beside.before, beside.after}) {
            refs.insert({node.shape, segment, false});
            refs.insert({node.shape, segment, true});
        }
    }
    for (const SegmentRef segment : selection.segments) {
        refs.insert({segment.shape, segment.segment, false});
        refs.insert({segment.shape, segment.segment, true});
    }
    std::vector<Control> controls;
    for (const ControlRef &ref : refs) {
        const Shape *shape = findShape(document, ref.shape);
        if (shape == nullptr || !isPath(*shape)) {
            continue;
        }
        const Outline outline = outlineOf(*shape);
        if (isCubic(outline, ref.segment)) {
            const Vec2 node = ref.atEnd ? outline.to(ref.segment) : outline.from(ref.segment);
            controls.push_back({ref, controlOf(outline.curves[ref.segment], ref.atEnd), node});
        }
    }
    return controls;
}

NodeKind nodeKind(const Shape &shape, std::uint32_t node) {
    return isPath(shape) && node < shape.nodes.size() ? kindOf(outlineOf(shape), node) : NodeKind::Corner;
}

Result<Document> moveControl(const Document &document, const ControlRef &control, Vec2 to, bool alone) {
    const Shape *given = findShape(document, control.shape);
    if (given == nullptr) {
        return notFound("shape");
    }
    const Outline outline = outlineOf(*given);
    if (!isPath(*given) || control.segment >= outline.segmentCount() || !isCubic(outline, control.segment)) {
        return notFound("control point");
    }
    Shape shape = *given;
    openCurves(shape);
    shape.path().curves[control.segment] = withControl(shape.path().curves[control.segment], control.atEnd, to);
    const auto count = static_cast<std::uint32_t>(outline.nodes.size());
    const std::uint32_t node = control.atEnd ? (control.segment + 1) % count : control.segment;
    const NodeKind kind = kindOf(outline, node);
    const Vec2 arm = outline.nodes[node] - to;
    if (!alone && kind != NodeKind::Corner && length(arm) > 0.0) {
        const Beside beside = segmentsAt(outline, node);
        const std::uint32_t other = control.atEnd ? beside.after : beside.before;
        const double reach = distance(controlOf(outline.curves[other], !control.atEnd), outline.nodes[node]);
        const double scale = kind == NodeKind::Symmetric ? 1.0 : reach / length(arm);
        shape.path().curves[other] =
            withControl(shape.path().curves[other], !control.atEnd, outline.nodes[node] + scale * arm);
    }
    return replacePath(document, std::move(shape));
}

Result<Document> setNodeKind(const Document &document, const std::set<NodeRef> &nodes, NodeKind kind) {
    Document next = document;
    for (const NodeRef node : nodes) {
        const Shape *given = findShape(next, node.shape);
        if (given == nullptr || node.node >= handleCount(*given)) {
            return notFound("node");
        }
        if (!isPath(*given)) {
            return notPath(*given);
        }
        Shape shape = *given;
        openCurves(shape);
        const Outline outline = outlineOf(shape);
        kind == NodeKind::Corner ? makeCorner(shape, outline, node.node) : makeSmooth(shape, outline, node.node, kind);
        Result<Document> changed = replacePath(next, std::move(shape));
        if (!changed) {
            return changed;
        }
        next = *std::move(changed);
    }
    return next;
}

Result<Document> setCurved(const Document &document, const std::set<SegmentRef> &segments, bool curved) {
    Document next = document;
    // From the last segment to the first, so that nodes inserted into an arc do not shift the others.
    for (auto at = segments.rbegin(); at != segments.rend(); ++at) {
        const SegmentRef segment = *at;
        const Shape *given = findShape(next, segment.shape);
        if (given == nullptr || segment.segment >= taggedSegments(*given)) {
            return notFound("segment");
        }
        if (!isPath(*given)) {
            return notPath(*given);
        }
        const std::uint32_t pieces = curved ? cubicsFor(outlineOf(*given), segment.segment) : 1;
        Result<Document> changed = divided(next, segment, pieces);
        if (changed) {
            Shape shape = *findShape(*changed, segment.shape);
            openCurves(shape);
            const Outline outline = outlineOf(shape);
            for (std::uint32_t k = segment.segment; k < segment.segment + pieces; ++k) {
                shape.path().curves[k] = curved ? asCubic(outline, k) : Curve();
            }
            changed = replacePath(*changed, std::move(shape));
        }
        if (!changed) {
            return changed;
        }
        next = *std::move(changed);
    }
    return next;
}

Result<Document> splitPath(const Document &document, NodeRef node) {
    const Shape *given = findShape(document, node.shape);
    if (given == nullptr || node.node >= handleCount(*given)) {
        return notFound("node");
    }
    if (!isPath(*given)) {
        return notPath(*given);
    }
    Shape shape = *given;
    shape.cuts.clear();
    shape.segmentSizes.clear(); // the segments of the parts take those at their places
    const auto at = static_cast<std::ptrdiff_t>(node.node);
    if (shape.isPolygon()) {
        std::rotate(shape.nodes.begin(), shape.nodes.begin() + at, shape.nodes.end());
        const auto turn = [&](auto &list) {
            if (!list.empty()) {
                std::rotate(list.begin(), list.begin() + at, list.end());
            }
        };
        turn(shape.path().curves);
        turn(shape.segmentTags);
        shape.nodes.push_back(shape.nodes.front());
        shape.path().closed = false;
        return replacePath(document, std::move(shape));
    }
    if (node.node == 0 || node.node + 1 == shape.nodes.size()) {
        return error("not-possible", "a path cannot be divided at its end", "select a node between the ends");
    }
    Shape rest = shape;
    shape.nodes.resize(node.node + 1);
    rest.nodes.erase(rest.nodes.begin(), rest.nodes.begin() + at);
    if (!shape.path().curves.empty()) {
        shape.path().curves.resize(node.node);
        rest.path().curves.erase(rest.path().curves.begin(), rest.path().curves.begin() + at);
    }
    if (!shape.segmentTags.empty()) {
        shape.segmentTags.resize(node.node);
        rest.segmentTags.erase(rest.segmentTags.begin(), rest.segmentTags.begin() + at);
    }
    keepNodeSizes(shape, *given);
    keepNodeSizes(rest, *given);
    return replacePath(document, std::move(shape), std::move(rest));
}

namespace {

/// Reverses an open path; its tags and curves must be complete lists.
void reverse(Shape &path) {
    std::reverse(path.nodes.begin(), path.nodes.end());
    std::reverse(path.segmentTags.begin(), path.segmentTags.end());
    std::vector<Curve> &curves = path.path().curves;
    std::reverse(curves.begin(), curves.end());
    for (Curve &curve : curves) {
        curve = curve.kind() == CurveKind::Line ? Curve() : curve.part(1.0, 0.0);
    }
}

/// Returns an open path with complete lists of tags and curves, turned so that the node is its last or first one.
Result<Shape> endingAt(const Document &document, NodeRef node, bool last) {
    const Shape *given = findShape(document, node.shape);
    if (given == nullptr || node.node >= handleCount(*given)) {
        return notFound("node");
    }
    const bool atStart = node.node == 0, atEnd = node.node + 1 == given->nodes.size();
    if (!given->isPolyline() || (!atStart && !atEnd)) {
        return error("not-possible", "only the ends of open paths can be joined", "select two ends");
    }
    Shape path = *given;
    openCurves(path);
    path.segmentTags.resize(path.nodes.size() - 1, path.tag);
    if (atEnd != last) {
        reverse(path);
    }
    return path;
}

} // namespace

Result<Document> joinEnds(const Document &document, NodeRef first, NodeRef second) {
    if (first == second) {
        return error("not-possible", "cannot join a single node", "select two ends of open paths");
    }
    Result<Shape> start = endingAt(document, first, true), rest = endingAt(document, second, false);
    if (!start || !rest) {
        return start ? rest.faults() : start.faults();
    }
    if (first.shape == second.shape) {
        return toggleClosed(document, first.shape);
    }
    Shape path = *std::move(start);
    const bool touch = path.nodes.back() == rest->nodes.front();
    if (!touch) {
        path.segmentTags.push_back(path.tag);
        path.path().curves.emplace_back();
    }
    path.nodes.insert(path.nodes.end(), rest->nodes.begin() + (touch ? 1 : 0), rest->nodes.end());
    path.segmentTags.insert(path.segmentTags.end(), rest->segmentTags.begin(), rest->segmentTags.end());
    std::vector<Curve> &curves = path.path().curves;
    curves.insert(curves.end(), rest->path().curves.begin(), rest->path().curves.end());
    path.segmentSizes.clear();
    path.nodeSizes.clear();
    takeNodeSizes(path, *findShape(document, first.shape));
    takeNodeSizes(path, *findShape(document, second.shape));
    Result<Document> next = replaceShape(document, std::move(path));
    return next ? Result<Document>(removeShapes(*next, {second.shape})) : next;
}

} // namespace forefront
