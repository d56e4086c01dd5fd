#include "core/engine/adapt/adaptive_meshing.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

namespace forefront {

namespace {

constexpr double kNear = 1.3;    ///< the aim is corrected within this multiple of the target
constexpr double kMargin = 0.98; ///< factor on the corrected aim

/// Returns a progress that prefixes stages with the name of the round. `progress` must outlive it.
Progress progressOfRound(const Progress &progress, int round) {
    Progress named;
    named.stop = progress.stop;
    if (progress.report) {
        named.report = [&progress, name = "mesh " + std::to_string(round) + ": "](std::string_view stage, double part) {
            progress.report(name + std::string(stage), part);
        };
    }
    return named;
}

/// Records the error of the mesh of the outcome, and reports it.
void addRound(AdaptOutcome &outcome, const TriMesh &mesh, const std::vector<double> &values,
              const ErrorEstimate &estimate, const AdaptReport &report) {
    outcome.rounds.push_back({mesh.nodes.size(), mesh.elements.size(), estimate.relative()});
    if (report) {
        report(outcome.rounds.size() - 1, outcome.rounds.back(), {mesh, values, estimate, outcome.spacing});
    }
}

/// Makes the next mesh of the outcome: with the spacing that meets a target according to the estimate on `mesh`, which
/// may be that of the outcome. Returns the faults.
Diagnostics remesh(AdaptOutcome &outcome, const MeshingJob &given, const TriMesh &mesh, const ErrorEstimate &estimate,
                   const AdaptTarget &target, const Progress &progress) {
    if (given.options.elements != Elements::Triangles ||
        std::ranges::any_of(given.regionElements,
                            [](const RegionElements &own) { return own.elements != Elements::Triangles; })) {
        return error("not-triangles", "adaptive meshing makes triangles alone", "choose triangles as elements");
    }
    if (given.options.order != ElementOrder::First) {
        return error("not-first-order", "adaptive meshing makes elements of first order alone", "choose order 1");
    }
    Result<SpacingSpec> spacing = adaptedSpacing(mesh, estimate, target, progress);
    if (!spacing) {
        return spacing.faults();
    }
    spacing->placed = given.spacing.placed;
    MeshingJob job{given.domain, std::move(*spacing), given.options};
    job.cracks = given.cracks;
    job.periodic = given.periodic;
    job.mapped = given.mapped;
    job.strips = given.strips;
    for (StripSpec &strip : job.strips) {
        strip.cells = LayerCells::Triangles;
    }
    Result<MeshingOutcome> next = meshDomain(job, progress);
    if (!next) {
        return next.faults();
    }
    outcome.spacing = std::move(job.spacing);
    outcome.mesh = takeTriMesh(std::move(next->mesh));
    return {};
}

/// Returns true if each of the last two meshes is far finer than the previous one and no better. One such mesh is not
/// enough: the first meshes may have missed features that a finer one shows.
bool stalls(const std::vector<AdaptRound> &rounds) {
    constexpr double kFiner = 1.5, kBetter = 0.97;
    if (rounds.size() < 3) {
        return false;
    }
    for (std::size_t i = rounds.size() - 2; i < rounds.size(); ++i) {
        if (static_cast<double>(rounds[i].elements) < kFiner * static_cast<double>(rounds[i - 1].elements) ||
            rounds[i].error < kBetter * rounds[i - 1].error) {
            return false;
        }
    }
    return true;
}

/// Returns the index of the first value that is not finite; their number if all are.
std::size_t firstNotFinite(const std::vector<double> &values) {
    const auto found = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
    return static_cast<std::size_t>(found - values.begin());
}

} // namespace

Result<NodalField> expressionField(const std::string &expression) {
    Result<ExpressionProgram> program = compileExpression(expression);
    if (!program) {
        return program.faults();
    }
    const auto shared = std::make_shared<const ExpressionProgram>(std::move(*program));
    return NodalField([shared](const TriMesh &mesh, const Progress &progress) -> Result<std::vector<double>> {
        constexpr std::size_t kBatch = 4096;
        std::vector<double> values(mesh.nodes.size());
        for (std::size_t first = 0; first < values.size(); first += kBatch) {
            if (progress.cancelled()) {
                return cancelled("evaluating the field");
            }
            progress("evaluating the field", static_cast<double>(first) / static_cast<double>(values.size()));
            const std::size_t count = std::min(kBatch, values.size() - first);
            shared->evaluateMany(std::span(mesh.nodes).subspan(first, count), std::span(values).subspan(first, count));
        }
        if (const std::size_t n = firstNotFinite(values); n < values.size()) {
            Diagnostics faults = error("expression-value", "the field is not finite at a node",
                                       "choose an expression that is finite everywhere in the domain");
            faults.front().at = mesh.nodes[n];
            return faults;
        }
        return values;
    });
}

namespace {

Result<AdaptOutcome> meshInRounds(const MeshingJob &job, TriMesh mesh, const NodalField &field,
                                  const AdaptTarget &target, int maxRounds, const Progress &progress,
                                  const AdaptReport &report) {
    AdaptOutcome outcome;
    outcome.mesh = std::move(mesh);
    AdaptTarget aim = target;
    for (int round = 0;; ++round) {
        const Progress inRound = progressOfRound(progress, round);
        const Result<std::vector<double>> values = field(outcome.mesh, inRound);
        if (!values) {
            return values.faults();
        }
        if (values->size() != outcome.mesh.nodes.size() || firstNotFinite(*values) < values->size()) {
            return error("field-value", "the field is not finite at every node of the mesh",
                         "check that the solver converges on this mesh");
        }
        const Result<ErrorEstimate> estimate = estimateError(outcome.mesh, *values, inRound);
        if (!estimate) {
            return estimate.faults();
        }
        const double reached = estimate->relative();
        addRound(outcome, outcome.mesh, *values, *estimate, report);
        outcome.met = reached <= target.error;
        outcome.stalled = !outcome.met && stalls(outcome.rounds);
        if (round >= 1 && (outcome.met || outcome.stalled || round >= maxRounds)) {
            return outcome;
        }
        // Meshes near the target tend to miss the aim by the same small amount.
        if (round >= 1 && reached < kNear * target.error) {
            aim.error *= kMargin * target.error / reached;
        }
        const Diagnostics faults = remesh(outcome, job, outcome.mesh, *estimate, aim, inRound);
        if (!faults.empty()) {
            return faults;
        }
    }
}

Result<AdaptOutcome> meshOnce(const MeshingJob &job, const TriMesh &mesh, const std::vector<double> &values,
                              const AdaptTarget &target, const Progress &progress, const AdaptReport &report) {
    if (const std::size_t n = firstNotFinite(values); n < values.size()) {
        Diagnostics faults =
            error("field-value", "the field is not finite at a node", "give a value at every node of the mesh");
        faults.front().at = mesh.nodes[n];
        return faults;
    }
    AdaptOutcome outcome;
    const Result<ErrorEstimate> estimate = estimateError(mesh, values, progress);
    if (!estimate) {
        return estimate.faults();
    }
    addRound(outcome, mesh, values, *estimate, report);
    const Diagnostics faults = remesh(outcome, job, mesh, *estimate, target, progress);
    if (!faults.empty()) {
        return faults;
    }
    return outcome;
}

} // namespace

Result<AdaptOutcome> adaptMesh(const MeshingJob &job, TriMesh mesh, const NodalField &field, const AdaptTarget &target,
                               int maxRounds, const Progress &progress, const AdaptReport &report) {
    return orOutOfMemory("to adapt the mesh", [&] {
        return meshInRounds(job, std::move(mesh), field, target, maxRounds, progress, report);
    });
}

Result<AdaptOutcome> adaptMeshOnce(const MeshingJob &job, const TriMesh &mesh, const std::vector<double> &values,
                                   const AdaptTarget &target, const Progress &progress, const AdaptReport &report) {
    return orOutOfMemory("to adapt the mesh", [&] { return meshOnce(job, mesh, values, target, progress, report); });
}

} // namespace forefront
