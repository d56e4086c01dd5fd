#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/free_memory.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace forefront {

namespace {

/// Returns the number of advances between checks for cancellation, which take a few milliseconds even where each
/// advance looks at all of Γ.
std::uint64_t batchFor(const Mesher &mesher) {
    return std::clamp<std::uint64_t>(10'000'000 / (mesher.state().front.segments() + 1), 16, 4096);
}

/// Advances with several threads, whose memory is then given back.
Status advanceInParallel(Mesher &mesher, const MeshingState &state, unsigned threads, const Progress &progress) {
    const MeshingOptions &options = state.job.options;
    releaseFreeMemory();
    if (!mesher.advanceInParallel(threads, progress, state.prepared.estimatedElements, elementsToStopAt(options))) {
        return progress.cancelled() ? cancelled("meshing") : stoppedFront(state.prepared, options);
    }
    return {};
}

} // namespace

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

Status frontStage(MeshingState &state, const Progress &progress) {
    const PreparedJob &prepared = state.prepared;
    if (prepared.frontBoundary()->segments.empty()) { // mapped faces fill the domain
        state.triangles = nodesOf(*prepared.frontBoundary());
        return {};
    }
    const unsigned threads = state.job.usableThreads();
    std::unique_ptr<Mesher> mesher = Mesher::create(prepared.frontBoundary(), prepared.spacing, state.job.options);
    mesher->reserve(static_cast<std::uint64_t>(Mesher::kReserve * prepared.estimatedElements) + 1024);
    if (threads > 1) {
        if (Status faults = advanceInParallel(*mesher, state, threads, progress); !faults.empty()) {
            return faults;
        }
    }
    if (Status faults = advanceToEnd(*mesher, prepared, state.job.options, "advancing the front", progress);
        !faults.empty()) {
        return faults;
    }
    state.work = mesher->state().work;
    state.triangles = std::move(*mesher).takeMesh();
    mesher.reset();
    if (threads > 1) {
        releaseFreeMemory();
    }
    return {};
}

} // namespace forefront
