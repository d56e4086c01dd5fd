#include "core/engine/mesh/topology.hpp"

#include "core/engine/base/paced_progress.hpp"

namespace forefront {

std::vector<HalfEdge> oppositeHalfEdges(const EdgeTable &table) {
    std::vector<HalfEdge> opposite(table.halfEdges().count(), kNoHalfEdge);
    table.forEach([&opposite](NodeId, NodeId, std::span<const HalfEdge> sides) {
        if (sides.size() >= 2) {
            opposite[sides[0]] = sides[1];
            opposite[sides[1]] = sides[0];
        }
    });
    return opposite;
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
