#pragma once

#include "core/engine/session/session_mailbox.hpp"
#include "core/engine/session/stepped_run.hpp"

#include <functional>
#include <optional>
#include <thread>

namespace forefront {

/// The worker thread of a MeshingSession. Only that thread uses the members, except the mailbox.
class SessionWorker {
  public:
    explicit SessionWorker(std::function<void()> wake);
    ~SessionWorker();
    SessionWorker(const SessionWorker &) = delete;
    SessionWorker &operator=(const SessionWorker &) = delete;

    /// Returns the mailbox, which the UI thread may use.
    SessionMailbox &mailbox() { return mailbox_; }
    const SessionMailbox &mailbox() const { return mailbox_; }

  private:
    using Clock = std::chrono::steady_clock;
    using Blocking = SessionMailbox::Blocking;
    using Outcome = TimelineTravel::Outcome;

    void loop();
    void execute(const StartCommand &command);
    void execute(const PlayCommand &command);
    void execute(const StepCommand &command);
    void execute(const SeekCommand &command);
    void execute(const SeekStopCommand &command);
    void execute(const SeekBirthCommand &command);
    void execute(const BreakpointsCommand &command);
    void execute(const FinishCommand &command);
    void execute(const PauseCommand &command);
    void execute(const CancelCommand &command);
    void execute(const ClearCommand &command);
    void execute(const LayersCommand &command);

    /// Starts a prepared job whose front can be stepped.
    void startStepped(const StartCommand &command, SteppedJob prepared);
    /// Leaves the previous run as it was, but not playing, since the new one was cancelled or has faults.
    void keepPrevious(RunState before, bool cancelled, Diagnostics faults);
    /// Discards the run with its mesh and timeline.
    void forget();
    void lookAhead();
    void beginMove();
    /// Begins a move along the timeline, which gets the steps of the improvement. Returns false if that was stopped.
    bool beginTravel();
    /// Records the improvement of a run that was finished without. Returns false if that was stopped.
    bool recordImprovement();
    void follow(Outcome outcome);
    void rest(RunState state);
    /// Stops on the timeline.
    void arrive();
    /// Improves the mesh of the front, once, and goes on with the move.
    void improveMesh();
    void fail(Diagnostics faults);
    double frontProgress() const;

    Progress progressInto(RunState state, std::stop_token stop);
    void publish(bool resting);
    void publishIfDue();

    SessionMailbox mailbox_;
    std::function<void()> wake_;

    std::optional<SteppedRun> run_;
    bool quiet_ = false; ///< publish nothing before the run rests
    ImprovementPace improvement_ = ImprovementPace::Steps;

    RunState state_ = RunState::Empty;
    Diagnostics diagnostics_;
    std::string stage_;
    double stageProgress_ = 0.0;
    std::uint64_t number_ = 0;      ///< of the last start command
    std::uint64_t shownNumber_ = 0; ///< number of run_; 0: no run
    std::uint64_t sequence_ = 0;
    SnapshotLayers layers_;
    Breakpoints breakpoints_;
    Clock::time_point lastPublish_;
    Clock::duration publishCost_{};

    std::jthread thread_; ///< last, so that it starts after and ends before all that it uses
};

} // namespace forefront
