#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/stages.hpp"

namespace forefront {

Status validateStage(MeshingState &state, const Progress &progress) {
    progress("validating", 0.0);
    return validate(state.job.domain, kMaxListedFaults, &state.faces);
}

} // namespace forefront
