#include "core/engine/session/stepped_run.hpp"

#include "core/engine/pipeline/stages.hpp"
#include "core/engine/session/whole_run.hpp"

#include <utility>

namespace forefront {

Result<PreparedJob> prepareStepped(const MeshingJob &job, const Progress &progress, double budget) {
    if (!canStep(job.options)) {
        return error("not-stepped", "a mesh of quadrilaterals cannot be stepped; expected triangles",
                     "choose triangles, or make the whole mesh with meshDomain() or forefront mesh --elements");
    }
    return prepare(job, progress, budget);
}

SteppedRun::SteppedRun(std::shared_ptr<const MeshingJob> job, PreparedJob prepared, std::uint64_t number)
    : job_(std::move(job)), prepared_(std::move(prepared)), number_(number),
      travel_(Mesher::create(prepared_.boundary, prepared_.spacing, job_->options)), builder_((number + 1) << 32U) {}

Diagnostics SteppedRun::excess() const {
    const bool exceeds = travel_.timeline().mesher().state().elements.size() > elementsToStopAt(job_->options);
    return exceeds ? stoppedFront(prepared_, job_->options) : Diagnostics{};
}

Status SteppedRun::improve(const Progress &progress) {
    MeshingState state{.job = *job_, .prepared = prepared_};
    state.triangles = toMesh(travel_.timeline().mesher().state(), *prepared_.boundary);
    if (Status faults = runStages(stagesAfterFront(), state, progress); !faults.empty()) {
        return faults;
    }
    secondsImprove_ = state.improvement.seconds;
    final_ = takeFinished(state, number_);
    return {};
}

void SteppedRun::fill(SessionSnapshot &snapshot, SnapshotLayers layers, bool resting) {
    snapshot.boundary = prepared_.boundary;
    snapshot.spacing = prepared_.spacing;
    snapshot.requestedElements = prepared_.requestedElements;
    snapshot.coarsening = prepared_.coarsening;
    snapshot.secondsImprove = secondsImprove_;
    if (layers.explanation) {
        const TimelineTravel::Moment moment = travel_.explain();
        snapshot.explanation = moment.advance;
        snapshot.eventCursor = moment.cursor;
        snapshot.eventCount = moment.advance ? moment.advance->events.size() : 0;
    }
    if (resting) {
        snapshot.stop = travel_.stop();
        snapshot.birth = travel_.birth();
    }
    const bool final = improved() && travel_.atEnd();
    layers.mesh = layers.mesh && !final;
    builder_.fill(snapshot, travel_.timeline(), layers, resting);
    if (final) {
        final_.fill(snapshot);
        snapshot.improved = job_->options.improve != ImproveLevel::None;
    }
    snapshot.rate = travel_.rate();
    snapshot.playing = travel_.playing();
    snapshot.secondsMesh = travel_.seconds();
    snapshot.meshHash = final_.hash;
}

} // namespace forefront
