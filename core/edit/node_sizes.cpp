#include "core/edit/node_sizes.hpp"

#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"
#include "core/spacing/spec/spec_check.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace forefront {

bool canHaveSize(const Shape &shape, std::uint32_t handle) {
    return handle < handleCount(shape) && !(isRound(shape) && handle == 0);
}

namespace {

/// Calls change(sizes, node) for each node, with the sizes of its shape.
template <class Change>
Result<Document> changeEach(const Document &document, const std::set<NodeRef> &nodes, const Change &change) {
    std::vector<Shape> shapes;
    for (const NodeRef &node : nodes) {
        if (shapes.empty() || shapes.back().id != node.shape) {
            const Shape *const shape = findShape(document, node.shape);
            if (shape == nullptr) {
                return error("no-such-shape", "shape not found");
            }
            shapes.push_back(*shape);
        }
        Shape &shape = shapes.back();
        if (!canHaveSize(shape, node.node)) {
            return isRound(shape) && node.node == 0
                       ? error("no-such-node", "the centre of " + displayName(shape) + " cannot have an element size",
                               "select a node on its outline")
                       : error("no-such-node", "node not found");
        }
        change(shape.nodeSizes, node.node);
    }
    return replaceShapes(document, std::move(shapes));
}

} // namespace

Result<Document> setNodeSize(const Document &document, const std::set<NodeRef> &nodes, std::optional<PartSize> size) {
    return changeEach(document, nodes, [&](std::map<std::uint32_t, PartSize> &sizes, std::uint32_t node) {
        if (size) {
            sizes[node] = *size;
        } else {
            sizes.erase(node);
        }
    });
}

Result<Document> changeNodeSizes(const Document &document, const std::set<NodeRef> &nodes,
                                 const NodeSizeChange &change) {
    return changeEach(document, nodes, [&](std::map<std::uint32_t, PartSize> &sizes, std::uint32_t node) {
        if (change.size) {
            sizes[node].size = *change.size;
        }
        if (const auto found = sizes.find(node); change.growth && found != sizes.end()) {
            found->second.growth = *change.growth;
        }
    });
}

void takeNodeSizes(Shape &shape, const Shape &from) {
    constexpr double kRounding = 1e-9; // of the size of the shape
    if (from.nodeSizes.empty()) {
        return;
    }
    const std::vector<Vec2> handles = handlesOf(shape), places = handlesOf(from);
    const double reach = kRounding * boundsOf(from).diagonal();
    for (const auto &[node, size] : from.nodeSizes) {
        for (std::uint32_t k = 0; k < handles.size() && node < places.size(); ++k) {
            if (distance(handles[k], places[node]) <= reach && canHaveSize(shape, k)) {
                shape.nodeSizes.emplace(k, size);
            }
        }
    }
}

void keepNodeSizes(Shape &shape, const Shape &before) {
    shape.nodeSizes.clear();
    takeNodeSizes(shape, before);
}

void placeBox(Shape &rectangle, Vec2 low, Vec2 high) {
    const Vec2 a = rectangle.nodes[0], c = rectangle.nodes[1];
    const bool fromRight = a.x > c.x, fromTop = a.y > c.y;
    std::map<std::uint32_t, PartSize> sizes;
    for (const auto &[corner, size] : rectangle.nodeSizes) {
        const bool right = (corner == 1 || corner == 2) != fromRight, top = (corner >= 2) != fromTop;
        sizes[top ? (right ? 2U : 3U) : (right ? 1U : 0U)] = size;
    }
    rectangle.nodeSizes = std::move(sizes);
    rectangle.nodes = {low, high};
}

Diagnostics checkNodeSizes(const Shape &shape) {
    for (const auto &[node, part] : shape.nodeSizes) {
        if (auto fault = partSizeFault(part, nodeName(shape, node), "bad-size")) {
            return {*std::move(fault)};
        }
    }
    return {};
}

std::string nodeName(const Shape &shape, std::uint32_t handle) {
    return "node " + std::to_string(handle + 1) + " of " + displayName(shape);
}

} // namespace forefront
