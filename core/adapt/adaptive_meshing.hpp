#pragma once

#include "core/adapt/error_spacing.hpp"
#include "core/base/api.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/mesher/options.hpp"

#include <functional>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// A function that returns values at the nodes of a mesh, from a formula or a solver. It may report progress and be
/// cancelled.
using NodalField = std::function<Result<std::vector<double>>(const Mesh &, const Progress &)>;

/// Returns a field from an expression in x and y. Errors: "expression-syntax"; when evaluated, "expression-value" with
/// the position, "cancelled".
Result<NodalField> expressionField(const std::string &expression);

/// The mesh of one round and the error of the field on it.
struct AdaptRound {
    std::size_t nodes = 0, elements = 0;
    double error = 0.0; ///< ErrorEstimate::relative()
};

/// Called at the end of each round.
using AdaptReport = std::function<void(std::size_t round, const AdaptRound &)>;

/// The result of adapt().
struct AdaptOutcome {
    Mesh mesh;
    SpacingSpec spacing;            ///< spacing of the last round, defined on the previous mesh
    std::vector<AdaptRound> rounds; ///< the given mesh and each new one
    bool met = false;               ///< the last estimate is within the target
    bool stalled = false;           ///< finer meshes no longer lower the estimate, for example at a jump of the field
};

/// Adapts a mesh to a target error in rounds: estimates the error, remeshes the domain with the spacing that follows
/// from it and evaluates the field on the new mesh, until the estimate meets the target or no longer falls. Makes at
/// least one and at most `maxRounds` new meshes. Errors: those of the field and of the mesher, "cancelled".
Result<AdaptOutcome> adapt(const Domain &domain, Mesh mesh, const NodalField &field, const AdaptTarget &target,
                           int maxRounds, const MeshingOptions &options, const Progress &progress = {},
                           const AdaptReport &report = {});

} // namespace forefront
