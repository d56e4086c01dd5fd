#include "core/engine/mesh/tri_mesh.hpp"

namespace forefront {

Box2 TriMesh::bounds() const {
    Box2 box;
    for (const Vec2 p : nodes) {
        box.add(p);
    }
    return box;
}

} // namespace forefront
