#include "core/engine/mesh/half_edges.hpp"

namespace forefront {

HalfEdgeNumbers::HalfEdgeNumbers(const MeshView &mesh) {
    HalfEdge begin = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        const CellTraits &traits = block.traits();
        Row &row = rows_.emplace_back();
        row.begin = begin;
        row.end = begin += static_cast<HalfEdge>(traits.corners * block.size());
        row.firstElement = static_cast<std::uint32_t>(block.first);
        row.endElement = static_cast<std::uint32_t>(block.first + block.size());
        row.corners = traits.corners;
        row.nodes = traits.nodes;
        row.second = traits.order == 2;
    }
}

HalfEdges::HalfEdges(const MeshView &mesh) : HalfEdgeNumbers(mesh) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        rows_[k].connectivity = mesh.blocks()[k].connectivity.data();
    }
    if (rows_.size() == 1 && mesh.blocks().front().kind == CellKind::Triangle3) {
        triangles_ = rows_.front().connectivity;
    }
}

} // namespace forefront
