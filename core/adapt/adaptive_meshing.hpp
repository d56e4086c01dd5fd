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

/// Values at the nodes of a mesh: a formula, or the result of a solver that is run on it. May report and be cancelled.
using NodalField = std::function<Result<std::vector<double>>(const Mesh &, const Progress &)>;

/// A field from an expression in x and y. Faults: "expression-syntax"; when evaluated: "expression-value" with the
/// place, "cancelled".
Result<NodalField> expressionField(const std::string &expression);

/// A mesh on the way and the error of the field on it.
struct AdaptRound {
    std::size_t nodes = 0, elements = 0;
    double error = 0.0; ///< ErrorEstimate::relative()
};

/// Told of each round as it ends.
using AdaptReport = std::function<void(std::size_t round, const AdaptRound &)>;

struct AdaptOutcome {
    Mesh mesh;
    SpacingSpec spacing;            ///< of the last round: on the mesh before the last
    std::vector<AdaptRound> rounds; ///< the given mesh and each that was made
    bool met = false;               ///< the last estimate is within the target
    bool stalled = false;           ///< given up: finer meshes did not lower the estimate, as where the field jumps
};

/// Estimates, remeshes the domain with the spacing that follows, evaluates the field on the new mesh, and so on until
/// the estimate meets the target or no longer falls; at least one and at most `most` new meshes. Faults: those of the
/// field and of the mesher, "cancelled".
Result<AdaptOutcome> adapt(const Domain &domain, Mesh mesh, const NodalField &field, const AdaptTarget &target,
                           int most, const MeshingOptions &options, const Progress &progress = {},
                           const AdaptReport &report = {});

} // namespace forefront
