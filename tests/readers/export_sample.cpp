// Writes small meshes in every format, each with its true figures as JSON.
//   export_sample FOLDER
// Reads a mesh with nodal values 1 + x + 2y and prints its figures.
//   export_sample --read FILE NAME
// Reads a mesh and writes it in the format of another extension, or with open boundary parts.
//   export_sample --copy MESH OUT
//   export_sample --open MESH OUT NAME...
// Reads a mesh and writes it extruded in layers.
//   export_sample --extrude MESH OUT HEIGHT LAYERS
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "tests/unit/block_samples.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>

using namespace forefront;

namespace {

/// [0,4]x[0,2], "steel" left and "copper" right of x = 2, a square hole [0.5,1]² in the steel.
Domain twoRegions() {
    Domain domain;
    domain.nodes = {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 2}, {0, 2}, {0.5, 0.5}, {0.5, 1}, {1, 1}, {1, 0.5}};
    domain.segments = {
        {0, 1, 1, SegmentRole::Boundary}, {1, 2, 1, SegmentRole::Boundary},  {2, 3, 2, SegmentRole::Boundary},
        {3, 4, 3, SegmentRole::Boundary}, {4, 5, 3, SegmentRole::Boundary},  {5, 0, 4, SegmentRole::Boundary},
        {6, 7, 5, SegmentRole::Boundary}, {7, 8, 5, SegmentRole::Boundary},  {8, 9, 5, SegmentRole::Boundary},
        {9, 6, 5, SegmentRole::Boundary}, {1, 4, 6, SegmentRole::Constraint}};
    domain.regionMarkers = {{{0.1, 0.1}, 1}, {{3.9, 0.1}, 2}};
    domain.boundaryNames = {{1, "bottom"}, {2, "right"}, {3, "top"}, {4, "left"}, {5, "hole"}, {6, "seam"}};
    domain.regionNames = {{1, "steel"}, {2, "copper"}};
    return domain;
}

/// The same domain with names that formats have to change: boundaries and regions of the same name, as after GeoJSON,
/// blanks, quotes, letters outside ASCII, and a point with the tag of an edge.
Domain twins() {
    Domain domain = twoRegions();
    domain.nodes.push_back({3.0, 1.25});
    domain.points = {{10, 2}};
    domain.boundaryNames = {
        {1, "steel"}, {2, "\u00d6ffnung \"s\u00fcd\""}, {3, "sea bed"}, {4, "sea_bed"}, {5, "4th hole"}, {6, "copper"}};
    return domain;
}

/// [0,10]x[0,2] for a tension test.
Domain strip() {
    Domain domain;
    domain.nodes = {{0, 0}, {10, 0}, {10, 2}, {0, 2}};
    domain.segments = {{0, 1, 1, SegmentRole::Boundary},
                       {1, 2, 2, SegmentRole::Boundary},
                       {2, 3, 3, SegmentRole::Boundary},
                       {3, 0, 4, SegmentRole::Boundary}};
    domain.boundaryNames = {{1, "bottom"}, {2, "right"}, {3, "top"}, {4, "left"}};
    domain.regionNames = {{1, "plate"}};
    return domain;
}

nlohmann::json figures(const MeshView &mesh) {
    nlohmann::json truth;
    truth["nodes"] = mesh.nodes.size();
    truth["elements"] = mesh.elementCount();
    for (const TaggedNode &point : mesh.points) {
        auto &part = truth["points"][boundaryName(mesh.boundaryNames, point.tag)];
        part["tag"] = point.tag;
        part["count"] = part.value("count", 0) + 1;
    }
    for (const TaggedEdge &edge : mesh.edges) {
        auto &part = truth["edges"][boundaryName(mesh.boundaryNames, edge.tag)];
        part["tag"] = edge.tag;
        part["count"] = part.value("count", 0) + 1;
        part["length"] = part.value("length", 0.0) + distance(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)]);
    }
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> t = mesh.cornersOf(e);
        const Vec2 a = mesh.nodes[index(t[0])];
        auto &region = truth["regions"][regionName(mesh.regionNames, mesh.region(e))];
        region["tag"] = mesh.region(e);
        region["count"] = region.value("count", 0) + 1;
        region["area"] =
            region.value("area", 0.0) + 0.5 * cross(mesh.nodes[index(t[1])] - a, mesh.nodes[index(t[2])] - a);
    }
    return truth;
}

int fail(const Diagnostics &faults) {
    for (const Diagnostic &fault : faults) {
        std::fprintf(stderr, "%s\n", toString(fault).c_str());
    }
    return 1;
}

int exportAll(const std::filesystem::path &folder, const std::string &name, const MeshView &mesh) {
    nlohmann::json truth = figures(mesh);
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh) {
            const std::filesystem::path path = folder / (name + '-' + format.id + format.extension);
            const Status status = writeMesh(path, mesh, format.id);
            if (hasErrors(status)) {
                return fail(status);
            }
            truth["files"][format.id] = path.string();
        }
    }
    std::ofstream(folder / (name + ".json")) << truth.dump(1) << '\n';
    return 0;
}

/// Meshes a domain and writes the mesh, and as NAME-outline the mesh without inner edges.
int exportDomain(const std::filesystem::path &folder, const std::string &name, const Domain &domain, double size) {
    MeshingJob job;
    job.domain = domain;
    job.spacing.size = size;
    const Result<MeshingOutcome> outcome = meshDomain(job);
    if (!outcome) {
        return fail(outcome.faults());
    }
    const int whole = exportAll(folder, name, outcome->mesh);
    return whole != 0 ? whole : exportAll(folder, name + "-outline", withoutInnerEdges(outcome->mesh));
}

/// Writes a mesh of any kinds of cells in every format that holds them, with all its cells as JSON.
int exportCells(const std::filesystem::path &folder, const std::string &name, const Mesh &mesh) {
    nlohmann::json truth;
    truth["boundaries"] = mesh.boundaryNames;
    truth["regions"] = mesh.regionNames;
    for (const Vec2 node : mesh.nodes) {
        truth["nodes"].push_back({node.x, node.y});
    }
    const auto add = [&](CellKind kind, std::int32_t tag, std::span<const NodeId> nodes) {
        nlohmann::json cell = {{"kind", wordsOf<CellKind>()[static_cast<std::size_t>(kind)]}, {"tag", tag}};
        for (const NodeId node : nodes) {
            cell["nodes"].push_back(index(node));
        }
        truth["cells"].push_back(cell);
    };
    const MeshView view(mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        add(view.kindOf(e), view.region(e), view.nodesOf(e));
    }
    for (const TaggedEdge &edge : mesh.edges) {
        const bool curved = edge.middle != kNoNode;
        add(curved ? CellKind::Edge3 : CellKind::Edge2, edge.tag,
            std::span<const NodeId>(std::array{edge.a, edge.b, edge.middle}).first(curved ? 3 : 2));
    }
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh && checkElements(format, mesh).empty()) {
            const std::filesystem::path path = folder / (name + '-' + format.id + format.extension);
            const Status status = writeMesh(path, mesh, format.id);
            if (hasErrors(status)) {
                return fail(status);
            }
            truth["files"][format.id] = path.string();
        }
    }
    std::ofstream(folder / (name + ".json")) << truth.dump() << '\n';
    return 0;
}

/// Returns a mesh with curved edges and few digits: CalculiX reads at most 20 characters of a number.
Mesh curved(const Mesh &mesh) {
    Mesh result = samples::bent(mesh, 0.1);
    for (Vec2 &node : result.nodes) {
        node = {std::round(1e6 * node.x) / 1e6, std::round(1e6 * node.y) / 1e6};
    }
    return result;
}

/// Meshes of triangles and of other cells, the second-order ones with curved edges.
int exportAllCells(const std::filesystem::path &folder) {
    const auto of = [](CellKind triangle, CellKind quadrilateral) {
        return samples::gridOfCells(
            4, 3, [=](std::size_t i, std::size_t j) { return (i + 2 * j) % 3 == 0 ? triangle : quadrilateral; }, 0.15);
    };
    const std::pair<const char *, Mesh> meshes[] = {
        {"mixed", samples::mixedSample()},
        {"curved6", curved(samples::sampleMesh(CellKind::Triangle6))},
        {"curved8", curved(of(CellKind::Triangle6, CellKind::Quadrilateral8))},
        {"curved9", curved(of(CellKind::Triangle6, CellKind::Quadrilateral9))},
        {"kinds", samples::allKindsSample()},
        {"flat3", samples::sampleMesh(CellKind::Triangle3)}};
    for (const auto &[name, mesh] : meshes) {
        if (const int code = exportCells(folder, name, mesh); code != 0) {
            return code;
        }
    }
    return 0;
}

/// A quarter of a plate of width 10 and length 20 with a hole of radius 1 about the origin, "hole" a true arc.
Domain quarterOfPlate() {
    Domain domain;
    domain.nodes = {{1, 0}, {10, 0}, {10, 5}, {0, 5}, {0, 1}};
    domain.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4}};
    domain.curves = {Curve::arc({0, 0}, {1, 0}, {0, 1}, 0.0, 0.5 * std::numbers::pi)};
    constexpr std::uint32_t kChords = 32;
    for (std::uint32_t k = 0; k < kChords; ++k) { // from (1, 0) to (0, 1)
        const std::uint32_t from = k == 0 ? 0 : static_cast<std::uint32_t>(domain.nodes.size() - 1);
        const double t0 = static_cast<double>(k) / kChords, t1 = static_cast<double>(k + 1) / kChords;
        if (k + 1 < kChords) {
            domain.nodes.push_back(domain.curves[0].point(t1));
        }
        const auto to = static_cast<std::uint32_t>(k + 1 < kChords ? domain.nodes.size() - 1 : 4);
        domain.segments.push_back({from, to, 5, SegmentRole::Boundary, {0, t0, t1}});
    }
    domain.boundaryNames = {{1, "bottom"}, {2, "right"}, {3, "top"}, {4, "left"}, {5, "hole"}};
    domain.regionNames = {{1, "plate"}};
    return domain;
}

/// The plate in triangles of second order, and in quadrilaterals of both orders; those of first order are smaller.
int exportPlates(const std::filesystem::path &folder) {
    struct Kind {
        const char *name;
        Elements elements;
        ElementOrder order;
        const char *spacing;
    };
    constexpr Kind kKinds[] = {
        {"plate6", Elements::Triangles, ElementOrder::Second, "0.1 + 0.2*max(0, sqrt(x*x+y*y)-1)"},
        {"plate8", Elements::Quads, ElementOrder::Second, "0.1 + 0.2*max(0, sqrt(x*x+y*y)-1)"},
        {"plate4", Elements::Quads, ElementOrder::First, "0.02 + 0.1*max(0, sqrt(x*x+y*y)-1)"}};
    for (const Kind &kind : kKinds) {
        MeshingJob job;
        job.domain = quarterOfPlate();
        job.spacing.expression = kind.spacing;
        job.options.elements = kind.elements;
        job.options.order = kind.order;
        job.options.verify = true;
        const Result<MeshingOutcome> outcome = meshDomain(job);
        if (!outcome) {
            return fail(outcome.faults());
        }
        if (const int code = exportCells(folder, kind.name, outcome->mesh); code != 0) {
            return code;
        }
    }
    return 0;
}

int printFigures(const std::filesystem::path &path, const char *field) {
    const Result<MeshField> read = allFormats().readField(path, field);
    if (!read) {
        return fail(read.faults());
    }
    nlohmann::json found = figures(takeTriMesh(read->mesh));
    double worst = 0.0;
    for (std::size_t n = 0; n < read->values.size(); ++n) {
        const Vec2 p = read->mesh.nodes[n];
        worst = std::max(worst, std::fabs(read->values[n] - (1.0 + p.x + 2.0 * p.y)));
    }
    found["worst_value"] = worst;
    std::printf("%s\n", found.dump().c_str());
    return 0;
}

/// Reads a mesh and writes it in the format of another extension.
int copyMesh(const std::filesystem::path &from, const std::filesystem::path &to) {
    const Result<Mesh> read = allFormats().readMesh(from);
    if (!read) {
        return fail(read.faults());
    }
    const Status status = writeMesh(to, *read);
    return status.empty() ? 0 : fail(status);
}

/// Reads a mesh and writes it with open boundary parts.
int writeOpen(const std::filesystem::path &from, const std::filesystem::path &to, std::span<char *const> names) {
    const Result<Mesh> read = allFormats().readMesh(from);
    if (!read) {
        return fail(read.faults());
    }
    ExportOptions options;
    for (const auto &[tag, name] : read->boundaryNames) {
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            options.openBoundaries.push_back(tag);
        }
    }
    const Status status = writeMesh(to, *read, {}, {}, options);
    return status.empty() ? 0 : fail(status);
}

/// Reads a mesh and writes it extruded.
int writeExtruded(const std::filesystem::path &from, const std::filesystem::path &to, double height,
                  std::uint32_t layers) {
    const Result<Mesh> read = allFormats().readMesh(from);
    if (!read) {
        return fail(read.faults());
    }
    ExportOptions options;
    options.extrusion = Extrusion{height, layers};
    const Status status = writeMesh(to, *read, {}, {}, options);
    return status.empty() ? 0 : fail(status);
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 4 && std::string_view(argv[1]) == "--copy") {
        return copyMesh(argv[2], argv[3]);
    }
    if (argc == 4 && std::string_view(argv[1]) == "--read") {
        return printFigures(argv[2], argv[3]);
    }
    if (argc == 6 && std::string_view(argv[1]) == "--extrude") {
        return writeExtruded(argv[2], argv[3], std::stod(argv[4]), static_cast<std::uint32_t>(std::stoul(argv[5])));
    }
    if (argc > 4 && std::string_view(argv[1]) == "--open") {
        return writeOpen(argv[2], argv[3], std::span(argv + 4, static_cast<std::size_t>(argc - 4)));
    }
    if (argc != 2) {
        std::fprintf(stderr,
                     "usage: export_sample FOLDER | --read FILE NAME | --copy MESH OUT | --open MESH OUT NAME... | "
                     "--extrude MESH OUT HEIGHT LAYERS\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    int code = exportDomain(folder, "sample", twoRegions(), 0.25);
    code = code != 0 ? code : exportDomain(folder, "twins", twins(), 0.25);
    code = code != 0 ? code : exportDomain(folder, "strip", strip(), 0.5);
    code = code != 0 ? code : exportAllCells(folder);
    return code != 0 ? code : exportPlates(folder);
}
