#include "core/engine/mesh/mesh_access.hpp"

#include "core/engine/mesh/edge_table.hpp"

#include <type_traits>

namespace forefront {

// The arrays are passed on as they are, so their items must be nothing but numbers.
static_assert(sizeof(Vec2) == 2 * sizeof(double) && std::is_standard_layout_v<Vec2>);
static_assert(sizeof(Element) == 3 * sizeof(std::uint32_t));
static_assert(std::is_same_v<std::underlying_type_t<NodeId>, std::uint32_t>);

std::span<const double> coordinates(const MeshView &mesh) {
    return {reinterpret_cast<const double *>(mesh.nodes.data()), 2 * mesh.nodes.size()};
}

std::span<const std::uint32_t> connectivity(const TriMesh &mesh) {
    return {reinterpret_cast<const std::uint32_t *>(mesh.elements.data()), 3 * mesh.elements.size()};
}

std::vector<std::uint32_t> edgesWithTag(const MeshView &mesh, std::int32_t tag) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        if (mesh.edges[e].tag == tag) {
            found.push_back(e);
        }
    }
    return found;
}

std::vector<EdgeSides> edgeSides(const MeshView &mesh) {
    const EdgeTable table(mesh);
    const HalfEdges &halfEdges = table.halfEdges();
    std::vector<EdgeSides> sides(mesh.edges.size());
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const TaggedEdge &edge = mesh.edges[e];
        for (const HalfEdge h : table.find(edge.a, edge.b)) {
            const bool left = halfEdges.startOf(h) == edge.a; // elements are counter-clockwise
            const std::size_t element = halfEdges.elementOf(h);
            (left ? sides[e].left : sides[e].right) = ElementId{static_cast<std::uint32_t>(element)};
            (left ? sides[e].leftRegion : sides[e].rightRegion) = mesh.region(element);
        }
    }
    return sides;
}

} // namespace forefront
