#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/elevation_option.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/form_options.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/open_boundaries.hpp"
#include "app/batch/option_notes.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "app/batch/script_options.hpp"
#include "app/reports/report.hpp"
#include "app/reports/second_order_notes.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/script/script_player.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/mesh/large_elements.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kRunHelp = R"help(
A script is a text of JSON objects, one command each, usually one a line. Paths are relative to the folder of the
script, or to the current folder if it is read from standard input.

  {"command": "new"}                                             an empty drawing; "project": with this content
  {"command": "open", "file": "plate.json"}                      a project or any file that the editor opens; of a
                                                                 map also "projection": "local" or "EPSG:3067",
                                                                 "layer", "nameProperty", "sizeProperty" and "weld",
                                                                 as the options of forefront mesh
  {"command": "add", "shapes": [{"kind": "rectangle", "nodes": [[0, 0], [4, 2]]}]}
  {"command": "move", "shapes": [1], "by": [1, 0]}               or "nodes": ["shape/1/node/0"]; takes along what
                                                                 is joined with them, without "alone": true
  {"command": "constrain", "kind": "length", "parts": ["shape/1/segment/0"], "value": "2*r"}
  {"command": "name", "boundary": 1, "name": "inlet"}            or "shape": 1, "regionMarker": 0, or
                                                                 "segments": ["shape/1/segment/0"], such as the
                                                                 open part of a coast
  {"command": "size", "size": 0.5}                               or "expression": "0.1+0.2*x"; "boundary": 1 with it
  {"command": "parameter", "name": "r", "expression": "0.4"}     null removes it
  {"command": "change", "remove": [2], "replace": [...], "members": {"options": {"method": "classic"}}}
  {"command": "undo", "steps": 2}                                and redo
  {"command": "mesh"}                                            with "hash": refused if the mesh has another
  {"command": "check"}                                           verifies the mesh and the limits of the project
  {"command": "export", "file": "plate.msh"}                     with "format": ID if the extension does not say it,
                                                                 "open": ["sea"], the open boundary parts, and
                                                                 "elevation": a grid, raster or expression; without
                                                                 them, those of the project
  {"command": "save", "file": "plate.json"}

Shapes and the members of "change" are written as in project files; a shape without "id" gets the next free one.

Examples:
  forefront run plate.jsonl
        carry out the commands of a file in order, up to the first that fails
  forefront run - < plate.jsonl
        read the script from standard input

Exit codes: 0 done, 1 script refused or a check failed (faults on stderr with line and column), 2 usage error,
3 cancelled)help";

constexpr std::size_t kMaxScriptBytes = std::size_t{1} << 30;

struct RunScriptArguments {
    std::filesystem::path script;
    bool quiet = false;
};

/// Carries out the commands of a script in order.
class ScriptRun {
  public:
    ScriptRun(const RunScriptArguments &arguments, const SourceText &source, InterruptWatch &interrupt)
        : arguments_(arguments), source_(source), interrupt_(interrupt), bar_(!arguments.quiet) {}

    /// Returns the faults of the first command that fails. Prints the warnings and notes of those before it.
    Status run(const Script &script) {
        for (const ScriptCommand &command : script.commands()) {
            Status faults = placedAt(perform(command), command, source_);
            if (hasErrors(faults)) {
                return faults;
            }
            if (arguments_.quiet) {
                std::erase_if(faults, [](const Diagnostic &fault) { return fault.severity == Severity::Note; });
            }
            printFaults(faults);
            if (interrupt_.interrupted()) {
                return error("cancelled", "cancelled");
            }
        }
        return {};
    }

  private:
    Status perform(const ScriptCommand &command) {
        switch (command.word) {
        case ScriptWord::Open:
            return open(command);
        case ScriptWord::Mesh:
            return mesh(command);
        case ScriptWord::Check:
            return check(command);
        case ScriptWord::Export:
            return exportMesh(command);
        case ScriptWord::Save:
            return save(command);
        case ScriptWord::New:
            projection_.clear();
            system_ = {};
            [[fallthrough]];
        default:
            meshed_.reset();
            return player_.play(command, source_);
        }
    }

    /// Returns the path of the member "file".
    Result<std::filesystem::path> pathOf(const ScriptCommand &command) const {
        const Result<std::string> file = requiredText(command, "file", source_);
        if (!file) {
            return file.faults();
        }
        if (isStandardStream(*file)) {
            return error("bad-value", "expected the name of a file, got '-'",
                         "scripts read and write files alone; ./- is a file of that name");
        }
        return source_.path.parent_path() / *file;
    }

    void print(const ScriptCommand &command, const std::string &text) const {
        if (!arguments_.quiet) {
            std::printf("line %d: %s\n", placeOf(source_.text, command.value.offset()).line, text.c_str());
        }
    }

    Status open(const ScriptCommand &command) {
        const Result<std::filesystem::path> path = pathOf(command);
        if (!path) {
            return path.faults();
        }
        const Result<DrawingArguments> drawing = openOptions(command, source_);
        if (!drawing) {
            return drawing.faults();
        }
        ImportNotes notes;
        Input input{*path, {}};
        if (const std::string wrong = checkDrawingOptions(*drawing, input, false); !wrong.empty()) {
            return error("bad-value", wrong);
        }
        drawing->applyTo(input.options);
        Result<Document> document = readDocument(input.path, input.options, &notes);
        if (!document) {
            return document.faults();
        }
        player_.load(*std::move(document));
        meshed_.reset();
        projection_ = drawing->projection;
        system_ = notes.contents().system;
        return notes.diagnostics();
    }

    Status mesh(const ScriptCommand &command) {
        const Result<std::string> expected = optionalText(command, "hash", source_);
        if (!expected) {
            return expected.faults();
        }
        const Progress progress = bar_.progress(interrupt_.token());
        const MeshingJob job = jobOf(player_.document());
        Result<MeshingOutcome> outcome = bar_.during({}, [&] { return meshDomain(job, progress); });
        if (!outcome) {
            return outcome.faults();
        }
        meshed_ = *std::move(outcome);
        const std::string hash = toHex(meshHash(meshed_->mesh));
        if (!expected->empty() && *expected != hash) {
            return error("different-mesh", "the mesh has the hash " + hash + ", expected " + *expected,
                         "leave \"hash\" out if the mesh may differ from the one recorded");
        }
        print(command, "mesh of " + std::to_string(meshed_->mesh.elementCount()) + " elements and " +
                           std::to_string(meshed_->mesh.nodes.size()) + " nodes, hash " + hash);
        return remarksOn(job);
    }

    /// Returns the notes and warnings on the mesh, those of the command mesh.
    Diagnostics remarksOn(const MeshingJob &job) const {
        const RunReport report = reportOf(*meshed_, job.options);
        Diagnostics remarks = job.findings;
        for (const Diagnostics &more :
             {meshed_->spacing->notes(),
              violatedLimits(meshed_->mesh, player_.document().limits, meshed_->spacing.get()),
              largeElements(meshed_->mesh, job.domain, job.spacing.placed.regions), flatElements(report.quality),
              concavePlaces(report.quads), secondOrderNotes(report.order)}) {
            remarks.insert(remarks.end(), more.begin(), more.end());
        }
        return remarks;
    }

    Status needsMesh() const {
        return meshed_ ? Status()
                       : error("no-mesh", "the document has no mesh", "put the command mesh before this one");
    }

    Status check(const ScriptCommand &command) {
        if (Status faults = needsMesh(); !faults.empty()) {
            return faults;
        }
        Diagnostics faults = verifyAgainst(meshed_->mesh, *meshed_->boundary);
        for (const LimitVerdict &verdict :
             checkLimits(meshed_->mesh, player_.document().limits, meshed_->spacing.get())) {
            if (!verdict.met()) {
                faults.push_back(error("limit-violated", toString(verdict)).front());
            }
        }
        if (!hasErrors(faults)) {
            print(command, "the mesh fits its domain and meets its limits");
        }
        return faults;
    }

    Status exportMesh(const ScriptCommand &command) {
        const Result<std::filesystem::path> path = pathOf(command);
        const Result<std::string> format = optionalText(command, "format", source_);
        if (!path || !format) {
            return !path ? path.faults() : format.faults();
        }
        if (Status faults = needsMesh(); !faults.empty()) {
            return faults;
        }
        if (const std::string wrong = checkFormat(*path, *format); !wrong.empty()) {
            return error("bad-value", wrong);
        }
        const std::vector<Output> outputs = {{*path, *format}};
        if (Status faults = checkOutputs(outputs, {source_.path}); !faults.empty()) {
            return faults;
        }
        const Diagnostics written = exportTo(outputs, command);
        if (!hasErrors(written)) {
            print(command, "wrote " + path->string());
        }
        return written;
    }

    /// Writes the mesh with the open parts and elevations that the command says.
    Diagnostics exportTo(const std::vector<Output> &outputs, const ScriptCommand &command) {
        Result<MeshForm> form = exportForm(command, source_);
        if (!form) {
            return form.faults();
        }
        form->system = system_;
        const MeshingJob job = jobOf(player_.document());
        const ElevationCalls calls{job.spacing, job.domain};
        if (std::string wrong = checkOpen(*form, outputs) + checkElevation(form->elevation, outputs); !wrong.empty()) {
            return error("bad-value", std::move(wrong));
        }
        const Document &document = player_.document();
        if (command.value.find("open")) {
            useWaterOf({}, document.elevation, outputs, *form); // an empty list closes all parts
        } else {
            useWaterOf(document.openBoundaries, document.elevation, outputs, *form);
        }
        if (Status faults = checkElevationExpression(form->elevation, calls); !faults.empty()) {
            return faults;
        }
        MeshView mesh(meshed_->mesh);
        if (Status faults = checkOpenNames(*form, mesh); !faults.empty()) {
            return faults;
        }
        const Result<std::vector<double>> elevations =
            form->elevation ? readElevations(*form->elevation, mesh, projection_, system_, arguments_.quiet, calls)
                            : Result<std::vector<double>>(std::vector<double>());
        if (!elevations) {
            return elevations.faults();
        }
        mesh.elevations = *elevations;
        return bar_.during({}, [&] { return writeAndCommit(outputs, mesh, *form, bar_.progress(interrupt_.token())); });
    }

    Status save(const ScriptCommand &command) {
        const Result<std::filesystem::path> path = pathOf(command);
        if (!path) {
            return path.faults();
        }
        if (Status faults = checkOutputs({{*path, {}}}, {source_.path}); !faults.empty()) {
            return faults;
        }
        if (Status faults = writeProject(*path, player_.document()); !faults.empty()) {
            return faults;
        }
        print(command, "wrote " + path->string());
        return {};
    }

    const RunScriptArguments &arguments_;
    const SourceText &source_;
    InterruptWatch &interrupt_;
    ProgressBar bar_;
    ScriptPlayer player_;
    std::optional<MeshingOutcome> meshed_; ///< of the document as it is now
    std::string projection_;               ///< of the map that was opened, for elevations
    MapSystem system_;                     ///< of that map, for files that name it
};

int runScript(const RunScriptArguments &arguments) {
    InterruptWatch interrupt;
    const bool standard = isStandardStream(arguments.script);
    const Result<std::string> text =
        standard ? readStandardInput(kMaxScriptBytes) : readFileBytes(arguments.script, kMaxScriptBytes);
    if (!text) {
        return refuse(text.faults(), interrupt);
    }
    SourceText source{*text, standard ? "standard input" : arguments.script.string(), {}, {}};
    source.path = standard ? std::filesystem::path() : arguments.script;
    const Result<Script> script = Script::read(source);
    if (!script) {
        return refuse(script.faults(), interrupt);
    }
    interrupt.deferToStop();
    const Status faults = ScriptRun(arguments, source, interrupt).run(*script);
    return faults.empty() ? static_cast<int>(kDone) : refuse(faults, interrupt);
}

} // namespace

int runCommand(const CommandLine &line) {
    RunScriptArguments arguments;
    CLI::App app("Carries out the commands of a script: draws, meshes, checks, exports.", "forefront run");
    app.footer(kRunHelp);
    app.add_option("SCRIPT", arguments.script, "script of JSON lines; -: standard input")->required();
    app.add_flag("-q,--quiet", arguments.quiet, "print only warnings and errors");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    return runScript(arguments);
}

} // namespace forefront
