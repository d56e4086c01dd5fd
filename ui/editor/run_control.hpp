#pragma once

#include "core/mesher/options.hpp"
#include "core/session/meshing_session.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

namespace forefront {

class DocumentStore;
class MessageLog;

/// The meshing run as the user sees it: starts runs from the document, keeps pace and granularity, knows whether the
/// mesh is out of date. All members are for the UI thread and return at once.
class RunControl {
  public:
    /// Speed 1 is this many advances a second.
    static constexpr double kAdvancesPerSecond = 10.0;
    static constexpr double kSlowest = 0.1, kFastest = 1000.0;

    RunControl(DocumentStore &document, MessageLog &log, std::function<void()> wake);

    /// Takes the newest snapshot; logs what the run has to say. Once per frame.
    void refresh();
    /// A newer snapshot waits.
    bool hasNews() const { return session_.latest() != snapshot_; }
    /// Never null; the same object for a whole frame.
    const SessionSnapshot &now() const { return *snapshot_; }
    const std::shared_ptr<const SessionSnapshot> &snapshot() const { return snapshot_; }
    void want(SnapshotLayers layers);

    /// Meshes the document at full speed.
    void mesh();
    /// Plays on from where the timeline stands, or pauses. Starts a run where there is none or it is out of date.
    void togglePlay();
    void step(Granularity granularity, std::int64_t n);
    void step(std::int64_t n) { step(granularity, n); }
    void seek(std::uint64_t advance);
    void seekEnd();
    void cancel();
    void clear();
    /// Cancelled by the user, and what comes of it is not known yet: the worker stops at once, but the partial mesh of
    /// millions of elements takes its time to be copied and drawn.
    bool cancelling() const { return cancelling_; }

    /// A command is pending or the worker is busy.
    bool busy() const { return session_.busy(); }
    bool playing() const;
    bool hasRun() const;
    /// There is a run, and the document has changed since it started.
    bool outOfDate() const;
    /// Of the run; of the document where there is none.
    Method method() const;
    double speed() const { return speed_; }
    void setSpeed(double factor);

    Granularity granularity = Granularity::Advance;
    /// Mesh again after every edit.
    bool live = false;

  private:
    void start(bool runToEnd);
    bool startIfNeeded();

    DocumentStore &document_;
    MessageLog &log_;
    MeshingSession session_;
    std::shared_ptr<const SessionSnapshot> snapshot_;
    /// What was meshed.
    struct Start {
        std::uint64_t revision = 0;
        Method method = Method::Fast;
    };
    std::map<std::uint64_t, Start> starts_; ///< by number of the run, from the one on show to the last
    std::uint64_t lastStart_ = 0;
    Start shown_;
    std::uint64_t refusalTold_ = 0; ///< number of the run
    bool started_ = false;
    bool cancelling_ = false;
    double speed_ = 1.0;
    std::uint64_t loggedRun_ = 0;
    RunState loggedState_ = RunState::Empty;
};

} // namespace forefront
