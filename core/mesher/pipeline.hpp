#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/domain/discretise.hpp"
#include "core/improve/improve.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesher/options.hpp"
#include "core/mesher/statistics.hpp"

#include <memory>

namespace forefront {

/// A finished run.
struct MeshingOutcome {
    Mesh mesh;
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    WorkCounters work;
    ImproveReport improvement;
    double secondsMesh = 0.0;    ///< CPU time: the front, from discretised boundary to Γ = ∅
    double secondsImprove = 0.0; ///< CPU time of the improvement
    double secondsPrepare = 0.0; ///< CPU time of validation, spacing and discretisation
};

/// The whole chain: validate, build the spacing, discretise, advance the front to its end, improve. The error code
/// "cancelled" says that progress.stop was requested.
Result<MeshingOutcome> meshDomain(const MeshingJob &job, const Progress &progress = {});

} // namespace forefront
