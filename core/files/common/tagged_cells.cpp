#include "core/files/common/tagged_cells.hpp"

#include <algorithm>

namespace forefront {

PartsByTag elementsByRegion(const MeshView &mesh) {
    PartsByTag regions;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            regions[block.region(k)].push_back(static_cast<std::uint32_t>(block.first + k));
        }
    }
    return regions;
}

PartsByTag edgesByTag(const MeshView &mesh) {
    PartsByTag boundaries;
    for (std::uint32_t k = 0; k < mesh.edges.size(); ++k) {
        boundaries[mesh.edges[k].tag].push_back(k);
    }
    return boundaries;
}

PartsByTag pointsByTag(const MeshView &mesh) {
    PartsByTag points;
    for (std::uint32_t k = 0; k < mesh.points.size(); ++k) {
        points[mesh.points[k].tag].push_back(k);
    }
    return points;
}

std::size_t nodesOfElements(const MeshView &mesh) {
    std::size_t count = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        count += block.connectivity.size();
    }
    return count;
}

std::size_t nodesOfEdges(const MeshView &mesh) {
    std::size_t count = 0;
    for (const TaggedEdge &edge : mesh.edges) {
        count += EdgeNodes(edge).size();
    }
    return count;
}

const char *titleOf(const MeshView &mesh) {
    const auto isTriangles = [](const MeshView::Block &block) { return block.traits().corners == 3; };
    return std::all_of(mesh.blocks().begin(), mesh.blocks().end(), isTriangles) ? "Plane triangle mesh" : "Plane mesh";
}

} // namespace forefront
