#include "core/engine/layers/layered_field.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/pipeline/strip_job.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

constexpr double kGrowthFromEnds = 0.2; ///< of the size, unless a smaller gradation is given

} // namespace

const MeshingJob &MeshingState::meshed() const {
    return prepared.strips ? prepared.strips->job : job;
}

Result<std::shared_ptr<const SpacingField>> withStripEnds(std::shared_ptr<const SpacingField> spacing,
                                                          const StripJob *strips, const Progress &progress) {
    if (strips == nullptr || strips->ends.empty()) {
        return spacing;
    }
    return layeredField(std::move(spacing), strips->ends, strips->job.domain.bounds(), progress, "the end of a strip");
}

Status stripsStage(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.job;
    if (job.strips.empty()) {
        return {};
    }
    progress("making strips", 0.0);
    const double growth = std::min(job.spacing.gradation.value_or(kGrowthFromEnds), kGrowthFromEnds);
    Result<WidenedDomain> widened = widenedDomain(job.domain, job.strips, job.spacing.placed.counts(), growth);
    if (!widened) {
        return widened.faults();
    }
    auto strips = std::make_shared<StripJob>();
    strips->job = job;
    strips->job.domain = std::move(widened->domain);
    strips->job.spacing.placed.elements = std::move(widened->elements);
    strips->job.spacing.placed.biases = std::move(widened->biases);
    strips->faces = std::move(widened->strips);
    strips->ends = std::move(widened->ends);
    state.faces = std::move(widened->faces);
    if (!job.periodic.empty()) {
        Result<PeriodicSides> sides =
            findPeriodicSides(job.periodic, strips->job.domain, state.faces, strips->job.spacing.placed.counts());
        if (!sides) {
            return sides.faults();
        }
        state.periodic = std::move(*sides);
    }
    Result<std::shared_ptr<const SpacingField>> spacing =
        withStripEnds(std::move(state.prepared.spacing), strips.get(), progress);
    if (!spacing) {
        return spacing.faults();
    }
    state.prepared.spacing = std::move(*spacing);
    state.prepared.strips = std::move(strips);
    return {};
}

} // namespace forefront
