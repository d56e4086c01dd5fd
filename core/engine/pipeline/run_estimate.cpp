#include "core/engine/pipeline/run_estimate.hpp"

#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kTrialElements = 10'000.0;
/// The elements at which a run that was taken for a small one is given up.
constexpr std::uint64_t kMostOfSmall = 40'000;
/// Memory per element of the front, the improvement and the mesh: the largest measured at 7·10⁴ to 7·10⁵ elements.
constexpr double kBytesPerTriangle = 105.0, kBytesPerQuad = 370.0, kBytesPerSecondOrder = 100.0;

/// Returns the CPU seconds of one element in a square that is meshed with these options.
Result<double> secondsPerElement(const MeshingOptions &options, const Progress &progress) {
    MeshingJob trial;
    trial.domain.nodes = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        trial.domain.segments.push_back({k, (k + 1) % 4});
    }
    trial.spacing.size = std::sqrt(4.0 / (std::numbers::sqrt3 * kTrialElements));
    trial.options = options;
    trial.options.keepBoundary = false;
    trial.options.maxElements = kDefaultMaxElements;
    const Result<MeshingOutcome> outcome = meshDomain(trial, progress);
    if (!outcome) {
        return outcome.faults();
    }
    const auto elements = static_cast<double>(outcome->mesh.elementCount());
    return (outcome->secondsMesh + outcome->secondsImprove) / std::max(1.0, elements);
}

double bytesFor(double elements, const MeshingOptions &options) {
    const double second = options.order == ElementOrder::Second ? kBytesPerSecondOrder : 0.0;
    return elements * ((makesQuads(options) ? kBytesPerQuad : kBytesPerTriangle) + second);
}

/// Runs a small job, which takes no longer than the trial of a large one and tells its elements exactly: where sizes
/// change faster than the elements of the boundary allow, the integral says too few. Errors: those of meshDomain(), and
/// "too-many-elements" for a job that turns out not to be small.
Result<RunEstimate> runSmall(const MeshingJob &job, const Progress &progress) {
    MeshingJob trial = job;
    trial.options.maxElements = std::min(job.options.maxElements, kMostOfSmall);
    const Result<MeshingOutcome> outcome = meshDomain(trial, progress);
    if (!outcome) {
        return outcome.faults();
    }
    RunEstimate estimate;
    estimate.elements = static_cast<double>(outcome->mesh.elementCount());
    estimate.nodes = static_cast<double>(outcome->mesh.nodes.size());
    estimate.seconds = outcome->secondsMesh + outcome->secondsImprove;
    return estimate;
}

/// Returns the number of edges between the domain and its outside.
std::uint64_t outerEdges(const DiscreteDomain &boundary) {
    return static_cast<std::uint64_t>(
        std::count_if(boundary.segments.begin(), boundary.segments.end(), [](const DiscreteSegment &segment) {
            return (segment.leftRegion == kOutside) != (segment.rightRegion == kOutside);
        }));
}

/// Estimates a large job from the integral of its spacing and the time of a trial.
Result<RunEstimate> scaledUp(const MeshingJob &job, const PreparedJob &prepared, const Progress &progress) {
    const Result<double> each = secondsPerElement(job.options, progress);
    if (!each) {
        return each.faults();
    }
    RunEstimate estimate;
    const auto inLayers = prepared.layers ? static_cast<double>(prepared.layers->cells.size()) : 0.0;
    const bool quads = makesQuads(job.options);
    const double triangles = std::max(0.0, prepared.estimatedElements - inLayers);
    const double free = triangles / (quads ? kTrianglesPerQuad : 1.0);
    estimate.elements = std::max(1.0, std::round(free + inLayers));
    // Euler's formula for a domain with one outline; holes change it by one node each.
    const auto outer = static_cast<double>(outerEdges(*prepared.boundary));
    const double corners = (quads ? free : 0.5 * free) + inLayers + 0.5 * outer + 1.0;
    const double edges = corners + estimate.elements - 1.0;
    const bool second = job.options.order == ElementOrder::Second;
    const bool centres = second && quads && job.options.quadNodes == QuadNodes::Nine;
    estimate.nodes = std::round(corners + (second ? edges : 0.0) + (centres ? free : 0.0));
    estimate.seconds = *each * estimate.elements;
    return estimate;
}

} // namespace

Result<RunEstimate> estimateRun(const MeshingJob &job, const Progress &progress) {
    CpuClock clock(CpuClock::Of::Program);
    const Result<PreparedJob> prepared = planMesh(job, progress);
    if (!prepared) {
        return prepared.faults();
    }
    const double secondsPrepare = clock.lap();
    const bool small = prepared->estimatedElements <= kTrialElements;
    Result<RunEstimate> estimate = small ? runSmall(job, progress) : scaledUp(job, *prepared, progress);
    if (!estimate && small && job.options.maxElements > kMostOfSmall &&
        hasCode(estimate.faults(), "too-many-elements")) {
        estimate = scaledUp(job, *prepared, progress);
    }
    if (estimate) {
        estimate->bytes = bytesFor(estimate->elements, job.options);
        estimate->boundaryEdges = prepared->boundary->segments.size();
        estimate->secondsPrepare = secondsPrepare;
        estimate->seconds += secondsPrepare;
    }
    return estimate;
}

} // namespace forefront
