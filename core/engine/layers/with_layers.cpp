#include "core/engine/layers/boundary_layers.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Gives a mesh the tagged edges and points of a boundary.
void retag(Mesh &mesh, const DiscreteDomain &boundary) {
    mesh.edges.clear();
    mesh.edgeStretches.clear();
    mesh.points.clear();
    for (std::size_t i = 0; i < boundary.segments.size(); ++i) {
        const DiscreteSegment &s = boundary.segments[i];
        // The domain lies to the left of a boundary edge.
        const bool reversed = s.leftRegion == kOutside;
        mesh.edges.push_back({NodeId{reversed ? s.b : s.a}, NodeId{reversed ? s.a : s.b}, s.tag});
        if (!boundary.stretches.empty()) {
            mesh.edgeStretches.push_back(reversed ? boundary.stretches[i].reversed() : boundary.stretches[i]);
        }
    }
    for (const ConstraintPoint &point : boundary.taggedPoints()) {
        mesh.points.push_back({NodeId{point.node}, point.tag});
    }
}

/// Drops the nodes that nothing uses: those that would have led the front to its size where the layers are now.
void dropUnusedNodes(Mesh &mesh) {
    std::vector<std::uint8_t> used(mesh.nodes.size(), 0);
    for (const CellBlock &block : mesh.blocks) {
        for (const NodeId node : block.connectivity()) {
            used[index(node)] = 1;
        }
    }
    for (const TaggedNode &point : mesh.points) {
        used[index(point.node)] = 1;
    }
    std::vector<NodeId> numbers(mesh.nodes.size(), kNoNode);
    std::uint32_t count = 0;
    for (std::size_t n = 0; n < used.size(); ++n) {
        if (used[n] != 0) {
            mesh.nodes[count] = mesh.nodes[n];
            numbers[n] = NodeId{count++};
        }
    }
    mesh.nodes.resize(count);
    for (CellBlock &block : mesh.blocks) {
        for (NodeId &node : block.connectivity()) {
            node = numbers[index(node)];
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.a = numbers[index(edge.a)];
        edge.b = numbers[index(edge.b)];
    }
    for (TaggedNode &point : mesh.points) {
        point.node = numbers[index(point.node)];
    }
}

} // namespace

Mesh withLayers(Mesh mesh, const BoundaryLayers &layers, const DiscreteDomain &boundary) {
    const auto outer = static_cast<std::uint32_t>(layers.outer->nodes.size());
    const auto shift = static_cast<std::uint32_t>(mesh.nodes.size()) - outer;
    mesh.nodes.insert(mesh.nodes.end(), layers.inner.begin(), layers.inner.end());
    for (const CellKind kind : {CellKind::Triangle3, CellKind::Quadrilateral4}) {
        const std::size_t corners = traitsOf(kind).corners;
        for (const LayerCell &cell : layers.cells) {
            if ((cell.nodes[3] == kNoIndex) != (corners == 3)) {
                continue;
            }
            std::array<NodeId, 4> nodes{};
            for (std::size_t k = 0; k < corners; ++k) {
                nodes[k] = NodeId{cell.nodes[k] < outer ? cell.nodes[k] : cell.nodes[k] + shift};
            }
            CellBlock &block = mesh.block(kind);
            block.add(std::span(nodes).first(corners));
            block.regions.push_back(boundary.regions.empty() ? 1 : boundary.regions[cell.region].tag);
        }
    }
    retag(mesh, boundary);
    if (boundary.gradedNodes > 0) {
        dropUnusedNodes(mesh);
    }
    return mesh;
}

} // namespace forefront
