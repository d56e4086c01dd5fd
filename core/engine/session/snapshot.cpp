#include "core/engine/session/snapshot.hpp"

#include <utility>

namespace forefront {

std::shared_ptr<MeshSnapshot> snapshotOf(Mesh mesh) {
    auto snapshot = std::make_shared<MeshSnapshot>();
    if (mesh.isTriangular()) {
        snapshot->mesh = takeTriMesh(std::move(mesh));
    } else {
        snapshot->whole = std::make_shared<const Mesh>(std::move(mesh));
        static_cast<Triangulated &>(*snapshot) = triangulated(*snapshot->whole);
    }
    snapshot->alpha = shapeFactors(snapshot->view());
    return snapshot;
}

} // namespace forefront
