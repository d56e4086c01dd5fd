#include "core/engine/pipeline/pipeline.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <chrono>
#include <new>
#include <utility>

namespace forefront {

namespace {

/// Adds up the CPU time of a group of stages that it runs.
Status runTimed(std::span<const Stage> stages, MeshingState &state, MeshingOutcome &outcome, CpuClock &clock,
                const Progress &progress) {
    for (const Stage &stage : stages) {
        if (Status faults = runStages({&stage, 1}, state, progress); !faults.empty()) {
            return faults;
        }
        double &seconds = stage.time == StageTime::Prepare ? outcome.secondsPrepare
                          : stage.time == StageTime::Mesh  ? outcome.secondsMesh
                                                           : outcome.secondsImprove;
        const double lap = clock.lap();
        seconds += stage.applies == nullptr || stage.applies(state.job.options) ? lap : 0.0;
    }
    return {};
}

Result<MeshingOutcome> runJob(const MeshingJob &job, const Progress &progress) {
    MeshingState state{.job = job};
    MeshingOutcome outcome;
    CpuClock clock(CpuClock::Of::Program);
    if (Status faults = runTimed(stagesBeforeFront(), state, outcome, clock, progress); !faults.empty()) {
        return faults;
    }
    const auto begin = std::chrono::steady_clock::now();
    for (const auto stages : {stagesOfFront(), stagesAfterFront()}) {
        if (Status faults = runTimed(stages, state, outcome, clock, progress); !faults.empty()) {
            return faults;
        }
    }
    outcome.secondsWall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (state.prepared.layers) {
        outcome.layers = state.prepared.layers->report;
    }
    outcome.boundary = std::move(state.prepared.boundary);
    outcome.spacing = std::move(state.prepared.spacing);
    outcome.work = state.work;
    outcome.improvement = state.improvement;
    outcome.leastAngle = std::move(state.leastAngle);
    outcome.quads = state.prepared.quads; // of regions with shapes of their own
    addReport(outcome.quads, state.quadReport);
    outcome.order = std::move(state.secondOrder);
    outcome.cracks = std::move(state.cracks);
    outcome.mesh = std::move(state.mesh);
    return outcome;
}

Result<PreparedJob> preparedBy(std::span<const Stage> stages, const MeshingJob &job, const Progress &progress,
                               double budget) {
    FOREFRONT_ASSERT(budget > 0.0);
    MeshingState state{.job = job, .budget = budget};
    if (Status faults = runStages(stages, state, progress); !faults.empty()) {
        return faults;
    }
    return std::move(state.prepared);
}

} // namespace

Result<PreparedJob> prepare(const MeshingJob &job, const Progress &progress, double budget) {
    return preparedBy(stagesBeforeFront(), job, progress, budget);
}

Result<PreparedJob> planMesh(const MeshingJob &job, const Progress &progress, double budget) {
    return preparedBy(stagesOfPlan(), job, progress, budget);
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
