#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Status periodicStage(MeshingState &state, const Progress &) {
    state.mesh.periodic = state.prepared.boundary->periodic;
    if (state.mesh.periodic.empty()) {
        return {};
    }
    if (Status faults = verifyPeriodic(state.mesh); !faults.empty()) {
        return faults;
    }
    alignMiddleNodes(state.mesh);
    return {};
}

} // namespace forefront
