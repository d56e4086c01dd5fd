#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/crack_lines.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/refine/least_angle.hpp"

#include <utility>

namespace forefront {

namespace {

Status validateLeastAngle(const MeshingJob &job) {
    const MeshingOptions &options = job.options;
    if (!options.leastAngle) {
        return {};
    }
    if (options.elements != Elements::Triangles) {
        return error("least-angle", "a least angle can be asked for triangles only",
                     "leave out the least angle, or choose triangles");
    }
    if (!job.layers.empty()) {
        return error("least-angle",
                     "a least angle cannot be had beside boundary layers, whose elements are long and thin",
                     "leave out the least angle, or the layers");
    }
    if (!(*options.leastAngle > 0.0 && *options.leastAngle <= kMaxLeastAngle)) {
        return error("least-angle", "the least angle is " + numberText(*options.leastAngle, 6) +
                                        "°; expected above 0 and at most " + numberText(kMaxLeastAngle, 6));
    }
    return {};
}

/// Refuses mapped faces together with what would divide their sides on one side alone.
Status validateMapped(const MeshingJob &job) {
    if (job.mapped.empty()) {
        return {};
    }
    if (!job.layers.empty()) {
        return error("mapped-layers", "boundary layers cannot be had beside mapped faces",
                     "leave out the boundary layers, or the mapped faces");
    }
    if (job.options.leastAngle) {
        return error("least-angle", "a least angle cannot be had beside mapped faces, whose rows stay",
                     "leave out the least angle, or the mapped faces");
    }
    return {};
}

/// Ties the segments of periodic parts. A least angle and boundary layers add nodes to the boundary afterwards, on one
/// side alone.
Status findPeriodic(MeshingState &state) {
    const MeshingJob &job = state.job;
    if (job.options.leastAngle) {
        return error("least-angle", "a least angle cannot be had beside periodic parts, whose nodes are paired",
                     "leave out the least angle, or the periodic parts");
    }
    if (!job.layers.empty()) {
        return error("periodic-layers", "boundary layers cannot be had beside periodic parts, whose nodes are paired",
                     "leave out the boundary layers, or the periodic parts");
    }
    Result<PeriodicSides> sides = findPeriodicSides(job.periodic, job.domain, state.faces, job.spacing.placed.counts());
    if (!sides) {
        return sides.faults();
    }
    state.periodic = std::move(*sides);
    return {};
}

} // namespace

Status validateStage(MeshingState &state, const Progress &progress) {
    progress("validating", 0.0);
    if (Status faults = validateLeastAngle(state.job); !faults.empty()) {
        return faults;
    }
    if (Status faults = validateMapped(state.job); !faults.empty()) {
        return faults;
    }
    Diagnostics faults = validate(state.job.domain, kMaxListedFaults, &state.faces);
    if (!hasErrors(faults)) {
        Diagnostics ofLayers = checkLayers(state.job.layers, state.job.domain);
        faults.insert(faults.end(), ofLayers.begin(), ofLayers.end());
    }
    if (!hasErrors(faults) && !state.job.periodic.empty()) {
        Status ofPeriodic = findPeriodic(state);
        faults.insert(faults.end(), ofPeriodic.begin(), ofPeriodic.end());
    }
    if (!hasErrors(faults) && !state.job.cracks.empty()) {
        Status ofCracks = checkCrackLines(state.job.cracks, state.job.periodic, state.job.domain, state.faces);
        faults.insert(faults.end(), ofCracks.begin(), ofCracks.end());
    }
    return faults;
}

} // namespace forefront
