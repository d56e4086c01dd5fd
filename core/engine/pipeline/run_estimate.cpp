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

/// Returns the number of edges between the domain and its outside.
std::uint64_t outerEdges(const DiscreteDomain &boundary) {
    return static_cast<std::uint64_t>(
        std::count_if(boundary.segments.begin(), boundary.segments.end(), [](const DiscreteSegment &segment) {
            return (segment.leftRegion == kOutside) != (segment.rightRegion == kOutside);
        }));
}

} // namespace

Result<RunEstimate> estimateRun(const MeshingJob &job, const Progress &progress) {
    CpuClock clock(CpuClock::Of::Program);
    const Result<PreparedJob> prepared = planMesh(job, progress);
    if (!prepared) {
        return prepared.faults();
    }
    RunEstimate estimate;
    estimate.secondsPrepare = clock.lap();
    const Result<double> each = secondsPerElement(job.options, progress);
    if (!each) {
        return each.faults();
    }
    const auto inLayers = prepared->layers ? static_cast<double>(prepared->layers->cells.size()) : 0.0;
    const bool quads = makesQuads(job.options);
    const double triangles = std::max(0.0, prepared->estimatedElements - inLayers);
    const double free = triangles / (quads ? kTrianglesPerQuad : 1.0);
    estimate.elements = std::max(1.0, std::round(free + inLayers));
    estimate.boundaryEdges = prepared->boundary->segments.size();
    // Euler's formula for a domain with one outline; holes change it by one node each.
    const auto outer = static_cast<double>(outerEdges(*prepared->boundary));
    const double corners = (quads ? free : 0.5 * free) + inLayers + 0.5 * outer + 1.0;
    const double edges = corners + estimate.elements - 1.0;
    const bool second = job.options.order == ElementOrder::Second;
    const bool centres = second && quads && job.options.quadNodes == QuadNodes::Nine;
    estimate.nodes = std::round(corners + (second ? edges : 0.0) + (centres ? free : 0.0));
    estimate.bytes =
        estimate.elements * ((quads ? kBytesPerQuad : kBytesPerTriangle) + (second ? kBytesPerSecondOrder : 0.0));
    estimate.seconds = estimate.secondsPrepare + *each * estimate.elements;
    return estimate;
}

} // namespace forefront
