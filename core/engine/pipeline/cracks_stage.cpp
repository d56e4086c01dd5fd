#include "core/engine/mesh/cracks.hpp"
#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Status cracksStage(MeshingState &state, const Progress &progress) {
    if (state.job.cracks.empty()) {
        return {};
    }
    Result<CrackReport> report = openCracks(state.mesh, state.job.cracks, progress);
    if (!report) {
        return report.faults();
    }
    state.cracks = std::move(*report);
    return {};
}

} // namespace forefront
