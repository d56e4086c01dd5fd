#include "core/files/common/solid_mesh.hpp"
#include "core/files/files.hpp"
#include "core/files/openfoam/foam_faces.hpp"
#include "core/files/openfoam/openfoam.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace solid_tests {

using Place = std::array<double, 3>;

/// Six times the volume between a face and the origin, by triangles about its first corner.
double sixfold(const std::vector<Place> &nodes, std::span<const std::uint32_t> face) {
    double sum = 0.0;
    const Place &a = nodes[face[0]];
    for (std::size_t k = 2; k < face.size(); ++k) {
        const Place &b = nodes[face[k - 1]], &c = nodes[face[k]];
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
}

/// The volume of a cell by its sides, whose normals point outwards.
double volumeOf(const std::vector<Place> &nodes, const SolidCell &cell) {
    const auto half = static_cast<std::uint32_t>(cell.count / 2);
    std::vector<std::uint32_t> back, front;
    double sum = 0.0;
    for (std::uint32_t k = 0; k < half; ++k) {
        const std::uint32_t next = (k + 1) % half;
        back.insert(back.begin(), cell.corners[k]);
        front.push_back(cell.corners[half + k]);
        const std::array side{cell.corners[k], cell.corners[next], cell.corners[half + next], cell.corners[half + k]};
        sum += sixfold(nodes, side);
    }
    return (sum + sixfold(nodes, back) + sixfold(nodes, front)) / 6.0;
}

double areaOf(const MeshView &mesh) {
    double twice = 0.0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const auto corners = mesh.cornersOf(e);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            twice += cross(mesh.nodes[index(corners[k])], mesh.nodes[index(corners[(k + 1) % corners.size()])]);
        }
    }
    return 0.5 * twice;
}

std::string solidText(const char *format, const MeshView &mesh, const Extrusion &extrusion) {
    StringSink sink;
    ExportOptions options;
    options.extrusion = extrusion;
    REQUIRE(writeMesh(sink, mesh, format, options).empty());
    return sink.text;
}

std::size_t countOf(const std::string &text, const std::string &part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++count;
    }
    return count;
}

} // namespace solid_tests

using namespace solid_tests;

TEST_CASE("Solids: cells fill the prism over the mesh, and the faces close it") {
    const Mesh mixed = samples::mixedSample();
    REQUIRE(mixed.blocks.size() == 2);
    for (const std::uint32_t layers : {1U, 3U}) {
        const SolidMesh solid(mixed, {0.7, layers});
        CHECK(solid.nodes.size() == mixed.nodes.size() * (layers + 1));
        REQUIRE(solid.cells.size() == mixed.elementCount() * layers);
        double volume = 0.0;
        for (const SolidCell &cell : solid.cells) {
            const double part = volumeOf(solid.nodes, cell);
            CHECK(part > 0.0);
            volume += part;
        }
        CHECK(volume == doctest::Approx(0.7 * areaOf(mixed)));
        std::size_t back = 0, front = 0;
        double top = 0.0;
        for (const SolidFace &face : solid.faces) {
            back += face.tag == solid.back ? 1 : 0;
            front += face.tag == solid.front ? 1 : 0;
            top += face.tag == solid.front ? sixfold(solid.nodes, face.nodes()) / 6.0 : 0.0;
            const auto corners = solid.cells[face.cell].nodes();
            for (const std::uint32_t node : face.nodes()) {
                CHECK(std::find(corners.begin(), corners.end(), node) != corners.end());
            }
        }
        CHECK(back == mixed.elementCount());
        CHECK(front == mixed.elementCount());
        CHECK(top == doctest::Approx(0.7 * areaOf(mixed) / 3.0));
        CHECK(solid.tags.edges.at(solid.front) == "front");
    }
}

TEST_CASE("Solids: the formats write all cells and the names of all parts, and others refuse by name") {
    const TriMesh mesh = twoRegionMesh();
    const SolidMesh solid(mesh, {2.0, 2});
    std::size_t formats = 0;
    for (const FileFormat &format : engineFormats().list()) {
        CAPTURE(format.id);
        ExportOptions options;
        options.extrusion = Extrusion{2.0, 2};
        if (format.writesMesh && !format.holdsSolids) {
            const Status refused = checkExport(format, mesh, options);
            REQUIRE(hasCode(refused, "unsupported-extrusion"));
            CHECK(refused.front().message.find(format.name) == 0);
            CHECK(refused.front().advice.find("openfoam (.foam)") != std::string::npos);
        }
        formats += format.holdsSolids ? 1 : 0;
    }
    CHECK(formats == 7);
    const std::string msh = solidText("msh2", mesh, {2.0, 2});
    CHECK(msh.find("$Nodes\n" + std::to_string(solid.nodes.size()) + '\n') != std::string::npos);
    CHECK(msh.find("$Elements\n" + std::to_string(solid.faces.size() + solid.cells.size()) + '\n') !=
          std::string::npos);
    CHECK(msh.find("\"front\"\n") != std::string::npos);
    CHECK(countOf(solidText("inp", mesh, {2.0, 2}), "*SURFACE, NAME=S_") == solid.tags.edges.size());
    CHECK(countOf(solidText("inp", mesh, {2.0, 2}), ", 1, 3; load: *DSLOAD / S_") == solid.tags.edges.size());
    CHECK(countOf(solidText("nastran", mesh, {2.0, 2}), "\nCPENTA  ") == solid.cells.size());
    CHECK(solidText("medit", mesh, {2.0, 2}).find("\nPrisms\n" + std::to_string(solid.cells.size()) + '\n') !=
          std::string::npos);
    CHECK(solidText("unv", mesh, {2.0, 2}).find("\nback\n") != std::string::npos);
    CHECK(solidText("vtu", mesh, {2.0, 2}).find("Name=\"boundary:back\"") != std::string::npos);
    const Mesh second = samples::sampleMesh(CellKind::Triangle6);
    ExportOptions options;
    options.extrusion = Extrusion{};
    StringSink sink;
    CHECK(hasCode(writeMesh(sink, second, "msh2", options), "unsupported-extrusion"));
    CHECK(sink.text.empty());
}

TEST_CASE("Solids: tags of back and front are free") {
    TriMesh mesh = samples::square(2, 2);
    const std::vector<std::int32_t> above = freeTags(mesh, 2);
    CHECK(above == std::vector<std::int32_t>{5, 6});
    mesh.edges.front().tag = std::numeric_limits<std::int32_t>::max();
    const std::set<std::int32_t> used{mesh.edges[0].tag, mesh.edges[1].tag, mesh.edges[2].tag};
    for (const std::int32_t tag : freeTags(mesh, 2)) {
        CHECK(tag > 0);
        CHECK(std::none_of(mesh.edges.begin(), mesh.edges.end(), [&](const TaggedEdge &e) { return e.tag == tag; }));
    }
}

TEST_CASE("OpenFOAM: faces are in upper triangular order, and close each cell") {
    const Mesh mixed = samples::mixedSample();
    for (const std::uint32_t layers : {1U, 3U}) {
        const Result<FoamFaces> result = foamFaces(mixed, layers);
        REQUIRE(result);
        const std::vector<Place> nodes = SolidMesh(mixed, {0.5, layers}).nodes;
        std::vector<double> volumes(mixed.elementCount() * layers, 0.0);
        for (std::size_t k = 0; k < result->inner; ++k) {
            const FoamFace &face = result->faces[k];
            CHECK(face.owner < face.neighbour);
            if (k > 0) {
                const FoamFace &before = result->faces[k - 1];
                CHECK(std::pair(before.owner, before.neighbour) < std::pair(face.owner, face.neighbour));
            }
            volumes[face.owner] += sixfold(nodes, face.nodes()) / 6.0;
            volumes[face.neighbour] -= sixfold(nodes, face.nodes()) / 6.0;
        }
        const auto addOuter = [&](const std::vector<FoamFace> &faces) {
            for (const FoamFace &face : faces) {
                volumes[face.owner] += sixfold(nodes, face.nodes()) / 6.0;
            }
        };
        for (const auto &[tag, faces] : result->parts) {
            addOuter(faces);
        }
        addOuter(result->untagged);
        addOuter(result->back);
        addOuter(result->front);
        CHECK(std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume > 0.0; }));
        CHECK(std::accumulate(volumes.begin(), volumes.end(), 0.0) == doctest::Approx(0.5 * areaOf(mixed)));
    }
    TriMesh torn = samples::square(1, 1);
    torn.elements.push_back(torn.elements.front());
    torn.elements.push_back(torn.elements.front());
    const Result<FoamFaces> refused = foamFaces(torn, 1);
    REQUIRE_FALSE(refused);
    CHECK(hasCode(refused.faults(), "not-manifold"));
    CHECK(refused.faults().front().at);
}

TEST_CASE("OpenFOAM: the folder of a case, its names and patches, and what is refused") {
    const TemporaryFolder folder;
    TriMesh mesh = twoRegionMesh();
    mesh.boundaryNames[1] = "frontAndBack";
    const auto place = folder / "plate.foam";
    CHECK(checkPlace(place, "").empty());
    REQUIRE(writeMesh(place, mesh).empty());
    CHECK(checkPlace(place, "").empty());
    const std::string boundary = *readFileBytes(place / "constant/polyMesh/boundary", 1U << 20U);
    CHECK(boundary.find("    frontAndBack\n    {\n        type            empty;") != std::string::npos);
    CHECK(boundary.find("    frontAndBack_2\n    {\n        type            patch;") != std::string::npos);
    CHECK(hasCode(exportNotes(place, mesh), "changed-names"));
    const std::string points = *readFileBytes(place / "constant/polyMesh/points", 1U << 20U);
    CHECK(points.find('\n' + std::to_string(2 * mesh.nodes.size()) + "\n(\n") != std::string::npos);
    ExportOptions options;
    options.extrusion = Extrusion{1.0, 2};
    REQUIRE(writeMesh(place, mesh, {}, {}, options).empty());
    const std::string layers = *readFileBytes(place / "constant/polyMesh/boundary", 1U << 20U);
    CHECK(layers.find("    front\n    {\n        type            patch;") != std::string::npos);
    CHECK(layers.find("empty") == std::string::npos);
    REQUIRE(writeFileAtomically(place / "constant/polyMesh/faces.gz", "old").empty());
    CHECK(hasCode(writeMesh(place, mesh), "cannot-write"));
    CHECK(usualExtrusion(samples::square(4, 4)).height == doctest::Approx(std::sqrt(1.0 / 32.0)));
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    CHECK(hasCode(writeMesh(folder / "other.foam", mesh, {}, progress), "cancelled"));
    CHECK_FALSE(std::filesystem::exists(folder / "other.foam")); // nor the folders
    REQUIRE(writeFileAtomically(folder / "file.foam", "x").empty());
    CHECK(hasCode(checkPlace(folder / "file.foam", ""), "cannot-write"));
    CHECK(hasCode(writeMesh(folder / "file.foam", mesh), "cannot-write"));
}
