#include "core/engine/base/cancelled.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/pipeline/even_counts.hpp"
#include "core/engine/pipeline/quad_start.hpp"
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

namespace {

/// Makes the boundary of the front even.
std::shared_ptr<const ColouredBoundary> evenBoundary(MeshingState &state, const Progress &progress) {
    progress("making the boundary even", 0.0);
    const MeshingOptions &options = state.job.options;
    PreparedJob &prepared = state.prepared;
    // The edges of layers must stay; the front has a triangle where that leaves an odd number.
    const bool divide = !options.keepBoundary && options.elements == Elements::Quads && !prepared.layers;
    const std::vector<std::uint32_t> elements = countsWithPeriodic(state.meshed(), *prepared.boundary);
    auto boundary = std::make_shared<const ColouredBoundary>(
        colourBoundary(*prepared.frontBoundary(), *prepared.spacing, {&state.meshed().domain, elements, divide}));
    if (boundary->added > 0) {
        prepared.boundary = std::shared_ptr<const DiscreteDomain>(boundary, &boundary->domain);
    }
    return boundary;
}

Status advanceQuads(MeshingState &state, const ColouredBoundary &boundary, QuadMesh &mesh, const Progress &progress) {
    const MeshingOptions &options = state.job.options;
    const PreparedJob &prepared = state.prepared;
    if (!advanceColoured({boundary, *prepared.spacing, options, prepared.estimatedElements, elementsToStopAt(options)},
                         mesh, progress)) {
        return progress.cancelled() ? cancelled("meshing") : stoppedFront(prepared, options);
    }
    return {};
}

} // namespace

Result<QuadStart> chooseQuadFront(MeshingState &state, const Progress &progress) {
    if (isFilled(state.prepared)) {
        const DiscreteDomain &domain = *state.prepared.frontBoundary();
        std::vector<std::uint8_t> colours(domain.nodes.size(), 0);
        return QuadStart{std::make_shared<const ColouredBoundary>(ColouredBoundary{domain, std::move(colours), 0, {}})};
    }
    QuadStart start{evenBoundary(state, progress)};
    QuadMesh mesh;
    if (Status faults = advanceQuads(state, *start.boundary, mesh, progress); !faults.empty()) {
        return faults;
    }
    start.lattice = mesh.report.lattice;
    return start;
}

Status quadFrontStage(MeshingState &state, const Progress &progress) {
    if (isFilled(state.prepared)) {
        return {};
    }
    const std::shared_ptr<const ColouredBoundary> boundary = evenBoundary(state, progress);
    if (Status faults = advanceQuads(state, *boundary, state.quads, progress); !faults.empty()) {
        return faults;
    }
    state.work = state.quads.work;
    return {};
}

Status quadCleanupStage(MeshingState &state, const Progress &progress) {
    if (isFilled(state.prepared)) {
        return {};
    }
    cleanUp(state.quads, *state.prepared.spacing, state.job.options, progress, state.quadWatch);
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
