#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/estimate.hpp"
#include "core/engine/mapped/mapped_counts.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/pipeline/element_limit.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/quads/even_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

namespace {

bool makesRowsOfQuads(const MeshingOptions &options) {
    return options.elements != Elements::Triangles;
}

/// Divides the boundary again with the numbers of elements that mapped faces need.
Status divideAgain(MeshingState &state, const MappedNumbers &numbers, const Progress &progress) {
    const MeshingJob &job = state.job;
    const bool automatic = job.spacing.usesAutomatic() && !job.spacing.maximum; // as for the first division
    Result<DiscreteDomain> boundary = discretise(
        numbers.domain, *state.prepared.spacing, job.options.keepBoundary, progress, &state.faces,
        automatic ? NarrowTips::Whole : NarrowTips::Divided, SegmentElements(numbers.elements, numbers.biases),
        state.periodic.links.empty() ? nullptr : &state.periodic);
    if (!boundary) {
        return boundary.faults();
    }
    boundary->estimatedElements = estimateElements(*boundary, *state.prepared.spacing);
    state.prepared.estimatedElements = boundary->estimatedElements;
    state.prepared.boundary = std::make_shared<const DiscreteDomain>(std::move(*boundary));
    return {};
}

/// Makes the cycles of edges even outside mapped faces, whose edges stay.
void makeEven(MeshingState &state, const MappedNumbers &numbers) {
    std::vector<std::uint32_t> kept = numbers.elements;
    for (std::uint32_t s = 0; s < kept.size(); ++s) {
        kept[s] = state.periodic.ties(s) ? std::max(kept[s], 1U) : kept[s];
    }
    const ColouredBoundary even =
        colourBoundary(*state.prepared.boundary, *state.prepared.spacing, {&state.job.domain, kept, true});
    if (even.added > 0) {
        state.prepared.boundary = std::make_shared<const DiscreteDomain>(even.domain);
    }
}

} // namespace

Status mappedStage(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.job;
    if (job.mapped.empty()) {
        return {};
    }
    progress("filling mapped faces", 0.0);
    const Result<std::vector<MappedFace>> faces = findMappedFaces(job.mapped, job.domain, state.faces);
    if (!faces) {
        return faces.faults();
    }
    const Result<MappedNumbers> numbers =
        equalNumbers({job.domain, *faces, job.spacing.placed.counts(), state.periodic, job.options.keepBoundary},
                     *state.prepared.boundary);
    if (!numbers) {
        return numbers.faults();
    }
    if (numbers->changed) {
        if (Status faults = divideAgain(state, *numbers, progress); !faults.empty()) {
            return faults;
        }
    }
    if (job.options.elements == Elements::Quads && !job.options.keepBoundary) {
        makeEven(state, *numbers);
    }
    Result<BoundaryLayers> rows =
        mappedRows(job.domain, *faces, *state.prepared.boundary, makesRowsOfQuads(job.options));
    if (!rows) {
        return rows.faults();
    }
    const auto limit = static_cast<double>(std::isinf(state.budget) ? limitOf(job.options) : kMaxElements);
    const auto made = static_cast<double>(rows->cells.size());
    if (made > limit) {
        return tooManyElements("the mapped faces need " + numberText(made, 6) + " elements", made, limit,
                               state.prepared);
    }
    state.prepared.layers = std::make_shared<const BoundaryLayers>(std::move(*rows));
    return {};
}

} // namespace forefront
