#include "core/engine/pipeline/stages.hpp"
#include "core/engine/refine/least_angle.hpp"

#include <memory>
#include <utility>

namespace forefront {

Status leastAngleStage(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.job;
    progress("raising the least angle", 0.0);
    DiscreteDomain boundary = *state.prepared.boundary;
    const SegmentElements counts = job.spacing.placed.counts();
    LeastAngleRules rules{*job.options.leastAngle, elementsToStopAt(job.options), {}};
    rules.mayDivide = [&, &segments = state.prepared.boundary->segments](std::uint32_t edge) {
        const std::uint32_t source = segments[edge].source; // of periodic parts, whose nodes are paired
        return !job.options.keepBoundary && counts[source] == 0 && !state.periodic.ties(source);
    };
    if (Status faults = refineToLeastAngle(state.triangles, boundary, rules, state.leastAngle, progress);
        !faults.empty()) {
        return faults;
    }
    state.prepared.boundary = std::make_shared<const DiscreteDomain>(std::move(boundary));
    return {};
}

} // namespace forefront
