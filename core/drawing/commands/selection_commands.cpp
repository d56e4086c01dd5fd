#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/picking/selected_handles.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace forefront {
namespace {

/// Returns the handles to move or delete by shape, without those of shapes selected as a whole.
std::map<std::uint32_t, std::set<std::uint32_t>> handlesOfSelection(const Document &document,
                                                                    const Selection &selection, bool withSegments) {
    std::map<std::uint32_t, std::set<std::uint32_t>> handles;
    for (const NodeRef node : selection.nodes) {
        if (!selection.shapes.contains(node.shape)) {
            handles[node.shape].insert(node.node);
        }
    }
    if (withSegments) {
        for (const SegmentRef segment : selection.segments) {
            const Shape *shape = findShape(document, segment.shape);
            if (shape == nullptr || selection.shapes.contains(segment.shape)) {
                continue;
            }
            handles[segment.shape].merge(handlesOfPart(*shape, segment.segment));
        }
    }
    return handles;
}

/// Joins the curves before and after a node that is removed next; the first of them takes the place of both.
void joinCurves(Shape &shape, std::uint32_t node) {
    if (!isPath(shape) || shape.path().curves.empty()) {
        return;
    }
    std::vector<Curve> &curves = shape.path().curves;
    shape.cuts.clear();
    const Outline outline = outlineOf(shape);
    const auto count = static_cast<std::uint32_t>(outline.segmentCount());
    if (count == 0) { // one node, which starts no curve
        return;
    }
    const bool atEnd = !outline.closed && (node == 0 || node == count);
    const std::uint32_t before = node == 0 ? count - 1 : node - 1, after = node % count;
    if (!atEnd && count > 1 && (outline.isCurved(before) || outline.isCurved(after))) {
        curves[before] = merged(outline.curve(before), outline.curve(after));
    }
    curves.erase(curves.begin() + (atEnd && node == count ? before : after));
}

/// Removes nodes and joins their neighbours along a curve as near as possible to the old ones; the segment that starts
/// at a removed node goes with it.
void removeNodes(Shape &shape, const std::set<std::uint32_t> &handles) {
    if (isRound(shape) || shape.is<SlotForm>()) {
        shape.nodes.clear();
        return;
    }
    if (shape.is<RectangleForm>()) {
        shape.as<RectangleForm>().radius = 0.0; // the corners are the nodes that can be selected
        becomePath(shape);
    }
    const Shape before = shape;
    for (auto handle = handles.rbegin(); handle != handles.rend(); ++handle) {
        if (*handle >= shape.nodes.size()) {
            continue;
        }
        joinCurves(shape, *handle);
        shape.nodes.erase(shape.nodes.begin() + *handle);
        if (!shape.segmentTags.empty()) {
            const auto last = static_cast<std::uint32_t>(shape.segmentTags.size() - 1);
            shape.segmentTags.erase(shape.segmentTags.begin() + std::min(*handle, last));
        }
    }
    shape.segmentSizes.clear(); // see carrySegmentSizes()
    keepNodeSizes(shape, before);
}

/// Maps some nodes of a path. Curves with both ends among them are mapped exactly; the others follow their ends.
void mapNodes(Shape &path, const std::set<std::uint32_t> &nodes, const PlaneMap &map) {
    const Outline before = outlineOf(path);
    std::vector<Vec2> places = path.nodes;
    for (const std::uint32_t node : nodes) {
        places[node] = map(places[node]);
    }
    moveNodes(path, std::move(places));
    for (const std::uint32_t node : nodes) {
        if (before.isCurved(node) && nodes.contains((node + 1) % static_cast<std::uint32_t>(path.nodes.size()))) {
            const Curve &curve = before.curves[node];
            path.path().curves[node] = map.isTranslation() ? moved(curve, map.shift) : curve.mapped(map);
            if (node < path.cuts.size()) {
                path.cuts[node].clear(); // even if neither end moves
            }
        }
    }
}

/// Returns the polylines that remain when some segments of a shape are removed; none for a circle.
std::vector<Shape> withoutSegments(const Shape &shape, const std::set<SegmentRef> &gone) {
    std::vector<Shape> pieces;
    const Outline outline = outlineOf(shape);
    const auto removed = [&](std::size_t k) { return gone.contains({shape.id, outline.part(k)}); };
    const std::size_t count = isRound(shape) ? 0 : outline.segmentCount();
    // In a closed outline, start after a removed segment, so that no piece is cut at its first node.
    std::size_t start = 0;
    while (outline.closed && start < count && !removed(start)) {
        ++start;
    }
    bool open = false;
    for (std::size_t step = 0; step < count; ++step) {
        const std::size_t k = (start + step) % count;
        if (removed(k)) {
            open = false;
            continue;
        }
        if (!open) {
            Shape piece;
            piece.id = shape.id;
            piece.form = PathForm{.closed = false};
            piece.use = shape.use;
            piece.tag = shape.tag;
            piece.name = shape.name;
            piece.nodes = {outline.from(k)};
            pieces.push_back(std::move(piece));
            open = true;
        }
        pieces.back().nodes.push_back(outline.to(k));
        pieces.back().segmentTags.push_back(segmentTag(shape, outline.part(k)));
        if (!outline.curves.empty()) {
            pieces.back().path().curves.push_back(outline.curves[k]);
        }
    }
    for (Shape &piece : pieces) {
        takeNodeSizes(piece, shape);
    }
    return pieces;
}

} // namespace

std::map<std::uint32_t, std::set<std::uint32_t>> handlesToMove(const Document &document, const Selection &selection) {
    return handlesOfSelection(document, selection, true);
}

Status mapHandles(Shape &shape, const std::set<std::uint32_t> &handles, const PlaneMap &map) {
    const std::vector<Vec2> places = handlesOf(shape);
    if (std::any_of(handles.begin(), handles.end(), [&](std::uint32_t handle) { return handle >= places.size(); })) {
        return error("no-such-node", "node not found");
    }
    if (handles.size() == places.size()) {
        mapShape(shape, map);
        return {};
    }
    if (isPath(shape)) {
        mapNodes(shape, handles, map);
        return {};
    }
    // A selected centre moves the whole circle, including its point.
    if (isRound(shape) && handles.contains(0)) {
        moveShape(shape, map.isTranslation() ? map.shift : map(places[0]) - places[0]);
        return {};
    }
    for (const std::uint32_t handle : handles) {
        placeHandle(shape, handle, map(places[handle]));
    }
    return {};
}

Result<Document> moveSelection(const Document &document, const Selection &selection, Vec2 by) {
    return transformSelection(document, selection, PlaneMap::translation(by));
}

Document deleteSelection(const Document &document, const Selection &selection) {
    Document next = document;
    const auto handles = handlesOfSelection(document, selection, false);
    std::vector<std::shared_ptr<const Shape>> kept;
    for (const auto &pointer : document.shapes) {
        if (selection.shapes.contains(pointer->id)) {
            continue;
        }
        const auto part = handles.find(pointer->id);
        const bool segmentGone = std::any_of(selection.segments.begin(), selection.segments.end(),
                                             [&](SegmentRef ref) { return ref.shape == pointer->id; });
        if (part == handles.end() && !segmentGone) {
            kept.push_back(pointer);
            continue;
        }
        std::vector<Shape> pieces{*pointer};
        if (part != handles.end()) {
            removeNodes(pieces.front(), part->second);
        } else {
            pieces = withoutSegments(*pointer, selection.segments);
        }
        for (Shape &piece : pieces) {
            if (checkShape(piece).empty()) {
                piece.id = &piece == &pieces.front() ? pointer->id : next.nextId++;
                kept.push_back(std::make_shared<const Shape>(std::move(piece)));
            }
        }
    }
    next.shapes = std::move(kept);
    for (auto k = selection.sources.rbegin(); k != selection.sources.rend(); ++k) {
        if (*k < next.spacing.sources.size()) {
            next.spacing.sources.erase(next.spacing.sources.begin() + *k);
        }
    }
    for (auto k = selection.markers.rbegin(); k != selection.markers.rend(); ++k) {
        if (*k < next.regionMarkers.size()) {
            next.regionMarkers.erase(next.regionMarkers.begin() + *k);
        }
    }
    if (!selection.constraints.empty()) {
        next = removeConstraints(next, selection.constraints);
    }
    return next;
}

Result<Document> duplicateSelection(const Document &document, const Selection &selection, Vec2 by, Selection *copies) {
    return copySelection(document, selection, std::array{PlaneMap::translation(by)}, copies);
}

} // namespace forefront
