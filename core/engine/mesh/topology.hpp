#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <optional>
#include <vector>

namespace forefront {

/// Returns for each side of each element the side across it, of another element, or kNoHalfEdge at the boundary. Edges
/// with more than two elements keep the first two; `verify` reports them.
std::vector<HalfEdge> oppositeHalfEdges(const EdgeTable &table);

/// The elements around each node in compressed rows: for node n, elements[offsets[n] .. offsets[n+1]).
struct NodeElements {
    std::vector<std::uint32_t> offsets;
    std::vector<ElementId> elements;
};
/// Returns the elements around each node.
NodeElements nodeElements(const TriMesh &mesh);
/// Returns the elements around each node, or std::nullopt when cancelled.
std::optional<NodeElements> nodeElements(const TriMesh &mesh, const Progress &progress);

} // namespace forefront
