#include "core/engine/session/whole_run.hpp"

#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <utility>
#include <vector>

namespace forefront {

bool canStep(const MeshingOptions &options) {
    return options.elements == Elements::Triangles;
}

Result<WholeRun> WholeRun::make(const MeshingJob &job, PreparedJob prepared, std::uint64_t number,
                                const Progress &progress) {
    MeshingState state{.job = job};
    state.prepared = std::move(prepared);
    WholeRun run;
    CpuClock clock(CpuClock::Of::Program);
    for (const auto stages : {stagesOfFront(), stagesAfterFront()}) {
        for (const Stage &stage : stages) {
            if (Status faults = runStages({&stage, 1}, state, progress); !faults.empty()) {
                return faults;
            }
            (stage.time == StageTime::Improve ? run.secondsImprove_ : run.secondsMesh_) += clock.lap();
        }
    }
    run.work_ = state.work;
    run.improved_ = job.options.improve != ImproveLevel::None;
    run.finished_ = takeFinished(state, number);
    run.prepared_ = std::move(state.prepared);
    return run;
}

void WholeRun::fill(SessionSnapshot &snapshot, SnapshotLayers layers) const {
    snapshot.boundary = prepared_.boundary;
    snapshot.spacing = prepared_.spacing;
    snapshot.layers = prepared_.layerReport();
    snapshot.requestedElements = prepared_.requestedElements;
    snapshot.coarsening = prepared_.coarsening;
    snapshot.stepped = false;
    snapshot.complete = true;
    snapshot.improved = improved_;
    snapshot.work = work_;
    snapshot.secondsMesh = secondsMesh_;
    snapshot.secondsImprove = secondsImprove_;
    snapshot.meshHash = finished_.hash;
    finished_.fill(snapshot);
    if (!layers.mesh) {
        snapshot.mesh = nullptr;
    }
}

} // namespace forefront
