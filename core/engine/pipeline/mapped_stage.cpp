#include "core/engine/base/number_text.hpp"
#include "core/engine/mapped/mapped_counts.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/pipeline/boundary_division.hpp"
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
Status divideAgain(MeshingState &state, const MappedNumbers &numbers, std::uint64_t limit, const Progress &progress) {
    Result<PreparedJob> again = discretised(
        {state.job, numbers.domain, SegmentElements(numbers.elements, numbers.biases), state.faces, state.periodic},
        state.prepared.spacing, limit, progress);
    if (!again) {
        return again.faults();
    }
    state.prepared.spacing = std::move(again->spacing);
    state.prepared.boundary = std::move(again->boundary);
    state.prepared.estimatedElements = again->estimatedElements;
    return {};
}

/// Returns the number of elements that the rows of mapped faces have.
double rowElements(const MappedNumbers &numbers, bool quads) {
    return quads ? numbers.cells : 2.0 * numbers.cells - numbers.corners;
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
    const Result<std::vector<TransfiniteFace>> faces = findMappedFaces(job.mapped, job.domain, state.faces);
    if (!faces) {
        return faces.faults();
    }
    const std::uint64_t limit = std::isinf(state.budget) ? limitOf(job.options) : kMaxElements;
    const Result<MappedNumbers> numbers = equalNumbers({job.domain, *faces, job.spacing.placed.counts(), state.periodic,
                                                        job.options.keepBoundary, static_cast<double>(limit)},
                                                       *state.prepared.boundary, progress);
    if (!numbers) {
        return numbers.faults();
    }
    const bool quads = makesRowsOfQuads(job.options);
    if (const double made = rowElements(*numbers, quads); made > static_cast<double>(limit)) {
        return tooManyElements("the mapped faces need " + numberText(made, 6) + " elements", made,
                               static_cast<double>(limit), state.prepared);
    }
    if (numbers->changed) {
        if (Status faults = divideAgain(state, *numbers, limit, progress); !faults.empty()) {
            return faults;
        }
    }
    if (job.options.elements == Elements::Quads && !job.options.keepBoundary) {
        makeEven(state, *numbers);
    }
    Result<BoundaryLayers> rows = mappedRows(job.domain, *faces, *state.prepared.boundary, quads, progress);
    if (!rows) {
        return rows.faults();
    }
    state.prepared.layers = std::make_shared<const BoundaryLayers>(std::move(*rows));
    return {};
}

} // namespace forefront
