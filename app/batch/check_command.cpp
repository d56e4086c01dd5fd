#include "app/batch/check_report.hpp"
#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/crack_option.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/raster_option.hpp"
#include "app/batch/strip_option.hpp"
#include "app/reports/report.hpp"
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/build_spacing.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/boundary_parts.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kCheckExamples = R"help(
Examples:
  forefront check plate.msh
        is the mesh conforming, oriented and free of overlaps?
  forefront check plate.msh --domain plate.poly
        does it also fill exactly that domain, with its tags, regions, constraints and area?
  forefront check plate.msh --spacing "max(0.05, 0.2*x)"
        how closely do its edges follow that spacing?
  forefront check plate.msh --min-angle 25 --max-growth 2
        is it within these limits? Lists the worst places if not
  forefront check bay.msh --max-valence 8 --max-growth 2 --min-across 3 --min-island-area 500
        is it fit for a model of water? At most 8 elements about a node, neighbours of similar areas, 3 elements across
        each channel, no tiny islands
  forefront check wing.msh --max-aspect 4 --max-layer-aspect 2000 --min-scaled-jacobian 0.2
        are its boundary layers not too thin for their length, and no corner too sharp?
  forefront check plate.msh --stats plate.json
        the verdict, the sizes of regions and boundary parts, and the quality as JSON, for scripts
  forefront check plate.msh --measures
        how are the angles, areas, edge lengths and other measures distributed?

Nodes that no element uses, and a mesh turned the other way (all elements clockwise), are reported but not refused.
The figures are printed for invalid meshes, too.

Exit codes: 0 valid, 1 invalid or unreadable mesh, or a limit violated (faults on stderr, one per line), 2 usage error.)help";

struct CheckArguments {
    std::filesystem::path mesh; ///< "-": standard input
    std::string inputFormat;
    std::optional<std::filesystem::path> domain;
    std::map<std::string, std::string> parameters; ///< of the projects; expressions by name, from --set
    DrawingArguments drawing;                      ///< of the domain
    bool repair = false;
    CrackArguments cracks; ///< of the domain
    StripArguments strips; ///< of the domain
    std::optional<double> size;
    std::optional<std::string> expression;
    std::vector<std::string> rasters, presets; ///< of --raster and --size-preset, which sets `expression`
    MeshLimits limits;
    std::optional<std::filesystem::path> savedLimits; ///< project
    bool measures = false;                            ///< print the table
    std::optional<std::filesystem::path> statistics;  ///< "-": to standard output, which then receives nothing else

    bool printsStatistics() const { return statistics && *statistics == "-"; }
};

/// Builds the requested node spacing: that of the options, or that of the project with the limits if one of them needs
/// a spacing; null if there is none.
Result<std::shared_ptr<const SpacingField>> readWanted(const CheckArguments &arguments, const MeshView &mesh) {
    if (!arguments.size && !arguments.expression) {
        if (!arguments.savedLimits || !arguments.limits[MeshLimit::MinDelta]) {
            return std::shared_ptr<const SpacingField>();
        }
        const Result<Document> project = readDocument(*arguments.savedLimits, {.parameters = arguments.parameters});
        if (!project) {
            return project.faults();
        }
        auto spacing = buildSpacing(jobOf(*project), {});
        return spacing ? std::move(spacing) : allFormats().locateFaults(*arguments.savedLimits, spacing.faults());
    }
    SpacingSpec spec;
    spec.size = arguments.size;
    spec.expression = arguments.expression;
    if (Diagnostics faults = addRasters(arguments.rasters, arguments.drawing.projection, {}, false, spec);
        !faults.empty()) {
        return faults;
    }
    const Result<MeshDomain> outline = domainOfMesh(mesh);
    return outline ? SpacingField::build(spec, outline->domain) : outline.faults();
}

/// Adds the length of each boundary part, by tag, times a factor.
void addLengths(const Domain &domain, double factor, std::map<std::int32_t, double> &lengths) {
    const auto known = [&](std::uint32_t node) { return node < domain.nodes.size(); };
    for (const DomainSegment &segment : domain.segments) {
        if (known(segment.a) && known(segment.b)) {
            lengths[segment.tag] += factor * distance(domain.nodes[segment.a], domain.nodes[segment.b]);
        }
    }
}

bool hasConstraints(const Domain &domain) {
    return std::any_of(domain.segments.begin(), domain.segments.end(),
                       [](const DomainSegment &segment) { return segment.role == SegmentRole::Constraint; });
}

/// In the outline of a mesh, edges without a tag get one. Returns all tagged edges of a mesh that is compared with such
/// an outline, with these; none if it has no tags at all, and is compared without them.
std::vector<TaggedEdge> edgesLikeAnOutline(const MeshView &mesh, const Input &domain) {
    const FileFormat *const format = domain.format();
    std::vector<TaggedEdge> edges(mesh.edges.begin(), mesh.edges.end());
    if (format != nullptr && format->readsMesh && !edges.empty()) {
        const std::vector<TaggedEdge> untagged = untaggedEdges(mesh);
        edges.insert(edges.end(), untagged.begin(), untagged.end());
    }
    return edges;
}

/// Returns the differences between a mesh and the domain it was made from.
Diagnostics checkAgainst(MeshView mesh, const MeshNumbers &numbers, const CheckArguments &arguments, Input &input) {
    // The parts of grids of water are open, land and islands, not those of the domain.
    const bool kinds = hasOpenBoundaries(arguments.mesh, arguments.inputFormat);
    const std::vector<TaggedEdge> edges = kinds ? std::vector<TaggedEdge>() : edgesLikeAnOutline(mesh, input);
    mesh.edges = edges;
    arguments.drawing.applyTo(input.options);
    input.options.keepSharedLines = arguments.repair;
    Result<DomainFile> file = allFormats().readDomain(input.path, input.options);
    if (!file) {
        return file.faults();
    }
    Domain &domain = file->domain;
    std::optional<Repaired> repaired;
    std::map<std::int32_t, double> changes; // in the lengths of boundary parts
    if (arguments.repair) {
        Result<Repaired> result = repair(domain, arguments.drawing.weldTolerance.value_or(0.0));
        if (!result) {
            return allFormats().locateFaults(input.path, result.faults(), input.options);
        }
        repaired = std::move(*result);
        addLengths(domain, -1.0, changes);
        addLengths(repaired->domain, 1.0, changes);
        printFaults(
            allFormats().locateFaults(input.path, carryElements(domain, *repaired, file->spacing), input.options));
        domain = std::move(repaired->domain);
    }
    if (Diagnostics wrong = namePartsOf(arguments.drawing, input, true, domain); !wrong.empty()) {
        return wrong;
    }
    if (Diagnostics unknown = applyCracks(arguments.cracks, domain, file->cracks); !unknown.empty()) {
        return allFormats().locateFaults(input.path, unknown, input.options);
    }
    Diagnostics wrongStrips = applyStrips(arguments.strips, domain, file->strips);
    if (wrongStrips.empty()) {
        PlacedSizes &placed = file->spacing.placed;
        wrongStrips = widenStrips(file->strips, file->cracks, {}, domain, placed.elements, placed.biases);
    }
    if (!wrongStrips.empty()) {
        return allFormats().locateFaults(input.path, wrongStrips, input.options);
    }
    const Repaired *const sources = repaired ? &*repaired : nullptr;
    const bool innerTags = acceptsInnerEdges(arguments.mesh) || hasInnerEdges(mesh);
    Diagnostics faults =
        verifyAgainst(mesh, domain, file->spacing.placed.counts(), kMaxListedFaults, numbers, innerTags, file->cracks);
    if (!file->strips.empty()) { // their domain has other segments than the one read
        std::ranges::for_each(faults, [](Diagnostic &fault) { fault.parts.clear(); });
    }
    if (!hasErrors(faults)) {
        Diagnostics parts;
        if (innerTags) {
            parts = checkBoundaryParts(mesh, input.path, input.options, changes);
        } else if (hasConstraints(domain)) {
            parts.push_back(noteOf(
                "inner-edges",
                "tags of edges inside the domain are not compared: the mesh has none, as is usual in this format"));
        }
        faults.insert(faults.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
        return faults;
    }
    faults = locateInDomain(meshingFaults(faults, domain, input, sources), input, sources);
    const FileFormat *const format = input.format();
    if (format != nullptr && format->arranges && !arguments.repair && arguments.drawing == DrawingArguments{}) {
        faults.push_back(
            noteOf("default-options", "the domain was read with the default options",
                   "repeat those that the mesh was made with, such as --weld, --overlap, --layer, --name-property, "
                   "--projection, --name, --beyond-page, --drop-lines, --stroke-areas, --shape-regions, "
                   "--no-white-holes or --repair"));
    }
    return faults;
}

/// Returns true if the figures of a mesh can be computed: its nodes and elements refer to what exists.
bool isMeasurable(const Diagnostics &faults) {
    return !hasCode(faults, "bad-index") && !hasCode(faults, "non-finite") && !hasCode(faults, "repeated-node");
}

void printFigures(const CheckArguments &arguments, const MeshReport &report, bool valid) {
    const MeshQuality &quality = report.quality;
    std::printf("%s%s: %zu nodes, %zu elements, hash %s\n%s"
                "shape factor: mean %.4f, geometric mean %.4f, minimum %.4f; angles %.1f to %.1f degrees\n",
                valid ? "valid" : "invalid", arguments.domain ? " for the domain" : "", quality.nodes, quality.elements,
                toHex(report.hash).c_str(), extentLine(quality.area, report.extent).c_str(), quality.alphaMean,
                quality.alphaGeometricMean, quality.alphaMin, quality.minAngle, quality.maxAngle);
    std::fputs(kindsLine(report).c_str(), stdout);
    if (report.hasSpacing) {
        std::fputs(conformityLine(quality).c_str(), stdout);
    }
}

/// Prints the figures of a mesh, those of a clockwise one as if it were turned. Returns the exit code.
int reportQuality(const CheckArguments &arguments, const std::filesystem::path &file, const MeshView &given,
                  const MeshNumbers &numbers, bool valid) {
    std::optional<Mesh> copy;
    const MeshView mesh = isClockwise(given) ? MeshView(copy.emplace(turned(copyOf(given)))) : given;
    const auto spacing = readWanted(arguments, mesh);
    if (!spacing) {
        printFaults(spacing.faults());
        return kUsage;
    }
    MeshReport report = reportOf(mesh, spacing->get(), valid, valid);
    report.hash = meshHash(given);
    const std::vector<LimitVerdict> verdicts = checkLimits(mesh, arguments.limits, spacing->get(), kListedPlaces);
    if (arguments.statistics) {
        const std::string json = statisticsJson(report, valid, verdicts);
        const Status status =
            arguments.printsStatistics() ? printText(json) : writeFileAtomically(*arguments.statistics, json);
        if (!status.empty()) {
            printFaults(status);
            return kRefused;
        }
    }
    if (!arguments.printsStatistics()) {
        printFigures(arguments, report, valid);
        if (arguments.measures) {
            printMeasures(mesh, spacing->get());
        }
    }
    const bool met = printVerdicts(file, verdicts, numbers, !arguments.printsStatistics());
    return valid && met ? kDone : kRefused;
}

int check(CheckArguments &arguments) {
    if (arguments.savedLimits) {
        if (const Diagnostics faults = addSavedLimits(*arguments.savedLimits, arguments.parameters, arguments.limits);
            !faults.empty()) {
            printFaults(faults);
            return kRefused;
        }
    }
    const Result<Input> input = openInput(arguments.mesh, arguments.inputFormat);
    if (!input) {
        printFaults(input.faults());
        return kRefused;
    }
    ImportNotes notes;
    const Result<Mesh> mesh = allFormats().readMesh(input->path, input->options, &notes);
    if (!mesh) {
        printFaults(mesh.faults());
        return kRefused;
    }
    printNotes(notes, false);
    Diagnostics faults;
    if (arguments.domain) {
        Result<Input> domain = openInput(*arguments.domain);
        if (!domain) {
            printFaults(domain.faults());
            return kRefused;
        }
        std::string wrong = checkDrawingOptions(arguments.drawing, *domain, arguments.repair);
        // If only --limits names a project, the parameters are those of that project.
        if (wrong.empty() && (domain->isProject() || !arguments.savedLimits)) {
            wrong = setParameters(*domain, arguments.parameters);
        }
        if (!wrong.empty()) {
            return wrongUsage("forefront check", wrong);
        }
        faults = checkAgainst(*mesh, notes.numbers(), arguments, *domain);
        if (domain->isProject() && !arguments.savedLimits) {
            const Result<Document> project = readDocument(domain->path, domain->options);
            if (project && project->limits.any()) {
                printFaults(
                    {noteOf("limits", "the limits of the project are not checked", "add --limits with its name")});
            }
        }
    } else {
        faults = verify(*mesh, kMaxListedFaults, notes.numbers());
    }
    for (const PeriodicLink &link : mesh->periodic) {
        const auto name = [&](std::int32_t tag) { return boundaryName(mesh->boundaryNames, tag); };
        faults.push_back(noteOf("periodic", "periodic: " + name(link.to) + " is the image of " + name(link.from) +
                                                ", " + countText(periodicPairs(*mesh, link).pairs.size(), "pair") +
                                                " of nodes"));
    }
    if (mesh->elementCount() == 0) {
        faults = error("empty-mesh", "the mesh has no elements");
    }
    printFaults(allFormats().locateFaults(input->path, faults, input->options));
    const bool valid = !hasErrors(faults);
    return isMeasurable(faults) ? reportQuality(arguments, input->path, *mesh, notes.numbers(), valid)
                                : static_cast<int>(kRefused);
}

} // namespace

int checkCommand(const CommandLine &line) {
    CheckArguments arguments;
    CLI::App app("Checks a mesh, alone or against its domain.", "forefront check");
    app.footer(kCheckExamples);
    app.add_option("MESH", arguments.mesh, meshFileHelp())->required();
    addInputFormatOption(app, "MESH", arguments.inputFormat);
    app.add_option("--domain", arguments.domain, "domain or project that the mesh was made from")->type_name("IN");
    addDrawingOptions(app, arguments.drawing);
    addParameterOption(app, arguments.parameters);
    app.add_flag("--repair", arguments.repair, "repair the domain first, as mesh --repair does");
    auto *spacing = app.add_option_group("Spacing", "report how closely the mesh follows this spacing; at most one");
    addSpacingOptions(*spacing, arguments.size, arguments.expression);
    addRasterOptions(app, *spacing, arguments.rasters, arguments.presets);
    spacing->require_option(0, 1);
    auto *limits = app.add_option_group("Limits", "refuse a mesh that violates one of these");
    addLimitOptions(*limits, arguments.limits);
    limits
        ->add_option(
            "--limits", arguments.savedLimits,
            "use the limits saved in a project (those given here take precedence), and its spacing if a limit needs "
            "one and none is given")
        ->type_name("PROJECT");
    app.add_flag("--measures", arguments.measures, "print the distribution of each quality measure");
    app.add_option("--stats", arguments.statistics,
                   "write the verdict and the figures as JSON, with the names that mesh --stats has for them; -: print "
                   "them instead of the summary")
        ->type_name("FILE.json");
    addCrackOptions(app, arguments.cracks,
                    "with --domain: the inner line NAME is a crack; every sector of elements between its faces must "
                    "have nodes of its own there; can be repeated");
    addStripOption(app, arguments.strips,
                   "with --domain: the inner line NAME is a strip with this width and number of rows, as in mesh; can "
                   "be repeated");
    addConfigOption(app);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    std::string wrong = checkInputs({arguments.mesh, arguments.domain}, arguments.inputFormat);
    if (wrong.empty()) {
        wrong = checkRasters(arguments.rasters, arguments.presets, arguments.expression);
    }
    if (wrong.empty()) {
        wrong = parseStrips(arguments.strips);
    }
    if (wrong.empty() && !arguments.strips.texts.empty() && !arguments.domain) {
        wrong = "--strip: names a line of the domain; add --domain";
    }
    if (wrong.empty() && !arguments.rasters.empty() && !arguments.expression) {
        wrong = "--raster: no expression calls it; add --spacing EXPR or --size-preset RULE";
    }
    if (!wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    if (!arguments.parameters.empty() && !arguments.domain && !arguments.savedLimits) {
        return wrongUsage(app.get_name(), "--set: only projects have parameters; add --domain or --limits");
    }
    if (!arguments.domain && arguments.cracks.any()) {
        return wrongUsage(app.get_name(), arguments.cracks.names.empty()
                                              ? "--no-cracks: tells how to read the domain; add --domain"
                                              : "--crack: names a line of the domain; add --domain");
    }
    if (!arguments.domain && (arguments.repair || !arguments.drawing.firstGiven().empty())) {
        return wrongUsage(app.get_name(), (arguments.repair ? "--repair" : arguments.drawing.firstGiven()) +
                                              ": tells how to read the domain; add --domain");
    }
    const bool spaced = arguments.size || arguments.expression || arguments.savedLimits;
    if (arguments.limits[MeshLimit::MinDelta] && !spaced) {
        return wrongUsage(app.get_name(), "--min-delta needs a spacing; add --size or --spacing");
    }
    if (arguments.printsStatistics() && arguments.measures) {
        return wrongUsage(app.get_name(),
                          "--stats - and --measures both write to standard output; give --stats a file");
    }
    if (arguments.statistics && !arguments.printsStatistics()) {
        std::vector<std::filesystem::path> inputs{arguments.mesh};
        for (const auto &input : {arguments.domain, arguments.savedLimits}) {
            if (input) {
                inputs.push_back(*input);
            }
        }
        if (const Diagnostics faults = checkOutputs({{*arguments.statistics, {}}}, inputs); !faults.empty()) {
            printFaults(faults);
            return kRefused;
        }
    }
    return check(arguments);
}

} // namespace forefront
