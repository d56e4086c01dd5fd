#include "core/engine/base/cancelled.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/pipeline/even_counts.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/quads/quad_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns true if mapped faces fill the domain, so that nothing is left to the front.
bool isFilled(const PreparedJob &prepared) {
    return prepared.frontBoundary()->segments.empty();
}

} // namespace

std::vector<std::uint32_t> countsWithPeriodic(const MeshingJob &job, const DiscreteDomain &boundary) {
    std::vector<std::uint32_t> counts(job.domain.segments.size(), 0);
    const SegmentElements given = job.spacing.placed.counts();
    for (std::size_t s = 0; s < counts.size(); ++s) {
        const std::int32_t tag = job.domain.segments[s].tag;
        const bool periodic = std::any_of(boundary.periodic.begin(), boundary.periodic.end(),
                                          [&](const auto &link) { return link.from == tag || link.to == tag; });
        counts[s] = periodic ? std::max(given[s], 1U) : given[s];
    }
    return counts;
}

Status quadFrontStage(MeshingState &state, const Progress &progress) {
    const MeshingOptions &options = state.job.options;
    PreparedJob &prepared = state.prepared;
    if (isFilled(prepared)) {
        return {};
    }
    progress("making the boundary even", 0.0);
    // The edges of layers must stay; the front has a triangle where that leaves an odd number.
    const bool divide = !options.keepBoundary && options.elements == Elements::Quads && !prepared.layers;
    const std::vector<std::uint32_t> elements = countsWithPeriodic(state.meshed(), *prepared.boundary);
    const ColouredBoundary boundary =
        colourBoundary(*prepared.frontBoundary(), *prepared.spacing, {&state.meshed().domain, elements, divide});
    if (!advanceColoured({boundary, *prepared.spacing, options, prepared.estimatedElements, elementsToStopAt(options)},
                         state.quads, progress)) {
        return progress.cancelled() ? cancelled("meshing") : stoppedFront(prepared, options);
    }
    state.work = state.quads.work;
    if (boundary.added > 0) {
        prepared.boundary = std::make_shared<const DiscreteDomain>(boundary.domain);
    }
    return {};
}

Status quadCleanupStage(MeshingState &state, const Progress &progress) {
    if (isFilled(state.prepared)) {
        return {};
    }
    cleanUp(state.quads, *state.prepared.spacing, state.job.options, progress);
    return {};
}

Status quadBlocksStage(MeshingState &state, const Progress &) {
    if (isFilled(state.prepared)) {
        state.mesh = Mesh(nodesOf(*state.prepared.frontBoundary()));
        return {};
    }
    state.mesh = toMesh(std::move(state.quads), *state.prepared.frontBoundary(), state.quadReport);
    return {};
}

} // namespace forefront
