#pragma once

#include "core/base/api.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/boundary/discretise.hpp"
#include "core/improve/improve.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesher/options.hpp"
#include "core/mesher/statistics.hpp"

#include <memory>
#include <string_view>

namespace FOREFRONT_API forefront {

class Mesher;

/// More elements than this are refused: half-edges, three an element, have ids of 31 bits while elements are joined.
inline constexpr double kMostElements = 7e8;

/// A job behind the door: validated, discretised, with its node spacing.
struct PreparedJob {
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    double estimatedElements = 0.0;
};

/// Validates, builds the spacing, discretises. Faults of each of these, "too-many-elements", or "cancelled".
Result<PreparedJob> prepare(const MeshingJob &job, const Progress &progress = {});

/// A finished run.
struct MeshingOutcome {
    Mesh mesh;
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    WorkCounters work;
    ImproveReport improvement;
    double secondsMesh = 0.0;    ///< CPU time: the front, from discretised boundary to Γ = ∅
    double secondsImprove = 0.0; ///< CPU time of the improvement
    double secondsWall = 0.0;    ///< of both on the clock: less than their sum where threads share the work
    double secondsPrepare = 0.0; ///< CPU time of validation, spacing and discretisation
};

/// The code "out-of-memory".
Diagnostics outOfMemory();
/// The code "cancelled".
Diagnostics cancelled();

/// Advances until Γ = ∅, reporting as `stage` how much of the estimate is done. False when cancelled.
bool advanceToEnd(Mesher &mesher, double estimatedElements, std::string_view stage, const Progress &progress);

/// The whole chain: validate, build the spacing, discretise, advance the front to its end, improve. The error code
/// "cancelled" says that progress.stop was requested.
Result<MeshingOutcome> meshDomain(const MeshingJob &job, const Progress &progress = {});

} // namespace forefront
