#include "core/adapt/adaptive_meshing.hpp"

#include "core/mesher/pipeline.hpp"
#include "core/spacing/expression.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace forefront {

namespace {

constexpr double kNear = 1.3;    ///< times the target: from here on the aim is corrected
constexpr double kMargin = 0.98; ///< of the corrected aim

} // namespace

Result<NodalField> expressionField(const std::string &expression) {
    Result<ExpressionProgram> program = compileExpression(expression);
    if (!program) {
        return program.faults();
    }
    const auto shared = std::make_shared<const ExpressionProgram>(std::move(*program));
    return NodalField([shared](const Mesh &mesh) -> Result<std::vector<double>> {
        std::vector<double> values(mesh.nodes.size());
        shared->evaluateMany(mesh.nodes, values);
        for (std::size_t n = 0; n < values.size(); ++n) {
            if (!std::isfinite(values[n])) {
                Diagnostics faults = error("expression-value", "the field has no finite value at a node",
                                           "choose an expression that is finite all over the domain");
                faults.front().at = mesh.nodes[n];
                return faults;
            }
        }
        return values;
    });
}

Result<AdaptOutcome> adapt(const Domain &domain, Mesh mesh, const NodalField &field, const AdaptTarget &target,
                           int most, const MeshingOptions &options, const Progress &progress) {
    AdaptOutcome outcome;
    outcome.mesh = std::move(mesh);
    AdaptTarget aim = target;
    for (int round = 0;; ++round) {
        const Result<std::vector<double>> values = field(outcome.mesh);
        if (!values) {
            return values.faults();
        }
        if (values->size() != outcome.mesh.nodes.size() ||
            !std::all_of(values->begin(), values->end(), [](double value) { return std::isfinite(value); })) {
            return error("field-value", "the field has no finite value at every node of the mesh",
                         "see that the solver converges on this mesh");
        }
        const ErrorEstimate estimate = estimateError(outcome.mesh, *values);
        outcome.rounds.push_back({outcome.mesh.nodes.size(), outcome.mesh.elements.size(), estimate.relative()});
        outcome.met = estimate.relative() <= target.error;
        if (round >= 1 && (outcome.met || round >= most)) {
            return outcome;
        }
        // Meshes near the target tend to end a little above what was aimed at, one like the other.
        if (round >= 1 && estimate.relative() < kNear * target.error) {
            aim.error *= kMargin * target.error / estimate.relative();
        }
        MeshingJob job{domain, adaptedSpacing(outcome.mesh, estimate, aim), options};
        Result<MeshingOutcome> next = meshDomain(job, progress);
        if (!next) {
            return next.faults();
        }
        outcome.spacing = std::move(job.spacing);
        outcome.mesh = std::move(next->mesh);
    }
}

} // namespace forefront
