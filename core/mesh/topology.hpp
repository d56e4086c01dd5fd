#pragma once

#include "core/base/progress.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <optional>
#include <vector>

namespace forefront {

/// neighbours[e][k] is the element across edge k of element e, or kNoElement at the boundary. Edges with more than two
/// elements keep the first two; `verify` reports them.
std::vector<std::array<ElementId, 3>> elementNeighbours(const Mesh &mesh);

/// Elements around each node in compressed rows: those of node n are elements[offsets[n] .. offsets[n+1]).
struct NodeElements {
    std::vector<std::uint32_t> offsets;
    std::vector<ElementId> elements;
};
NodeElements nodeElements(const Mesh &mesh);
/// The same; nothing when cancelled.
std::optional<NodeElements> nodeElements(const Mesh &mesh, const Progress &progress);

} // namespace forefront
