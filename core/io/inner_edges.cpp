#include "core/io/inner_edges.hpp"

#include "core/mesh/edge_table.hpp"

#include <vector>

namespace forefront {

Mesh withoutInnerEdges(const Mesh &mesh) {
    Mesh result = mesh;
    const EdgeTable table(mesh);
    std::erase_if(result.edges, [&](const TaggedEdge &edge) { return table.find(edge.a, edge.b).size() > 1; });
    return result;
}

} // namespace forefront
