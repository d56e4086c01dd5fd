#include "core/engine/session/session_worker.hpp"

#include "core/engine/pipeline/pipeline.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <utility>

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
            if (mailbox_.take(command, run_ ? run_->travel().workDue() : std::nullopt)) {
                quiet_ = quiet_ && (std::holds_alternative<LayersCommand>(command) ||
                                    std::holds_alternative<BreakpointsCommand>(command)); // the user takes over
                std::visit([this](const auto &c) { execute(c); }, command);
            } else if (run_ && !run_->travel().resting() && mailbox_.open()) {
                follow(run_->travel().work());
            }
        } catch (const std::bad_alloc &) {
            fail(outOfMemory());
        } catch (const std::exception &thrown) {
            fail(error("callback-failed", std::string("a function of the job threw an exception: ") + thrown.what()));
        } catch (...) {
            fail(error("callback-failed", "a function of the job threw an exception"));
        }
    }
}

/// Discards the run, of which an advance may be half done.
void SessionWorker::fail(Diagnostics faults) {
    mailbox_.endBlocking();
    execute(ClearCommand{});
    diagnostics_ = std::move(faults);
    rest(RunState::Failed);
}

void SessionWorker::execute(const StartCommand &command) {
    if (!run_) {
        execute(ClearCommand{});
    }
    const RunState before = state_;
    number_ = command.number;
    diagnostics_.clear();
    quiet_ = command.mode == StartMode::RunQuiet;
    // The front of quadrilaterals is chosen here as well, so that the previous mesh is replaced only once that is done.
    const Progress progress = progressInto(RunState::Preparing, mailbox_.beginBlocking(Blocking::Preparing));
    progress("validating", 0.0);
    Result<SteppedJob> prepared = prepareStepped(*command.job, progress, command.budget);
    mailbox_.endBlocking();
    if (!prepared) {
        keepPrevious(before, progress.cancelled(), prepared.faults());
        return;
    }
    forget();
    shownNumber_ = number_;
    startStepped(command, *std::move(prepared));
}

void SessionWorker::startStepped(const StartCommand &command, SteppedJob prepared) {
    quiet_ = quiet_ && prepared.prepared.estimatedElements <= kQuietElements;
    run_.emplace(command.job, std::move(prepared), number_);
    run_->travel().setBreakpoints(breakpoints_);
    run_->awaitImprovement();
    improvement_ = command.improvement;
    if (improvement_ == ImprovementPace::Steps && command.mode != StartMode::RunQuiet) {
        run_->stepImprovement();
    }
    stage_ = "advancing the front";
    if (command.mode != StartMode::Pause) {
        execute(FinishCommand{});
        return;
    }
    lookAhead();
    if (command.position > 0) {
        execute(SeekCommand{command.position});
    } else {
        rest(RunState::Paused);
    }
}

/// Finds out how long the run is, if that takes a moment: the timeline then has its whole length from the start.
void SessionWorker::lookAhead() {
    constexpr double kAdvances = 4.0, kMore = 1000.0; // far more than a run has for each predicted element
    const double predicted = run_->prepared().estimatedElements;
    if (predicted <= kQuietElements) {
        run_->travel().lookAhead(static_cast<std::uint64_t>(kAdvances * predicted + kMore));
    }
}

void SessionWorker::keepPrevious(RunState before, bool cancelled, Diagnostics faults) {
    diagnostics_ = cancelled ? Diagnostics{} : std::move(faults);
    if (run_) {
        rest(before == RunState::Running ? RunState::Paused : before);
    } else {
        rest(cancelled ? RunState::Cancelled : RunState::Failed);
    }
}

void SessionWorker::execute(const ClearCommand &) {
    forget();
    rest(RunState::Empty);
}

void SessionWorker::forget() {
    run_.reset();
    stageProgress_ = 0.0;
    diagnostics_.clear();
    stage_.clear();
    shownNumber_ = 0;
}

void SessionWorker::execute(const CancelCommand &) {
    if (run_ && !run_->travel().resting()) {
        rest(RunState::Cancelled);
    }
}

void SessionWorker::execute(const PauseCommand &) {
    if (run_ && !run_->travel().resting()) {
        rest(RunState::Paused);
    }
}

void SessionWorker::execute(const LayersCommand &command) {
    const bool changed = !(layers_ == command.layers);
    layers_ = command.layers;
    if (changed) {
        publish(!run_ || run_->travel().resting());
    }
}

void SessionWorker::execute(const FinishCommand &) {
    if (run_) {
        beginMove();
        follow(run_->travel().reachEnd());
    }
}

void SessionWorker::execute(const SeekCommand &command) {
    if (run_ && beginTravel()) {
        follow(run_->travel().reach(command.advance));
    }
}

void SessionWorker::execute(const SeekStopCommand &command) {
    if (run_ && beginTravel()) {
        follow(run_->travel().reachStop(command.forward));
    }
}

void SessionWorker::execute(const SeekBirthCommand &command) {
    if (run_ && beginTravel()) {
        follow(run_->travel().reachBirth(command.place, command.tolerance));
    }
}

void SessionWorker::execute(const BreakpointsCommand &command) {
    breakpoints_ = command.breakpoints;
    if (run_) {
        run_->travel().setBreakpoints(breakpoints_);
    }
}

void SessionWorker::execute(const StepCommand &command) {
    if (run_ && command.count != 0 && beginTravel()) {
        follow(run_->travel().step(command.granularity, command.count));
    }
}

void SessionWorker::execute(const PlayCommand &command) {
    if (!run_ || command.rate == 0.0) {
        execute(PauseCommand{});
        return;
    }
    if (beginTravel()) {
        run_->travel().play(command.rate);
        publish(false);
    }
}

bool SessionWorker::beginTravel() {
    const bool ready = improvement_ == ImprovementPace::AtOnce || recordImprovement();
    if (ready) {
        beginMove();
    }
    return ready;
}

bool SessionWorker::recordImprovement() {
    if (!run_->improved()) {
        run_->stepImprovement();
    }
    if (run_->stepsImprovement()) {
        return true;
    }
    const Progress progress = progressInto(RunState::Improving, mailbox_.beginBlocking(Blocking::Recording));
    const Status faults = run_->recordImprovement(progress);
    mailbox_.endBlocking();
    if (!faults.empty()) {
        rest(RunState::Finished);
    }
    return faults.empty();
}

void SessionWorker::beginMove() {
    state_ = RunState::Running;
    stage_ = "advancing the front";
    lastPublish_ = Clock::now(); // a short move shows only its target
}

void SessionWorker::follow(Outcome outcome) {
    if (outcome != Outcome::Still) {
        if (Diagnostics excess = run_->excess(); !excess.empty()) {
            fail(std::move(excess));
            return;
        }
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
    case Outcome::FrontDone:
        improveMesh();
        break;
    }
}

void SessionWorker::arrive() {
    rest(run_->travel().atEnd() ? RunState::Finished : RunState::Paused);
}

void SessionWorker::improveMesh() {
    const Progress progress = progressInto(RunState::Improving, mailbox_.beginBlocking(Blocking::Improving));
    Status faults = run_->improve(progress);
    mailbox_.endBlocking();
    const bool done = faults.empty();
    if (!done && !progress.cancelled()) {
        fail(std::move(faults));
        return;
    }
    if (!done) {
        state_ = RunState::Running;
        return; // the command that stopped it is next, and may continue the move
    }
    state_ = RunState::Running;
    stage_ = "advancing the front";
    follow(run_->travel().work()); // the rest of the move
}

void SessionWorker::rest(RunState state) {
    if (run_) {
        run_->travel().rest();
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
    snapshot->run = number_;
    snapshot->shownRun = shownNumber_;
    snapshot->state = state_;
    snapshot->diagnostics = diagnostics_;
    snapshot->stage = stage_;
    snapshot->progress = stageProgress_;
    if (run_) {
        run_->fill(*snapshot, layers_, resting);
        if (state_ != RunState::Improving && state_ != RunState::Preparing) {
            snapshot->progress = run_->travel().timeline().complete() ? 1.0 : frontProgress();
        }
    }
    mailbox_.deliver(std::move(snapshot));
    lastPublish_ = Clock::now();
    publishCost_ = lastPublish_ - begin;
    if (wake_) {
        wake_();
    }
}

/// Returns the progress of the front, an estimate, since the number of elements is known only at the end.
double SessionWorker::frontProgress() const {
    return std::min(0.99, static_cast<double>(run_->travel().timeline().position()) /
                              (run_->prepared().estimatedElements + 1.0));
}

} // namespace forefront
