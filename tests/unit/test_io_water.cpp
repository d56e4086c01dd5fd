#include "core/files/files.hpp"
#include "core/files/hydro/selafin.hpp"
#include "core/files/ugrid/classic_netcdf.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Two triangles on [0,2]x[0,1] with the sides 1 (bottom), 2 (right) and 4 (left).
TriMesh waterBasin() {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    mesh.elements = {{NodeId{0}, NodeId{1}, NodeId{2}}, {NodeId{0}, NodeId{2}, NodeId{3}}};
    mesh.edges = {{NodeId{0}, NodeId{1}, 1}, {NodeId{1}, NodeId{2}, 2}, {NodeId{3}, NodeId{0}, 4}};
    mesh.boundaryNames = {{2, "open sea"}};
    return mesh;
}

std::string waterText(const char *format, const MeshView &mesh, std::vector<std::int32_t> open = {}) {
    StringSink sink;
    ExportOptions options;
    options.openBoundaries = std::move(open);
    REQUIRE(writeMesh(sink, mesh, format, options).empty());
    return sink.text;
}

/// The number at a byte, with the highest byte first.
std::uint32_t bigEndian(const std::string &bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        value = value << 8U | static_cast<unsigned char>(bytes.at(at + k));
    }
    return value;
}

} // namespace

TEST_CASE("MIKE: the text of a small mesh, codes of open parts, and quadrilaterals beside triangles") {
    const TriMesh basin = waterBasin();
    MeshView mesh(basin);
    const std::vector<double> elevations = {-1, -2, -2.5, 0};
    mesh.elevations = elevations;
    CHECK(waterText("mike", mesh, {4, 2}) == "100079 1000 4 NON-UTM\n1 0 0 -1 2\n2 2 0 -2 3\n3 2 1 -2.5 3\n4 0 1 0 2\n"
                                             "2 3 21\n1 1 2 3\n2 1 3 4\n");
    CHECK(waterText("mike", mesh).find("1 0 0 -1 1\n") != std::string::npos);
    const Mesh mixed = samples::mixedSample();
    CHECK(waterText("mike", mixed).find('\n' + std::to_string(mixed.elementCount()) + " 4 25\n") != std::string::npos);
}

TEST_CASE("ANUGA: vertices, neighbours opposite to their corners, and names of one word") {
    const TriMesh basin = waterBasin();
    const std::string text = waterText("anuga", basin);
    CHECK(text.find("4 0 # <# of verts>") == 0);
    CHECK(text.find("\n0 0 1 2 -1 1 -1 region_1\n1 0 2 3 -1 -1 0 region_1\n") != std::string::npos);
    CHECK(text.find("\n1 1 2 open_sea\n") != std::string::npos);
    CHECK(hasCode(exportNotes("a.tsh", basin), "changed-names"));
}

TEST_CASE("TELEMAC: records of the geometry, conditions of the boundary, and the origin of far coordinates") {
    const TemporaryFolder folder;
    TriMesh basin = waterBasin();
    ExportOptions options;
    options.openBoundaries = {2};
    REQUIRE(writeMesh(folder / "a.slf", basin, {}, {}, options).empty());
    const std::string slf = *readFileBytes(folder / "a.slf", 1U << 20U);
    CHECK(bigEndian(slf, 0) == 80);
    CHECK(slf.substr(76, 8) == "SERAFIN ");
    const std::size_t counts = 88 + 16 + 40 + 48; // title, numbers of variables, name, parameters
    CHECK(bigEndian(slf, counts) == 16);
    CHECK(bigEndian(slf, counts + 4) == 2);
    CHECK(bigEndian(slf, counts + 8) == 4);
    CHECK(slf.size() == counts + 24 + (8 + 24) + 4 * (8 + 16) + 12);
    CHECK(*readFileBytes(folder / "a.cli", 1000) ==
          "2 2 2 0. 0. 0. 0. 2 0. 0. 0. 1 1\n5 4 4 0. 0. 0. 0. 4 0. 0. 0. 2 2\n"
          "5 4 4 0. 0. 0. 0. 4 0. 0. 0. 3 3\n2 2 2 0. 0. 0. 0. 2 0. 0. 0. 4 4\n");
    for (Vec2 &node : basin.nodes) {
        node = node + Vec2{500'000.25, 7.0};
    }
    REQUIRE(writeMesh(folder / "far.slf", basin).empty());
    const std::string far = *readFileBytes(folder / "far.slf", 1U << 20U);
    CHECK(bigEndian(far, 88 + 16 + 40 + 4 + 8) == 500'001);
    CHECK(bigEndian(far, 88 + 16 + 40 + 4 + 12) == 0);
    CHECK(hasCode(exportNotes("far.slf", basin), "moved-origin"));
    basin.elements.pop_back();
    basin.nodes.push_back({-1, 0});
    basin.nodes.push_back({-1, -1});
    basin.elements.push_back({NodeId{0}, NodeId{4}, NodeId{5}});
    const Status touching = writeMesh(folder / "b.slf", basin);
    REQUIRE(hasCode(touching, "not-manifold"));
    CHECK(touching.front().at == basin.nodes[0]);
}

TEST_CASE("UGRID: the header tells where the values are") {
    ClassicNetcdf file;
    file.dimensions = {{"n", 3}};
    file.attributes = {{"Conventions", std::string("CF-1.8")}};
    file.variables = {
        {"a",
         {0},
         {},
         false,
         [](BigEndian &out) {
             for (const std::uint32_t value : {7U, 8U, 9U}) {
                 out.integer(value);
             }
         }},
        {"bcdef", {}, {{"k", std::vector<std::int32_t>{5}}}, true, [](BigEndian &out) { out.real(1.0); }}};
    StringSink sink;
    TextWriter out(sink);
    file.write(out);
    out.flush();
    const std::string &bytes = sink.text;
    CHECK(bytes.substr(0, 4) == std::string("CDF\2", 4));
    CHECK(bytes.size() > 20);
    CHECK(bigEndian(bytes, bytes.size() - 20) == 7);
    CHECK(bigEndian(bytes, bytes.size() - 12) == 9);
    CHECK(bigEndian(bytes, bytes.size() - 8) == 0x3ff00000);
    CHECK(bigEndian(bytes, bytes.size() - 24) == bytes.size() - 8); // where the last variable begins
    const std::string mesh = waterText("ugrid", samples::mixedSample());
    CHECK(mesh.find("UGRID-1.0") != std::string::npos);
    CHECK(mesh.find("flag_meanings") != std::string::npos);
}

TEST_CASE("UGRID: the reference system of a map is named as CF, Delft3D FM and MDAL want it") {
    const TriMesh basin = waterBasin();
    const auto text = [&](const MapSystem &system) {
        StringSink sink;
        ExportOptions options;
        options.system = system;
        REQUIRE(writeMesh(sink, basin, "ugrid", options).empty());
        return sink.text;
    };
    const auto has = [](const std::string &file, std::string_view words) {
        return file.find(words) != std::string::npos;
    };
    const std::string none = text({});
    CHECK_FALSE(has(none, "grid_mapping"));
    CHECK(has(none, "projection_x_coordinate"));
    const std::string projected = text({.code = "EPSG:3067", .wkt = "PROJCRS[\"x\"]"});
    CHECK(has(projected, "EPSG_code"));
    CHECK(has(projected, "EPSG:3067"));
    CHECK(has(projected, "crs_wkt"));
    CHECK(has(projected, "projected_coordinate_system"));
    const std::string degrees = text({.code = {}, .wkt = {}, .geographic = true});
    CHECK(has(degrees, "wgs84"));
    CHECK(has(degrees, "latitude_longitude"));
    CHECK(has(degrees, "degrees_north"));
    CHECK_FALSE(has(degrees, "projection_x_coordinate"));
    const std::string local = text({.code = {}, .wkt = {}, .geographic = false, .centre = Vec2{25.5, 60.25}});
    CHECK(has(local, "azimuthal_equidistant"));
    CHECK(has(local, "PARAMETER[\"latitude_of_center\",60.25]"));
    // Doubles are written as such: 60.25 is 0x404e200000000000.
    const std::size_t at = local.find("latitude_of_projection_origin");
    REQUIRE(at != std::string::npos);
    CHECK(bigEndian(local, at + 32) == 6); // the type
    CHECK(bigEndian(local, at + 40) == 0x404e2000);
}
