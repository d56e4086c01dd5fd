#pragma once

#include "core/engine/improve/improve_record.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/quad_start.hpp"
#include "core/engine/quads/quad_record.hpp"
#include "core/engine/session/finished_mesh.hpp"
#include "core/engine/session/snapshot_builder.hpp"
#include "core/engine/session/timeline_travel.hpp"

#include <memory>
#include <optional>

namespace forefront {

/// A job that is ready for a stepped run.
struct SteppedJob {
    PreparedJob prepared;
    std::optional<QuadStart> quads; ///< of a job of quadrilaterals
};

/// Prepares a job as prepare() does and, for quadrilaterals, chooses the front. Errors: those of prepare() and
/// chooseQuadFront().
Result<SteppedJob> prepareStepped(const MeshingJob &job, const Progress &progress, double budget);

/// A prepared run with its timeline, its snapshots and, at the end, its improved mesh; the common part of MeshStepper
/// and MeshingSession. Belongs to one thread at a time.
class SteppedRun {
  public:
    /// `number`: of the run, counted from 1; makes the versions of its mesh views differ from those of other runs.
    SteppedRun(std::shared_ptr<const MeshingJob> job, SteppedJob prepared, std::uint64_t number);

    TimelineTravel &travel() { return travel_; }
    const TimelineTravel &travel() const { return travel_; }
    const PreparedJob &prepared() const { return prepared_; }

    /// Returns the fault of a front that has exceeded the job's maximum number of elements, since the estimate was too
    /// low; empty if it has not.
    Diagnostics excess() const;
    /// Maximum number of elements whose improvement is stepped; that of a larger mesh is one step. The clean-up of more
    /// quadrilaterals is stepped by passes, see QuadRecord, which takes at most QuadRecord::kMaxBytes. The timeline of
    /// their front takes about 300 bytes for each advance, in which it makes one quadrilateral or a little less.
    static constexpr std::size_t kSteppedElements = 100'000;
    /// Makes moves wait for improve() where the front is done.
    void awaitImprovement() { travel_.awaitImprovement(); }
    /// Does so and makes improve() record the steps of the improvement, which then follow the advances on the timeline.
    void stepImprovement();
    bool stepsImprovement() const { return stepsImprovement_; }
    /// Returns true once improve() has made the final mesh.
    bool improved() const { return final_.view != nullptr; }
    /// Makes the final mesh from the front's, which must be complete. Returns the faults that the stages
    /// after the front found, or "cancelled".
    Status improve(const Progress &progress);
    /// Improves the mesh of the front of an improved run again, for its steps, which are then on the timeline. The run
    /// must be at its end, and stays there. Faults: "cancelled".
    Status recordImprovement(const Progress &progress);

    /// Fills in everything that follows from the run at its position. `resting`: it does not move, so that slower
    /// figures are computed as well.
    void fill(SessionSnapshot &snapshot, SnapshotLayers layers, bool resting);

  private:
    bool improves() const { return job_->options.improve != ImproveLevel::None; }
    /// Returns true if stages after the improvement change the mesh.
    bool completes() const;
    /// Returns a record of the improvement of a mesh, which is to be its watch; none if its steps are not recorded.
    std::optional<ImproveRecord> recordFor(const TriMesh &mesh) const;
    void takeSteps(std::optional<ImproveRecord> record);
    const ColouredMesher &colouredMesher() const;
    /// Joins the front of a job of quadrilaterals in `state`, and begins a record of that and what follows if
    /// `records`.
    void joinQuads(MeshingState &state, bool records);
    void takeQuadSteps();
    Mesh meshOfStep(std::size_t number);
    MeshQuality shapesOfStep(std::size_t number);
    TriMesh meshOfFront() const;
    void fillStep(SessionSnapshot &snapshot, bool withMesh, bool resting);
    std::shared_ptr<const ImproveStep> lastStep();

    std::shared_ptr<const MeshingJob> job_;
    PreparedJob prepared_;
    std::optional<QuadStart> quads_; ///< of a job of quadrilaterals
    std::uint64_t number_;
    TimelineTravel travel_;
    SnapshotBuilder builder_;
    FinishedMesh final_;
    bool stepsImprovement_ = false;
    std::optional<ImproveRecord> record_;
    std::optional<QuadRecord> quadRecord_;
    // The step at shownStep_, as far as a snapshot has asked for it.
    std::size_t shownStep_ = 0;
    std::shared_ptr<const ImproveStep> step_;
    std::shared_ptr<const MeshSnapshot> stepMesh_;
    std::optional<MeshQuality> stepShapes_, stepQuality_;
    double secondsImprove_ = 0.0;
};

} // namespace forefront
