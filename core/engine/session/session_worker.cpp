#include "core/engine/session/session_worker.hpp"

#include "core/engine/improve/improve.hpp"
#include "core/engine/mesher/pipeline.hpp"

#include <algorithm>
#include <limits>
#include <new>

namespace forefront {

namespace {

using namespace std::chrono_literals;

/// Minimum time between snapshots, that of a frame.
constexpr auto kFrame = 16ms;

} // namespace

SessionWorker::SessionWorker(std::function<void()> wake) : wake_(std::move(wake)) {
    thread_ = std::jthread([this] { loop(); });
}

SessionWorker::~SessionWorker() {
    mailbox_.close();
}

void SessionWorker::loop() {
    while (mailbox_.open()) {
        SessionCommand command = PauseCommand{};
        try {
            if (mailbox_.take(command, travel_ ? travel_->workDue() : std::nullopt)) {
                quiet_ = quiet_ && (std::holds_alternative<LayersCommand>(command) ||
                                    std::holds_alternative<BreakpointsCommand>(command)); // the user takes over
                std::visit([this](const auto &c) { execute(c); }, command);
            } else if (travel_ && !travel_->resting() && mailbox_.open()) {
                follow(travel_->work());
            }
        } catch (const std::bad_alloc &) {
            runOutOfMemory();
        }
    }
}

/// Discards the run and reports that memory ran out.
void SessionWorker::runOutOfMemory() {
    mailbox_.endBlocking();
    execute(ClearCommand{});
    diagnostics_ = outOfMemory();
    rest(RunState::Failed);
}

/// Discards the run, whose estimated number of elements was too low, and reports that.
void SessionWorker::stopTooLarge() {
    const PreparedJob prepared{boundary_, spacing_, estimatedElements_, requestedElements_, coarsening_};
    Diagnostics faults = stoppedFront(prepared, job_->options);
    execute(ClearCommand{});
    diagnostics_ = std::move(faults);
    rest(RunState::Failed);
}

void SessionWorker::execute(const StartCommand &command) {
    if (!travel_) {
        execute(ClearCommand{});
    }
    const RunState before = state_;
    ++run_;
    diagnostics_.clear();
    quiet_ = command.mode == StartMode::RunQuiet;
    const Progress progress = progressInto(RunState::Preparing, mailbox_.beginBlocking(Blocking::Preparing));
    progress("validating", 0.0);
    Result<PreparedJob> prepared = prepare(*command.job, progress, command.budget);
    mailbox_.endBlocking();
    if (!prepared) {
        const bool cancelled = progress.cancelled();
        diagnostics_ = cancelled ? Diagnostics{} : prepared.faults();
        // The previous run, if any, stays as it was but stops playing.
        rest(travel_ ? (before == RunState::Running ? RunState::Paused : before)
                     : (cancelled ? RunState::Cancelled : RunState::Failed));
        return;
    }
    forget();
    job_ = command.job;
    shownRun_ = run_;
    spacing_ = prepared->spacing;
    boundary_ = prepared->boundary;
    estimatedElements_ = prepared->estimatedElements;
    requestedElements_ = prepared->requestedElements;
    coarsening_ = prepared->coarsening;
    quiet_ = quiet_ && estimatedElements_ <= kQuietElements;
    travel_.emplace(Mesher::create(boundary_, spacing_, job_->options));
    travel_->setBreakpoints(breakpoints_);
    stage_ = "advancing the front";
    if (command.mode != StartMode::Pause) {
        execute(FinishCommand{});
    } else {
        rest(RunState::Paused);
    }
}

void SessionWorker::execute(const ClearCommand &) {
    forget();
    rest(RunState::Empty);
}

void SessionWorker::forget() {
    travel_.reset();
    job_.reset();
    spacing_.reset();
    boundary_.reset();
    finalMesh_.reset();
    finalHash_ = 0;
    builder_ = SnapshotBuilder((run_ + 1) << 32);
    stageProgress_ = 0.0;
    improvementStopped_ = false;
    diagnostics_.clear();
    secondsImprove_ = requestedElements_ = 0.0;
    coarsening_ = 1.0;
    stage_.clear();
    shownRun_ = 0;
}

void SessionWorker::execute(const CancelCommand &) {
    if (travel_ && (!travel_->resting() || improvementStopped_)) {
        rest(RunState::Cancelled);
    }
}

void SessionWorker::execute(const PauseCommand &) {
    if (travel_ && !travel_->resting()) {
        rest(RunState::Paused);
    }
}

void SessionWorker::execute(const LayersCommand &command) {
    const bool changed = !(layers_ == command.layers);
    layers_ = command.layers;
    if (changed) {
        publish(!travel_ || travel_->resting());
    }
}

void SessionWorker::execute(const FinishCommand &) {
    if (travel_) {
        beginMove();
        follow(travel_->reachEnd());
    }
}

void SessionWorker::execute(const SeekCommand &command) {
    if (travel_) {
        beginMove();
        follow(travel_->reach(command.advance));
    }
}

void SessionWorker::execute(const SeekStopCommand &command) {
    if (travel_) {
        beginMove();
        follow(travel_->reachStop(command.forward));
    }
}

void SessionWorker::execute(const SeekBirthCommand &command) {
    if (travel_) {
        beginMove();
        follow(travel_->reachBirth(command.place, command.tolerance));
    }
}

void SessionWorker::execute(const BreakpointsCommand &command) {
    breakpoints_ = command.breakpoints;
    if (travel_) {
        travel_->setBreakpoints(breakpoints_);
    }
}

void SessionWorker::execute(const StepCommand &command) {
    if (travel_ && command.count != 0) {
        beginMove();
        follow(travel_->step(command.granularity, command.count));
    }
}

void SessionWorker::execute(const PlayCommand &command) {
    if (!travel_ || command.rate == 0.0) {
        execute(PauseCommand{});
        return;
    }
    beginMove();
    travel_->play(command.rate);
    publish(false);
}

void SessionWorker::beginMove() {
    improvementStopped_ = false;
    state_ = RunState::Running;
    stage_ = "advancing the front";
    lastPublish_ = Clock::now(); // a short move shows only its target
}

void SessionWorker::follow(Outcome outcome) {
    if (outcome != Outcome::Still &&
        travel_->timeline().mesher().state().elements.size() > elementsToStopAt(job_->options)) {
        stopTooLarge();
        return;
    }
    switch (outcome) {
    case Outcome::Still:
        break;
    case Outcome::Moved:
        publishIfDue();
        break;
    case Outcome::Arrived:
        arrive();
        break;
    }
}

/// Stops on the timeline. At its end, the mesh is improved once.
void SessionWorker::arrive() {
    if (!travel_->atEnd()) {
        rest(RunState::Paused);
    } else if (finalMesh_) {
        rest(RunState::Finished);
    } else {
        improveMesh();
    }
}

void SessionWorker::improveMesh() {
    Mesh mesh = toMesh(travel_->timeline().mesher().state(), *boundary_);
    if (job_->options.improve != ImproveLevel::None) {
        const Progress progress = progressInto(RunState::Improving, mailbox_.beginBlocking(Blocking::Improving));
        progress("improving", 0.0);
        secondsImprove_ =
            improve(mesh, {job_->options.improve, job_->options.threads, spacing_.get()}, progress).seconds;
        mailbox_.endBlocking();
        if (progress.cancelled()) {
            improvementStopped_ = true;
            rest(RunState::Paused);
            return;
        }
    }
    finishWith(std::move(mesh));
}

void SessionWorker::finishWith(Mesh mesh) {
    auto view = std::make_shared<MeshView>();
    view->alpha = shapeFactors(mesh);
    finalQuality_ = measure(mesh, spacing_.get());
    finalHash_ = meshHash(mesh);
    view->mesh = std::move(mesh);
    view->version = std::numeric_limits<std::uint64_t>::max() - run_;
    finalMesh_ = std::move(view);
    rest(RunState::Finished);
}

void SessionWorker::rest(RunState state) {
    if (travel_) {
        travel_->rest();
    }
    state_ = state;
    publish(true);
}

Progress SessionWorker::progressInto(RunState state, std::stop_token stop) {
    Progress progress;
    progress.stop = std::move(stop);
    progress.report = [this, state](std::string_view stage, double fraction) {
        const bool newStage = stage_ != stage;
        state_ = state;
        stage_ = stage;
        stageProgress_ = fraction;
        if (newStage || Clock::now() - lastPublish_ > 50ms) {
            publish(false);
        }
    };
    return progress;
}

void SessionWorker::publishIfDue() {
    // Copying large meshes takes at most a quarter of the time.
    if (Clock::now() - lastPublish_ > std::max<Clock::duration>(kFrame, 4 * publishCost_)) {
        publish(false);
    }
}

void SessionWorker::publish(bool resting) {
    if (quiet_ && !resting) {
        return;
    }
    const auto begin = Clock::now();
    auto snapshot = std::make_shared<SessionSnapshot>();
    snapshot->sequence = ++sequence_;
    snapshot->run = run_;
    snapshot->shownRun = shownRun_;
    snapshot->state = state_;
    snapshot->diagnostics = diagnostics_;
    snapshot->stage = stage_;
    snapshot->progress = stageProgress_;
    snapshot->secondsImprove = secondsImprove_;
    snapshot->boundary = boundary_;
    snapshot->spacing = spacing_;
    snapshot->requestedElements = requestedElements_;
    snapshot->coarsening = coarsening_;
    if (travel_) {
        fillFromRun(*snapshot, resting);
    }
    mailbox_.deliver(std::move(snapshot));
    lastPublish_ = Clock::now();
    publishCost_ = lastPublish_ - begin;
    if (wake_) {
        wake_();
    }
}

void SessionWorker::fillFromRun(SessionSnapshot &snapshot, bool resting) {
    if (layers_.explanation) {
        const TimelineTravel::Moment moment = travel_->explain();
        snapshot.explanation = moment.advance;
        snapshot.eventCursor = moment.cursor;
        snapshot.eventCount = moment.advance ? moment.advance->events.size() : 0;
    }
    if (resting) {
        snapshot.stop = travel_->stop();
        snapshot.birth = travel_->birth();
    }
    const bool final = finalMesh_ && travel_->atEnd();
    SnapshotLayers layers = layers_;
    layers.mesh = layers.mesh && !final;
    builder_.fill(snapshot, travel_->timeline(), layers, resting);
    if (final) {
        snapshot.mesh = finalMesh_;
        snapshot.quality = finalQuality_;
        snapshot.improved = job_->options.improve != ImproveLevel::None;
    }
    if (state_ != RunState::Improving && state_ != RunState::Preparing) {
        snapshot.progress = travel_->timeline().complete() ? 1.0 : frontProgress();
    }
    snapshot.rate = travel_->rate();
    snapshot.playing = travel_->playing();
    snapshot.secondsMesh = travel_->seconds();
    snapshot.meshHash = finalHash_;
}

/// Returns the progress of the front, an estimate, since the number of elements is known only at the end.
double SessionWorker::frontProgress() const {
    return std::min(0.99, static_cast<double>(travel_->timeline().position()) / (estimatedElements_ + 1.0));
}

} // namespace forefront
