#include "core/files/inner_edges.hpp"

#include "core/engine/mesh/edge_table.hpp"

#include <algorithm>
#include <vector>

namespace forefront {

bool hasInnerEdges(const TriMesh &mesh) {
    if (mesh.edges.empty()) {
        return false;
    }
    const EdgeTable table(mesh);
    return std::any_of(mesh.edges.begin(), mesh.edges.end(),
                       [&](const TaggedEdge &edge) { return table.find(edge.a, edge.b).size() > 1; });
}

TriMesh withoutInnerEdges(const TriMesh &mesh) {
    TriMesh result = mesh;
    const EdgeTable table(mesh);
    std::size_t kept = 0;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        if (table.find(mesh.edges[e].a, mesh.edges[e].b).size() <= 1) {
            result.edges[kept] = mesh.edges[e];
            if (!mesh.edgeStretches.empty()) {
                result.edgeStretches[kept] = mesh.edgeStretches[e];
            }
            ++kept;
        }
    }
    result.edges.resize(kept);
    result.edgeStretches.resize(mesh.edgeStretches.empty() ? 0 : kept);
    return result;
}

} // namespace forefront
