#include "core/files/inner_edges.hpp"

#include "core/files/common/tagged_sides.hpp"

namespace forefront {

namespace {

template <class AnyMesh>
AnyMesh outlineOf(const AnyMesh &mesh) {
    AnyMesh result = mesh;
    const TaggedSides sides(mesh);
    std::size_t kept = 0;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        if (sides.of(e).size() <= 1) {
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

} // namespace

bool hasInnerEdges(const MeshView &mesh) {
    const TaggedSides sides(mesh);
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        if (sides.of(e).size() > 1) {
            return true;
        }
    }
    return false;
}

TriMesh withoutInnerEdges(const TriMesh &mesh) {
    return outlineOf(mesh);
}

Mesh withoutInnerEdges(const Mesh &mesh) {
    return outlineOf(mesh);
}

} // namespace forefront
