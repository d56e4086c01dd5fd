#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/pipeline/pipeline.hpp"

namespace forefront {

/// A mesh whose job was changed until it meets its limits, as far as that is possible.
struct FixedMesh {
    MeshingJob job;
    MeshingOutcome outcome;
    Diagnostics remarks; ///< notes on each change, and on what no change can mend
};

/// Meshes a job; while the mesh violates limits, changes the settings that help by fixOf() and meshes it again, in at
/// most kMaxFixRounds rounds. Returns the mesh with the fewest violations; of several, the first. Errors: those of
/// meshDomain() for the job as given, cancelled.
Result<FixedMesh> meshWithinLimits(MeshingJob job, const MeshLimits &limits, const Progress &progress);

inline constexpr int kMaxFixRounds = 10;

} // namespace forefront
