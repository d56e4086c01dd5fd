#pragma once

#include "core/engine/base/length_unit.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "ui/background/background_list.hpp"
#include "ui/workspace/mesh/file_fields.hpp"
#include "ui/workspace/run/document_run.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

class DocumentStore;
struct Document;
class MessageLog;

/// A mesh that was read from a file, ready to be shown.
struct FileMesh {
    std::shared_ptr<MeshSnapshot> view;
    std::shared_ptr<const FileFields> fields; ///< null: none
    MeshQuality quality;
    std::uint64_t hash = 0;
};

/// Takes over a mesh and its fields; measureMesh() computes the rest.
FileMesh takeMesh(MeshFields read);
/// Computes the quality and hash of a mesh; takes a while for a large one. Does not change the mesh.
void measureMesh(FileMesh &file);
/// Does both.
FileMesh fileMeshOf(MeshFields read);

/// Controls the meshing run for the user interface: starts runs from the document, holds speed and granularity, and
/// knows whether the mesh is out of date. Call all members from the UI thread; none of them blocks.
class RunControl final : public BackgroundActivity {
  public:
    /// Advances per second at speed 1.
    static constexpr double kAdvancesPerSecond = 10.0;
    static constexpr double kSlowest = 0.1, kFastest = 1000.0;

    RunControl(DocumentStore &document, MessageLog &log, BackgroundList &list);

    /// Shows the run of another document, once that is the one of the store; null: it has none yet. Returns the run
    /// shown until now. If it plays, it pauses; if it makes a mesh at full speed, it goes on.
    std::unique_ptr<DocumentRun> exchange(std::unique_ptr<DocumentRun> other);
    /// Returns what is left of a run in the background without its mesh, which exchange() makes again.
    std::unique_ptr<DocumentRun> withoutMesh(const DocumentRun &run) const;
    /// Ends a run whose document was closed. Its worker stops by itself, and a later refresh() frees the rest.
    void drop(std::unique_ptr<DocumentRun> run);
    /// Returns the number of dropped runs that refresh() has not freed yet.
    std::size_t ending() const { return ending_.size(); }

    /// Fetches the newest snapshot and logs what the run reports. Called once per frame.
    void refresh();
    /// Keeps the mesh up to date with the document while `live`: the current run is finished and shown, then the newest
    /// document is meshed. For a mesh above `liveBudget`, a coarser preview follows the edits, and the full mesh is
    /// made once `gestureOver`, which is also when the result is logged. A run that rests in its course rests after as
    /// many advances again where only the rules of the method have changed. `faulty`: the drawing has faults, which are
    /// shown elsewhere. Called once per frame, after input.
    void follow(bool gestureOver, bool faulty);
    /// Returns true if live meshing has yet to start a mesh of the newest document, or its full mesh after a preview.
    bool liveMeshPending() const;
    /// Returns true if live meshing can do that now, since the worker is idle.
    bool canFollow() const { return liveMeshPending() && !run_->session.busy(); }
    /// Returns true if the mesh shown is a preview, coarser than the document asks for.
    bool preview() const { return run_->snapshot->coarsening > 1.0; }
    /// Returns true if a newer snapshot is waiting.
    bool hasNews() const override { return run_->session.latest() != run_->snapshot; }
    /// Returns the snapshot of this frame; it does not change within a frame.
    const SessionSnapshot &now() const { return *snapshot(); }
    /// Returns the snapshot to show. For an empty drawing this is an empty one; undoing the deletion brings the mesh
    /// back.
    const std::shared_ptr<const SessionSnapshot> &snapshot() const {
        return run_->opened ? run_->opened : drawingIsEmpty() ? empty_ : run_->snapshot;
    }
    /// Shows a mesh that was read from a file, with its values, until a run starts.
    void showFile(FileMesh read);
    void showFile(MeshFields read) { showFile(fileMeshOf(std::move(read))); }
    /// Returns the values of the mesh shown, one for each of its nodes or elements; null if there are none.
    std::shared_ptr<const FileFields> fields() const { return run_->opened ? run_->fields : nullptr; }
    /// Shows a mesh of a round of adaptive refinement in the same way.
    void showAdapted(MeshFields made);
    /// Returns true if the mesh shown has no front to step through: it was read from a file, or made by Adapt.
    bool showsFile() const { return run_->opened != nullptr; }
    /// Returns true if the mesh shown was made by Adapt.
    bool showsAdapted() const { return showsFile() && run_->adapted; }
    void want(SnapshotLayers layers);

    /// Returns true if runs of the document make quadrilaterals, by a front of their own whatever the method.
    bool makesQuads() const;

    /// Returns the meshing job of the document as it is now.
    MeshingJob job() const;
    /// Meshes the document at full speed.
    void mesh();
    /// Plays from the current position, or pauses. Starts a new run if there is none or it is out of date.
    void togglePlay();
    void step(Granularity granularity, std::int64_t n);
    void step(std::int64_t n) { step(granularity, n); }
    /// Moves to a position, see SessionSnapshot::position().
    void seek(std::uint64_t position);
    void seekEnd();
    /// Moves to the next advance, or with `forward` false the previous one, that fulfils a breakpoint. Starts a run if
    /// there is none or it is out of date.
    void seekStop(bool forward);
    /// Moves to the advance that made the part within `tolerance` of `place`, see MeshingSession::seekBirth().
    void seekBirth(Vec2 place, double tolerance);
    const Breakpoints &breakpoints() const { return run_->breakpoints; }
    void setBreakpoints(const Breakpoints &breakpoints);
    void cancel();
    void clear();
    /// Returns true while a cancelled run has not delivered its result: the worker stops at once, but copying and
    /// drawing a partial mesh of millions of elements takes time.
    bool cancelling() const { return run_->cancelling; }

    /// Returns true while a command is pending or the worker is busy.
    bool busy() const { return run_->session.busy(); }
    bool working() const override;
    bool playing() const;
    bool hasRun() const;
    /// Returns true if the document has changed since the run started and live meshing will not catch up by itself.
    bool outOfDate() const;
    /// Returns the revision of the document whose mesh is shown.
    std::uint64_t shownRevision() const { return run_->shown.revision; }
    /// Returns the unit of length of the mesh shown: that of the document it was made from; none for one from a file.
    LengthUnit shownUnit() const;
    /// Returns the revision of the document that live meshing last started a mesh of, or decided not to mesh.
    std::uint64_t followedRevision() const { return run_->followed; }
    /// Returns the revision of the document, or an earlier one whose mesh is the same.
    std::uint64_t meshRevision() const;
    /// Returns the method of the run, or of the document if there is no run.
    Method method() const;
    /// Returns true if that run is one of quadrilaterals.
    bool showsQuads() const;
    double speed() const { return speed_; }
    void setSpeed(double factor);

    Granularity granularity = Granularity::Advance;
    /// Live meshing: meshes after every edit.
    bool live = false;
    /// Number of elements up to which meshes follow every change; larger ones have a coarser preview.
    double liveBudget = 25'000.0;
    /// Number of elements above which live meshing shows only the preview, since a full mesh could use up the memory.
    static constexpr double kLargestLive = 2e6;

  private:
    /// Live meshing, which the window must not miss while the worker is idle.
    class LiveMeshing final : public BackgroundActivity {
      public:
        LiveMeshing(BackgroundList &list, const RunControl &run) : BackgroundActivity(list), run_(run) {}
        bool working() const override { return run_.liveMeshPending(); }
        bool hasNews() const override { return run_.canFollow(); }

      private:
        const RunControl &run_;
    };

    bool drawingIsEmpty() const;
    void start(StartMode mode, RunExtent extent = RunExtent::Full);
    void resume(const ResumedRun &resumed);
    /// Starts a run that waits after a number of advances.
    void startAt(std::uint64_t advance);
    void startRun(StartMode mode, const RunStart &start, std::uint64_t advance);
    void startLiveMesh();
    bool keepsPosition(const SessionSnapshot &newest) const;
    bool replaceable(const SessionSnapshot &newest, bool gestureOver) const;
    bool needsFullMesh() const;
    bool startIfNeeded();
    /// Starts a run for a move along the timeline if there is none.
    void beginMove();
    void log(const SessionSnapshot &snapshot);
    void logLive(bool faulty);
    /// Logs notes unless they are the last ones logged.
    void logNotes(const Diagnostics &notes, std::uint64_t revision);

    DocumentStore &document_;
    MessageLog &log_;
    std::shared_ptr<RunNumbers> numbers_ = std::make_shared<RunNumbers>(); ///< of the runs of all documents
    std::unique_ptr<DocumentRun> run_;                                     ///< of the document; never null
    std::vector<std::unique_ptr<DocumentRun>> ending_;                     ///< see drop()
    const std::shared_ptr<const SessionSnapshot> empty_ = std::make_shared<const SessionSnapshot>();
    std::uint64_t openedCount_ = 0;
    bool resting_ = false; ///< no gesture is under way, and the drawing has no faults
    bool gestureOver_ = false;
    double speed_ = 1.0;
    LiveMeshing liveMeshing_;
};

} // namespace forefront
