#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Status improveStage(MeshingState &state, const Progress &progress) {
    const MeshingOptions &options = state.job.options;
    progress("improving", 0.0);
    state.improvement =
        improve(state.triangles,
                {options.improve, state.job.usableThreads(), state.prepared.spacing.get(), state.watch}, progress);
    return {};
}

} // namespace forefront
