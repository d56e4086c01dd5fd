#include "core/files/common/edge_chains.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

/// Walks along the edges of a list, each once.
class EdgeWalk {
  public:
    EdgeWalk(const MeshView &mesh, std::span<const std::uint32_t> edges)
        : mesh_(mesh), edges_(edges), used_(edges.size(), 0) {
        for (std::uint32_t k = 0; k < edges.size(); ++k) {
            ends_.emplace_back(edge(k).a, k);
            ends_.emplace_back(edge(k).b, k);
        }
        std::sort(ends_.begin(), ends_.end());
    }

    std::vector<EdgeChain> chains() {
        std::vector<EdgeChain> chains;
        for (std::uint32_t k = 0; k < edges_.size(); ++k) {
            if (used_[k] == 0) {
                chains.push_back(chainOf(k));
            }
        }
        return chains;
    }

  private:
    const TaggedEdge &edge(std::uint32_t k) const { return mesh_.edges[edges_[k]]; }

    /// Returns the edges that end at a node.
    std::span<const std::pair<NodeId, std::uint32_t>> edgesAt(NodeId node) const {
        const auto [begin, end] = std::equal_range(ends_.begin(), ends_.end(), std::pair(node, 0U),
                                                   [](const auto &a, const auto &b) { return a.first < b.first; });
        return {begin, end};
    }

    /// Appends edges to a chain from its last node on, until it ends or closes.
    void extend(std::vector<NodeId> &nodes) {
        while (nodes.front() != nodes.back()) {
            const auto here = edgesAt(nodes.back());
            const auto next =
                std::find_if(here.begin(), here.end(), [&](const auto &end) { return used_[end.second] == 0; });
            if (here.size() != 2 || next == here.end()) {
                return;
            }
            const TaggedEdge &found = edge(next->second);
            used_[next->second] = 1;
            if (found.middle != kNoNode) {
                nodes.push_back(found.middle);
            }
            nodes.push_back(found.a == next->first ? found.b : found.a);
        }
    }

    EdgeChain chainOf(std::uint32_t k) {
        used_[k] = 1;
        std::vector<NodeId> ahead = {edge(k).a};
        if (edge(k).middle != kNoNode) {
            ahead.push_back(edge(k).middle);
        }
        ahead.push_back(edge(k).b);
        extend(ahead);
        if (ahead.front() == ahead.back()) {
            return {std::move(ahead)};
        }
        std::reverse(ahead.begin(), ahead.end());
        extend(ahead);
        std::reverse(ahead.begin(), ahead.end());
        return {std::move(ahead)};
    }

    const MeshView &mesh_;
    std::span<const std::uint32_t> edges_;
    std::vector<std::uint8_t> used_;                     ///< per edge of the list
    std::vector<std::pair<NodeId, std::uint32_t>> ends_; ///< ends of the edges, by node
};

} // namespace

std::vector<EdgeChain> joinEdges(const MeshView &mesh, std::span<const std::uint32_t> edges) {
    return EdgeWalk(mesh, edges).chains();
}

} // namespace forefront
