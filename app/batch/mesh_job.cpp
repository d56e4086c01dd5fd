#include "app/batch/mesh_job.hpp"

#include "app/batch/exit_code.hpp"
#include "app/batch/option_notes.hpp"
#include "app/batch/part_options.hpp"
#include "app/batch/raster_option.hpp"
#include "app/batch/rules_option.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/curved_bounds.hpp"
#include "core/files/files.hpp"

#include <filesystem>
#include <utility>

namespace forefront {

namespace {

/// Reads the domain of any file with its element sizes, and also options if the file is a project.
Result<ReadJob> readDomainOf(const Input &input, ImportNotes &notes) {
    if (input.isProject()) {
        const Result<Document> document = readDocument(input.path, input.options, &notes);
        if (!document) {
            return document.faults();
        }
        Result<MeshingJob> job = readJobOf(*document, input.path.string(), &notes);
        if (!job) {
            return job.faults();
        }
        return ReadJob{*std::move(job),
                       boundsOf(*document),
                       document->picture,
                       document->limits,
                       document->unit,
                       {},
                       {},
                       {},
                       document->openBoundaries,
                       document->elevation};
    }
    Result<DomainFile> file = allFormats().readDomain(input.path, input.options, &notes);
    if (!file) {
        return file.faults();
    }
    const Box2 box = curvedBounds(file->domain);
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
                               : arguments.sizeFromBoundary ? "--size-from-boundary"
                                                            : nullptr;
    if (Diagnostics faults =
            addRasters(arguments.rasters, arguments.drawing.projection, read.system, arguments.quiet, spacing);
        !faults.empty()) {
        return faults;
    }
    if (option != nullptr && !arguments.quiet) {
        printFaults(replacedSpacing(option, spacing));
    }
    if (arguments.sizeFromBoundary) {
        SpacingSpec lengths;
        lengths.fromBoundary = true;
        lengths.names = spacing.names;
        lengths.rasters = spacing.rasters;
        spacing.replaceRules(std::move(lengths));
    } else if (!applySpacingOptions(arguments.size, arguments.expression, spacing) && file) {
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
        fromFile->names = spacing.names; // which the elevations may still call, with the rasters
        fromFile->rasters = spacing.rasters;
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

/// Repairs the domain of a job and keeps where its parts come from.
Diagnostics repairDomain(const MeshArguments &arguments, const Input &input, const Progress &progress, ReadJob &read) {
    MeshingJob &job = read.job;
    Result<Repaired> repaired = repair(job.domain, arguments.drawing.weldTolerance.value_or(0.0), progress.stop);
    if (!repaired) {
        return allFormats().locateFaults(input.path, repaired.faults(), input.options);
    }
    if (!arguments.quiet) {
        printFaults(allFormats().locateFaults(input.path, notesWithPlaces(repaired->changes), input.options));
    }
    read.repaired = std::move(*repaired);
    printFaults(
        allFormats().locateFaults(input.path, carryElements(job.domain, *read.repaired, job.spacing), input.options));
    job.domain = std::move(read.repaired->domain);
    return {};
}

} // namespace

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

std::string checkFiles(const MeshArguments &arguments, MeshFiles &files) {
    std::string wrong = checkDrawingOptions(arguments.drawing, files.input, arguments.repair);
    wrong = wrong.empty() ? setParameters(files.input, arguments.parameters) : wrong;
    wrong = wrong.empty() && files.spacing ? checkPicture(arguments, *files.spacing) : wrong;
    if (wrong.empty()) {
        arguments.drawing.applyTo(files.input.options);
        files.input.options.strict = arguments.strict;
        files.input.options.keepSharedLines = arguments.repair;
    }
    return wrong;
}

Result<ReadJob> readJob(const MeshArguments &arguments, const MeshFiles &files, ProgressBar &bar) {
    ImportNotes notes, spacingNotes;
    Result<ReadJob> read = bar.during("reading", [&] { return readDomainOf(files.input, notes); });
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

Diagnostics applyArguments(const MeshArguments &arguments, const Input &input, const Progress &progress,
                           ReadJob &read) {
    if (arguments.repair) {
        if (Diagnostics faults = repairDomain(arguments, input, progress, read); !faults.empty()) {
            return faults;
        }
    }
    const Diagnostics named = namePartsOf(arguments.drawing, input, arguments.quiet, read.job.domain);
    if (hasErrors(named)) {
        return named;
    }
    printFaults(named);
    if (Diagnostics faults = applyOptions(arguments, read.job.options); !faults.empty()) {
        return faults;
    }
    return applyPartOptions(arguments, input, read.periodicOfMesh, read.job);
}

} // namespace forefront
