#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Status validateStage(MeshingState &state, const Progress &progress) {
    progress("validating", 0.0);
    Diagnostics faults = validate(state.job.domain, kMaxListedFaults, &state.faces);
    if (!hasErrors(faults)) {
        Diagnostics ofLayers = checkLayers(state.job.layers, state.job.domain);
        faults.insert(faults.end(), ofLayers.begin(), ofLayers.end());
    }
    return faults;
}

} // namespace forefront
