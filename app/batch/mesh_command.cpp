#include "app/batch/cli_options.hpp"
#include "app/batch/coast_notes.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/elevation_option.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/mesh_job.hpp"
#include "app/batch/option_notes.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "app/batch/several_inputs.hpp"
#include "app/batch/unit_option.hpp"
#include "app/reports/estimate_report.hpp"
#include "app/reports/report.hpp"
#include "app/reports/second_order_notes.hpp"
#include "core/drawing/commands/mesh_within_limits.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/large_elements.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/target_elements.hpp"
#include "core/engine/spacing/scaled_sizes.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// Returns notes on options that have no effect on this run.
Diagnostics unusedOptions(const MeshArguments &arguments, const MeshingJob &job, const SpacingField &spacing) {
    Diagnostics notes;
    const auto add = [&](const char *option, const char *reason) {
        notes.push_back(noteOf("no-effect", std::string(option) + " has no effect: " + reason));
    };
    if (arguments.gradation && spacing.minimum() == spacing.maximum()) {
        add("--gradation", "the size is the same everywhere");
    }
    if (arguments.curveTolerance && job.domain.curves.empty()) {
        add("--curve-tolerance", "the domain has no curves");
    } else if (arguments.curveTolerance && job.options.keepBoundary) {
        add("--curve-tolerance", "the given segments are kept");
    }
    const auto hasQuads = [](const RegionElements &own) { return own.elements != Elements::Triangles; };
    const auto hasTriangles = [](const RegionElements &own) { return own.elements == Elements::Triangles; };
    if (job.options.elements != Elements::Triangles && std::ranges::none_of(job.regionElements, hasTriangles)) {
        if (arguments.method) {
            add("--method", "quadrilaterals have a front of their own");
        }
        if (arguments.threads) {
            add("--threads", "quadrilaterals are made on one thread");
        }
    }
    const bool mayCallRasters =
        job.spacing.expression || (arguments.form.elevation && !isElevationFile(*arguments.form.elevation));
    if (!arguments.rasters.empty() && !mayCallRasters) {
        add("--raster", "no expression sets the size; add --spacing EXPR or --size-preset RULE");
    }
    if (arguments.quadNodes && job.options.order == ElementOrder::First) {
        add("--quad-nodes", "elements of order 1 have nodes at their corners alone; add --order 2");
    } else if (arguments.quadNodes && job.options.elements == Elements::Triangles &&
               std::ranges::none_of(job.regionElements, hasQuads) && job.layers.empty() && job.strips.empty()) {
        add("--quad-nodes", "the elements are triangles");
    }
    return notes;
}

/// Meshes a job within its limits, and leaves the changed job. Prints the remarks.
Result<MeshingOutcome> fixedMesh(const MeshLimits &limits, const Progress &progress, bool quiet, MeshingJob &job) {
    Result<FixedMesh> fixed = meshWithinLimits(job, limits, progress);
    if (!fixed) {
        return fixed.faults();
    }
    if (!quiet) {
        printFaults(fixed->remarks);
    }
    job = std::move(fixed->job);
    return std::move(fixed->outcome);
}

/// Scales the sizes of a job until its mesh has a number of elements. Returns the errors or, if there are none, a
/// warning if limits hold the sizes.
Diagnostics scaleToTarget(std::uint64_t target, MeshingJob &job, const Progress &progress) {
    const auto scaled = [&job](double factor) {
        MeshingJob next = job;
        next.spacing = scaledSizes(job.spacing, factor, job.domain);
        next.shared = nullptr; // the field of other sizes
        return next;
    };
    const Result<TargetSizes> sizes = sizesForElements(scaled, target, progress);
    if (!sizes) {
        return sizes.faults();
    }
    job = scaled(sizes->factor);
    return missedTarget(*sizes, target, job);
}

/// Writes the meshes in a form, and the statistics, all of them or none. Returns the errors or, if there are none,
/// notes on what the formats changed.
Diagnostics writeResults(const MeshArguments &arguments, const MeshForm &form, const Mesh &outcome,
                         const ElevationCalls &calls, const RunReport &report, const Progress &progress) {
    MeshView mesh(outcome);
    std::vector<double> elevations;
    if (arguments.form.elevation) {
        Result<std::vector<double>> read = readElevations(*arguments.form.elevation, mesh, arguments.drawing.projection,
                                                          form.system, arguments.quiet, calls);
        if (!read) {
            return read.faults();
        }
        elevations = std::move(*read);
        mesh.elevations = elevations;
        printFaults(dryElevations(elevations, pairFormats(arguments.outputs, arguments.formats)));
    }
    FileSet files;
    Diagnostics notes = writeOutputs(files, pairFormats(arguments.outputs, arguments.formats), mesh, form, progress);
    if (hasErrors(notes)) {
        return notes;
    }
    if (arguments.statistics && !arguments.printsStatistics()) {
        files.write(*arguments.statistics, statisticsJson(report));
    }
    const Status written = files.commit();
    return written.empty() ? notes : written;
}

Status printResult(const MeshArguments &arguments, const RunReport &report) {
    if (arguments.printsStatistics()) {
        return printText(statisticsJson(report));
    }
    if (!arguments.quiet) {
        std::FILE *const out = usesStandardOutput(arguments.outputs) ? stderr : stdout;
        printWritten(arguments.outputs, out);
        std::fputs(summary(report).c_str(), out);
    }
    return {};
}

/// Prints how large and long a run would be. Returns the exit code.
int printEstimate(const MeshArguments &arguments, const RunEstimate &estimate, const MeshingOptions &options,
                  const InterruptWatch &interrupt) {
    const Status printed =
        printText(arguments.json ? estimateJson(estimate, arguments.input.string()) : estimateText(estimate, options));
    return printed.empty() ? static_cast<int>(kDone) : refuse(printed, interrupt);
}

/// Prints what is to be said of a mesh before it is written.
void printRemarks(const MeshArguments &arguments, const MeshingOutcome &outcome, const MeshingJob &job,
                  const MeshLimits &limits) {
    if (!arguments.quiet) {
        printFaults(outcome.spacing->notes());
        printFaults(unusedOptions(arguments, job, *outcome.spacing));
    }
    printFaults(dryPresets(arguments.presets, job.spacing, outcome.mesh));
    printFaults(openShore(arguments.presets, arguments.form.open));
    printFaults(violatedLimits(outcome.mesh, limits, outcome.spacing.get()));
    printFaults(largeElements(outcome.mesh, job.domain, job.spacing.placed.regions));
}

/// Writes a mesh with its statistics and prints the result. Returns the exit code.
int finish(const MeshArguments &arguments, const ReadJob &read, const MeshingOutcome &outcome, ProgressBar &bar,
           const Progress &progress, const InterruptWatch &interrupt) {
    RunReport report = reportOf(outcome, read.job.options);
    report.input = arguments.input.string();
    MeshForm form = withUnitOf(read.unit, arguments.form);
    form.system = read.system;
    const ElevationCalls calls{read.job.spacing, read.job.domain};
    const Diagnostics notes =
        bar.during({}, [&] { return writeResults(arguments, form, outcome.mesh, calls, report, progress); });
    if (hasErrors(notes)) {
        return refuse(notes, interrupt);
    }
    if (!arguments.quiet) {
        printFaults(notes);
        printFaults(flatElements(report.quality));
        printFaults(concavePlaces(report.quads));
        printFaults(secondOrderNotes(report.order));
        printFaults(shortenedLayers(outcome.layers, outcome.mesh.boundaryNames));
    }
    const Status printed = printResult(arguments, report);
    return printed.empty() ? static_cast<int>(kDone) : refuse(printed, interrupt);
}

int runMesh(MeshArguments arguments) {
    InterruptWatch interrupt;
    ProgressBar bar(!arguments.quiet);
    const Progress progress = bar.progress(interrupt.token());

    Result<MeshFiles> files = bar.during("reading", [&] { return openFiles(arguments); });
    if (!files) {
        return refuse(files.faults(), interrupt);
    }
    if (const std::string wrong = checkFiles(arguments, *files); !wrong.empty()) {
        return wrongUsage("forefront mesh", wrong);
    }
    Result<ReadJob> read = readJob(arguments, *files, bar);
    interrupt.deferToStop();
    Diagnostics faults = read ? applyArguments(arguments, files->input, progress, *read) : read.faults();
    if (!faults.empty()) {
        return refuse(faults, interrupt);
    }
    useWaterOf(read->openBoundaries, read->elevation, pairFormats(arguments.outputs, arguments.formats),
               arguments.form);
    MeshingJob &job = read->job;
    faults = checkElevationExpression(arguments.form.elevation, ElevationCalls{job.spacing, job.domain});
    if (!faults.empty()) {
        return hasCode(faults, "expression-syntax") ? wrongUsage("forefront mesh", faults.front().message)
                                                    : refuse(faults, interrupt);
    }
    const auto refuseRun = [&](const Diagnostics &why) {
        const Repaired *const repaired = read->repaired ? &*read->repaired : nullptr;
        const Diagnostics wrong = meshingFaults(why, job.domain, files->input, repaired);
        const Input &owner = files->spacing ? *files->spacing : files->input;
        const int code = refuse(arguments.expression ? wrong : locateSpacing(wrong, owner), interrupt);
        const bool mistyped = arguments.expression && hasCode(why, "expression-syntax");
        return code == kRefused && mistyped ? static_cast<int>(kUsage) : code;
    };
    if (arguments.targetElements) {
        faults = bar.during({}, [&] { return scaleToTarget(*arguments.targetElements, job, progress); });
        if (hasErrors(faults)) {
            return refuseRun(faults);
        }
        printFaults(faults);
    }
    if (arguments.dryRun) {
        const Result<RunEstimate> estimate = bar.during({}, [&] { return estimateRun(job, progress); });
        return estimate ? printEstimate(arguments, *estimate, job.options, interrupt) : refuseRun(estimate.faults());
    }
    const MeshLimits limits = mergedLimits(read->limits, arguments.limits);
    if (arguments.fix && !limits.any()) {
        return wrongUsage("forefront mesh", "--fix: there are no limits; add --limit NAME=VALUE");
    }
    const Result<MeshingOutcome> outcome = bar.during({}, [&] {
        return arguments.fix ? fixedMesh(limits, progress, arguments.quiet, job) : meshDomain(job, progress);
    });
    if (!outcome) {
        return refuseRun(outcome.faults());
    }
    printRemarks(arguments, *outcome, job, limits);
    return finish(arguments, *read, *outcome, bar, progress, interrupt);
}

} // namespace

int meshCommand(const CommandLine &line) {
    const auto parsed = parseMeshArguments(line);
    if (const int *code = std::get_if<int>(&parsed)) {
        return *code;
    }
    const MeshArguments &all = std::get<MeshArguments>(parsed);
    std::vector<MeshArguments> runs;
    std::vector<Output> files;
    for (const std::filesystem::path &input : all.inputs) {
        const MeshArguments &one = runs.emplace_back(all.of(input));
        const std::vector<Output> outputs = pairFormats(one.outputs, one.formats);
        files.insert(files.end(), outputs.begin(), outputs.end());
        if (one.statistics && !one.printsStatistics()) {
            files.push_back({*one.statistics, {}});
        }
    }
    std::vector<std::filesystem::path> inputs = all.inputs;
    if (all.spacingFile) {
        inputs.emplace_back(*all.spacingFile);
    }
    if (all.form.elevation && isElevationFile(*all.form.elevation)) {
        inputs.emplace_back(*all.form.elevation);
    }
    if (const Diagnostics faults = checkOutputs(files, inputs); !faults.empty()) {
        printFaults(faults);
        return kRefused;
    }
    return runEach(all.inputs, all.quiet || all.json || all.printsStatistics(),
                   [&](std::size_t k) { return runMesh(runs[k]); });
}

} // namespace forefront
