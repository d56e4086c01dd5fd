#include "core/engine/mesh/topology.hpp"

#include "core/engine/base/paced_progress.hpp"
#include "core/engine/mesh/edge_table.hpp"

namespace forefront {

std::vector<std::array<ElementId, 3>> elementNeighbours(const TriMesh &mesh) {
    std::vector<std::array<ElementId, 3>> neighbours(mesh.elements.size(), {kNoElement, kNoElement, kNoElement});
    EdgeTable(mesh).forEach([&neighbours](NodeId, NodeId, std::span<const HalfEdge> sides) {
        if (sides.size() >= 2) {
            const HalfEdge h = sides[0], g = sides[1];
            neighbours[elementOf(h)][sideOf(h)] = ElementId{static_cast<std::uint32_t>(elementOf(g))};
            neighbours[elementOf(g)][sideOf(g)] = ElementId{static_cast<std::uint32_t>(elementOf(h))};
        }
    });
    return neighbours;
}

NodeElements nodeElements(const TriMesh &mesh) {
    return *nodeElements(mesh, Progress{});
}

std::optional<NodeElements> nodeElements(const TriMesh &mesh, const Progress &progress) {
    NodeElements rows;
    PacedProgress pace(progress, "finding the elements around nodes", 2 * mesh.elements.size());
    rows.offsets.assign(mesh.nodes.size() + 1, 0);
    rows.elements.resize(3 * mesh.elements.size());
    for (const Element &element : mesh.elements) {
        if (!pace.next()) {
            return std::nullopt;
        }
        for (const NodeId node : element) {
            ++rows.offsets[index(node)];
        }
    }
    std::uint32_t sum = 0;
    for (std::uint32_t &offset : rows.offsets) {
        sum += offset;
        offset = sum;
    }
    for (std::size_t e = mesh.elements.size(); e-- > 0;) {
        if (!pace.next()) {
            return std::nullopt;
        }
        for (const NodeId node : mesh.elements[e]) {
            rows.elements[--rows.offsets[index(node)]] = ElementId{static_cast<std::uint32_t>(e)};
        }
    }
    return rows;
}

} // namespace forefront
