#include "core/engine/session/stepped_run.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <utility>

namespace forefront {

Result<SteppedJob> prepareStepped(const MeshingJob &job, const Progress &progress, double budget) {
    Result<PreparedJob> prepared = prepare(job, progress, budget);
    if (!prepared) {
        return prepared.faults();
    }
    SteppedJob stepped{*std::move(prepared), std::nullopt};
    if (makesQuads(job.options)) {
        MeshingState state{.job = job, .prepared = std::move(stepped.prepared)};
        Result<QuadStart> start = chooseQuadFront(state, progress);
        if (!start) {
            return start.faults();
        }
        stepped = {std::move(state.prepared), *std::move(start)};
    }
    return stepped;
}

namespace {

std::unique_ptr<Mesher> mesherOf(const MeshingJob &job, const PreparedJob &prepared,
                                 const std::optional<QuadStart> &quads) {
    return quads ? ColouredMesher::create(quads->boundary, prepared.spacing, job.options, rowsOfFront(quads->lattice))
                 : Mesher::create(prepared.frontBoundary(), prepared.spacing, job.options);
}

} // namespace

SteppedRun::SteppedRun(std::shared_ptr<const MeshingJob> job, SteppedJob prepared, std::uint64_t number)
    : job_(std::move(job)), prepared_(std::move(prepared.prepared)), quads_(std::move(prepared.quads)), number_(number),
      travel_(mesherOf(*job_, prepared_, quads_)), builder_((number + 1) << 32U) {}

Diagnostics SteppedRun::excess() const {
    const std::size_t made = travel_.timeline().mesher().state().elements.size() / (quads_ ? 2 : 1);
    const bool exceeds = made > elementsToStopAt(job_->options);
    return exceeds ? stoppedFront(prepared_, job_->options) : Diagnostics{};
}

Status SteppedRun::improve(const Progress &progress) {
    MeshingState state{.job = *job_, .prepared = prepared_};
    std::optional<ImproveRecord> record;
    if (quads_) {
        joinQuads(state, stepsImprovement_);
    } else {
        state.triangles = meshOfFront();
        record = stepsImprovement_ ? recordFor(state.triangles) : std::nullopt;
        state.watch = record ? &*record : nullptr;
    }
    CpuClock clock;
    if (Status faults = runStages(stagesAfterFront(), state, progress); !faults.empty()) {
        return faults;
    }
    secondsImprove_ = quads_ ? clock.lap() : state.improvement.seconds; // the clean-up of quadrilaterals has no report
    final_ = takeFinished(state, number_);
    if (stepsImprovement_) {
        quads_ ? takeQuadSteps() : takeSteps(std::move(record));
    } else {
        travel_.setImprovement(0, {});
    }
    return {};
}

Status SteppedRun::recordImprovement(const Progress &progress) {
    FOREFRONT_ASSERT(improved() && travel_.atEnd());
    MeshingState state{.job = *job_, .prepared = prepared_};
    if (quads_) {
        joinQuads(state, true);
        if (improves()) {
            quadCleanupStage(state, progress);
        }
        if (progress.cancelled()) {
            quadRecord_.reset();
            return cancelled("the record of the clean-up");
        }
        stepsImprovement_ = true;
        takeQuadSteps();
        return {};
    }
    state.triangles = meshOfFront();
    std::optional<ImproveRecord> record = recordFor(state.triangles);
    if (record) {
        state.watch = &*record;
        if (Status faults = improveStage(state, progress); !faults.empty()) {
            return faults;
        }
        if (progress.cancelled()) {
            return cancelled("the record of the improvement");
        }
    }
    stepsImprovement_ = true;
    takeSteps(std::move(record));
    return {};
}

TriMesh SteppedRun::meshOfFront() const {
    return toMesh(travel_.timeline().mesher().state(), *prepared_.frontBoundary());
}

std::optional<ImproveRecord> SteppedRun::recordFor(const TriMesh &mesh) const {
    const bool stepped = improves() && mesh.elements.size() <= kSteppedElements;
    return stepped ? std::optional<ImproveRecord>(std::in_place, mesh) : std::nullopt;
}

void SteppedRun::takeSteps(std::optional<ImproveRecord> record) {
    record_ = std::move(record);
    std::vector<std::size_t> passEnds = record_ ? record_->passEnds() : std::vector<std::size_t>{};
    std::size_t steps = record_ ? record_->steps() : 0;
    if (completes() || (improves() && !record_)) {
        passEnds.push_back(++steps);
    }
    travel_.setImprovement(steps, std::move(passEnds));
}

bool SteppedRun::completes() const {
    return (job_->options.leastAngle && !quads_) || prepared_.layers || job_->options.order == ElementOrder::Second ||
           !job_->cracks.empty();
}

const ColouredMesher &SteppedRun::colouredMesher() const {
    return static_cast<const ColouredMesher &>(travel_.timeline().mesher()); // as mesherOf() made it
}

void SteppedRun::joinQuads(MeshingState &state, bool records) {
    const ColouredMesher &front = colouredMesher();
    quadRecord_.reset();
    if (front.boundary().segments.empty()) { // mapped faces fill the domain
        return;
    }
    ColouredTriangles triangles = front.triangles();
    if (records) {
        const bool single = triangles.mesh.elements.size() / 2 <= kSteppedElements;
        quadRecord_.emplace(front.joinedCells(), front.boundary(),
                            single ? QuadRecord::Detail::Changes : QuadRecord::Detail::Passes);
        state.quadWatch = &*quadRecord_;
    }
    state.quads = joinFront(std::move(triangles), front, job_->options, state.quadWatch);
    state.quads.report.lattice = quads_->lattice;
}

void SteppedRun::takeQuadSteps() {
    std::vector<std::size_t> passEnds = quadRecord_ ? quadRecord_->passEnds() : std::vector<std::size_t>{};
    std::size_t steps = quadRecord_ ? quadRecord_->steps() : 0;
    if (completes() || !quadRecord_) {
        passEnds.push_back(++steps);
    }
    travel_.setImprovement(steps, std::move(passEnds));
}

Mesh SteppedRun::meshOfStep(std::size_t number) {
    if (quadRecord_) {
        quadRecord_->moveTo(number);
        return quadRecord_->mesh();
    }
    record_->moveTo(number);
    return Mesh(record_->mesh());
}

void SteppedRun::stepImprovement() {
    stepsImprovement_ = true;
    travel_.awaitImprovement();
}

/// Returns the step that led to the position, within the improvement. The last one may be more than the record has.
std::shared_ptr<const ImproveStep> SteppedRun::lastStep() {
    const std::size_t number = travel_.improveStep();
    if (record_ && number <= record_->steps()) {
        record_->moveTo(number);
        return std::make_shared<const ImproveStep>(record_->step());
    }
    if (quadRecord_ && number <= quadRecord_->steps()) {
        quadRecord_->moveTo(number);
        return std::make_shared<const ImproveStep>(quadRecord_->step());
    }
    auto step = std::make_shared<ImproveStep>();
    if (quads_) {
        step->change = ImproveChange::Completion;
        step->number = number;
        step->quads = true;
        step->measured = quadRecord_.has_value();
        if (quadRecord_) {
            quadRecord_->moveTo(quadRecord_->steps());
            step->quadsBefore = step->quadsAfter = quadRecord_->figures(); // of the part that the front made
        }
        return step;
    }
    step->change = record_ || !improves() ? ImproveChange::Completion : ImproveChange::Remainder;
    step->number = number;
    if (record_) {
        record_->moveTo(record_->steps());
        step->before = record_->figures();
    } else {
        step->before = figuresOf(meshOfFront());
    }
    step->after = figuresOf(final_.quality);
    return step;
}

/// Returns the figures that follow from the shapes alone; of quadrilaterals all figures.
MeshQuality SteppedRun::shapesOfStep(std::size_t number) {
    if (quadRecord_) {
        return measureQuality(meshOfStep(number), prepared_.spacing.get());
    }
    record_->moveTo(number);
    return record_->shapes();
}

/// Fills in the mesh after a step of the improvement, before its last one, and what the step changed.
void SteppedRun::fillStep(SessionSnapshot &snapshot, bool withMesh, bool resting) {
    const std::size_t number = travel_.improveStep();
    if (!step_ || shownStep_ != number) {
        shownStep_ = number;
        step_ = lastStep();
        stepMesh_.reset();
        stepShapes_.reset();
        stepQuality_.reset();
    }
    snapshot.improvement = step_;
    if (travel_.atEnd()) {
        return;
    }
    if (!stepMesh_ && withMesh) {
        std::shared_ptr<MeshSnapshot> view = snapshotOf(meshOfStep(number));
        constexpr std::uint64_t kOfSteps = std::uint64_t{1} << 31U; // the front has fewer versions
        view->version = ((number_ + 1) << 32U) + kOfSteps + number;
        stepMesh_ = std::move(view);
    }
    const bool measured = withMesh && resting;
    if (measured && !stepQuality_) {
        stepQuality_ = measureQuality(stepMesh_->view(), prepared_.spacing.get());
    }
    if (!stepShapes_) {
        stepShapes_ = shapesOfStep(number);
    }
    snapshot.mesh = withMesh ? stepMesh_ : nullptr;
    snapshot.quality = measured ? *stepQuality_ : *stepShapes_;
    snapshot.stateHash = measured ? meshHash(stepMesh_->view()) : 0;
}

void SteppedRun::fill(SessionSnapshot &snapshot, SnapshotLayers layers, bool resting) {
    snapshot.boundary = prepared_.boundary;
    snapshot.spacing = prepared_.spacing;
    snapshot.layers = prepared_.layerReport();
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
    const bool withMesh = layers.mesh;
    layers.mesh = layers.mesh && !final && travel_.improveStep() == 0;
    builder_.fill(snapshot, travel_.timeline(), layers, resting);
    snapshot.improveStep = travel_.improveStep();
    snapshot.improveSteps = travel_.improveSteps();
    if (travel_.improveStep() > 0 && (!final || travel_.stepped())) {
        fillStep(snapshot, withMesh, resting);
    }
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
