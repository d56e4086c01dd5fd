#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/boundary/estimate.hpp"
#include "core/engine/boundary/graded_nodes.hpp"
#include "core/engine/layers/layered_field.hpp"
#include "core/engine/pipeline/boundary_division.hpp"
#include "core/engine/pipeline/build_spacing.hpp"
#include "core/engine/pipeline/element_limit.hpp"
#include "core/engine/pipeline/periodic_sites.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/pipeline/strip_job.hpp"
#include "core/engine/spacing/kept_field.hpp"
#include "core/engine/spacing/scaled_field.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

constexpr double kChordGrowth = 0.18; ///< of the size around short chords, as of the automatic spacing beside curves

constexpr double kGrowthFromPeriodic = 0.2; ///< of the size, unless a smaller gradation is given

/// Discretises the boundary. Where that divides a periodic part more finely than the spacing, for the sake of the other
/// one, the spacing is lowered around it and the boundary discretised again. Changes `spacing`.
Result<DiscreteDomain> divided(const BoundaryDivision &division, NarrowTips tips,
                               std::shared_ptr<const SpacingField> &spacing, const Progress &progress) {
    const MeshingJob &job = division.job;
    const PeriodicSides &sides = division.periodic;
    const auto divide = [&] {
        return discretise(division.domain, *spacing, job.options.keepBoundary, progress, &division.faces, tips,
                          division.elements, sides.links.empty() ? nullptr : &sides);
    };
    Result<DiscreteDomain> boundary = divide();
    if (!boundary || sides.links.empty() || job.options.keepBoundary) {
        return boundary;
    }
    const double growth = std::min(job.spacing.gradation.value_or(kGrowthFromPeriodic), kGrowthFromPeriodic);
    std::vector<SizeSite> sites = periodicSites(*boundary, sides, *spacing, growth);
    if (sites.empty()) {
        return boundary;
    }
    Result<std::shared_ptr<const SpacingField>> lowered =
        layeredField(std::move(spacing), std::move(sites), boundary->bounds(), progress, "the other periodic part");
    if (!lowered) {
        return lowered.faults();
    }
    spacing = std::move(*lowered);
    return divide();
}

} // namespace

Result<PreparedJob> discretised(const BoundaryDivision &division, std::shared_ptr<const SpacingField> spacing,
                                std::uint64_t limit, const Progress &progress) {
    const MeshingJob &job = division.job;
    progress("discretising the boundary", 0.0);
    // Sizes that were asked for are kept everywhere, sizes chosen automatically only where they help.
    const bool automatic = job.spacing.usesAutomatic() && !job.spacing.maximum;
    const std::shared_ptr<const SpacingField> given = spacing;
    Result<DiscreteDomain> boundary =
        divided(division, automatic ? NarrowTips::Whole : NarrowTips::Divided, spacing, progress);
    if (!boundary) {
        return boundary.faults();
    }
    if (const auto *const kept = dynamic_cast<const KeptField *>(given.get())) {
        addGradedNodes(*kept, division.faces, *boundary);
    }
    PreparedJob prepared;
    prepared.estimatedElements = boundary->estimatedElements = estimateElements(*boundary, *spacing);
    prepared.requestedElements = prepared.estimatedElements;
    prepared.spacing = std::move(spacing);
    prepared.boundary = std::make_shared<const DiscreteDomain>(std::move(*boundary));
    // Given segments may be far shorter than the spacing; each takes about one element.
    const double needed = std::max(prepared.estimatedElements, static_cast<double>(prepared.boundary->segments.size()));
    if (!(needed <= static_cast<double>(limit))) {
        return tooManyElements("the node spacing needs about " + numberText(needed, 3) + " elements", needed,
                               static_cast<double>(limit), prepared);
    }
    return prepared;
}

namespace {

/// Discretises the boundary of a job with the numbers of elements that it gives.
Result<PreparedJob> discretised(const MeshingJob &job, const DomainFaces &faces, const PeriodicSides &sides,
                                std::shared_ptr<const SpacingField> spacing, std::uint64_t limit,
                                const Progress &progress) {
    return discretised({job, job.domain, job.spacing.placed.counts(), faces, sides}, std::move(spacing), limit,
                       progress);
}

/// Returns a size source for each chord that is far shorter than the spacing there, among those that were taken as
/// straight and those beside them.
std::vector<SizeSource> shortChords(const PreparedJob &prepared, const MeshingJob &job) {
    if (prepared.boundary->straightened.empty()) {
        return {};
    }
    const Domain &domain = job.domain;
    std::vector<std::uint8_t> isEnd(domain.nodes.size(), 0);
    for (const std::uint32_t s : prepared.boundary->straightened) {
        isEnd[domain.segments[s].a] = isEnd[domain.segments[s].b] = 1;
    }
    constexpr double kFarShorter = 0.5; // relative to the spacing
    const double minimum = job.spacing.minimum.value_or(0.0);
    std::vector<SizeSource> sources;
    const SegmentElements elements = job.spacing.placed.counts();
    for (std::size_t s = 0; s < domain.segments.size(); ++s) {
        const DomainSegment &segment = domain.segments[s];
        if (!segment.stretch.follows() || elements[s] > 0 || (isEnd[segment.a] == 0 && isEnd[segment.b] == 0)) {
            continue;
        }
        const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        const double length = distance(a, b);
        if (length > 0.0 && std::max(length, minimum) < kFarShorter * prepared.spacing->at(midpoint(a, b))) {
            SizeSource source;
            source.shape = SourceShape::Line;
            source.a = a;
            source.b = b;
            source.size = length;
            source.growth = job.spacing.gradation.value_or(kChordGrowth);
            sources.push_back(std::move(source));
        }
    }
    return sources;
}

/// Discretises the boundary. Where curves cross, so that chords are taken as they are, the automatic spacing knows the
/// lengths of whole curves only: short chords become sources, and the boundary is discretised again.
Result<PreparedJob> discretisedWithChords(MeshingState &state, std::uint64_t limit, const Progress &progress) {
    const MeshingJob &job = state.meshed();
    const DomainFaces &faces = state.faces;
    const PeriodicSides &sides = state.periodic;
    const std::shared_ptr<const StripJob> strips = state.prepared.strips;
    Result<PreparedJob> prepared = discretised(job, faces, sides, std::move(state.prepared.spacing), limit, progress);
    constexpr int kMaxRounds = 4; // finer pieces may cross elsewhere
    MeshingJob again;
    for (int round = 0; round < kMaxRounds && prepared && job.spacing.usesAutomatic(); ++round) {
        std::vector<SizeSource> sources = shortChords(*prepared, job);
        if (sources.empty()) {
            break;
        }
        if (round == 0) {
            again = state.job; // the spacing knows no strips
            again.shared = nullptr;
            again.spacing.keepAutomatic = true;
        }
        std::ranges::move(sources, std::back_inserter(again.spacing.sources));
        Result<std::shared_ptr<const SpacingField>> finer = buildSpacing(again, progress);
        if (finer) {
            finer = withStripEnds(std::move(*finer), strips.get(), progress);
        }
        Result<PreparedJob> next =
            finer ? discretised(job, faces, sides, std::move(*finer), limit, progress) : finer.faults();
        if (!next && !progress.cancelled()) {
            break; // the mesh would be too large
        }
        prepared = std::move(next);
    }
    return prepared;
}

/// Discretises the boundary with the spacing of the job or, if that needs more elements than the budget, with a coarser
/// one.
Result<PreparedJob> discretisedWithin(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.meshed();
    const std::uint64_t limit = std::isinf(state.budget) ? limitOf(job.options) : kMaxElements; // a preview is coarser
    Result<PreparedJob> prepared = discretisedWithChords(state, limit, progress);
    if (!prepared || prepared->estimatedElements <= state.budget) {
        return prepared;
    }
    const double requested = prepared->estimatedElements, factor = std::sqrt(requested / state.budget);
    Result<PreparedJob> coarse =
        discretised(job, state.faces, state.periodic, scaledField(prepared->spacing, factor), limit, progress);
    if (coarse) {
        coarse->requestedElements = requested;
        coarse->coarsening = factor;
    }
    return coarse;
}

} // namespace

Status boundaryStage(MeshingState &state, const Progress &progress) {
    Result<PreparedJob> prepared = discretisedWithin(state, progress);
    if (!prepared) {
        return prepared.faults();
    }
    prepared->strips = std::move(state.prepared.strips);
    state.prepared = std::move(*prepared);
    return {};
}

} // namespace forefront
