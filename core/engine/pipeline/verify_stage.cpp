#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Status verifyStage(MeshingState &state, const Progress &progress) {
    progress("checking the mesh", 0.0);
    Diagnostics faults = verifyAgainst(state.mesh, state.meshed().domain, state.meshed().spacing.placed.counts(),
                                       kMaxListedFaults, {}, true, state.job.cracks);
    if (!hasErrors(faults)) {
        return {}; // a check of the file prints the notes
    }
    for (Diagnostic &fault : faults) {
        fault.message = "the finished mesh is wrong: " + fault.message;
    }
    return faults;
}

} // namespace forefront
