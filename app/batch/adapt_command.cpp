#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "app/batch/unit_option.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/adapt/mesh_outline.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kAdaptExamples = R"help(
The error is that of the gradient, relative to the norm of the gradient, as estimated by the method of Zienkiewicz and
Zhu: 0.05 means 5 %. A field from a file is known only on its own mesh, so a single new mesh is made: run the solver on
it, then adapt again. An expression is evaluated on each new mesh until the estimate meets the requested error.

Examples:
  forefront adapt plate.vtu --field temperature --error 0.05 -o finer.msh
        a mesh on which the error of the point data "temperature" is expected to be 5 %
  forefront adapt plate.msh --expression "atan(20*(x*x+y*y-1))" --error 0.02 --size-min 0.001 -o adapted.msh
        repeats until the interpolation error of the formula is within 2 %

Exit codes: 0 done, 1 input refused (faults on stderr, one per line), 2 usage error, 3 cancelled.)help";

constexpr int kRounds = 8; ///< maximum number of new meshes by default

struct AdaptArguments {
    std::filesystem::path mesh; ///< "-": standard input
    std::string inputFormat;
    std::optional<std::string> field, expression;
    AdaptTarget target;
    std::optional<int> rounds;
    std::optional<double> maxElements;
    Method method = Method::Fast;
    std::optional<std::filesystem::path> domain;
    DrawingArguments drawing; ///< of the domain
    std::vector<std::filesystem::path> outputs;
    std::vector<std::string> formats; ///< ids for the outputs in order; the rest by extension
    MeshForm form;
    bool quiet = false;

    MeshingOptions options() const {
        MeshingOptions options;
        options.method = method;
        applyMaxElements(maxElements, options);
        return options;
    }
    /// Returns the stream for messages: stderr if a mesh goes to standard output.
    std::FILE *messages() const { return usesStandardOutput(outputs) ? stderr : stdout; }
};

void printRound(const AdaptArguments &arguments, std::size_t round, std::size_t nodes, std::size_t elements,
                std::optional<double> error) {
    if (!arguments.quiet) {
        std::FILE *const out = arguments.messages();
        std::fprintf(out, "mesh %zu: %zu nodes, %zu elements", round, nodes, elements);
        if (error) {
            std::fprintf(out, ", estimated error %.4f", *error);
        }
        std::fputs("\n", out);
        std::fflush(out); // minutes may pass until the next
    }
}

/// Reads the mesh and, with --field, its values; refuses an invalid mesh.
Result<MeshField> readInput(const AdaptArguments &arguments, const Input &file, ProgressBar &bar) {
    MeshField input;
    ImportNotes notes;
    if (arguments.field) {
        Result<MeshField> read = bar.during(
            "reading", [&] { return allFormats().readField(file.path, *arguments.field, file.options, &notes); });
        if (!read) {
            return read.faults();
        }
        input = std::move(*read);
    } else {
        Result<Mesh> read =
            bar.during("reading", [&] { return allFormats().readMesh(file.path, file.options, &notes); });
        if (!read) {
            return read.faults();
        }
        input.mesh = std::move(*read);
    }
    printNotes(notes, arguments.quiet);
    if (input.mesh.elementCount() == 0) {
        return allFormats().locateFaults(file.path, error("empty-mesh", "the file has no elements"), file.options);
    }
    Diagnostics faults = verify(input.mesh, kMaxListedFaults, notes.numbers());
    if (hasErrors(faults)) {
        return allFormats().locateFaults(file.path, std::move(faults), file.options);
    }
    if (!arguments.quiet) {
        printFaults(allFormats().locateFaults(file.path, std::move(faults), file.options));
    }
    if (isClockwise(input.mesh)) {
        input.mesh = turned(std::move(input.mesh));
    }
    return input;
}

/// Returns the domain to mesh, with the sizes that belong to its places: that of a file, or the outline of the mesh.
/// `unit`: set to that of the file, if it names one.
Result<MeshingJob> readJob(const AdaptArguments &arguments, const Input &domainFile, const Mesh &mesh,
                           ImportNotes &notes, LengthUnit &unit) {
    if (!arguments.domain) {
        Result<MeshDomain> outline = outlineOf(mesh);
        if (!outline) {
            return outline.faults();
        }
        MeshingJob job{std::move(outline->domain), {}, arguments.options()};
        job.cracks = std::move(outline->cracks);
        job.periodic = std::move(outline->periodic);
        return job;
    }
    Result<DomainFile> file = allFormats().readDomain(domainFile.path, domainFile.options, &notes);
    if (!file) {
        return file.faults();
    }
    const Diagnostics remarks = namePartsOf(arguments.drawing, domainFile, arguments.quiet, file->domain);
    if (hasErrors(remarks)) {
        return remarks;
    }
    printFaults(remarks);
    unit = file->unit;
    MeshingJob job{std::move(file->domain), std::move(file->spacing), arguments.options()};
    job.cracks = std::move(file->cracks);
    job.periodic = std::move(file->periodic);
    job.mapped = std::move(file->mapped);
    job.strips = std::move(file->strips);
    return job;
}

/// Makes one new mesh, on which a solver must compute the field.
Result<TriMesh> adaptToField(const AdaptArguments &arguments, const MeshingJob &job, const TriMesh &mesh,
                             const std::vector<double> &values, const Progress &progress, ProgressBar &bar) {
    const auto tell = [&](std::size_t i, const AdaptRound &round, const AdaptState &) {
        bar.clear();
        printRound(arguments, i, round.nodes, round.elements, round.error);
    };
    Result<AdaptOutcome> outcome =
        bar.during({}, [&] { return adaptMeshOnce(job, mesh, values, arguments.target, progress, tell); });
    if (!outcome) {
        return outcome.faults();
    }
    printRound(arguments, 1, outcome->mesh.nodes.size(), outcome->mesh.elements.size(), std::nullopt);
    if (!arguments.quiet) {
        std::fputs("now solve on the new mesh; if the error is still too large there, adapt again\n",
                   arguments.messages());
    }
    return std::move(outcome->mesh);
}

Result<TriMesh> adaptToExpression(const AdaptArguments &arguments, const MeshingJob &job, TriMesh mesh,
                                  const Progress &progress, ProgressBar &bar) {
    const Result<NodalField> field = expressionField(*arguments.expression);
    if (!field) {
        return field.faults();
    }
    const auto tell = [&](std::size_t i, const AdaptRound &round, const AdaptState &) {
        bar.clear();
        printRound(arguments, i, round.nodes, round.elements, round.error);
    };
    Result<AdaptOutcome> outcome = bar.during({}, [&] {
        return adaptMesh(job, std::move(mesh), *field, arguments.target, arguments.rounds.value_or(kRounds), progress,
                         tell);
    });
    if (!outcome) {
        return outcome.faults();
    }
    if (outcome->stalled) {
        std::fputs(
            "warning: the requested error is not met, and finer meshes do not reduce it; check whether the field "
            "is discontinuous or depends on the mesh\n",
            stderr);
    } else if (!outcome->met) {
        std::fprintf(stderr, "warning: the requested error is not met; allow more --rounds%s\n",
                     arguments.target.sizeMin > 0.0 ? " or a smaller --size-min" : "");
    }
    return std::move(outcome->mesh);
}

int runAdapt(const AdaptArguments &arguments) {
    InterruptWatch interrupt;
    ProgressBar bar(!arguments.quiet);
    const Progress progress = bar.progress(interrupt.token());
    const Result<Input> file = bar.during("reading", [&] { return openInput(arguments.mesh, arguments.inputFormat); });
    Result<Input> domainFile =
        bar.during("reading", [&] { return arguments.domain ? openInput(*arguments.domain) : Result<Input>(Input{}); });
    if (!file || !domainFile) {
        return refuse(file ? domainFile.faults() : file.faults(), interrupt);
    }
    if (arguments.domain) {
        if (const std::string wrong = checkDrawingOptions(arguments.drawing, *domainFile, false); !wrong.empty()) {
            return wrongUsage("forefront adapt", wrong);
        }
        arguments.drawing.applyTo(domainFile->options);
    }
    Result<MeshField> input = readInput(arguments, *file, bar);
    if (!input) {
        return refuse(input.faults(), interrupt);
    }
    ImportNotes notes;
    LengthUnit unit = LengthUnit::None;
    Result<MeshingJob> job =
        bar.during("reading", [&] { return readJob(arguments, *domainFile, input->mesh, notes, unit); });
    if (!job) {
        return refuse(job.faults(), interrupt);
    }
    printNotes(notes, arguments.quiet);
    if (arguments.domain && domainFile->isProject() && !arguments.quiet) {
        printFaults({noteOf("project-domain",
                            "only the drawing of the project is used; the sizes follow the error, and this command "
                            "sets the meshing options")});
    }
    interrupt.deferToStop();
    const auto isPlain = [](const CellBlock &block) { return block.size() == 0 || block.traits().nodes == 3; };
    if (!std::ranges::all_of(input->mesh.blocks, isPlain) && !arguments.quiet) {
        printFaults(
            {warningOf("triangles-alone",
                       "the new mesh has triangles of first order alone: adapting makes no quadrilaterals and no "
                       "elements of second order")});
    }
    TriMesh triangles = takeTriangulated(std::move(input->mesh)).mesh; // the error is estimated on triangles
    const Result<TriMesh> mesh = arguments.field
                                     ? adaptToField(arguments, *job, triangles, input->values, progress, bar)
                                     : adaptToExpression(arguments, *job, std::move(triangles), progress, bar);
    if (!mesh) {
        const bool mistyped = hasCode(mesh.faults(), "expression-syntax");
        const int code = refuse(
            mistyped ? mesh.faults()
                     : meshingFaults(mesh.faults(), job->domain, arguments.domain ? *domainFile : *file, nullptr),
            interrupt);
        return code == kRefused && mistyped ? static_cast<int>(kUsage) : code;
    }
    const Diagnostics written = bar.during({}, [&] {
        return writeAndCommit(pairFormats(arguments.outputs, arguments.formats), *mesh,
                              withUnitOf(unit, arguments.form), progress);
    });
    if (hasErrors(written)) {
        return refuse(written, interrupt);
    }
    if (!arguments.quiet) {
        printFaults(written);
        printWritten(arguments.outputs, arguments.messages());
    }
    return kDone;
}

/// Returns the error for an option that has no effect with the others; empty if there is none.
std::string unusedAdaptOption(const AdaptArguments &arguments) {
    if (arguments.rounds && arguments.field) {
        return "--rounds: a field is known only on its own mesh, so that one new mesh is made; leave out --rounds, or "
               "give --expression";
    }
    if (!arguments.domain && !arguments.drawing.firstGiven().empty()) {
        return arguments.drawing.firstGiven() + ": tells how to read the domain; add --domain";
    }
    return {};
}

void addAdaptOptions(CLI::App &app, AdaptArguments &arguments) {
    app.add_option("MESH", arguments.mesh,
                   "mesh file: " + extensionList([](const FileFormat &format) { return format.readsMesh; }) +
                       "; with nodal values if --field is given: " +
                       extensionList([](const FileFormat &format) { return format.readsFields; }) +
                       "; -: standard input")
        ->required();
    addInputFormatOption(app, "MESH", arguments.inputFormat);
    auto *field = app.add_option_group("Field", "exactly one");
    field->add_option("--field", arguments.field, "name of the nodal values in the file")->type_name("NAME");
    field->add_option("--expression", arguments.expression, "a field as an expression in x and y")->type_name("EXPR");
    field->require_option(1);
    app.add_option("--error", arguments.target.error, "error of the gradient to reach, as a fraction of its norm")
        ->required()
        ->check(numberWithin(1e-9, 1.0))
        ->type_name("E");
    addOutputOptions(app, arguments.outputs, arguments.formats, arguments.form)->required();
    app.add_option("--rounds", arguments.rounds, "with --expression: maximum number of new meshes (default 8)")
        ->check(wholeNumberWithin(1, 100))
        ->type_name("N");
    app.add_option("--size-min", arguments.target.sizeMin, "minimum edge length")
        ->check(positiveNumber())
        ->type_name("H");
    app.add_option("--size-max", arguments.target.sizeMax, "maximum edge length")
        ->check(positiveNumber())
        ->type_name("H");
    app.add_option("--gradation", arguments.target.gradation,
                   "maximum change of edge length per unit of distance (default 0.3)")
        ->check(positiveNumber())
        ->type_name("G");
    addWordOption<Method>(app, "--method", arguments.method,
                          "fast (default), or classic: S. H. Lo's ten steps, shortest segment first")
        ->type_name("METHOD");
    addMaxElementsOption(app, arguments.maxElements);
    addUnitOption(app, arguments.form, "the unit of the domain, if it has one");
    app.add_option("--domain", arguments.domain, "domain to mesh; default: the area of the mesh, with its tags")
        ->type_name("IN");
    addDrawingOptions(app, arguments.drawing);
    app.add_flag("-q,--quiet", arguments.quiet, "print only warnings and errors");
}

} // namespace

int adaptCommand(const CommandLine &line) {
    AdaptArguments arguments;
    CLI::App app("Remeshes until a field is represented to a requested accuracy, with as few elements as possible.",
                 "forefront adapt");
    app.footer(kAdaptExamples);
    addAdaptOptions(app, arguments);
    addConfigOption(app);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    std::string wrong = checkFormats(arguments.outputs, arguments.formats);
    if (wrong.empty()) {
        wrong = checkInputs({arguments.mesh, arguments.domain}, arguments.inputFormat);
    }
    if (wrong.empty()) {
        wrong = unusedAdaptOption(arguments);
    }
    if (wrong.empty()) {
        wrong = checkUnit(arguments.form, pairFormats(arguments.outputs, arguments.formats));
    }
    if (!wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    std::vector<std::filesystem::path> inputs{arguments.mesh};
    if (arguments.domain) {
        inputs.push_back(*arguments.domain);
    }
    const Diagnostics faults = checkOutputs(pairFormats(arguments.outputs, arguments.formats), inputs);
    printFaults(faults);
    return faults.empty() ? runAdapt(arguments) : static_cast<int>(kRefused);
}

} // namespace forefront
