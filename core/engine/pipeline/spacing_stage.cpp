#include "core/engine/pipeline/build_spacing.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/spacing/shared_spacing.hpp"

namespace forefront {

Result<std::shared_ptr<const SpacingField>> buildSpacing(const MeshingJob &job, const Progress &progress) {
    const SpacingSpec &spec = job.spacing;
    const GivenSegments segments = job.options.keepBoundary ? GivenSegments::Kept : GivenSegments::Divided;
    if (job.options.keepBoundary && spec.usesAutomatic() && spec.paint.tiles.empty() && !spec.background) {
        SpacingSpec kept = spec;
        kept.fromBoundary = true; // segments that stay as they are set the size of their neighbourhood
        return SpacingField::build(kept, job.domain, progress, segments);
    }
    return job.shared ? job.shared->get(spec, job.domain, progress, segments)
                      : SpacingField::build(spec, job.domain, progress, segments);
}

Status spacingStage(MeshingState &state, const Progress &progress) {
    progress("building the node spacing", 0.0);
    Result<std::shared_ptr<const SpacingField>> spacing = buildSpacing(state.job, progress);
    if (!spacing) {
        return spacing.faults();
    }
    state.prepared.spacing = std::move(*spacing);
    return {};
}

} // namespace forefront
