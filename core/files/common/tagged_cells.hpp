#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace forefront {

/// Returns the kind of a tagged edge: the one of 3 nodes if it has a middle node.
inline CellKind cellKindOf(const TaggedEdge &edge) {
    return edge.middle == kNoNode ? CellKind::Edge2 : CellKind::Edge3;
}

/// The nodes of a tagged edge: its ends, then its middle node if it has one.
class EdgeNodes {
  public:
    explicit EdgeNodes(const TaggedEdge &edge)
        : nodes_{edge.a, edge.b, edge.middle}, count_(traitsOf(cellKindOf(edge)).nodes) {}

    std::size_t size() const { return count_; }
    const NodeId *begin() const { return nodes_.data(); }
    const NodeId *end() const { return nodes_.data() + count_; }

  private:
    std::array<NodeId, 3> nodes_;
    std::size_t count_;
};

/// Indices of elements, edges or points by region or tag, ascending.
using PartsByTag = std::map<std::int32_t, std::vector<std::uint32_t>>;

PartsByTag elementsByRegion(const MeshView &mesh);
PartsByTag edgesByTag(const MeshView &mesh);
PartsByTag pointsByTag(const MeshView &mesh);

/// Returns the number of nodes of all elements, or of all tagged edges; nodes of several count several times.
std::size_t nodesOfElements(const MeshView &mesh);
std::size_t nodesOfEdges(const MeshView &mesh);

/// Returns the title of a mesh in files that begin with one.
const char *titleOf(const MeshView &mesh);

} // namespace forefront
