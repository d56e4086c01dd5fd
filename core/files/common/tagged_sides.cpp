#include "core/files/common/tagged_sides.hpp"

#include "core/engine/base/key_order.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

/// Few sides of elements have both ends on tagged edges, and only those are looked up.
TaggedSides::TaggedSides(const MeshView &mesh) : offsets_(mesh.edges.size() + 1, 0) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys; // of both ends, with the edge
    std::vector<std::uint8_t> onEdge(mesh.nodes.size(), 0);
    keys.reserve(mesh.edges.size());
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        const auto [a, b] = std::minmax(mesh.edges[e].a, mesh.edges[e].b);
        keys.emplace_back(pairKey(a, b), e);
        onEdge[index(a)] = onEdge[index(b)] = 1;
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::pair<std::uint32_t, ElementSide>> found;
    for (const MeshView::Block &block : mesh.blocks()) {
        const std::uint32_t corners = block.traits().corners;
        for (std::size_t k = 0; k < block.size(); ++k) {
            const std::span<const NodeId> nodes = block.nodesOf(k);
            for (std::uint32_t side = 0; side < corners; ++side) {
                const NodeId a = nodes[side], b = nodes[(side + 1) % corners];
                if (onEdge[index(a)] == 0 || onEdge[index(b)] == 0) {
                    continue;
                }
                const std::uint64_t key = pairKey(std::min(a, b), std::max(a, b));
                auto at = std::lower_bound(keys.begin(), keys.end(), std::pair(key, std::uint32_t{0}));
                for (; at != keys.end() && at->first == key; ++at) {
                    const auto element = static_cast<std::uint32_t>(block.first + k);
                    found.emplace_back(at->second, ElementSide{element, side, a == mesh.edges[at->second].a});
                    ++offsets_[at->second + std::size_t{1}];
                }
            }
        }
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        offsets_[e + 1] += offsets_[e];
    }
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    sides_.resize(found.size());
    for (const auto &[edge, side] : found) {
        sides_[next[edge]++] = side;
    }
}

} // namespace forefront
