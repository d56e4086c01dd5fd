#pragma once

#include "core/engine/adapt/error_spacing.hpp"
#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"

#include <functional>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// A function that returns values at the nodes of a mesh, from a formula or a solver. It may report progress and be
/// cancelled.
using NodalField = std::function<Result<std::vector<double>>(const TriMesh &, const Progress &)>;

/// Returns a field from an expression in x and y. Errors: "expression-syntax"; when evaluated, "expression-value" with
/// the position, "cancelled".
Result<NodalField> expressionField(const std::string &expression);

/// The mesh of one round and the error of the field on it.
struct AdaptRound {
    std::size_t nodes = 0, elements = 0;
    double error = 0.0; ///< ErrorEstimate::relative()
};

/// The state of adaptMesh() at the end of a round; valid during the call that reports it.
struct AdaptState {
    const TriMesh &mesh;
    const std::vector<double> &values; ///< of the field at the nodes
    const ErrorEstimate &estimate;
    const SpacingSpec &spacing; ///< that the mesh was made with; empty for the given mesh
};

/// Called at the end of each round.
using AdaptReport = std::function<void(std::size_t round, const AdaptRound &, const AdaptState &)>;

/// The result of adaptMesh().
struct AdaptOutcome {
    TriMesh mesh;
    SpacingSpec spacing;            ///< spacing of the last round, defined on the previous mesh
    std::vector<AdaptRound> rounds; ///< the given mesh and each new one
    bool met = false;               ///< the last estimate is within the target
    bool stalled = false;           ///< finer meshes no longer lower the estimate, for example at a jump of the field
};

/// Adapts a mesh to a target error in rounds: estimates the error, remeshes the domain with the spacing that follows
/// from it and evaluates the field on the new mesh, until the estimate meets the target or no longer falls. Makes at
/// least one and at most `maxRounds` new meshes. Of the spacing of `job`, the placed sizes (see PlacedSizes) hold in
/// all rounds; its rules are replaced by sizes that follow from the error. Errors: as for the field and the mesher,
/// "cancelled".
Result<AdaptOutcome> adaptMesh(const MeshingJob &job, TriMesh mesh, const NodalField &field, const AdaptTarget &target,
                               int maxRounds, const Progress &progress = {}, const AdaptReport &report = {});

/// Makes one new mesh for a field that is known only on the nodes of a mesh, such as a solution: it must be computed
/// again there. Reports the given mesh as round 0, the only one of the outcome. Errors: as adaptMesh().
Result<AdaptOutcome> adaptMeshOnce(const MeshingJob &job, const TriMesh &mesh, const std::vector<double> &values,
                                   const AdaptTarget &target, const Progress &progress = {},
                                   const AdaptReport &report = {});

} // namespace forefront
