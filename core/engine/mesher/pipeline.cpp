#include "core/engine/mesher/pipeline.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/base/free_memory.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/estimate.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/spacing/scaled_field.hpp"
#include "core/engine/spacing/shared_spacing.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <new>

namespace forefront {

namespace {

constexpr double kChordGrowth = 0.18; ///< of the size around short chords, as of the automatic spacing beside curves

/// Returns the number of advances between checks for cancellation, which take a few milliseconds even where each
/// advance looks at all of Γ.
std::uint64_t batchFor(const Mesher &mesher) {
    return std::clamp<std::uint64_t>(10'000'000 / (mesher.state().front.segments() + 1), 16, 4096);
}

/// Builds the spacing of a job.
Result<std::shared_ptr<const SpacingField>> spacingOf(const MeshingJob &job, const Progress &progress) {
    const SpacingSpec &spec = job.spacing;
    if (job.options.keepBoundary && spec.usesAutomatic() && spec.paint.tiles.empty() && !spec.background) {
        SpacingSpec kept = spec;
        kept.fromBoundary = true; // segments that stay as they are set the size of their neighbourhood
        return SpacingField::build(kept, job.domain, progress);
    }
    return job.shared ? job.shared->get(spec, job.domain, progress) : SpacingField::build(spec, job.domain, progress);
}

/// Returns the limit on the elements of a job.
std::uint64_t limitOf(const MeshingOptions &options) {
    return std::min(options.maxElements, kMaxElements);
}

/// Returns the error for a job that needs too many elements, with a size that would fit.
Diagnostics tooManyElements(const std::string &what, double needed, double limit, const PreparedJob &prepared) {
    // The number of elements falls with the square of the size. The margin is for the rounding and the estimate.
    const double factor = 1.05 * std::sqrt(std::max(1.0, needed / limit));
    const SpacingField &spacing = *prepared.spacing;
    const bool uniform = spacing.minimum() == spacing.maximum();
    std::string advice = uniform ? "choose an element size of at least " + numberText(factor * spacing.minimum(), 3)
                                 : "choose element sizes at least " + numberText(factor, 3) + " times as large";
    if (limit < static_cast<double>(kMaxElements)) {
        advice += ", or raise the maximum number of elements";
    }
    return error("too-many-elements", what + "; expected at most " + numberText(limit, 9), std::move(advice));
}

/// Discretises the boundary with `spacing` and checks the number of elements.
Result<PreparedJob> discretised(const MeshingJob &job, const DomainFaces &faces,
                                std::shared_ptr<const SpacingField> spacing, std::uint64_t limit,
                                const Progress &progress) {
    progress("discretising the boundary", 0.0);
    // Sizes that were asked for are kept everywhere, sizes chosen automatically only where they help.
    const bool automatic = job.spacing.usesAutomatic() && !job.spacing.maximum;
    Result<DiscreteDomain> boundary = discretise(job.domain, *spacing, job.options.keepBoundary, progress, &faces,
                                                 automatic ? NarrowTips::Whole : NarrowTips::Divided);
    if (!boundary) {
        return boundary.faults();
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
    for (const DomainSegment &segment : domain.segments) {
        if (!segment.stretch.follows() || segment.elements > 0 || (isEnd[segment.a] == 0 && isEnd[segment.b] == 0)) {
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
Result<PreparedJob> discretisedWithChords(const MeshingJob &job, const DomainFaces &faces,
                                          std::shared_ptr<const SpacingField> spacing, std::uint64_t limit,
                                          const Progress &progress) {
    Result<PreparedJob> prepared = discretised(job, faces, std::move(spacing), limit, progress);
    constexpr int kMaxRounds = 4; // finer pieces may cross elsewhere
    MeshingJob again;
    for (int round = 0; round < kMaxRounds && prepared && job.spacing.usesAutomatic(); ++round) {
        std::vector<SizeSource> sources = shortChords(*prepared, job);
        if (sources.empty()) {
            break;
        }
        if (round == 0) {
            again = job;
            again.shared = nullptr;
            again.spacing.keepAutomatic = true;
        }
        std::ranges::move(sources, std::back_inserter(again.spacing.sources));
        Result<std::shared_ptr<const SpacingField>> finer = spacingOf(again, progress);
        Result<PreparedJob> next =
            finer ? discretised(again, faces, std::move(*finer), limit, progress) : finer.faults();
        if (!next && !progress.cancelled()) {
            break; // the mesh would be too large
        }
        prepared = std::move(next);
    }
    return prepared;
}

} // namespace

Result<PreparedJob> prepare(const MeshingJob &job, const Progress &progress, double budget) {
    FOREFRONT_ASSERT(budget > 0.0);
    progress("validating", 0.0);
    DomainFaces faces;
    Diagnostics faults = validate(job.domain, kMaxListedFaults, &faces);
    if (hasErrors(faults)) {
        return faults;
    }
    if (progress.cancelled()) {
        return cancelled("meshing");
    }
    progress("building the node spacing", 0.0);
    Result<std::shared_ptr<const SpacingField>> spacing = spacingOf(job, progress);
    if (!spacing) {
        return spacing.faults();
    }
    const std::uint64_t limit = std::isinf(budget) ? limitOf(job.options) : kMaxElements; // a preview is made coarser
    Result<PreparedJob> prepared = discretisedWithChords(job, faces, std::move(*spacing), limit, progress);
    if (!prepared || prepared->estimatedElements <= budget) {
        return prepared;
    }
    const double requested = prepared->estimatedElements, factor = std::sqrt(requested / budget);
    Result<PreparedJob> coarse = discretised(job, faces, scaledField(prepared->spacing, factor), limit, progress);
    if (coarse) {
        coarse->requestedElements = requested;
        coarse->coarsening = factor;
    }
    return coarse;
}

namespace {

Result<MeshingOutcome> runJob(const MeshingJob &job, const Progress &progress) {
    MeshingOutcome outcome;
    const unsigned threads = job.usableThreads();
    CpuClock clock(CpuClock::Of::Program);
    Result<PreparedJob> prepared = prepare(job, progress);
    if (!prepared) {
        return prepared.faults();
    }
    outcome.boundary = prepared->boundary;
    outcome.spacing = prepared->spacing;
    outcome.secondsPrepare = clock.lap();
    const auto begin = std::chrono::steady_clock::now();

    std::unique_ptr<Mesher> mesher = Mesher::create(outcome.boundary, outcome.spacing, job.options);
    mesher->reserve(static_cast<std::uint64_t>(Mesher::kReserve * prepared->estimatedElements) + 1024);
    if (threads > 1) {
        releaseFreeMemory();
    }
    if (threads > 1 &&
        !mesher->advanceInParallel(threads, progress, prepared->estimatedElements, elementsToStopAt(job.options))) {
        return progress.cancelled() ? cancelled("meshing") : stoppedFront(*prepared, job.options);
    }
    if (Status faults = advanceToEnd(*mesher, *prepared, job.options, "advancing the front", progress);
        !faults.empty()) {
        return faults;
    }
    outcome.work = mesher->state().work;
    outcome.mesh = std::move(*mesher).takeMesh();
    mesher.reset();
    if (threads > 1) {
        releaseFreeMemory();
    }
    outcome.secondsMesh = clock.lap();

    if (job.options.improve != ImproveLevel::None) {
        outcome.improvement = improve(outcome.mesh, {job.options.improve, threads, outcome.spacing.get()}, progress);
        outcome.secondsImprove = clock.lap();
    }
    outcome.secondsWall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (progress.cancelled()) {
        return cancelled("meshing");
    }
    return outcome;
}

} // namespace

std::uint64_t elementsToStopAt(const MeshingOptions &options) {
    const std::uint64_t limit = limitOf(options); // estimates may be a fifth too low
    return std::min(limit + limit / 4 + 1000, kMaxElements);
}

Diagnostics stoppedFront(const PreparedJob &prepared, const MeshingOptions &options) {
    // How many elements the unmeshed part takes is unknown; assume as many.
    const auto made = static_cast<double>(elementsToStopAt(options));
    return tooManyElements("the front has made " + numberText(made, 3) + " elements and is not closed yet", 2.0 * made,
                           static_cast<double>(limitOf(options)), prepared);
}

Status advanceToEnd(Mesher &mesher, const PreparedJob &prepared, const MeshingOptions &options, std::string_view stage,
                    const Progress &progress) {
    const std::uint64_t end = elementsToStopAt(options);
    while (!mesher.finished()) {
        mesher.advance(batchFor(mesher));
        if (progress.cancelled()) {
            return cancelled("meshing");
        }
        if (mesher.state().elements.size() > end) {
            return stoppedFront(prepared, options);
        }
        progress(stage, std::min(0.99, static_cast<double>(mesher.state().elements.size()) /
                                           (prepared.estimatedElements + 1.0)));
    }
    return {};
}

Diagnostics outOfMemory() {
    return error("out-of-memory", "not enough memory for this mesh", "choose a larger element size");
}

Result<MeshingOutcome> meshDomain(const MeshingJob &job, const Progress &progress) {
    try {
        return runJob(job, progress);
    } catch (const std::bad_alloc &) {
        Diagnostics faults = outOfMemory();
        if (job.options.grid == GridKind::Uniform && job.options.gridColumns > 0) {
            faults.front().advice = "choose a background grid with fewer cells, or a larger element size";
        }
        return faults;
    }
}

} // namespace forefront
