#include "core/mesh/elements_across.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace forefront {

namespace {

/// The loops of boundary edges, and the distance of each node along its loop.
class BoundaryLoops {
  public:
    BoundaryLoops(const Mesh &mesh, const MeshEdges &edges)
        : mesh_(mesh), next_(mesh.nodes.size(), {kNoNode, kNoNode}), loop_(mesh.nodes.size(), kNoIndex),
          along_(mesh.nodes.size(), 0.0) {
        for (const MeshEdge &edge : edges.edges) {
            if (edge.elements[1] == kNoElement) {
                link(edge.a, edge.b);
                link(edge.b, edge.a);
            }
        }
        for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
            if (next_[n][0] != kNoNode && loop_[n] == kNoIndex) {
                follow(NodeId{n});
            }
        }
    }

    bool holds(NodeId node) const { return loop_[index(node)] != kNoIndex; }

    /// Returns true if two boundary nodes are far apart along the boundary compared with their straight distance.
    bool facing(NodeId a, NodeId b) const {
        const std::uint32_t loop = loop_[index(a)];
        if (loop != loop_[index(b)]) {
            return true;
        }
        constexpr double kDetour = 4.0;
        const double apart = std::abs(along_[index(a)] - along_[index(b)]);
        const double shorter = std::min(apart, lengths_[loop] - apart);
        return shorter > kDetour * distance(mesh_.nodes[index(a)], mesh_.nodes[index(b)]);
    }

  private:
    /// Records one of the two neighbours of a node. Where loops touch, a node has more; the last one recorded counts.
    void link(NodeId from, NodeId to) {
        auto &pair = next_[index(from)];
        (pair[0] == kNoNode ? pair[0] : pair[1]) = to;
    }

    void follow(NodeId start) {
        const auto loop = static_cast<std::uint32_t>(lengths_.size());
        double length = 0.0;
        NodeId before = kNoNode, at = start;
        while (true) {
            loop_[index(at)] = loop;
            along_[index(at)] = length;
            const auto &pair = next_[index(at)];
            const NodeId to = pair[0] != before ? pair[0] : pair[1];
            if (to == kNoNode) {
                break;
            }
            length += distance(mesh_.nodes[index(at)], mesh_.nodes[index(to)]);
            if (loop_[index(to)] != kNoIndex) {
                break; // closed, or touching another loop
            }
            before = at;
            at = to;
        }
        lengths_.push_back(length);
    }

    const Mesh &mesh_;
    std::vector<std::array<NodeId, 2>> next_;
    std::vector<std::uint32_t> loop_;
    std::vector<double> along_;
    std::vector<double> lengths_; ///< of the loops
};

/// The nearest boundary node of each node, by number of edges.
struct Nearest {
    std::vector<NodeId> origin;
    std::vector<std::uint32_t> edges;
};

/// Finds the nearest boundary nodes by a search that starts at all boundary nodes at once.
Nearest nearestBoundary(const Mesh &mesh, const MeshEdges &edges, const BoundaryLoops &loops) {
    std::vector<std::uint32_t> offsets(mesh.nodes.size() + 1, 0);
    for (const MeshEdge &edge : edges.edges) {
        ++offsets[index(edge.a) + 1];
        ++offsets[index(edge.b) + 1];
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        offsets[n + 1] += offsets[n];
    }
    std::vector<NodeId> neighbours(offsets.back());
    std::vector<std::uint32_t> fill(offsets.begin(), offsets.end() - 1);
    for (const MeshEdge &edge : edges.edges) {
        neighbours[fill[index(edge.a)]++] = edge.b;
        neighbours[fill[index(edge.b)]++] = edge.a;
    }
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
        for (std::uint32_t i = offsets[at]; i < offsets[at + 1]; ++i) {
            const std::size_t to = index(neighbours[i]);
            if (nearest.origin[to] == kNoNode) {
                nearest.origin[to] = nearest.origin[at];
                nearest.edges[to] = nearest.edges[at] + 1;
                queue.push_back(neighbours[i]);
            }
        }
    }
    return nearest;
}

} // namespace

std::vector<double> elementsAcross(const Mesh &mesh, const MeshEdges &edges) {
    const BoundaryLoops loops(mesh, edges);
    const Nearest nearest = nearestBoundary(mesh, edges, loops);
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
