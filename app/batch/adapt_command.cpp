#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/options.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "core/adapt/adaptive_meshing.hpp"
#include "core/adapt/mesh_outline.hpp"
#include "core/io/files.hpp"
#include "core/io/inner_edges.hpp"
#include "core/mesh/verify.hpp"
#include "core/mesher/pipeline.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kExamples = R"help(
The error is that of the gradient, estimated after Zienkiewicz and Zhu and divided by the norm of the gradient: 0.05 is
5 %. A field of a file is known on that mesh alone: one new mesh is made; solve on it again and repeat. An expression is
evaluated on each new mesh until the estimate meets the wanted error.

Examples:
  forefront adapt plate.vtu --field temperature --error 0.05 -o finer.msh
        a mesh on which the error of the point data "temperature" should be 5 %
  forefront adapt plate.msh --expression "atan(20*(x*x+y*y-1))" --error 0.02 --size-min 0.001 -o adapted.msh
        round after round until the interpolation of the formula is within 2 %

Exit codes: 0 done, 1 the input is refused (faults on stderr, one a line), 2 wrong usage, 3 cancelled.)help";

struct AdaptArguments {
    std::filesystem::path mesh;
    std::optional<std::string> field, expression;
    AdaptTarget target;
    int rounds = 8;
    std::optional<std::filesystem::path> domain;
    std::vector<std::filesystem::path> outputs;
    InnerEdges innerEdges = InnerEdges::Keep;
    bool quiet = false;
};

void printRound(const AdaptArguments &arguments, std::size_t round, std::size_t nodes, std::size_t elements,
                std::optional<double> error) {
    if (!arguments.quiet) {
        std::printf("mesh %zu: %zu nodes, %zu elements", round, nodes, elements);
        if (error) {
            std::printf(", estimated error %.4f", *error);
        }
        std::printf("\n");
        std::fflush(stdout); // minutes may pass until the next
    }
}

/// Mesh and, with --field, its values; refused where it is no valid mesh.
Result<MeshField> readInput(const AdaptArguments &arguments) {
    MeshField input;
    if (arguments.field) {
        Result<MeshField> read = readField(arguments.mesh, *arguments.field);
        if (!read) {
            return read.faults();
        }
        input = std::move(*read);
    } else {
        Result<Mesh> read = readMesh(arguments.mesh);
        if (!read) {
            return read.faults();
        }
        input.mesh = std::move(*read);
    }
    if (input.mesh.elements.empty()) {
        return locateFaults(arguments.mesh, error("empty-mesh", "the file holds no triangles"));
    }
    Diagnostics faults = verify(input.mesh);
    if (hasErrors(faults)) {
        return locateFaults(arguments.mesh, std::move(faults));
    }
    return input;
}

/// One round: what the solver says of the next mesh is not known here.
Result<Mesh> adaptToField(const AdaptArguments &arguments, const Domain &domain, const MeshField &input,
                          const Progress &progress) {
    const Result<ErrorEstimate> estimate = estimateError(input.mesh, input.values, progress);
    if (!estimate) {
        return estimate.faults();
    }
    printRound(arguments, 0, input.mesh.nodes.size(), input.mesh.elements.size(), estimate->relative());
    Result<SpacingSpec> spacing = adaptedSpacing(input.mesh, *estimate, arguments.target, progress);
    if (!spacing) {
        return spacing.faults();
    }
    const MeshingJob job{domain, std::move(*spacing), {}};
    Result<MeshingOutcome> outcome = meshDomain(job, progress);
    if (!outcome) {
        return outcome.faults();
    }
    printRound(arguments, 1, outcome->mesh.nodes.size(), outcome->mesh.elements.size(), std::nullopt);
    if (!arguments.quiet) {
        std::printf("now solve on the new mesh; if the error is still too large there, adapt again\n");
    }
    return std::move(outcome->mesh);
}

Result<Mesh> adaptToExpression(const AdaptArguments &arguments, const Domain &domain, Mesh mesh,
                               const Progress &progress, ProgressBar &bar) {
    const Result<NodalField> field = expressionField(*arguments.expression);
    if (!field) {
        return field.faults();
    }
    const auto tell = [&](std::size_t i, const AdaptRound &round) {
        bar.clear();
        printRound(arguments, i, round.nodes, round.elements, round.error);
    };
    Result<AdaptOutcome> outcome =
        adapt(domain, std::move(mesh), *field, arguments.target, arguments.rounds, {}, progress, tell);
    bar.clear();
    if (!outcome) {
        return outcome.faults();
    }
    if (outcome->stalled) {
        std::fputs("warning: the wanted error is not met, and finer meshes do not lower it: does the field jump, or do "
                   "its values depend on the mesh?\n",
                   stderr);
    } else if (!outcome->met) {
        std::fprintf(stderr, "warning: the wanted error is not met; allow more rounds%s\n",
                     arguments.target.sizeMin > 0.0 ? " or a smaller --size-min" : "");
    }
    return std::move(outcome->mesh);
}

int runAdapt(const AdaptArguments &arguments) {
    InterruptWatch interrupt;
    ProgressBar bar(!arguments.quiet);
    Progress progress;
    progress.stop = interrupt.token();
    progress.report = [&bar](std::string_view stage, double fraction) { bar.show(stage, fraction); };
    bar.show("reading", 0.0);
    Result<MeshField> input = readInput(arguments);
    if (!input) {
        bar.clear();
        return refuse(input.faults(), interrupt);
    }
    const Result<Domain> domain = arguments.domain ? readDomain(*arguments.domain) : outlineOf(input->mesh);
    bar.clear();
    if (!domain) {
        return refuse(domain.faults(), interrupt);
    }
    interrupt.askFromNowOn();
    const Result<Mesh> mesh = arguments.field
                                  ? adaptToField(arguments, *domain, *input, progress)
                                  : adaptToExpression(arguments, *domain, std::move(input->mesh), progress, bar);
    bar.clear();
    if (!mesh) {
        const std::filesystem::path &file = arguments.domain.value_or(arguments.mesh);
        const bool mistyped = hasCode(mesh.faults(), "expression-syntax");
        const int code =
            refuse(mistyped ? mesh.faults() : meshingFaults(mesh.faults(), *domain, file, true), interrupt);
        return code == kRefused && mistyped ? static_cast<int>(kUsage) : code;
    }
    const bool drops = arguments.innerEdges == InnerEdges::Drop;
    const Mesh outline = drops ? withoutInnerEdges(*mesh) : Mesh();
    for (const std::filesystem::path &path : arguments.outputs) {
        const Status written = writeMesh(path, drops ? outline : *mesh, {}, progress);
        bar.clear();
        if (hasErrors(written)) {
            return refuse(written, interrupt);
        }
        if (!arguments.quiet) {
            printFaults(written);
            std::printf("wrote %s\n", path.string().c_str());
        }
    }
    return kDone;
}

} // namespace

int adaptCommand(int argc, const char *const *argv) {
    AdaptArguments arguments;
    CLI::App app("Makes a mesh on which a field is as exact as wanted, with as few elements as possible.",
                 "forefront adapt");
    app.footer(kExamples);
    app.add_option("MESH", arguments.mesh, "mesh file; with --field one that holds nodal values: .vtu, .vtk, .msh")
        ->required();
    auto *field = app.add_option_group("Field", "exactly one");
    field->add_option("--field", arguments.field, "nodal values of the file by their name")->type_name("NAME");
    field->add_option("--expression", arguments.expression, "a field as an expression in x and y")->type_name("EXPR");
    field->require_option(1);
    app.add_option("--error", arguments.target.error, "wanted error of the gradient, as a part of its norm: 0 to 1")
        ->required()
        ->check(numberWithin(1e-9, 1.0))
        ->type_name("E");
    app.add_option("-o,--output", arguments.outputs, "mesh to write; the extension tells the format; repeatable")
        ->required()
        ->allow_extra_args(false)
        ->type_name("OUT");
    addInnerEdgesOption(app, arguments.innerEdges);
    app.add_option("--rounds", arguments.rounds, "with --expression: at most so many new meshes (default 8)")
        ->check(wholeNumberWithin(1, 100))
        ->type_name("N");
    app.add_option("--size-min", arguments.target.sizeMin, "no edges much shorter than this")
        ->check(positiveNumber())
        ->type_name("H");
    app.add_option("--size-max", arguments.target.sizeMax, "nor longer than this")
        ->check(positiveNumber())
        ->type_name("H");
    app.add_option("--gradation", arguments.target.gradation,
                   "greatest change of edge length per unit of distance (default 0.3)")
        ->check(positiveNumber())
        ->type_name("G");
    app.add_option("--domain", arguments.domain, "domain to mesh; else what the mesh covers, with its tags")
        ->type_name("IN");
    app.add_flag("-q,--quiet", arguments.quiet, "print nothing but warnings and errors");
    if (const auto code = parseOptions(app, argc, argv)) {
        return *code;
    }
    for (const std::filesystem::path &path : arguments.outputs) {
        const std::string wrong = checkFormat(path, {});
        if (!wrong.empty()) {
            return wrongUsage(app.get_name(), wrong);
        }
    }
    std::vector<std::filesystem::path> inputs{arguments.mesh};
    if (arguments.domain) {
        inputs.push_back(*arguments.domain);
    }
    std::vector<Output> files;
    for (const std::filesystem::path &path : arguments.outputs) {
        files.push_back({path, {}});
    }
    const Diagnostics faults = checkOutputs(files, inputs);
    printFaults(faults);
    return faults.empty() ? runAdapt(arguments) : static_cast<int>(kRefused);
}

} // namespace forefront
