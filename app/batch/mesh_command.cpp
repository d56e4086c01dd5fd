#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/elevation_option.hpp"
#include "app/batch/estimate_report.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/fix_option.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/mesh_arguments.hpp"
#include "app/batch/open_boundaries.hpp"
#include "app/batch/option_notes.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/part_options.hpp"
#include "app/batch/progress_bar.hpp"
#include "app/batch/raster_option.hpp"
#include "app/batch/report.hpp"
#include "app/batch/rules_option.hpp"
#include "app/batch/several_inputs.hpp"
#include "app/batch/unit_option.hpp"
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
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

/// What to mesh, and where a picture of sizes lies.
struct ReadJob {
    MeshingJob job;
    Box2 box;                                      ///< of the domain
    std::optional<BackgroundPicture> picture;      ///< of a project
    MeshLimits limits;                             ///< of a project
    LengthUnit unit = LengthUnit::None;            ///< of the coordinates
    MapSystem system = {};                         ///< of the coordinates of a map
    std::vector<PeriodicSpec> periodicOfMesh = {}; ///< parts that nobody asked for
};

/// Reads the domain of any file with its element sizes, and also options if the file is a project.
Result<ReadJob> readJob(const Input &input, ImportNotes &notes) {
    if (input.isProject()) {
        const Result<Document> document = readDocument(input.path, input.options, &notes);
        if (!document) {
            return document.faults();
        }
        return ReadJob{jobOf(*document), boundsOf(*document), document->picture, document->limits, document->unit};
    }
    Result<DomainFile> file = allFormats().readDomain(input.path, input.options, &notes);
    if (!file) {
        return file.faults();
    }
    const Box2 box = file->domain.bounds();
    MeshingJob job{std::move(file->domain), std::move(file->spacing), {}};
    job.cracks = std::move(file->cracks);
    job.periodic = file->periodic;
    return ReadJob{std::move(job), box, {}, {}, file->unit, {}, std::move(file->periodic)};
}

/// Returns what is wrong with the options of a picture as spacing file; empty if nothing is.
std::string checkPicture(const MeshArguments &arguments, const Input &file) {
    const FileFormat *const format = file.format();
    const bool picture = format != nullptr && format->kind == FileKind::Picture;
    if (picture && !arguments.pictureSizes) {
        return "--spacing-file: a picture needs sizes for black and white; add --picture-sizes BLACK:WHITE";
    }
    return picture || (!arguments.pictureSizes && !arguments.pictureBox)
               ? std::string()
               : "--picture-sizes, --picture-box: " + file.path.string() + " is not a picture; expected a PNG file";
}

/// Sets the parameters of the input. Returns what is wrong with options that depend on the formats of the files; empty
/// if nothing is.
std::string checkFiles(const MeshArguments &arguments, Input &input, const std::optional<Input> &spacingFile) {
    std::string wrong = checkDrawingOptions(arguments.drawing, input, arguments.repair);
    wrong = wrong.empty() ? setParameters(input, arguments.parameters) : wrong;
    return wrong.empty() && spacingFile ? checkPicture(arguments, *spacingFile) : wrong;
}

/// Returns the sizes of a picture with its place. Fault: turned-picture.
Result<std::optional<PictureSizes>> placedPicture(const MeshArguments &arguments, const Input &file,
                                                  const ReadJob &job) {
    std::optional<PictureSizes> sizes = arguments.pictureSizes;
    std::error_code none;
    if (sizes && arguments.pictureBox) {
        sizes->box = *arguments.pictureBox;
    } else if (sizes && job.picture && std::filesystem::equivalent(file.path, job.picture->file, none)) {
        if (job.picture->angle != 0.0) {
            return error("turned-picture",
                         "the background picture is turned by " + numberText(job.picture->angle, 6) +
                             " degrees; expected a picture along the axes as spacing",
                         "give its rectangle with --picture-box X0,Y0,X1,Y1, or turn the picture in another program");
        }
        sizes->box = boundsOf(*job.picture);
    } else if (sizes) {
        sizes->box = job.box;
        sizes->around = true;
    }
    return sizes;
}

/// Replaces the spacing of a project by that of the command line, such as that of `file`.
Diagnostics applySpacing(const MeshArguments &arguments, const std::optional<Input> &file, ReadJob &read,
                         ImportNotes &notes) {
    SpacingSpec &spacing = read.job.spacing;
    const char *const option = arguments.size               ? "--size"
                               : !arguments.presets.empty() ? "--size-preset"
                               : arguments.expression       ? "--spacing"
                               : file                       ? "--spacing-file"
                                                            : nullptr;
    if (Diagnostics faults = addRasters(arguments.rasters, arguments.drawing.projection, arguments.quiet, spacing);
        !faults.empty()) {
        return faults;
    }
    if (option != nullptr && !arguments.quiet) {
        printFaults(replacedSpacing(option, spacing));
    }
    if (!applySpacingOptions(arguments.size, arguments.expression, spacing) && file) {
        ImportOptions options = file->options;
        const Result<std::optional<PictureSizes>> placed = placedPicture(arguments, *file, read);
        if (!placed) {
            return placed.faults();
        }
        options.picture = *placed;
        options.projection = arguments.drawing.projection;
        Result<SpacingSpec> fromFile = allFormats().readSpacing(file->path, options, &notes);
        if (!fromFile) {
            return fromFile.faults();
        }
        spacing.replaceRules(std::move(*fromFile));
    }
    if (arguments.gradation) {
        spacing.gradation = arguments.gradation;
    }
    if (arguments.segmentsPerTurn) {
        spacing.segmentsPerTurn = arguments.segmentsPerTurn;
    }
    if (arguments.elementsAcross) {
        spacing.elementsAcross = arguments.elementsAcross;
    }
    if (arguments.curveTolerance) {
        read.job.domain.curveTolerance = arguments.curveTolerance->distance(read.job.domain.bounds().diagonal());
    }
    return {};
}

Diagnostics applyOptions(const MeshArguments &arguments, MeshingOptions &options) {
    if (arguments.grid) {
        options.grid = *arguments.grid;
        options.gridColumns = arguments.gridColumns;
        options.gridRows = arguments.gridRows;
    }
    options.keepBoundary = options.keepBoundary || arguments.keepBoundary;
    options.verify = arguments.verify;
    options.order = arguments.order.value_or(options.order);
    options.quadNodes = arguments.quadNodes.value_or(options.quadNodes);
    if (arguments.leastAngle) {
        options.leastAngle = arguments.leastAngle;
    }
    options.method = arguments.method.value_or(options.method);
    options.improve = arguments.improve.value_or(options.improve);
    options.threads = arguments.threads.value_or(options.threads);
    applyMaxElements(arguments.maxElements, options);
    return applyRules(arguments.rules, options);
}

/// Returns notes on options that have no effect on this run.
Diagnostics unusedOptions(const MeshArguments &arguments, const MeshingJob &job, const SpacingField &spacing) {
    Diagnostics notes;
    const auto add = [&](const char *option, const char *reason) {
        notes.push_back(noteOf("no-effect", std::string(option) + " has no effect: " + reason).front());
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
    if (!arguments.rasters.empty() && !job.spacing.expression) {
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

/// Repairs the domain of a job and records in `sources` where its parts come from.
Diagnostics repairDomain(const MeshArguments &arguments, const Input &input, const Progress &progress, MeshingJob &job,
                         std::optional<Repaired> &sources) {
    Result<Repaired> repaired = repair(job.domain, arguments.drawing.weldTolerance.value_or(0.0), progress.stop);
    if (!repaired) {
        return allFormats().locateFaults(input.path, repaired.faults(), input.options);
    }
    if (!arguments.quiet) {
        printFaults(allFormats().locateFaults(input.path, notesWithPlaces(repaired->changes), input.options));
    }
    sources = std::move(*repaired);
    carryElements(job.domain, *sources, job.spacing);
    job.domain = std::move(sources->domain);
    return {};
}

/// Prints notes; returns none.
Diagnostics printed(const Diagnostics &notes) {
    printFaults(notes);
    return {};
}

/// Returns the limits of a project with those of the command line in their place where both are given.
MeshLimits allLimits(MeshLimits limits, const MeshLimits &given) {
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        limits[limit] = given[limit] ? given[limit] : limits[limit];
    }
    return limits;
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
                         const RunReport &report, const Progress &progress) {
    MeshView mesh(outcome);
    std::vector<double> elevations;
    if (arguments.form.elevation) {
        Result<std::vector<double>> read =
            readElevations(*arguments.form.elevation, mesh, arguments.drawing.projection, arguments.quiet);
        if (!read) {
            return read.faults();
        }
        elevations = std::move(*read);
        mesh.elevations = elevations;
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

/// The files that a mesh is made from.
struct MeshFiles {
    Input input;
    std::optional<Input> spacing;
};

Result<MeshFiles> openFiles(const MeshArguments &arguments) {
    Result<Input> input = openInput(arguments.input, arguments.inputFormat);
    if (!input) {
        return input.faults();
    }
    MeshFiles files{std::move(*input), {}};
    if (arguments.spacingFile) {
        Result<Input> spacing = openInput(*arguments.spacingFile);
        if (!spacing) {
            return spacing.faults();
        }
        files.spacing = std::move(*spacing);
    }
    return files;
}

/// Reads the files, shows the progress and prints the notes of the readers.
Result<ReadJob> readFiles(const MeshArguments &arguments, const MeshFiles &files, ProgressBar &bar) {
    ImportNotes notes, spacingNotes;
    Result<ReadJob> read = bar.during("reading", [&] { return readJob(files.input, notes); });
    if (!read) {
        return read;
    }
    read->system = notes.contents().system;
    printNotes(notes, arguments.quiet);
    const Diagnostics faults =
        bar.during("reading", [&] { return applySpacing(arguments, files.spacing, *read, spacingNotes); });
    if (!faults.empty()) {
        return faults;
    }
    printNotes(spacingNotes, arguments.quiet);
    return read;
}

int runMesh(const MeshArguments &arguments) {
    InterruptWatch interrupt;
    ProgressBar bar(!arguments.quiet);
    const Progress progress = bar.progress(interrupt.token());

    Result<MeshFiles> files = bar.during("reading", [&] { return openFiles(arguments); });
    if (!files) {
        return refuse(files.faults(), interrupt);
    }
    Input &input = files->input;
    if (const std::string wrong = checkFiles(arguments, input, files->spacing); !wrong.empty()) {
        return wrongUsage("forefront mesh", wrong);
    }
    arguments.drawing.applyTo(input.options);
    input.options.strict = arguments.strict;
    input.options.keepSharedLines = arguments.repair;
    Result<ReadJob> read = readFiles(arguments, *files, bar);
    Diagnostics faults = read ? Diagnostics() : read.faults();
    MeshingJob *const job = read ? &read->job : nullptr;
    interrupt.deferToStop();
    std::optional<Repaired> repaired;
    if (faults.empty() && arguments.repair) {
        faults = repairDomain(arguments, input, progress, *job, repaired);
    }
    if (faults.empty()) {
        faults = namePartsOf(arguments.drawing, input, arguments.quiet, job->domain);
        faults = hasErrors(faults) ? faults : printed(faults);
    }
    if (faults.empty()) {
        faults = applyOptions(arguments, job->options);
    }
    if (faults.empty()) {
        faults = applyPartOptions(arguments, input, read->periodicOfMesh, *job);
    }
    if (!faults.empty()) {
        return refuse(faults, interrupt);
    }
    const MeshLimits limits = allLimits(read->limits, arguments.limits);

    const auto refuseRun = [&](const Diagnostics &why) {
        const Diagnostics wrong = meshingFaults(why, job->domain, input, repaired ? &*repaired : nullptr);
        const Input &owner = files->spacing ? *files->spacing : input;
        const int code = refuse(arguments.expression ? wrong : locateSpacing(wrong, owner), interrupt);
        const bool mistyped = arguments.expression && hasCode(why, "expression-syntax");
        return code == kRefused && mistyped ? static_cast<int>(kUsage) : code;
    };
    if (arguments.targetElements) {
        faults = bar.during({}, [&] { return scaleToTarget(*arguments.targetElements, *job, progress); });
        if (hasErrors(faults)) {
            return refuseRun(faults);
        }
        printFaults(faults);
    }
    if (arguments.dryRun) {
        const Result<RunEstimate> estimate = bar.during({}, [&] { return estimateRun(*job, progress); });
        if (!estimate) {
            return refuseRun(estimate.faults());
        }
        const Status printed = printText(arguments.json ? estimateJson(*estimate, arguments.input.string())
                                                        : estimateText(*estimate, job->options));
        return printed.empty() ? static_cast<int>(kDone) : refuse(printed, interrupt);
    }
    if (arguments.fix && !limits.any()) {
        return wrongUsage("forefront mesh", "--fix: there are no limits; add --limit NAME=VALUE");
    }
    const Result<MeshingOutcome> outcome = bar.during({}, [&] {
        return arguments.fix ? fixedMesh(limits, progress, arguments.quiet, *job) : meshDomain(*job, progress);
    });
    if (!outcome) {
        return refuseRun(outcome.faults());
    }
    if (!arguments.quiet) {
        printFaults(outcome->spacing->notes());
        printFaults(unusedOptions(arguments, *job, *outcome->spacing));
    }
    printFaults(violatedLimits(outcome->mesh, limits, outcome->spacing.get()));
    printFaults(largeElements(outcome->mesh, job->domain, job->spacing.placed.regions));
    RunReport report = reportOf(*outcome, job->options);
    report.input = arguments.input.string();
    MeshForm form = withUnitOf(read->unit, arguments.form);
    form.system = read->system;
    faults = bar.during({}, [&] { return writeResults(arguments, form, outcome->mesh, report, progress); });
    if (hasErrors(faults)) {
        return refuse(faults, interrupt);
    }
    if (!arguments.quiet) {
        printFaults(faults);
        printFaults(flatElements(report.quality));
        printFaults(notConvex(report.quads));
        printFaults(straightEdges(report.order));
        printFaults(shortenedLayers(outcome->layers, outcome->mesh.boundaryNames));
    }
    const Status printed = printResult(arguments, report);
    return printed.empty() ? static_cast<int>(kDone) : refuse(printed, interrupt);
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
