#include "core/drawing/picking/dragged_parts.hpp"

#include "core/drawing/picking/selected_handles.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

namespace forefront {
namespace {

/// A segment at a node of a path, and the node at its other end.
struct PathSpoke {
    std::uint32_t segment = 0, other = 0;
};

/// Calls `visit` for the segments that begin or end at a node.
template <class Visit>
void forSpokes(const Outline &outline, std::uint32_t node, const Visit &visit) {
    const auto nodes = static_cast<std::uint32_t>(outline.nodes.size());
    const auto segments = static_cast<std::uint32_t>(outline.segmentCount());
    if (node < segments) {
        visit(PathSpoke{node, (node + 1) % nodes});
    }
    if (node > 0 && node <= segments) {
        visit(PathSpoke{node - 1, node - 1});
    } else if (node == 0 && outline.closed && segments > 1) {
        visit(PathSpoke{segments - 1, nodes - 1});
    }
}

} // namespace

PickIndex::Filter targetsOfDrag(const Document &document, const Selection &dragged) {
    auto ignored = std::make_shared<PickIndex::Parts>();
    std::set<std::uint32_t> shapes = dragged.shapes;
    for (const auto &[moved, handles] : handlesToMove(document, dragged)) {
        const std::uint32_t id = moved;
        const Shape *const shape = findShape(document, id);
        if (shape == nullptr || !isPath(*shape)) {
            shapes.insert(id);
            continue;
        }
        const Outline outline = outlineOf(*shape);
        for (const std::uint32_t node : handles) {
            ignored->nodes.insert({id, node});
            forSpokes(outline, node, [&](const PathSpoke &spoke) {
                ignored->segments.insert({id, outline.part(spoke.segment)});
                ignored->nodes.insert({id, spoke.other}); // a node on its neighbour leaves a segment of no length
            });
        }
    }
    PickIndex::Filter filter([shapes = std::move(shapes)](const Shape &shape) { return !shapes.contains(shape.id); });
    filter.ignored = std::move(ignored);
    return filter;
}

std::set<NodeRef> nodesMovedWith(const Document &document, const Selection &selection) {
    std::set<NodeRef> nodes;
    const auto add = [&](const Shape &shape, const std::set<std::uint32_t> &handles, bool all) {
        // A corner of a rectangle moves its neighbours, and the handles of round shapes each other.
        const bool whole = all || !isPath(shape);
        for (std::uint32_t k = 0; k < handleCount(shape); ++k) {
            if (whole || handles.contains(k)) {
                nodes.insert({shape.id, k});
            }
        }
    };
    for (const std::uint32_t id : selection.shapes) {
        if (const Shape *const shape = findShape(document, id)) {
            add(*shape, {}, true);
        }
    }
    for (const auto &[id, handles] : handlesToMove(document, selection)) {
        if (const Shape *const shape = findShape(document, id)) {
            add(*shape, handles, false);
        }
    }
    return nodes;
}

std::vector<Vec2> linesToNode(const Document &document, const Selection &dragged, NodeRef node) {
    const Shape *const shape = findShape(document, node.shape);
    if (shape == nullptr || !isPath(*shape) || dragged.shapes.contains(node.shape)) {
        return {};
    }
    const auto all = handlesToMove(document, dragged);
    const auto moving = all.find(node.shape);
    const Outline outline = outlineOf(*shape);
    std::vector<Vec2> starts;
    forSpokes(outline, node.node, [&](const PathSpoke &spoke) {
        const bool follows = moving == all.end() || !moving->second.contains(spoke.other);
        if (follows && !outline.isCurved(spoke.segment)) {
            starts.push_back(outline.nodes[spoke.other]);
        }
    });
    return starts;
}

} // namespace forefront
