#include "core/engine/base/cancelled.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/quads/quad_mesh.hpp"

#include <memory>
#include <utility>

namespace forefront {

Status quadFrontStage(MeshingState &state, const Progress &progress) {
    const MeshingOptions &options = state.job.options;
    PreparedJob &prepared = state.prepared;
    progress("making the boundary even", 0.0);
    // The edges of layers must stay; the front has a triangle where that leaves an odd number.
    const bool divide = !options.keepBoundary && options.elements == Elements::Quads && !prepared.layers;
    const ColouredBoundary boundary = colourBoundary(*prepared.frontBoundary(), *prepared.spacing,
                                                     {&state.job.domain, state.job.spacing.placed.counts(), divide});
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
    cleanUp(state.quads, *state.prepared.spacing, state.job.options, progress);
    return {};
}

Status quadBlocksStage(MeshingState &state, const Progress &) {
    state.mesh = toMesh(std::move(state.quads), *state.prepared.frontBoundary(), state.quadReport);
    return {};
}

} // namespace forefront
