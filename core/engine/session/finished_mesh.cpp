#include "core/engine/session/finished_mesh.hpp"

#include <limits>
#include <utility>

namespace forefront {

void FinishedMesh::fill(SessionSnapshot &snapshot) const {
    snapshot.mesh = view;
    snapshot.boundary = boundary;
    snapshot.quality = quality;
    snapshot.order = order;
    snapshot.leastAngle = leastAngle;
}

FinishedMesh takeFinished(MeshingState &state, std::uint64_t number) {
    FinishedMesh finished;
    finished.quality = measureQuality(state.mesh, state.prepared.spacing.get());
    finished.hash = meshHash(state.mesh);
    finished.boundary = state.prepared.boundary;
    if (state.job.options.order == ElementOrder::Second) {
        finished.order = std::make_shared<const SecondOrderReport>(std::move(state.secondOrder));
    }
    if (state.job.options.leastAngle) {
        finished.leastAngle = std::make_shared<const LeastAngleReport>(std::move(state.leastAngle));
    }
    std::shared_ptr<MeshSnapshot> view = snapshotOf(std::move(state.mesh));
    view->version = std::numeric_limits<std::uint64_t>::max() - number;
    finished.view = std::move(view);
    return finished;
}

} // namespace forefront
