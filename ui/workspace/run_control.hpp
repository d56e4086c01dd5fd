#pragma once

#include "core/mesher/options.hpp"
#include "core/session/meshing_session.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace forefront {

class DocumentStore;
class MessageLog;

/// The meshing run as the user sees it: starts runs from the document, keeps speed and granularity, and knows whether
/// the mesh is out of date. All members belong to the UI thread and return at once.
class RunControl {
  public:
    /// Advances per second at speed 1.
    static constexpr double kAdvancesPerSecond = 10.0;
    static constexpr double kSlowest = 0.1, kFastest = 1000.0;

    RunControl(DocumentStore &document, MessageLog &log, std::function<void()> wake);

    /// Takes the newest snapshot and logs what the run reports. Called once per frame.
    void refresh();
    /// Keeps the mesh up with the document while `live`: what runs is finished and shown, then the newest document is
    /// meshed. A mesh too large to follow the hand (kQuietElements) is started again only where `gestureOver`, which
    /// also is when the result is logged. `faulty`: the drawing has faults that are shown anyway. Once per frame, after
    /// input.
    void follow(bool gestureOver, bool faulty);
    /// True if live meshing has not taken the newest document yet.
    bool hasToFollow() const;
    /// True if it could take it now: the worker is idle.
    bool canFollow() const { return hasToFollow() && !session_.busy(); }
    /// True if a newer snapshot is waiting.
    bool hasNews() const { return session_.latest() != snapshot_; }
    /// Never null; the same object for a whole frame.
    const SessionSnapshot &now() const { return *snapshot_; }
    const std::shared_ptr<const SessionSnapshot> &snapshot() const { return snapshot_; }
    void want(SnapshotLayers layers);

    /// Meshes the document at full speed.
    void mesh();
    /// Plays from the current position, or pauses. Starts a new run if there is none or it is out of date.
    void togglePlay();
    void step(Granularity granularity, std::int64_t n);
    void step(std::int64_t n) { step(granularity, n); }
    void seek(std::uint64_t advance);
    void seekEnd();
    void cancel();
    void clear();
    /// True while a cancelled run has not delivered its result: the worker stops at once, but copying and drawing a
    /// partial mesh of millions of elements takes time.
    bool cancelling() const { return cancelling_; }

    /// True while a command is pending or the worker is busy.
    bool busy() const { return session_.busy(); }
    bool playing() const;
    bool hasRun() const;
    /// True if the document has changed since the run started and live meshing is not about to catch up.
    bool outOfDate() const;
    /// Revision of the document whose mesh is shown.
    std::uint64_t shownRevision() const { return shown_.revision; }
    /// Method of the run, or of the document if there is no run.
    Method method() const;
    double speed() const { return speed_; }
    void setSpeed(double factor);

    Granularity granularity = Granularity::Advance;
    /// Mesh after every edit.
    bool live = false;

  private:
    void start(StartMode mode);
    bool startIfNeeded();
    void log(const SessionSnapshot &snapshot);
    void logLive(bool faulty);

    DocumentStore &document_;
    MessageLog &log_;
    MeshingSession session_;
    std::shared_ptr<const SessionSnapshot> snapshot_;
    /// What a run was started from.
    struct Start {
        std::uint64_t revision = 0;
        Method method = Method::Fast;
        bool live = false;
    };
    /// Result of the last live run; logged when the gesture is over.
    struct LiveResult {
        std::string note;    ///< empty: refused
        Diagnostics refusal; ///< why
        std::uint64_t revision = 0;
    };
    std::map<std::uint64_t, Start> starts_; ///< by run number, from the one shown to the last
    std::uint64_t lastStart_ = 0;
    Start shown_;
    std::uint64_t refusalLogged_ = 0; ///< run number
    std::uint64_t followed_ = 0;      ///< newest revision that live meshing has started or passed over
    std::optional<LiveResult> liveResult_;
    bool started_ = false;
    bool cancelling_ = false;
    double speed_ = 1.0;
    std::uint64_t loggedRun_ = 0;
    RunState loggedState_ = RunState::Empty;
};

} // namespace forefront
