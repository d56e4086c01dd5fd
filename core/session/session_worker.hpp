#pragma once

#include "core/mesher/timeline.hpp"
#include "core/session/session_command.hpp"
#include "core/session/snapshot_builder.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace forefront {

/// The thread behind a MeshingSession. Members that end in _ belong to it alone; what both threads touch is in
/// `shared_`.
class SessionWorker {
  public:
    explicit SessionWorker(std::function<void()> wake);
    ~SessionWorker();
    SessionWorker(const SessionWorker &) = delete;
    SessionWorker &operator=(const SessionWorker &) = delete;

    /// Called from the UI's thread.
    void push(SessionCommand command);
    std::shared_ptr<const SessionSnapshot> latest() const;
    bool busy() const;

  private:
    using Clock = std::chrono::steady_clock;
    enum class Activity : std::uint8_t { Resting, Reaching, Playing };
    /// What is being computed without looking at the command queue, and so must be stopped by the sender of a command.
    enum class Blocking : std::uint8_t { Nothing, Preparing, Improving };

    struct Shared {
        mutable std::mutex mutex;
        std::condition_variable_any changed;
        std::deque<SessionCommand> commands;
        std::shared_ptr<const SessionSnapshot> latest = std::make_shared<SessionSnapshot>();
        Blocking blocking = Blocking::Nothing;
        std::stop_source stop; ///< of the blocking computation
        bool active = false;
    };

    void loop(const std::stop_token &quit);
    bool takeCommand(const std::stop_token &quit, SessionCommand &command);
    void execute(const StartCommand &command);
    void execute(const PlayCommand &command);
    void execute(const StepCommand &command);
    void execute(const SeekCommand &command);
    void execute(const FinishCommand &command);
    void execute(const PauseCommand &command);
    void execute(const CancelCommand &command);
    void execute(const ClearCommand &command);
    void execute(const WantCommand &command);

    void reach(std::uint64_t position);
    void settle();
    void stepEvents(std::int64_t count);
    void stepLayers(std::int64_t count);
    void workABatch();
    void reachABatch();
    void playABatch();
    std::uint64_t move(std::int64_t advances);
    void rest(RunState state);
    void arrive();
    void improveMesh();
    void finishWith(Mesh mesh);
    void runOutOfMemory();
    double frontProgress() const;

    std::stop_token beginBlocking(Blocking kind);
    void endBlocking();
    Progress progressInto(RunState state, std::stop_token stop);
    void publish(bool resting);
    void publishIfDue();
    void explain(SessionSnapshot &snapshot);

    Shared shared_;
    std::function<void()> wake_;

    std::shared_ptr<const MeshingJob> job_;
    std::shared_ptr<const SpacingField> spacing_;
    std::shared_ptr<const DiscreteDomain> boundary_;
    std::unique_ptr<Timeline> timeline_;
    SnapshotBuilder builder_{0};
    std::shared_ptr<const MeshView> finalMesh_;
    MeshQuality finalQuality_;
    std::uint64_t finalHash_ = 0;
    double estimatedElements_ = 0.0;
    double secondsMesh_ = 0.0;
    double secondsImprove_ = 0.0;

    RunState state_ = RunState::Empty;
    Activity activity_ = Activity::Resting;
    Diagnostics diagnostics_;
    std::string stage_;
    double stageProgress_ = 0.0;
    std::uint64_t run_ = 0;
    std::uint64_t sequence_ = 0;
    SnapshotLayers layers_;

    std::uint64_t target_ = 0;        ///< Reaching: position to reach
    std::size_t layersWanted_ = 0;    ///< Reaching: so many layer ends, then the last of them is the target
    bool improvementStopped_ = false; ///< by a command that came meanwhile
    double rate_ = 0.0;               ///< Playing: advances per second, negative: back
    double owed_ = 0.0;               ///< Playing: fraction of an advance not yet played
    double measuredRate_ = 0.0;
    Clock::time_point lastTick_;
    Clock::time_point lastPublish_;
    Clock::duration publishCost_{};
    /// Stepping by events: inside the next advance, which is explained but not done. 0: outside.
    std::size_t eventsDone_ = 0;
    std::shared_ptr<const AdvanceExplanation> nextAdvance_;

    std::jthread thread_; ///< last, so that all it uses is there before and after it
};

} // namespace forefront
