#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/session/breakpoints.hpp"
#include "core/engine/session/snapshot.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>

namespace FOREFRONT_API forefront {

/// The length of a step.
enum class Granularity : std::uint8_t {
    Event,   ///< one moment inside an advance
    Advance, ///< one front advance: an element (fast method: up to three), or a deferred base
    Layer    ///< once around the front: as many advances as Γ had segments
};

/// The behaviour of a new run once it is prepared.
enum class StartMode : std::uint8_t {
    Pause,   ///< waits before the first advance
    Run,     ///< meshes to the end at full speed and publishes progress and partial meshes on the way
    RunQuiet ///< as Run, but publishes nothing before the end, so that the previous mesh stays visible after an edit; a
             ///< run above kQuietElements publishes its progress all the same
};
/// Maximum predicted number of elements of a quiet run. Larger runs take long enough for their progress to matter.
inline constexpr double kQuietElements = 100'000.0;

/// A meshing run on a worker thread, with a timeline that moves forward and back. Call all members from one thread (the
/// UI thread); they return at once, and results appear in latest(). Destruction cancels the run and joins the thread.
class MeshingSession {
  public:
    /// Starts the worker. It calls `wake`, unless empty, after each new snapshot, to wake a waiting event loop.
    explicit MeshingSession(std::function<void()> wake = {});
    ~MeshingSession();
    MeshingSession(const MeshingSession &) = delete;
    MeshingSession &operator=(const MeshingSession &) = delete;

    /// Starts a new run and cancels the previous one, which stays visible until the new one is prepared, and for good
    /// if the new one is refused. A job of more than about `budget` elements is coarsened to it, see prepare().
    void start(std::shared_ptr<const MeshingJob> job, StartMode mode,
               double budget = std::numeric_limits<double>::infinity());
    /// Starts a new run with StartMode::Run if `runToEnd`, else with StartMode::Pause.
    void start(std::shared_ptr<const MeshingJob> job, bool runToEnd) {
        start(std::move(job), runToEnd ? StartMode::Run : StartMode::Pause);
    }
    /// Runs to the end at full speed, then improves the mesh.
    void finish();
    /// Plays from the cursor at a number of advances per second; a negative rate plays backward. Computes further
    /// advances at the known end. Playing from the end of the run starts again at the beginning.
    void play(double advancesPerSecond);
    /// Pauses at the current position.
    void pause();
    /// Moves n steps, back if negative, and pauses.
    void step(Granularity granularity, std::int64_t n);
    /// Moves to a position and pauses. Positions beyond the known ones are computed.
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

  private:
    struct Worker;
    std::unique_ptr<Worker> worker_;
};

} // namespace forefront
