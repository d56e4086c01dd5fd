#pragma once

#include "core/base/api.hpp"
#include "core/mesher/options.hpp"
#include "core/session/snapshot.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace FOREFRONT_API forefront {

/// How far one step goes.
enum class Granularity : std::uint8_t {
    Event,   ///< one moment inside an advance
    Advance, ///< one front advance: an element (fast method: up to three), none where it is deferred
    Layer    ///< the front once around: as many advances as Γ had segments
};

/// What a new run does once it is prepared.
enum class StartMode : std::uint8_t {
    Pause,   ///< waits before the first advance
    Run,     ///< meshes to the end at full speed and publishes progress and partial meshes on the way
    RunQuiet ///< as Run, but publishes nothing before the end, so that the previous mesh stays on show: for a mesh that
             ///< follows an edit. A run above kQuietElements publishes its progress all the same.
};
/// Largest predicted number of elements of a quiet run; a larger one takes long enough for its progress to matter.
inline constexpr double kQuietElements = 100'000.0;

/// A meshing run on a worker thread, with a timeline that goes forward and back. All members are called from one thread
/// (the UI's) and return at once; results arrive in latest(). Destruction cancels and joins.
class MeshingSession {
  public:
    /// `wake` is called from the worker whenever a new snapshot is there (to wake a waiting event loop); may be empty.
    explicit MeshingSession(std::function<void()> wake = {});
    ~MeshingSession();
    MeshingSession(const MeshingSession &) = delete;
    MeshingSession &operator=(const MeshingSession &) = delete;

    /// Starts a new run and cancels the previous one, which stays on show until the new one is prepared, and for good
    /// if the new one is refused.
    void start(std::shared_ptr<const MeshingJob> job, StartMode mode);
    /// As above, with `runToEnd` for StartMode::Run, else StartMode::Pause.
    void start(std::shared_ptr<const MeshingJob> job, bool runToEnd) {
        start(std::move(job), runToEnd ? StartMode::Run : StartMode::Pause);
    }
    /// Runs on to the end at full speed, then improves.
    void finish();
    /// Plays forward (or back, with a negative rate) at a number of advances per second from the position of the
    /// cursor; at the known end, it computes on. Playing from the end starts again at the beginning.
    void play(double advancesPerSecond);
    void pause();
    /// Steps n (negative: back) and pauses.
    void step(Granularity granularity, std::int64_t n);
    /// Goes to a position in [0, known] (further: computes on) and pauses.
    void seek(std::uint64_t advance);
    /// Stops what is running within 100 ms; the partial mesh stays and can be stepped through.
    void cancel();
    /// Forgets the run.
    void clear();

    /// Layers wanted from now on.
    void want(SnapshotLayers layers);
    /// The newest snapshot, never null. Never waits for the worker's computing.
    std::shared_ptr<const SessionSnapshot> latest() const;
    /// True while the worker has something to do (a command pending, playing, running, improving).
    bool busy() const;

  private:
    struct Worker;
    std::unique_ptr<Worker> worker_;
};

} // namespace forefront
