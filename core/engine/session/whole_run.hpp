#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/finished_mesh.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

/// Returns true if the front of a job is a timeline that can be stepped; other jobs make their mesh as a whole.
bool canStep(const MeshingOptions &options);

/// A run that made its mesh as a whole, without a timeline. Belongs to one thread at a time.
class WholeRun {
  public:
    /// Makes the mesh of a prepared job. `number`: of the run, counted from 1. Errors: those of the stages,
    /// "cancelled".
    static Result<WholeRun> make(const MeshingJob &job, PreparedJob prepared, std::uint64_t number,
                                 const Progress &progress);

    /// Fills in everything that follows from the run.
    void fill(SessionSnapshot &snapshot, SnapshotLayers layers) const;

  private:
    PreparedJob prepared_;
    FinishedMesh finished_;
    WorkCounters work_;
    bool improved_ = false;
    double secondsMesh_ = 0.0, secondsImprove_ = 0.0;
};

} // namespace forefront
