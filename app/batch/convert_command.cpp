#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/elevation_option.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/form_options.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/open_boundaries.hpp"
#include "app/batch/output_formats.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "app/batch/several_inputs.hpp"
#include "app/reports/second_order_notes.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/quads/recombine.hpp"
#include "core/files/common/dropped_fields.hpp"
#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kConvertExamples = R"help(
Nodes, elements, tags and names stay as they are, and so do nodal values "elevation" in formats that hold elevations. Other
values of nodes and elements are left out, with a note. A mesh with
elements that a format does not have is refused, and the message names formats that have them.

Examples:
  forefront convert plate.inp -o plate.msh
        triangles and quadrilaterals of both orders, with sets as regions and boundary parts
  forefront convert plate.msh -o plate.vtu -o plate.su2
        the same mesh in two formats
  forefront convert plate.msh bridge.msh -o "{}.vtu"
        each mesh into a file of its name
  forefront convert quads.msh -o triangles.node --triangles
        quadrilaterals become triangles, and elements of second order become several of first order
  forefront convert triangles.msh -o quads.inp --recombine
        quadrilaterals made of the triangles, with the same boundary, interfaces and tagged edges
  forefront convert plate.msh -o second.msh --order 2
        elements with nodes in the middles of their edges, which stay straight
  forefront convert plate.msh -o plate.inp --numbering rcm
        the same mesh with nodes and elements numbered for a small bandwidth
  forefront convert bay.msh -o bay.14 --open sea
        a grid of ADCIRC with one open boundary part; the rest is land
  forefront convert plate.msh -o plate.foam --extrude 0.1
        the folder of a case of OpenFOAM, one cell of 0.1 thick
  forefront convert plate.msh -o plate.vtu --extrude 2:8
        prisms and hexahedra in 8 layers, 2 high in all

Exit codes: 0 done, 1 input refused (faults on stderr, one per line), 2 usage error, 3 cancelled.)help";

struct ConvertArguments {
    std::vector<std::filesystem::path> meshes; ///< "-": standard input
    std::filesystem::path mesh;                ///< one of them
    std::string inputFormat;
    std::vector<std::filesystem::path> outputs; ///< "{}" in a name: the name of the mesh without its extension
    std::vector<std::string> formats;           ///< ids for the outputs in order; the rest by extension
    MeshForm form;
    bool triangles = false;            ///< split all elements into triangles of 3 nodes
    bool recombine = false;            ///< make quadrilaterals of triangles
    std::optional<ElementOrder> order; ///< raise the order of elements to this one
    std::optional<QuadNodes> quadNodes;
    bool quiet = false;

    /// Returns the stream for messages: stderr if a mesh goes to standard output.
    std::FILE *messages() const { return usesStandardOutput(outputs) ? stderr : stdout; }
};

/// Prints a note with the names of the values that no output holds.
void noteDroppedFields(const MeshFields &read, const Input &file) {
    Diagnostic note = noteOf(kDroppedFields, droppedFields(read));
    if (note.message.empty()) {
        return;
    }
    note.file = file.path.string();
    printFaults({note});
}

/// Returns the faults of a mesh that a format of the outputs cannot hold, before anything is written.
Diagnostics checkConverted(const Mesh &mesh, const ConvertArguments &arguments) {
    for (const Output &output : pairFormats(arguments.outputs, arguments.formats)) {
        Diagnostics faults = checkExport(*formatOf(output), mesh, exportOptionsOf(arguments.form, mesh));
        for (Diagnostic &fault : faults) {
            fault.file = isStandardStream(output.path) ? "" : output.path.string();
            if (fault.code == "unsupported-elements") {
                fault.advice += fault.advice.empty() ? "split the elements with --triangles"
                                                     : ", or split the elements with --triangles";
            }
        }
        if (!faults.empty()) {
            return faults;
        }
    }
    return {};
}

bool hasTriangles(const Mesh &mesh) {
    return std::any_of(mesh.blocks.begin(), mesh.blocks.end(),
                       [](const CellBlock &block) { return block.size() > 0 && block.traits().corners == 3; });
}

/// Prints how many triangles recombining left.
void noteRecombined(const QuadReport &report, const ConvertArguments &arguments) {
    if (report.triangles > 0 && !arguments.quiet) {
        printFaults({noteOf("triangles-left", countText(report.triangles, "triangle") +
                                                  " left, where faces have odd numbers of edges, "
                                                  "or lines that must stay meet at flat angles")});
    }
}

/// Changes the elements as the options ask. Returns the faults of a mesh that cannot be changed so.
Diagnostics changeElements(Mesh &mesh, const ConvertArguments &arguments, const Progress &progress) {
    const auto noEffect = [&](const std::string &text) {
        if (!arguments.quiet) {
            printFaults({noteOf("no-effect", text)});
        }
    };
    if (arguments.triangles && mesh.blocks.size() == 1 && mesh.blocks.front().kind() == CellKind::Triangle3) {
        noEffect("--triangles has no effect: all elements are triangles of 3 nodes");
    }
    if (arguments.triangles) {
        mesh = takeTriangulated(std::move(mesh)).mesh;
    }
    const bool joins = arguments.recombine && hasTriangles(mesh);
    if (arguments.recombine && !joins) {
        noEffect("--recombine has no effect: the mesh has no triangles");
    }
    if (joins) {
        const Result<QuadReport> report = recombine(mesh, ImproveLevel::Default, progress);
        if (!report) {
            return report.faults();
        }
        noteRecombined(*report, arguments);
    }
    if (!arguments.order) {
        return {};
    }
    std::size_t second = 0;
    for (const CellBlock &block : mesh.blocks) {
        second += block.traits().order == 2 ? block.size() : 0;
    }
    if (second == mesh.elementCount()) {
        noEffect("--order has no effect: all elements are of second order");
        return {};
    }
    if (second > 0) {
        return error("mixed-orders",
                     std::to_string(second) + " of " + std::to_string(mesh.elementCount()) +
                         " elements are of second order; expected elements of first order alone",
                     "add --triangles, which makes all of them triangles of first order");
    }
    SecondOrderReport report;
    if (!raiseOrder(mesh, {.quadNodes = arguments.quadNodes.value_or(QuadNodes::Eight)}, report, progress)) {
        return cancelled("converting");
    }
    if (!arguments.quiet) {
        printFaults(secondOrderNotes(report));
    }
    return {};
}

/// Takes the elevations of the nodes out of the values of a file, if it has some at all nodes.
std::vector<double> takeElevations(MeshFields &read, const ConvertArguments &arguments) {
    const auto found = read.fields.find("elevation");
    const bool complete =
        found != read.fields.end() && !arguments.form.elevation &&
        std::all_of(found->second.begin(), found->second.end(), [](double value) { return std::isfinite(value); });
    if (!complete) {
        return {};
    }
    std::vector<double> elevations = std::move(found->second);
    read.fields.erase(found);
    return elevations;
}

/// Sets the elevations that --elevation gives, or completes those of the file for nodes that were added. Returns the
/// faults of places without one.
Diagnostics setElevations(const MeshView &mesh, const ConvertArguments &arguments, std::vector<double> &elevations) {
    if (!arguments.form.elevation) {
        if (!elevations.empty()) {
            addMiddleElevations(mesh, elevations);
        }
        return {};
    }
    Result<std::vector<double>> read = readElevations(*arguments.form.elevation, mesh, {}, {}, arguments.quiet);
    if (!read) {
        return read.faults();
    }
    elevations = std::move(*read);
    return {};
}

/// Returns the form with the numbers of the file unless others are asked for.
MeshForm formAsRead(MeshForm form) {
    form.numbering = form.numbering.value_or(Numbering::Creation);
    return form;
}

void printSize(const Mesh &mesh, const ConvertArguments &arguments) {
    std::string text = std::to_string(mesh.nodes.size()) + " nodes";
    for (const CellBlock &block : mesh.blocks) {
        text += ", " + std::to_string(block.size()) + ' ' +
                (block.size() == 1 ? block.traits().name : block.traits().plural);
    }
    std::fprintf(arguments.messages(), "%s\n", text.c_str());
}

int runConvert(const ConvertArguments &arguments) {
    InterruptWatch interrupt;
    ProgressBar bar(!arguments.quiet);
    const Progress progress = bar.progress(interrupt.token());
    const Result<Input> file = bar.during("reading", [&] { return openInput(arguments.mesh, arguments.inputFormat); });
    if (!file) {
        return refuse(file.faults(), interrupt);
    }
    ImportNotes notes;
    Result<MeshFields> read =
        bar.during("reading", [&] { return allFormats().readFields(file->path, file->options, &notes); });
    if (!read) {
        return refuse(read.faults(), interrupt);
    }
    printNotes(notes, arguments.quiet);
    std::vector<double> elevations = takeElevations(*read, arguments);
    if (!arguments.quiet) {
        noteDroppedFields(*read, *file);
    }
    if (arguments.recombine && hasTriangles(read->mesh) && !elevations.empty()) {
        elevations.clear();
        if (!arguments.quiet) {
            printFaults({noteOf("elevations", "the elevations of the file are left out, since recombining moves nodes; "
                                              "give them with --elevation")});
        }
    }
    Mesh mesh = std::move(read->mesh);
    if (mesh.elementCount() == 0) {
        return refuse(
            allFormats().locateFaults(file->path, error("empty-mesh", "the mesh has no elements"), file->options),
            interrupt);
    }
    if (isClockwise(mesh)) {
        mesh = turned(std::move(mesh));
        if (!arguments.quiet) {
            printFaults({noteOf("clockwise", "all elements are clockwise; they are written turned the other way")});
        }
    }
    if (const Diagnostics faults = changeElements(mesh, arguments, progress); !faults.empty()) {
        return refuse(allFormats().locateFaults(file->path, faults, file->options), interrupt);
    }
    if (const Diagnostics faults = setElevations(mesh, arguments, elevations); !faults.empty()) {
        return refuse(faults, interrupt);
    }
    if (const Diagnostics unsupported = checkConverted(mesh, arguments); !unsupported.empty()) {
        return refuse(unsupported, interrupt);
    }
    if (const Diagnostics unknown = checkOpenNames(arguments.form, mesh); !unknown.empty()) {
        return refuse(allFormats().locateFaults(file->path, unknown, file->options), interrupt);
    }
    interrupt.deferToStop();
    const Diagnostics written = bar.during({}, [&] {
        MeshView view(mesh);
        view.elevations = elevations;
        return writeAndCommit(pairFormats(arguments.outputs, arguments.formats), view, formAsRead(arguments.form),
                              progress);
    });
    if (hasErrors(written)) {
        return refuse(written, interrupt);
    }
    if (!arguments.quiet) {
        printFaults(written);
        printSize(mesh, arguments);
        printWritten(arguments.outputs, arguments.messages());
    }
    return kDone;
}

} // namespace

int convertCommand(const CommandLine &line) {
    ConvertArguments arguments;
    CLI::App app("Writes a mesh in other formats.", "forefront convert");
    app.footer(kConvertExamples);
    app.add_option("MESH", arguments.meshes,
                   meshFileHelp() + "; several: each is converted, and {} in the names of outputs is replaced by the "
                                    "name of the mesh without its extension")
        ->required();
    addInputFormatOption(app, "MESH", arguments.inputFormat);
    addOutputOptions(app, arguments.outputs, arguments.formats, arguments.form)->required();
    addFormOptions(app, arguments.form, "none, since no unit is read from mesh files");
    app.add_flag("--triangles", arguments.triangles, "split all elements into triangles of 3 nodes");
    app.add_flag(
        "--recombine", arguments.recombine,
        "make quadrilaterals of triangles; boundary edges, interfaces between regions, tagged edges and tagged "
        "points stay, nodes inside move; after --triangles if both are given");
    app.add_option_function<std::string>(
           "--order", [&arguments](const std::string &) { arguments.order = ElementOrder::Second; },
           "2: add nodes in the middles of edges, which stay straight")
        ->check(oneOf(std::span(wordsOf<ElementOrder>()).last(1)))
        ->type_name("ORDER");
    addWordOption<QuadNodes>(app, "--quad-nodes", arguments.quadNodes,
                             "nodes of a quadrilateral of order 2: 8 (default), or 9 with one in its centre")
        ->needs("--order")
        ->type_name("N");
    app.add_flag("-q,--quiet", arguments.quiet, "print only warnings and errors");
    addConfigOption(app);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    std::string wrong = checkFormats(arguments.outputs, arguments.formats);
    if (wrong.empty()) {
        wrong = checkForm(arguments.form, pairFormats(arguments.outputs, arguments.formats), arguments.order);
    }
    if (wrong.empty()) {
        const Diagnostics faults = checkElevationExpression(arguments.form.elevation);
        wrong = faults.empty() ? std::string() : faults.front().message;
    }
    if (wrong.empty()) {
        wrong = checkInputs({arguments.meshes.front()}, arguments.inputFormat);
    }
    if (wrong.empty()) {
        wrong = checkStems(arguments.meshes, arguments.outputs);
    }
    if (!wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    std::vector<ConvertArguments> runs;
    std::vector<Output> files;
    for (const std::filesystem::path &mesh : arguments.meshes) {
        ConvertArguments &one = runs.emplace_back(arguments);
        one.mesh = mesh;
        for (std::filesystem::path &output : one.outputs) {
            output = withStem(output, mesh);
        }
        const std::vector<Output> outputs = pairFormats(one.outputs, one.formats);
        files.insert(files.end(), outputs.begin(), outputs.end());
    }
    std::vector<std::filesystem::path> inputs = arguments.meshes;
    if (arguments.form.elevation && isElevationFile(*arguments.form.elevation)) {
        inputs.emplace_back(*arguments.form.elevation);
    }
    if (const Diagnostics faults = checkOutputs(files, inputs); !faults.empty()) {
        printFaults(faults);
        return kRefused;
    }
    return runEach(arguments.meshes, arguments.quiet, [&](std::size_t k) { return runConvert(runs[k]); });
}

} // namespace forefront
