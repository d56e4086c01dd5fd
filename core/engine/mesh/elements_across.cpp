#include "core/engine/mesh/elements_across.hpp"

#include "core/engine/base/rows.hpp"
#include "core/engine/mesh/wall_loops.hpp"

#include <cstdint>
#include <limits>

namespace forefront {
namespace {

/// The nearest node on a wall of each node, by number of edges.
struct Nearest {
    std::vector<NodeId> origin;
    std::vector<std::uint32_t> edges;
};

/// Finds the nearest nodes on walls by a search that starts at all of them at once.
Nearest nearestWall(const MeshView &mesh, const MeshEdges &edges, const WallLoops &loops) {
    const Rows<NodeId> neighbours(mesh.nodes.size(), [&](const auto &add) {
        for (const MeshEdge &edge : edges.edges) {
            add(index(edge.a), edge.b);
            add(index(edge.b), edge.a);
        }
    });
    Nearest nearest{std::vector<NodeId>(mesh.nodes.size(), kNoNode), std::vector<std::uint32_t>(mesh.nodes.size(), 0)};
    std::vector<NodeId> queue;
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
        if (loops.holds(NodeId{n})) {
            nearest.origin[n] = NodeId{n};
            queue.push_back(NodeId{n});
        }
    }
    for (std::size_t k = 0; k < queue.size(); ++k) {
        const std::size_t at = index(queue[k]);
        for (const NodeId neighbour : neighbours[at]) {
            const std::size_t to = index(neighbour);
            if (nearest.origin[to] == kNoNode) {
                nearest.origin[to] = nearest.origin[at];
                nearest.edges[to] = nearest.edges[at] + 1;
                queue.push_back(neighbour);
            }
        }
    }
    return nearest;
}

} // namespace

std::vector<double> elementsAcross(const MeshView &mesh, const MeshEdges &edges) {
    const WallLoops loops(mesh, edges);
    const Nearest nearest = nearestWall(mesh, edges, loops);
    std::vector<double> values(edges.edges.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < values.size(); ++k) {
        const MeshEdge &edge = edges.edges[k];
        const std::size_t a = index(edge.a), b = index(edge.b);
        const NodeId from = nearest.origin[a], to = nearest.origin[b];
        const bool inner = edge.elements[1] != kNoElement;
        if (inner && from != kNoNode && to != kNoNode && from != to && loops.facing(from, to)) {
            values[k] = static_cast<double>(nearest.edges[a] + nearest.edges[b] + 1);
        }
    }
    return values;
}

} // namespace forefront
