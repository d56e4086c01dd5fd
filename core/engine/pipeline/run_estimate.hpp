#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"

#include <cstdint>

namespace FOREFRONT_API forefront {

/// Triangles per quadrilateral of the same spacing: the median over the samples.
inline constexpr double kTrianglesPerQuad = 2.07;

/// What a run will need.
struct RunEstimate {
    double elements = 0.0;
    double nodes = 0.0;   ///< with those in the middles of edges
    double bytes = 0.0;   ///< memory that the run adds
    double seconds = 0.0; ///< CPU time of the run
    /// CPU time of validation, spacing and discretisation, which the estimate has spent.
    double secondsPrepare = 0.0;
    std::uint64_t boundaryEdges = 0;
};

/// Estimates a run: prepares it, which integrates 4/(√3·ρ²) over the domain. A run of at most 10,000 elements is then
/// made, so that its elements and nodes are exact; for a larger one a square of about 10,000 elements is meshed with
/// the same options for the time. There the number of triangles is within 15 % in all samples, half of them within 2.5
/// %, and the number of quadrilaterals is taken as the samples' median share of that; where sizes change fast it
/// differs by up to a half, and elements added for a least angle are not counted. Errors: those of prepare() and
/// meshDomain().
Result<RunEstimate> estimateRun(const MeshingJob &job, const Progress &progress = {});

} // namespace forefront
