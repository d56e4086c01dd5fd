#include "core/engine/mesh/orientation.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

bool isClockwise(const TriMesh &mesh) {
    return !mesh.elements.empty() && std::all_of(mesh.elements.begin(), mesh.elements.end(), [&](const Element &n) {
        return orientation(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])]) < 0;
    });
}

TriMesh turned(TriMesh mesh) {
    for (Element &element : mesh.elements) {
        std::swap(element[1], element[2]);
    }
    return mesh;
}

} // namespace forefront
