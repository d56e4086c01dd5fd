#include "core/session/session_worker.hpp"

#include "core/improve/improve.hpp"
#include "core/mesher/cpu_clock.hpp"
#include "core/mesher/pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace forefront {

namespace {

using namespace std::chrono_literals;

/// A batch of advances takes about a millisecond, so that commands are answered at once.
constexpr std::int64_t kBatch = 512;
constexpr auto kFrame = 16ms;
constexpr std::uint64_t kToTheEnd = std::numeric_limits<std::uint64_t>::max();
/// Playing faster than this, single advances can't be followed and are not explained.
constexpr double kExplainedRate = 120.0;

/// Commands that do not disturb the improvement.
bool outlivesBlocking(const SessionCommand &command) {
    return std::holds_alternative<WantCommand>(command) || std::holds_alternative<FinishCommand>(command);
}

} // namespace

SessionWorker::SessionWorker(std::function<void()> wake) : wake_(std::move(wake)) {
    thread_ = std::jthread([this](const std::stop_token &quit) { loop(quit); });
}

SessionWorker::~SessionWorker() {
    thread_.request_stop();
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.stop.request_stop();
    }
    shared_.changed.notify_all();
    thread_.join();
}

void SessionWorker::push(SessionCommand command) {
    {
        const std::lock_guard lock(shared_.mutex);
        const bool ends = std::holds_alternative<StartCommand>(command) ||
                          std::holds_alternative<ClearCommand>(command) ||
                          std::holds_alternative<CancelCommand>(command);
        if (ends || (shared_.blocking == Blocking::Improving && !outlivesBlocking(command))) {
            shared_.stop.request_stop();
        }
        shared_.commands.push_back(std::move(command));
    }
    shared_.changed.notify_all();
}

std::shared_ptr<const SessionSnapshot> SessionWorker::latest() const {
    const std::lock_guard lock(shared_.mutex);
    return shared_.latest;
}

bool SessionWorker::busy() const {
    const std::lock_guard lock(shared_.mutex);
    return shared_.active || !shared_.commands.empty();
}

/// Waits for a command; while something is under way, only looks whether there is one.
bool SessionWorker::takeCommand(const std::stop_token &quit, SessionCommand &command) {
    std::unique_lock lock(shared_.mutex);
    const auto ready = [&] { return !shared_.commands.empty(); };
    shared_.active = activity_ != Activity::Resting;
    if (activity_ == Activity::Resting) {
        shared_.changed.wait(lock, quit, ready);
    } else if (activity_ == Activity::Playing) {
        shared_.changed.wait_until(lock, quit, lastTick_ + kFrame, ready);
    }
    if (!ready()) {
        return false;
    }
    command = std::move(shared_.commands.front());
    shared_.commands.pop_front();
    shared_.active = true;
    return true;
}

void SessionWorker::loop(const std::stop_token &quit) {
    while (!quit.stop_requested()) {
        SessionCommand command = PauseCommand{};
        try {
            if (takeCommand(quit, command)) {
                std::visit([this](const auto &c) { execute(c); }, command);
            } else if (!quit.stop_requested()) {
                workABatch();
            }
        } catch (const std::bad_alloc &) {
            runOutOfMemory();
        }
    }
}

/// Gives the memory of the run back and says so.
void SessionWorker::runOutOfMemory() {
    endBlocking();
    execute(ClearCommand{});
    diagnostics_ = outOfMemory();
    rest(RunState::Failed);
}

std::stop_token SessionWorker::beginBlocking(Blocking kind) {
    const std::lock_guard lock(shared_.mutex);
    shared_.stop = std::stop_source{};
    const bool replaced =
        std::any_of(shared_.commands.begin(), shared_.commands.end(), [&](const SessionCommand &command) {
            return std::holds_alternative<StartCommand>(command) || std::holds_alternative<ClearCommand>(command) ||
                   std::holds_alternative<CancelCommand>(command) ||
                   (kind == Blocking::Improving && !outlivesBlocking(command));
        });
    if (replaced || thread_.get_stop_token().stop_requested()) {
        shared_.stop.request_stop();
    }
    shared_.blocking = kind;
    return shared_.stop.get_token();
}

void SessionWorker::endBlocking() {
    const std::lock_guard lock(shared_.mutex);
    shared_.blocking = Blocking::Nothing;
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

void SessionWorker::execute(const StartCommand &command) {
    execute(ClearCommand{});
    job_ = command.job;
    ++run_;
    const Progress progress = progressInto(RunState::Preparing, beginBlocking(Blocking::Preparing));
    progress("validating", 0.0);
    Result<PreparedJob> prepared = prepare(*job_, progress);
    endBlocking();
    if (!prepared) {
        const bool cancelled = progress.cancelled();
        diagnostics_ = cancelled ? Diagnostics{} : prepared.faults();
        rest(cancelled ? RunState::Cancelled : RunState::Failed);
        return;
    }
    spacing_ = prepared->spacing;
    boundary_ = prepared->boundary;
    estimatedElements_ = prepared->estimatedElements;
    timeline_ = std::make_unique<Timeline>(Mesher::create(boundary_, spacing_, job_->options));
    stage_ = "advancing the front";
    if (command.runToEnd) {
        reach(kToTheEnd);
    } else {
        rest(RunState::Paused);
    }
}

void SessionWorker::execute(const ClearCommand &) {
    timeline_.reset();
    job_.reset();
    spacing_.reset();
    boundary_.reset();
    finalMesh_.reset();
    finalHash_ = 0;
    builder_ = SnapshotBuilder((run_ + 1) << 32);
    stageProgress_ = 0.0;
    improvementStopped_ = false;
    diagnostics_.clear();
    nextAdvance_.reset();
    eventsDone_ = 0;
    secondsMesh_ = secondsImprove_ = 0.0;
    stage_.clear();
    rest(RunState::Empty);
}

void SessionWorker::execute(const CancelCommand &) {
    if (timeline_ && (activity_ != Activity::Resting || improvementStopped_)) {
        rest(RunState::Cancelled);
    }
}

void SessionWorker::execute(const PauseCommand &) {
    if (timeline_ && activity_ != Activity::Resting) {
        rest(RunState::Paused);
    }
}

void SessionWorker::execute(const WantCommand &command) {
    const bool changed = !(layers_ == command.layers);
    layers_ = command.layers;
    if (changed) {
        publish(activity_ == Activity::Resting);
    }
}

void SessionWorker::execute(const FinishCommand &) {
    reach(kToTheEnd);
}

void SessionWorker::execute(const SeekCommand &command) {
    reach(command.advance);
}

void SessionWorker::execute(const PlayCommand &command) {
    if (!timeline_ || command.rate == 0.0) {
        execute(PauseCommand{});
        return;
    }
    if (command.rate > 0.0 && timeline_->complete() && timeline_->position() == timeline_->known()) {
        move(-static_cast<std::int64_t>(timeline_->position()));
    }
    eventsDone_ = 0;
    rate_ = command.rate;
    owed_ = 0.0;
    lastTick_ = Clock::now();
    activity_ = Activity::Playing;
    state_ = RunState::Running;
    publish(false);
}

void SessionWorker::execute(const StepCommand &command) {
    if (!timeline_ || command.count == 0) {
        return;
    }
    if (command.granularity != Granularity::Advance) {
        settle();
    }
    switch (command.granularity) {
    case Granularity::Event:
        stepEvents(command.count);
        return;
    case Granularity::Layer:
        stepLayers(command.count);
        return;
    case Granularity::Advance:
        break;
    }
    // Steps that come faster than they are done add up.
    const bool underWay = activity_ == Activity::Reaching && target_ != kToTheEnd;
    const std::uint64_t origin = underWay ? target_ : timeline_->position();
    const auto back = static_cast<std::uint64_t>(command.count < 0 ? -command.count : 0);
    // Inside an advance, the first step back leads to its beginning.
    const std::uint64_t inside = eventsDone_ > 0 && back > 0 ? 1 : 0;
    reach(command.count >= 0 ? origin + static_cast<std::uint64_t>(command.count)
                             : origin - std::min(origin, back - inside));
}

/// Goes the rest of a short way before something that starts from where it leads.
void SessionWorker::settle() {
    for (int batch = 0; batch < 64 && activity_ == Activity::Reaching && target_ != kToTheEnd; ++batch) {
        reachABatch();
    }
    activity_ = Activity::Resting;
}

void SessionWorker::stepEvents(std::int64_t count) {
    for (; count > 0; --count) {
        if (eventsDone_ == 0) {
            if (timeline_->mesher().finished()) {
                break;
            }
            nextAdvance_ = std::make_shared<const AdvanceExplanation>(timeline_->mesher().explainNext());
        }
        if (++eventsDone_ >= nextAdvance_->events.size()) {
            eventsDone_ = 0;
            move(1);
        }
    }
    for (; count < 0; ++count) {
        if (eventsDone_ == 0) {
            if (move(-1) == 0) {
                break;
            }
            nextAdvance_ = std::make_shared<const AdvanceExplanation>(timeline_->mesher().explainNext());
            eventsDone_ = nextAdvance_->events.size();
        }
        --eventsDone_;
    }
    if (eventsDone_ == 0 && timeline_->complete() && timeline_->position() == timeline_->known()) {
        arrive();
    } else {
        rest(RunState::Paused);
    }
}

void SessionWorker::stepLayers(std::int64_t count) {
    const std::vector<std::uint64_t> &ends = timeline_->layerEnds();
    const std::uint64_t position = timeline_->position();
    if (count > 0) {
        const auto above = std::upper_bound(ends.begin(), ends.end(), position) - ends.begin();
        reach(kToTheEnd);
        layersWanted_ = static_cast<std::size_t>(above + count);
    } else {
        // Inside an advance, the first step back may lead to where it began.
        const std::uint64_t from = position + (eventsDone_ > 0 ? 1 : 0);
        const auto below = std::lower_bound(ends.begin(), ends.end(), from) - ends.begin();
        const std::int64_t wanted = below + count;
        reach(wanted < 0 ? 0 : ends[static_cast<std::size_t>(wanted)]);
    }
}

/// Sets out for a position; the way there is gone in batches.
void SessionWorker::reach(std::uint64_t position) {
    if (!timeline_) {
        return;
    }
    eventsDone_ = 0;
    layersWanted_ = 0;
    improvementStopped_ = false;
    target_ = position;
    activity_ = Activity::Reaching;
    state_ = RunState::Running;
    stage_ = "advancing the front";
    lastTick_ = Clock::now();
    if (timeline_->position() == target_) {
        reachABatch();
    }
}

void SessionWorker::workABatch() {
    if (activity_ == Activity::Reaching) {
        reachABatch();
    } else if (activity_ == Activity::Playing) {
        playABatch();
    }
}

std::uint64_t SessionWorker::move(std::int64_t advances) {
    CpuClock clock;
    const auto begin = Clock::now();
    const std::uint64_t knownBefore = timeline_->known();
    const std::uint64_t done = advances >= 0 ? timeline_->forward(static_cast<std::uint64_t>(advances))
                                             : timeline_->back(static_cast<std::uint64_t>(-advances));
    if (timeline_->known() > knownBefore) {
        secondsMesh_ += clock.lap();
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (activity_ == Activity::Reaching && seconds > 0.0) {
        measuredRate_ = static_cast<double>(done) / seconds;
    }
    return done;
}

void SessionWorker::reachABatch() {
    if (layersWanted_ > 0 && timeline_->layerEnds().size() >= layersWanted_) {
        target_ = timeline_->layerEnds()[layersWanted_ - 1];
        layersWanted_ = 0;
    }
    const std::uint64_t position = timeline_->position();
    std::uint64_t done = 0;
    if (target_ > position) {
        done = move(static_cast<std::int64_t>(std::min<std::uint64_t>(target_ - position, kBatch)));
    } else if (target_ < position) {
        done = move(-static_cast<std::int64_t>(std::min<std::uint64_t>(position - target_, kBatch)));
    }
    if (timeline_->position() == target_ || done == 0 ||
        (timeline_->complete() && timeline_->position() == timeline_->known())) {
        arrive();
    } else {
        publishIfDue();
    }
}

void SessionWorker::playABatch() {
    const auto now = Clock::now();
    owed_ += rate_ * std::chrono::duration<double>(now - lastTick_).count();
    lastTick_ = now;
    // A slow machine plays slower; it never falls behind without end.
    const double most = 0.05 * std::abs(rate_) + 1.0;
    owed_ = std::clamp(owed_, -most, most);
    const auto due = static_cast<std::int64_t>(owed_);
    if (due == 0) {
        return;
    }
    owed_ -= static_cast<double>(due);
    measuredRate_ = std::abs(rate_);
    std::int64_t left = due;
    while (left != 0 && Clock::now() - now < kFrame) {
        const std::int64_t batch = std::clamp<std::int64_t>(left, -kBatch, kBatch);
        const std::uint64_t done = move(batch);
        left -= batch;
        if (done < static_cast<std::uint64_t>(std::abs(batch))) {
            arrive();
            return;
        }
    }
    if (rate_ > 0.0 && timeline_->complete() && timeline_->position() == timeline_->known()) {
        arrive();
    } else {
        publishIfDue();
    }
}

/// The place set out for: somewhere on the timeline, or its end, where the mesh is improved once.
void SessionWorker::arrive() {
    activity_ = Activity::Resting;
    if (!timeline_->complete() || timeline_->position() != timeline_->known()) {
        rest(RunState::Paused);
    } else if (finalMesh_) {
        rest(RunState::Finished);
    } else {
        improveMesh();
    }
}

void SessionWorker::improveMesh() {
    Mesh mesh = toMesh(timeline_->mesher().state(), *boundary_);
    if (job_->options.improve != ImproveLevel::None) {
        const Progress progress = progressInto(RunState::Improving, beginBlocking(Blocking::Improving));
        progress("improving", 0.0);
        CpuClock clock;
        improve(mesh, {job_->options.improve, job_->options.threads, spacing_.get()}, progress);
        secondsImprove_ = clock.lap();
        endBlocking();
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
    activity_ = Activity::Resting;
    state_ = state;
    publish(true);
}

void SessionWorker::publishIfDue() {
    // Copying a large mesh takes its time: never more than a quarter of all.
    if (Clock::now() - lastPublish_ > std::max<Clock::duration>(kFrame, 4 * publishCost_)) {
        publish(false);
    }
}

void SessionWorker::publish(bool resting) {
    const auto begin = Clock::now();
    auto snapshot = std::make_shared<SessionSnapshot>();
    snapshot->sequence = ++sequence_;
    snapshot->run = run_;
    snapshot->state = state_;
    snapshot->diagnostics = diagnostics_;
    snapshot->stage = stage_;
    snapshot->progress = stageProgress_;
    snapshot->rate = measuredRate_;
    snapshot->secondsMesh = secondsMesh_;
    snapshot->secondsImprove = secondsImprove_;
    snapshot->boundary = boundary_;
    snapshot->spacing = spacing_;
    if (timeline_) {
        const bool atEnd = finalMesh_ && timeline_->position() == timeline_->known() && eventsDone_ == 0;
        SnapshotLayers layers = layers_;
        layers.mesh = layers.mesh && !atEnd;
        explain(*snapshot);
        builder_.fill(*snapshot, *timeline_, layers, resting);
        if (atEnd) {
            snapshot->mesh = finalMesh_;
            snapshot->quality = finalQuality_;
            snapshot->improved = job_->options.improve != ImproveLevel::None;
        }
        if (state_ != RunState::Improving) {
            snapshot->progress = timeline_->complete() ? 1.0 : frontProgress();
        }
        snapshot->meshHash = finalHash_;
    }
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.latest = std::move(snapshot);
    }
    lastPublish_ = Clock::now();
    publishCost_ = lastPublish_ - begin;
    if (wake_) {
        wake_();
    }
}

/// An estimate: how many elements there will be is known at the end only.
double SessionWorker::frontProgress() const {
    return std::min(0.99, static_cast<double>(timeline_->position()) / (estimatedElements_ + 1.0));
}

/// The advance that the cursor is in, or else the one done last, derived again by doing it once more with recording.
void SessionWorker::explain(SessionSnapshot &snapshot) {
    const bool followed =
        activity_ == Activity::Resting || (activity_ == Activity::Playing && std::abs(rate_) <= kExplainedRate);
    if (!layers_.explanation || !followed) {
        return;
    }
    if (eventsDone_ > 0) {
        snapshot.explanation = nextAdvance_;
        snapshot.eventCursor = eventsDone_ - 1;
    } else if (timeline_->position() > 0) {
        timeline_->back(1);
        snapshot.explanation = std::make_shared<const AdvanceExplanation>(timeline_->mesher().explainNext());
        timeline_->forward(1);
        snapshot.eventCursor = snapshot.explanation->events.size();
    }
    snapshot.eventCount = snapshot.explanation ? snapshot.explanation->events.size() : 0;
}

} // namespace forefront
