#include "core/drawing/shapes/node_sizes.hpp"

#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace forefront {

bool canHaveSize(const Shape &shape, std::uint32_t handle) {
    return handle < handleCount(shape) && !isCentre(shape, handle) && !shape.is<SlotForm>();
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
            return shape.is<SlotForm>()
                       ? error("no-such-node", "the handles of " + displayName(shape) + " cannot have an element size",
                               "convert it to a path, or give its boundary part a size")
                   : isCentre(shape, node.node)
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

namespace {

/// See giveSize(); `handles` are those of the shape.
bool giveSizeAt(Shape &shape, const std::vector<Vec2> &handles, Vec2 at, const PartSize &size, double reach) {
    bool given = false;
    for (std::uint32_t k = 0; k < handles.size(); ++k) {
        if (distance(handles[k], at) <= reach && canHaveSize(shape, k)) {
            PartSize &present = shape.nodeSizes.emplace(k, size).first->second;
            present = size.size < present.size ? size : present;
            given = true;
        }
    }
    return given;
}

/// Returns the distance within which two places are the same, for nodes of a shape.
double roundingOf(const Shape &shape) {
    constexpr double kRounding = 1e-9; // relative to the size of the shape
    return kRounding * boundsOf(shape).diagonal();
}

} // namespace

bool giveSize(Shape &shape, Vec2 at, const PartSize &size, double reach) {
    return giveSizeAt(shape, handlesOf(shape), at, size, reach);
}

void takeNodeSizes(Shape &shape, const Shape &from) {
    if (from.nodeSizes.empty()) {
        return;
    }
    const std::vector<Vec2> handles = handlesOf(shape), places = handlesOf(from);
    const double reach = roundingOf(from);
    for (const auto &[node, size] : from.nodeSizes) {
        if (node < places.size()) {
            giveSizeAt(shape, handles, places[node], size, reach);
        }
    }
}

void keepNodeSizes(Shape &shape, const Shape &before) {
    shape.nodeSizes.clear();
    takeNodeSizes(shape, before);
}

void moveNodeSizes(Shape &shape, const Shape &before) {
    shape.nodeSizes.clear();
    if (before.nodeSizes.empty()) {
        return;
    }
    const std::vector<Vec2> handles = handlesOf(shape), places = handlesOf(before);
    const double rounding = roundingOf(before);
    for (const auto &[node, size] : before.nodeSizes) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t k = 0; k < handles.size() && node < places.size(); ++k) {
            nearest = canHaveSize(shape, k) ? std::min(nearest, distance(handles[k], places[node])) : nearest;
        }
        if (std::isfinite(nearest)) {
            giveSizeAt(shape, handles, places[node], size, nearest + rounding);
        }
    }
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
