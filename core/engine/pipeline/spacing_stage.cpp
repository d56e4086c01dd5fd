#include "core/engine/pipeline/build_spacing.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/spacing/shared_spacing.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Returns the regions of a job whose elements are quadrilaterals, or may be.
QuadRegions quadRegionsOf(const MeshingJob &job) {
    QuadRegions quads{job.options.elements != Elements::Triangles};
    for (const RegionElements &region : job.regionElements) {
        if ((region.elements != Elements::Triangles) != quads.byDefault) {
            quads.others.push_back(region.region);
        }
    }
    return quads;
}

bool hasMaxArea(const RegionSize &region) {
    return region.maxArea > 0.0;
}

} // namespace

Result<std::shared_ptr<const SpacingField>> buildSpacing(const MeshingJob &job, const Progress &progress) {
    std::optional<SpacingSpec> withQuads;
    if (std::ranges::any_of(job.spacing.placed.regions, hasMaxArea)) {
        withQuads = job.spacing;
        withQuads->placed.quads = quadRegionsOf(job);
    }
    const SpacingSpec &spec = withQuads ? *withQuads : job.spacing;
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
