#include "core/engine/pipeline/layer_plan.hpp"

#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Result<LayerRows> planLayerRows(const MeshingJob &job, const Progress &progress) {
    if (job.layers.empty()) {
        return LayerRows();
    }
    MeshingState state{.job = job};
    if (Status faults = runStages(stagesBeforeLayers(), state, progress); !faults.empty()) {
        return faults;
    }
    return rowsOfLayers(state, progress);
}

} // namespace forefront
