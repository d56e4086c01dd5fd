#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
#include "core/files/hydro/hydro.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::string elevatedText(const char *format, const MeshView &mesh, const ExportOptions &options = {}) {
    StringSink sink;
    REQUIRE(writeMesh(sink, mesh, format, options).empty());
    return sink.text;
}

} // namespace

TEST_CASE("Raster: bilinear between the centres of cells, constant beyond them, none outside") {
    const Raster raster{{0.5, 0.5}, {1.0, 2.0}, 3, 2, {1.0, 2.0, 4.0, 3.0, 4.0, kNoValue}};
    CHECK(raster.at({0.5, 0.5}) == 1.0);
    CHECK(raster.at({1.0, 0.5}) == 1.5);
    CHECK(raster.at({1.0, 1.5}) == 2.5);
    CHECK(raster.at({0.0, -0.5}) == 1.0);
    CHECK(raster.at({3.0, 0.5}) == 4.0);
    CHECK(raster.at({1.5, 2.5}) == 4.0); // on the line of cells beside the missing one
    CHECK(std::isnan(raster.at({1.6, 2.5})));
    CHECK(std::isnan(raster.at({3.01, 0.5})));
    CHECK(std::isnan(raster.at({1.0, 3.6})));
    CHECK(raster.gradient({1.0, 1.5}) == Vec2{1.0, 1.0});
    CHECK(raster.gradient({2.0, 0.5}).x == 2.0);
    CHECK(raster.gradient({0.2, 1.5}) == Vec2{0.0, 1.0});
    CHECK(std::isnan(raster.gradient({2.0, 1.0}).y));
}

TEST_CASE("Elevations: of a raster file and of an expression, and places without one are refused") {
    const TemporaryFolder folder;
    const TriMesh mesh = samples::square(2, 2);
    const auto file = folder / "depth.asc";
    REQUIRE(writeFileAtomically(file, "ncols 2\nnrows 2\nxllcorner -1\nyllcorner -1\ncellsize 2\nNODATA_value -9\n"
                                      "-1 -2\n-3 -4\n")
                .empty());
    const Result<Raster> raster = readRaster(file);
    REQUIRE(raster);
    CHECK(raster->at({0.0, 0.0}) == -3.0);
    const Result<std::vector<double>> read = elevationsOf(mesh, *raster);
    REQUIRE(read);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        CHECK((*read)[n] == doctest::Approx(-3.0 - 0.5 * mesh.nodes[n].x + mesh.nodes[n].y));
    }
    REQUIRE(writeFileAtomically(file, "ncols 2\nnrows 2\nxllcorner -1\nyllcorner -1\ncellsize 2\nNODATA_value -9\n"
                                      "-1 -9\n-3 -4\n")
                .empty());
    const Result<std::vector<double>> missing = elevationsOf(mesh, *readRaster(file));
    REQUIRE_FALSE(missing);
    CHECK(hasCode(missing.faults(), "no-elevation"));
    CHECK(missing.faults().front().message.find("4 nodes of 9") != std::string::npos);
    REQUIRE(missing.faults().front().at);
    CHECK(*missing.faults().front().at == Vec2{0.5, 0.5});
    REQUIRE(writeFileAtomically(file, "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value 3\n3\n")
                .empty());
    CHECK(hasCode(readRaster(file).faults(), "no-values"));
    CHECK((*elevationsOf(mesh, "x - 2*y"))[8] == -1.0);
    CHECK(hasCode(elevationsOf(mesh, "x +").faults(), "expression-syntax"));
    CHECK(hasCode(elevationsOf(mesh, "1/x").faults(), "no-elevation"));
}

TEST_CASE("Elevations: an expression calls the rasters, the names and the shore of a job") {
    const TriMesh mesh = samples::square(2, 2);
    const Domain domain = squareDomain(1.0);
    SpacingSpec spacing;
    spacing.names = {{"tide", 0.5}};
    spacing.rasters["depth"] =
        std::make_shared<const Raster>(Raster{{0.0, 0.0}, {1.0, 1.0}, 2, 2, {1.0, 3.0, 1.0, 3.0}});
    const Result<std::vector<double>> values = elevationsOf(mesh, "tide - depth(x,y) + shore(x,y)", spacing, domain);
    REQUIRE(values);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vec2 p = mesh.nodes[n];
        const double shore = std::min({p.x, p.y, 1.0 - p.x, 1.0 - p.y});
        CHECK((*values)[n] == doctest::Approx(0.5 - (1.0 + 2.0 * p.x) + shore));
    }
    CHECK(hasCode(elevationsOf(mesh, "-depth(x,y)").faults(), "expression-syntax"));
    CHECK(hasCode(elevationsOf(mesh, "-deep(x,y)", spacing, domain).faults(), "expression-syntax"));
    spacing.rasters["depth"] =
        std::make_shared<const Raster>(Raster{{0.0, 0.0}, {0.1, 0.1}, 2, 2, {1.0, 3.0, 1.0, 3.0}});
    const Result<std::vector<double>> far = elevationsOf(mesh, "-depth(x,y)", spacing, domain);
    REQUIRE_FALSE(far.ok());
    CHECK(hasCode(far.faults(), "raster-gap"));
    CHECK(elevationsOf(mesh, "-x", spacing, domain)); // which does not call it
}

TEST_CASE("Elevations: the formats hold them, read them back, or note that they leave them out") {
    const TemporaryFolder folder;
    const TriMesh mesh = twoRegionMesh();
    MeshView view(mesh);
    const std::vector<double> elevations = *elevationsOf(mesh, "0.5 - x");
    view.elevations = elevations;
    // Files that have a z of each node, or that their program cannot run without one.
    const std::set<std::string_view> alwaysInSpace = {"2dm",  "adcirc", "gr3", "selafin", "ugrid",
                                                      "mike", "anuga",  "ply", "stl",     "off"};
    std::size_t readers = 0;
    for (const FileFormat &format : engineFormats().list()) {
        if (!format.writesMesh) {
            continue;
        }
        CAPTURE(format.id);
        const auto path = folder / (std::string(format.id) + format.extension);
        REQUIRE(writeMesh(path, view, format.id).empty());
        CHECK(hasCode(exportNotes(path, view, format.id), "elevation-left-out") == !format.holdsElevations);
        CHECK_FALSE(hasCode(exportNotes(path, view, format.id), "no-elevation"));
        const auto notesIn = [&](LengthUnit unit) { return exportNotes(path, view, format.id, {.unit = unit}); };
        CHECK(hasCode(notesIn(LengthUnit::Millimetre), "says-metres") == (format.id == std::string_view("mike")));
        CHECK_FALSE(hasCode(notesIn(LengthUnit::Metre), "says-metres"));
        const Diagnostics flat = exportNotes(path, mesh, format.id);
        CHECK((hasCode(flat, "no-elevation") || hasCode(flat, "no-depth")) == alwaysInSpace.contains(format.id));
        if (format.holdsElevations && format.readsFields) {
            ++readers;
            const Result<MeshFields> back = engineFormats().readFields(path);
            REQUIRE(back);
            REQUIRE(back->fields.count("elevation") == 1);
            for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
                CHECK(back->fields.at("elevation")[n] == 0.5 - back->mesh.nodes[n].x);
            }
        }
    }
    CHECK(readers == 8); // MSH in three forms, VTU, XDMF, 2DM, fort.14, gr3
    const TriMesh square = samples::square(1, 1);
    MeshView squareView(square);
    const std::vector<double> slope = *elevationsOf(square, "0.5 - x");
    squareView.elevations = slope;
    CHECK(elevatedText("adcirc", squareView).find("\n1 0 0 -0.5\n2 1 0 0.5\n") != std::string::npos);
    CHECK(noteDepths(squareView).empty());
}

TEST_CASE("Elevations: nodes in the middles of edges get the mean of their ends") {
    const Mesh mesh = samples::sampleMesh(CellKind::Quadrilateral9);
    std::size_t corners = 0;
    while (mesh.blocks[0].nodesOf(0)[4] != NodeId{static_cast<std::uint32_t>(corners)}) {
        ++corners;
    }
    std::vector<double> elevations;
    for (std::size_t n = 0; n < corners; ++n) {
        elevations.push_back(3.0 * mesh.nodes[n].x - mesh.nodes[n].y);
    }
    addMiddleElevations(mesh, elevations);
    REQUIRE(elevations.size() == mesh.nodes.size());
    for (const std::span<const NodeId> nodes : {mesh.blocks[0].nodesOf(0)}) {
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(elevations[index(nodes[4 + k])] ==
                  doctest::Approx(0.5 * (elevations[index(nodes[k])] + elevations[index(nodes[(k + 1) % 4])])));
        }
    }
}
