#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Edges that follow each other, as their nodes in order, middle nodes included. In a closed chain, the first node
/// comes again at the end.
struct EdgeChain {
    std::vector<NodeId> nodes;
    bool closed() const { return nodes.front() == nodes.back(); }
};

/// Joins edges of a mesh into chains, each edge in one of them. Chains end where more or less than two of the edges
/// meet. Each runs in the direction of its edge that comes first in the list. `edges`: indices into MeshView::edges.
std::vector<EdgeChain> joinEdges(const MeshView &mesh, std::span<const std::uint32_t> edges);

} // namespace forefront
