#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/unmatched_sector.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/pipeline/element_limit.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace forefront {

namespace {

constexpr double kGrowthFromTops = 0.2; ///< of the size, unless a smaller gradation is given

double maxElementsOf(const MeshingState &state) {
    return static_cast<double>(std::isinf(state.budget) ? limitOf(state.job.options) : kMaxElements);
}

LayerRequest requestOf(const MeshingState &state) {
    const MeshingJob &job = state.job;
    const double gradation = std::min(job.spacing.gradation.value_or(kGrowthFromTops), kGrowthFromTops);
    return {job.domain,           job.layers,     job.spacing.placed.counts(), job.options.keepBoundary, gradation,
            maxElementsOf(state), &state.periodic};
}

} // namespace

Status layersStage(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.job;
    if (job.layers.empty()) {
        return {};
    }
    PreparedJob &prepared = state.prepared;
    const double limit = maxElementsOf(state);
    Result<BuiltLayers> built = buildLayers(requestOf(state), prepared.boundary, prepared.spacing, progress);
    if (!built) {
        return built.faults();
    }
    if (const DiscreteDomain &outer = *built->layers->outer;
        const std::optional<std::uint32_t> node = unmatchedSector(outer)) {
        Diagnostics faults = error("layers-crossing", "boundary layers run into each other where lines meet",
                                   "leave out the layers of one of the lines, or end it before the others");
        faults.front().at = outer.nodes[*node];
        return faults;
    }
    prepared.layers = std::move(built->layers);
    prepared.boundary = std::move(built->boundary);
    prepared.spacing = std::move(built->spacing);
    prepared.estimatedElements = prepared.boundary->estimatedElements;
    if (!(prepared.estimatedElements <= limit)) {
        return tooManyElements("the boundary layers and the node spacing need about " +
                                   numberText(prepared.estimatedElements, 3) + " elements",
                               prepared.estimatedElements, limit, prepared);
    }
    return {};
}

Result<LayerRows> rowsOfLayers(const MeshingState &state, const Progress &progress) {
    return layerRows(requestOf(state), *state.prepared.boundary, progress);
}

Status joinStage(MeshingState &state, const Progress &) {
    if (const PreparedJob &prepared = state.prepared; prepared.layers) {
        state.mesh = withLayers(std::move(state.mesh), *prepared.layers, *prepared.boundary);
    }
    return {};
}

} // namespace forefront
