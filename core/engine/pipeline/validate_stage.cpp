#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/refine/least_angle.hpp"

namespace forefront {

namespace {

Status validateLeastAngle(const MeshingOptions &options) {
    if (!options.leastAngle) {
        return {};
    }
    if (options.elements != Elements::Triangles) {
        return error("least-angle", "a least angle can be asked for triangles only",
                     "leave out the least angle, or choose triangles");
    }
    if (!(*options.leastAngle > 0.0 && *options.leastAngle <= kMaxLeastAngle)) {
        return error("least-angle", "the least angle is " + numberText(*options.leastAngle, 6) +
                                        "°; expected above 0 and at most " + numberText(kMaxLeastAngle, 6));
    }
    return {};
}

} // namespace

Status validateStage(MeshingState &state, const Progress &progress) {
    progress("validating", 0.0);
    if (Status faults = validateLeastAngle(state.job.options); !faults.empty()) {
        return faults;
    }
    return validate(state.job.domain, kMaxListedFaults, &state.faces);
}

} // namespace forefront
