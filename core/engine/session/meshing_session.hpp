#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/session/breakpoints.hpp"
#include "core/engine/session/session_mode.hpp"
#include "core/engine/session/snapshot.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>

namespace FOREFRONT_API forefront {

/// The numbers of runs, counted from 1. Sessions that share them never give two runs the same number, nor two meshes
/// the same version. For one thread.
struct RunNumbers {
    std::uint64_t last = 0;
};

/// A meshing run on a worker thread, with a timeline that moves forward and back, as by a MeshStepper. Call all members
/// from one thread (the UI thread); all but wait() and waitForNews() return at once, and results appear in latest().
/// Destruction cancels the run and joins the thread.
class MeshingSession {
  public:
    /// Starts the worker. It calls `wake`, unless empty, after each new snapshot, to wake a waiting event loop.
    /// `numbers`: never null.
    explicit MeshingSession(std::function<void()> wake = {},
                            std::shared_ptr<RunNumbers> numbers = std::make_shared<RunNumbers>());
    ~MeshingSession();
    MeshingSession(const MeshingSession &) = delete;
    MeshingSession &operator=(const MeshingSession &) = delete;

    /// Starts a new run and cancels the previous one, which stays visible until the new one is prepared, and for good
    /// if the new one is refused. A job of more than about `budget` elements is coarsened to it, see prepare().
    /// `position`: the number of advances after which a run waits that starts paused.
    void start(std::shared_ptr<const MeshingJob> job, StartMode mode,
               double budget = std::numeric_limits<double>::infinity(), std::uint64_t position = 0,
               ImprovementPace improvement = ImprovementPace::Steps);
    /// Runs to the end at full speed, then improves the mesh.
    void finish();
    /// Plays from the cursor at a number of advances per second; a negative rate plays backward. Computes further
    /// advances at the known end. Playing from the end of the run starts again at the beginning.
    void play(double advancesPerSecond);
    /// Pauses at the current position.
    void pause();
    /// Moves n steps, back if negative, and pauses.
    void step(Granularity granularity, std::int64_t n);
    /// Moves to a position and pauses: a number of advances, or the last advance and a number of steps of the
    /// improvement after it. Positions beyond the known ones are computed.
    void seek(std::uint64_t advance);
    /// Sets the conditions that stop play(), step() and seekStop().
    void stopAt(const Breakpoints &breakpoints);
    /// Moves at full speed, back or forward, to the next advance that fulfils a condition, and pauses.
    void seekStop(bool forward);
    /// Moves to the advance that made the node or edge within `tolerance` of a place, or the element around it, and
    /// pauses. Where nothing is made yet, moves forward until an element covers the place. The elements are those of
    /// the front, before improvement.
    void seekBirth(Vec2 place, double tolerance);
    /// Stops the computation within 100 ms. The partial mesh remains and can be stepped through.
    void cancel();
    /// Discards the run.
    void clear();

    /// Selects the layers of all later snapshots.
    void want(SnapshotLayers layers);
    /// Returns the newest snapshot, never null, without waiting for the worker.
    std::shared_ptr<const SessionSnapshot> latest() const;
    /// Returns true while the worker has work: a pending command, playing, running or improving.
    bool busy() const;
    /// Waits until the worker has no work left and returns the newest snapshot. While the run plays, that is at its
    /// end.
    std::shared_ptr<const SessionSnapshot> wait() const;
    /// Waits for a snapshot newer than the one with the number `sequence`, or until the worker has no work left, and
    /// returns the newest snapshot.
    std::shared_ptr<const SessionSnapshot> waitForNews(std::uint64_t sequence) const;

  private:
    struct Worker;
    std::shared_ptr<RunNumbers> numbers_;
    std::unique_ptr<Worker> worker_;
};

} // namespace forefront
