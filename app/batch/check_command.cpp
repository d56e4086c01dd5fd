#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/options.hpp"
#include "core/base/hash.hpp"
#include "core/io/files.hpp"
#include "core/mesh/quality.hpp"
#include "core/mesh/verify.hpp"
#include "core/spacing/spacing_field.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace forefront {

namespace {

constexpr const char *kExamples = R"help(
Examples:
  forefront check plate.msh
        is the mesh conforming, oriented and free of overlaps?
  forefront check plate.msh --domain plate.poly
        and does it fill exactly that domain, with its tags, regions, constraints and area?
  forefront check plate.msh --spacing "max(0.05, 0.2*x)"
        and how well do its edges keep that spacing?

Exit codes: 0 valid, 1 not valid or not readable (faults on stderr, one a line), 2 wrong usage.)help";

struct CheckArguments {
    std::filesystem::path mesh;
    std::optional<std::filesystem::path> domain;
    std::optional<double> size;
    std::optional<std::string> expression;
};

/// The node spacing that was asked for; null when none is given.
Result<std::shared_ptr<const SpacingField>> readWanted(const CheckArguments &arguments, const Mesh &mesh) {
    if (!arguments.size && !arguments.expression) {
        return std::shared_ptr<const SpacingField>();
    }
    SpacingSpec spec;
    spec.size = arguments.size;
    spec.expression = arguments.expression;
    Domain extent;
    extent.nodes = mesh.nodes;
    return SpacingField::build(spec, extent);
}

int check(const CheckArguments &arguments) {
    const Result<Mesh> mesh = readMesh(arguments.mesh);
    if (!mesh) {
        printFaults(mesh.faults());
        return kRefused;
    }
    Diagnostics faults;
    if (arguments.domain) {
        const Result<Domain> domain = readDomain(*arguments.domain);
        faults = domain ? verifyAgainst(*mesh, *domain) : domain.faults();
        if (domain && hasErrors(faults)) {
            faults = meshingFaults(faults, *domain, *arguments.domain, true);
        }
    } else {
        faults = verify(*mesh);
    }
    if (mesh->elements.empty()) {
        faults = error("empty-mesh", "the mesh has no elements");
    }
    printFaults(locateFaults(arguments.mesh, faults));
    if (hasErrors(faults)) {
        return kRefused;
    }
    const auto spacing = readWanted(arguments, *mesh);
    if (!spacing) {
        printFaults(spacing.faults());
        return kUsage;
    }
    const MeshQuality quality = measure(*mesh, spacing->get());
    std::printf("valid%s: %zu nodes, %zu elements, hash %s\n"
                "shape factor: mean %.4f, geometric mean %.4f, least %.4f; angles %.1f to %.1f degrees\n",
                arguments.domain ? " for the domain" : "", quality.nodes, quality.elements,
                toHex(meshHash(*mesh)).c_str(), quality.alphaMean, quality.alphaGeometricMean, quality.alphaMin,
                quality.minAngle, quality.maxAngle);
    if (*spacing) {
        std::printf("spacing conformity: mean %.4f\n", quality.deltaMean);
    }
    return kDone;
}

} // namespace

int checkCommand(int argc, const char *const *argv) {
    CheckArguments arguments;
    CLI::App app("Checks a mesh, alone or against its domain.", "forefront check");
    app.footer(kExamples);
    app.add_option("MESH", arguments.mesh, "mesh file: .msh, .vtu, .vtk, .mesh, .inp, .su2, .node, .ele, .obj")
        ->required();
    app.add_option("--domain", arguments.domain, "domain or project it was made of")->type_name("IN");
    auto *spacing = app.add_option_group("Spacing", "to tell how well the mesh keeps it; at most one");
    addSpacingOptions(*spacing, arguments.size, arguments.expression);
    spacing->require_option(0, 1);
    if (const auto code = parseOptions(app, argc, argv)) {
        return *code;
    }
    return check(arguments);
}

} // namespace forefront
