#include "app/batch/check_report.hpp"
#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/report.hpp"
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/boundary_parts.hpp"
#include "core/files/files.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

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
  forefront check plate.msh --measures
        how are the angles, areas, edge lengths and other measures distributed?

Exit codes: 0 valid, 1 invalid or unreadable mesh, or a limit violated (faults on stderr, one per line), 2 usage error.)help";

struct CheckArguments {
    std::filesystem::path mesh; ///< "-": standard input
    std::string inputFormat;
    std::optional<std::filesystem::path> domain;
    std::map<std::string, std::string> parameters; ///< of the projects; expressions by name, from --set
    DrawingArguments drawing;                      ///< of the domain
    bool repair = false;
    std::optional<double> size;
    std::optional<std::string> expression;
    MeshLimits limits;
    std::optional<std::filesystem::path> savedLimits; ///< project
    bool measures = false;                            ///< print the table
};

/// Builds the requested node spacing: that of the options, or that of the project with the limits if one of them needs
/// a spacing; null if there is none.
Result<std::shared_ptr<const SpacingField>> readWanted(const CheckArguments &arguments, const Mesh &mesh) {
    if (!arguments.size && !arguments.expression) {
        if (!arguments.savedLimits || !arguments.limits[MeshLimit::MinDelta]) {
            return std::shared_ptr<const SpacingField>();
        }
        const Result<Document> project = readDocument(*arguments.savedLimits, {.parameters = arguments.parameters});
        return project ? SpacingField::build(spacingOf(*project), toDomain(*project)) : project.faults();
    }
    SpacingSpec spec;
    spec.size = arguments.size;
    spec.expression = arguments.expression;
    const Result<Domain> domain = domainOfMesh(mesh);
    return domain ? SpacingField::build(spec, *domain) : domain.faults();
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

/// Returns the differences between a mesh and the domain it was made from.
Diagnostics checkAgainst(const Mesh &mesh, const CheckArguments &arguments, Input &input) {
    arguments.drawing.applyTo(input.options);
    Result<Domain> domain = allFormats().readDomain(input.path, input.options);
    if (!domain) {
        return domain.faults();
    }
    std::optional<Repaired> repaired;
    std::map<std::int32_t, double> changes; // in the lengths of boundary parts
    if (arguments.repair) {
        Result<Repaired> result = repair(*domain, arguments.drawing.weldTolerance.value_or(0.0));
        if (!result) {
            return allFormats().locateFaults(input.path, result.faults(), input.options);
        }
        repaired = std::move(*result);
        addLengths(*domain, -1.0, changes);
        addLengths(repaired->domain, 1.0, changes);
        domain = std::move(repaired->domain);
    }
    const Repaired *const sources = repaired ? &*repaired : nullptr;
    Diagnostics faults = verifyAgainst(mesh, *domain);
    if (!hasErrors(faults)) {
        const Diagnostics parts = checkBoundaryParts(mesh, input.path, input.options, changes);
        faults.insert(faults.end(), parts.begin(), parts.end());
        return faults;
    }
    faults = locateInDomain(meshingFaults(faults, *domain, input, sources), input, sources);
    const FileFormat *const format = input.format();
    if (format != nullptr && format->arranges && !arguments.repair && arguments.drawing == DrawingArguments{}) {
        Diagnostic hint;
        hint.severity = Severity::Note;
        hint.code = "default-options";
        hint.message = "the domain was read with the default options";
        hint.advice = "repeat those that the mesh was made with, such as --weld, --overlap, --layer, --name-property, "
                      "--projection, --beyond-page, --drop-lines, --stroke-areas, --shape-regions or --repair";
        faults.push_back(std::move(hint));
    }
    if (!acceptsInnerEdges(arguments.mesh)) {
        Diagnostic hint;
        hint.severity = Severity::Note;
        hint.code = "inner-edges";
        hint.message = "by default, meshes of this format are written without tagged edges inside the domain";
        hint.advice = "write the mesh with --inner-edges keep";
        faults.push_back(std::move(hint));
    }
    return faults;
}

/// Prints the figures of a valid mesh. Returns the exit code.
int reportQuality(const CheckArguments &arguments, const std::filesystem::path &file, const Mesh &mesh) {
    const auto spacing = readWanted(arguments, mesh);
    if (!spacing) {
        printFaults(spacing.faults());
        return kUsage;
    }
    const MeshQuality quality = measureQuality(mesh, spacing->get());
    std::printf("valid%s: %zu nodes, %zu elements, hash %s\n%s"
                "shape factor: mean %.4f, geometric mean %.4f, minimum %.4f; angles %.1f to %.1f degrees\n",
                arguments.domain ? " for the domain" : "", quality.nodes, quality.elements,
                toHex(meshHash(mesh)).c_str(), extentLine(quality.area, extentOf(mesh, quality.edges)).c_str(),
                quality.alphaMean, quality.alphaGeometricMean, quality.alphaMin, quality.minAngle, quality.maxAngle);
    if (*spacing) {
        std::printf("spacing conformity: mean %.4f\n", quality.deltaMean);
    }
    if (arguments.measures) {
        printMeasures(mesh, spacing->get());
    }
    return printVerdicts(file, mesh, arguments.limits, spacing->get()) ? kDone : kRefused;
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
        faults = checkAgainst(*mesh, arguments, *domain);
    } else {
        faults = verify(*mesh);
    }
    if (mesh->elements.empty()) {
        faults = error("empty-mesh", "the mesh has no elements");
    }
    printFaults(allFormats().locateFaults(input->path, faults, input->options));
    if (hasErrors(faults)) {
        return kRefused;
    }
    return reportQuality(arguments, input->path, *mesh);
}

} // namespace

int checkCommand(int argc, const char *const *argv) {
    CheckArguments arguments;
    CLI::App app("Checks a mesh, alone or against its domain.", "forefront check");
    app.footer(kCheckExamples);
    app.add_option("MESH", arguments.mesh,
                   "mesh file: .msh, .vtu, .vtk, .mesh, .inp, .su2, .node, .ele, .obj, .vol; -: standard input")
        ->required();
    addInputFormatOption(app, "MESH", arguments.inputFormat);
    app.add_option("--domain", arguments.domain, "domain or project that the mesh was made from")->type_name("IN");
    addDrawingOptions(app, arguments.drawing);
    addParameterOption(app, arguments.parameters);
    app.add_flag("--repair", arguments.repair, "repair the domain first, as mesh --repair does");
    auto *spacing = app.add_option_group("Spacing", "report how closely the mesh follows this spacing; at most one");
    addSpacingOptions(*spacing, arguments.size, arguments.expression);
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
    if (const auto code = parseOptions(app, argc, argv)) {
        return *code;
    }
    const std::string wrong = checkInputs({arguments.mesh, arguments.domain}, arguments.inputFormat);
    if (!wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    if (!arguments.parameters.empty() && !arguments.domain && !arguments.savedLimits) {
        return wrongUsage(app.get_name(), "--set: only projects have parameters; add --domain or --limits");
    }
    if (!arguments.domain && (arguments.repair || !arguments.drawing.firstGiven().empty())) {
        return wrongUsage(app.get_name(), (arguments.repair ? "--repair" : arguments.drawing.firstGiven()) +
                                              ": tells how to read the domain; add --domain");
    }
    const bool spaced = arguments.size || arguments.expression || arguments.savedLimits;
    if (arguments.limits[MeshLimit::MinDelta] && !spaced) {
        return wrongUsage(app.get_name(), "--min-delta needs a spacing; add --size or --spacing");
    }
    return check(arguments);
}

} // namespace forefront
