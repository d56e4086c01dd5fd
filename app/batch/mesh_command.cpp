#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/mesh_arguments.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "app/batch/report.hpp"
#include "core/domain/validate.hpp"
#include "core/edit/document.hpp"
#include "core/io/files.hpp"
#include "core/io/inner_edges.hpp"
#include "core/mesher/pipeline.hpp"

#include <algorithm>
#include <cstdio>

namespace forefront {

namespace {

/// By content; of what can be read only once, such as a pipe, by name.
bool isProject(const std::filesystem::path &file) {
    constexpr std::string_view kProject = "project";
    std::error_code none;
    if (std::filesystem::is_regular_file(file, none)) {
        const FileFormat *const format = fileFormatOf(file);
        return format != nullptr && format->id == kProject;
    }
    const std::vector<const FileFormat *> named = fileFormatsNamed(file);
    return !named.empty() && named.front()->id == kProject;
}

/// Domain of any file; spacing and options too where it is a project.
Result<MeshingJob> readJob(const MeshArguments &arguments) {
    if (isProject(arguments.input)) {
        const Result<Document> document = readDocument(arguments.input);
        if (!document) {
            return document.faults();
        }
        return MeshingJob{toDomain(*document), document->spacing, document->options};
    }
    Result<Domain> domain = readDomain(arguments.input);
    if (!domain) {
        return domain.faults();
    }
    return MeshingJob{std::move(*domain), {}, {}};
}

/// The command line wins over the project.
Diagnostics applySpacing(const MeshArguments &arguments, SpacingSpec &spacing) {
    if (arguments.size || arguments.expression) {
        spacing = {};
        spacing.size = arguments.size;
        spacing.expression = arguments.expression;
    } else if (arguments.spacingFile) {
        Result<SpacingSpec> read = readSpacing(*arguments.spacingFile);
        if (!read) {
            return read.faults();
        }
        spacing = std::move(*read);
    }
    if (arguments.gradation) {
        spacing.gradation = arguments.gradation;
    }
    return {};
}

void applyOptions(const MeshArguments &arguments, MeshingOptions &options) {
    if (arguments.grid) {
        options.grid = *arguments.grid;
        options.gridColumns = arguments.gridColumns;
        options.gridRows = arguments.gridRows;
    }
    options.keepBoundary = options.keepBoundary || arguments.keepBoundary;
    options.method = arguments.method.value_or(options.method);
    options.improve = arguments.improve.value_or(options.improve);
    options.threads = arguments.threads.value_or(options.threads);
}

Diagnostics repairDomain(const MeshArguments &arguments, Domain &domain) {
    Result<Repaired> repaired = repair(domain);
    if (!repaired) {
        return locateFaults(arguments.input, repaired.faults());
    }
    if (!arguments.quiet) {
        printFaults(locateFaults(arguments.input, std::move(repaired->changes)));
    }
    domain = std::move(repaired->domain);
    return {};
}

/// Writes the meshes and the statistics. The result holds what went wrong, else notes on what the formats changed.
Diagnostics writeOutputs(const MeshArguments &arguments, const Mesh &mesh, const RunReport &report,
                         const Progress &progress) {
    const bool drops = arguments.innerEdges == InnerEdges::Drop && !arguments.outputs.empty();
    const Mesh outline = drops ? withoutInnerEdges(mesh) : Mesh();
    Diagnostics notes;
    for (std::size_t i = 0; i < arguments.outputs.size(); ++i) {
        const Diagnostics faults =
            writeMesh(arguments.outputs[i], drops ? outline : mesh, arguments.format(i), progress);
        if (hasErrors(faults)) {
            return faults;
        }
        notes.insert(notes.end(), faults.begin(), faults.end());
    }
    if (arguments.statistics && !arguments.printsStatistics()) {
        const Diagnostics faults = writeFileAtomically(*arguments.statistics, statisticsJson(report));
        notes.insert(notes.end(), faults.begin(), faults.end());
    }
    return notes;
}

void printResult(const MeshArguments &arguments, const RunReport &report) {
    if (arguments.printsStatistics()) {
        std::fputs(statisticsJson(report).c_str(), stdout);
    } else if (!arguments.quiet) {
        for (const auto &path : arguments.outputs) {
            std::printf("wrote %s\n", path.string().c_str());
        }
        std::fputs(summary(report).c_str(), stdout);
    }
}

} // namespace

int meshCommand(int argc, const char *const *argv) {
    const auto parsed = parseMeshArguments(argc, argv);
    if (const int *code = std::get_if<int>(&parsed)) {
        return *code;
    }
    const MeshArguments &arguments = std::get<MeshArguments>(parsed);
    std::vector<Output> files;
    for (std::size_t k = 0; k < arguments.outputs.size(); ++k) {
        files.push_back({arguments.outputs[k], arguments.format(k)});
    }
    if (arguments.statistics && !arguments.printsStatistics()) {
        files.push_back({*arguments.statistics, {}});
    }
    std::vector<std::filesystem::path> inputs{arguments.input};
    if (arguments.spacingFile) {
        inputs.emplace_back(*arguments.spacingFile);
    }
    Diagnostics faults = checkOutputs(files, inputs);
    if (!faults.empty()) {
        printFaults(faults);
        return kRefused;
    }
    InterruptWatch interrupt;
    ProgressBar bar(!arguments.quiet);
    Progress progress;
    progress.stop = interrupt.token();
    progress.report = [&bar](std::string_view stage, double fraction) { bar.show(stage, fraction); };

    bar.show("reading", 0.0);
    Result<MeshingJob> job = readJob(arguments);
    faults = job ? applySpacing(arguments, job->spacing) : job.faults();
    bar.clear();
    interrupt.askFromNowOn();
    if (faults.empty() && arguments.repair) {
        faults = repairDomain(arguments, job->domain);
    }
    if (!faults.empty()) {
        return refuse(faults, interrupt);
    }
    applyOptions(arguments, job->options);

    const Result<MeshingOutcome> outcome = meshDomain(*job, progress);
    bar.clear();
    if (!outcome) {
        const int code =
            refuse(meshingFaults(outcome.faults(), job->domain, arguments.input, !arguments.repair), interrupt);
        const bool mistyped = arguments.expression && hasCode(outcome.faults(), "expression-syntax");
        return code == kRefused && mistyped ? static_cast<int>(kUsage) : code;
    }
    const RunReport report = reportOf(*outcome, job->options);
    faults = writeOutputs(arguments, outcome->mesh, report, progress);
    bar.clear();
    if (hasErrors(faults)) {
        return refuse(faults, interrupt);
    }
    if (!arguments.quiet) {
        printFaults(faults);
    }
    printResult(arguments, report);
    return kDone;
}

} // namespace forefront
