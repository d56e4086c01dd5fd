#include "core/engine/base/number_text.hpp"
#include "core/engine/mapped/mapped_counts.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/pipeline/boundary_division.hpp"
#include "core/engine/pipeline/element_limit.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/pipeline/strip_job.hpp"
#include "core/engine/quads/even_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns the shapes of the elements of a region.
Elements elementsOf(const MeshingJob &job, std::int32_t region) {
    const auto own = std::ranges::find(job.regionElements, region, &RegionElements::region);
    return own == job.regionElements.end() ? job.options.elements : own->elements;
}

/// Returns true if a region has quadrilaterals alone.
bool hasRegionOfQuads(const MeshingJob &job) {
    return job.options.elements == Elements::Quads ||
           std::ranges::find(job.regionElements, Elements::Quads, &RegionElements::elements) !=
               job.regionElements.end();
}

/// Divides the boundary again with the numbers of elements that mapped faces need.
Status divideAgain(MeshingState &state, const MappedNumbers &numbers, std::uint64_t limit, const Progress &progress) {
    Result<PreparedJob> again =
        discretised({state.meshed(), numbers.domain, SegmentElements(numbers.elements, numbers.biases), state.faces,
                     state.periodic},
                    state.prepared.spacing, limit, progress);
    if (!again) {
        return again.faults();
    }
    state.prepared.spacing = std::move(again->spacing);
    state.prepared.boundary = std::move(again->boundary);
    state.prepared.estimatedElements = again->estimatedElements;
    return {};
}

/// Makes the cycles of edges even outside mapped faces, whose edges stay.
void makeEven(MeshingState &state, const MappedNumbers &numbers) {
    std::vector<std::uint32_t> kept = numbers.elements;
    for (std::uint32_t s = 0; s < kept.size(); ++s) {
        kept[s] = state.periodic.ties(s) ? std::max(kept[s], 1U) : kept[s];
    }
    const ColouredBoundary even =
        colourBoundary(*state.prepared.boundary, *state.prepared.spacing, {&state.meshed().domain, kept, true});
    if (even.added > 0) {
        state.prepared.boundary = std::make_shared<const DiscreteDomain>(even.domain);
    }
}

} // namespace

Status mappedStage(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.meshed();
    const std::span<const StripFace> strips =
        state.prepared.strips ? std::span<const StripFace>(state.prepared.strips->faces) : std::span<const StripFace>();
    if (job.mapped.empty() && strips.empty()) {
        return {};
    }
    progress(job.mapped.empty() ? "filling strips" : "filling mapped faces", 0.0);
    Result<std::vector<TransfiniteFace>> faces = findMappedFaces(job.mapped, job.domain, state.faces);
    if (!faces) {
        return faces.faults();
    }
    for (TransfiniteFace &face : *faces) {
        face.quads = elementsOf(job, state.faces.labels.tag[face.face]) != Elements::Triangles;
    }
    const std::uint64_t limit = std::isinf(state.budget) ? limitOf(job.options) : kMaxElements;
    const Result<MappedNumbers> numbers =
        equalNumbers({job.domain, *faces, strips, job.spacing.placed.counts(), state.periodic, job.options.keepBoundary,
                      static_cast<double>(limit)},
                     *state.prepared.boundary, progress);
    if (!numbers) {
        return numbers.faults();
    }
    if (const double made = numbers->inFaces + numbers->inStrips; made > static_cast<double>(limit)) {
        return tooManyElements(std::string(job.mapped.empty() ? "the strips need " : "the mapped faces need ") +
                                   numberText(made, 6) + " elements",
                               made, static_cast<double>(limit), state.prepared);
    }
    if (numbers->changed) {
        if (Status faults = divideAgain(state, *numbers, limit, progress); !faults.empty()) {
            return faults;
        }
    }
    if (hasRegionOfQuads(job) && !job.options.keepBoundary) {
        makeEven(state, *numbers);
    }
    Result<BoundaryLayers> rows = mappedRows(job.domain, *faces, strips, *state.prepared.boundary, progress);
    if (!rows) {
        return rows.faults();
    }
    state.prepared.layers = std::make_shared<const BoundaryLayers>(std::move(*rows));
    return {};
}

} // namespace forefront
