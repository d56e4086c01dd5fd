#include "core/engine/mesh/islands.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/mesh/shoreline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace forefront {

namespace {

using KeyedEdge = std::pair<std::uint64_t, std::uint32_t>; ///< its ends and its index

std::uint64_t keyOf(NodeId a, NodeId b) {
    return pairKey(std::min(a, b), std::max(a, b));
}

/// Returns the edges with one element, in the order of their ends.
std::vector<KeyedEdge> boundaryEdges(const MeshEdges &edges) {
    std::vector<KeyedEdge> found;
    for (std::uint32_t k = 0; k < edges.edges.size(); ++k) {
        if (edges.edges[k].elements[1] == kNoElement) {
            found.emplace_back(keyOf(edges.edges[k].a, edges.edges[k].b), k);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace

std::vector<MeshIsland> islandsOf(const MeshView &mesh, const MeshEdges &edges) {
    const std::vector<KeyedEdge> boundary = boundaryEdges(edges);
    std::vector<MeshIsland> islands;
    for (const ShoreStretch &stretch : shoreline(mesh, {})) {
        if (stretch.kind != ShoreStretch::Kind::Island) {
            continue;
        }
        MeshIsland island;
        double twice = 0.0, around = 0.0;
        const Vec2 origin = mesh.nodes[index(stretch.nodes.front())];
        for (std::size_t k = 0; k < stretch.nodes.size(); ++k) {
            const NodeId a = stretch.nodes[k], b = stretch.nodes[(k + 1) % stretch.nodes.size()];
            twice += cross(mesh.nodes[index(a)] - origin, mesh.nodes[index(b)] - origin);
            around += distance(mesh.nodes[index(a)], mesh.nodes[index(b)]);
            const auto at = std::lower_bound(boundary.begin(), boundary.end(), KeyedEdge{keyOf(a, b), 0});
            if (at != boundary.end() && at->first == keyOf(a, b)) {
                island.edges.push_back(at->second);
            }
        }
        island.area = 0.5 * std::fabs(twice);
        constexpr double kRounding = 1e-12;
        if (island.area > kRounding * around * around) { // else it is a closed crack
            islands.push_back(std::move(island));
        }
    }
    return islands;
}

} // namespace forefront
