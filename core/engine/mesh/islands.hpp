#pragma once

#include "core/engine/mesh/measures.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// A hole of a mesh; to models of water, an island.
struct MeshIsland {
    double area = 0.0;
    std::vector<std::uint32_t> edges; ///< around it, indices into the edges of the mesh
};

/// Returns the islands of a mesh: the loops of its boundary that lie inside another.
std::vector<MeshIsland> islandsOf(const MeshView &mesh, const MeshEdges &edges);

} // namespace forefront
