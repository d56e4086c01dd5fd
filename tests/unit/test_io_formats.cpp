#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/node_table.hpp"
#include "core/files/files.hpp"
#include "core/files/format.hpp"
#include "core/files/text/text_scanner.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// OBJ stores faces by group.
TriMesh byRegion(TriMesh mesh) {
    const TriMesh old = mesh;
    std::size_t next = 0;
    for (const std::int32_t region : {2, 5}) {
        for (std::size_t e = 0; e < old.elements.size(); ++e) {
            if (old.regions[e] == region) {
                mesh.elements[next] = old.elements[e];
                mesh.regions[next++] = region;
            }
        }
    }
    return mesh;
}

/// The nodes and elements alone: grids of water tell only open boundaries, land and islands apart.
TriMesh shapeAlone(const TriMesh &mesh) {
    TriMesh shape;
    shape.nodes = mesh.nodes;
    shape.elements = mesh.elements;
    shape.regions.assign(mesh.elements.size(), 1);
    return shape;
}

} // namespace

TEST_CASE("Formats: a mesh written in any format is read back the same, with tags, names and regions") {
    const TemporaryFolder folder;
    const TriMesh mesh = twoRegionMesh();
    for (const FileFormat &format : allFormats().list()) {
        if (!format.writesMesh || !format.readsMesh) {
            continue;
        }
        CAPTURE(format.id);
        const auto path = folder / (std::string("mesh_") + format.id + format.extension);
        const Status status = writeMesh(path, mesh, format.id);
        REQUIRE_MESSAGE(status.empty(), messages(status));
        auto back = triangles(allFormats().readMesh(path));
        REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
        undoRounding(*back, mesh, exportNotes(path, mesh, format.id));
        if (format.hasOpenBoundaries) {
            CHECK(difference(shapeAlone(mesh), shapeAlone(*back)) == "");
            CHECK(back->edges.size() >= 2 * (8 + 5)); // the sides of the rectangle
        } else {
            CHECK(difference(std::string(format.id) == "obj" ? byRegion(mesh) : mesh, *back) == "");
        }
        CHECK(verify(*back).empty());
    }
}

TEST_CASE("Formats: reading a mesh of any format reports its progress and can be cancelled") {
    const TemporaryFolder folder;
    const TriMesh mesh = twoRegionMesh(200, 100);
    for (const FileFormat &format : allFormats().list()) {
        if (!format.writesMesh || !format.readsMesh) {
            continue;
        }
        CAPTURE(std::string(format.id));
        const auto path = folder / (std::string("mesh_") + format.id + format.extension);
        REQUIRE(writeMesh(path, mesh, format.id).empty());
        std::vector<double> reports;
        std::stop_source stop;
        double stopAt = 2.0;
        ImportOptions options;
        options.progress = {[&](std::string_view stage, double fraction) {
                                CHECK(stage.starts_with("reading mesh_"));
                                reports.push_back(fraction);
                                if (fraction > stopAt) {
                                    stop.request_stop();
                                }
                            },
                            stop.get_token()};
        CHECK(allFormats().readFields(path, options).ok());
        REQUIRE(reports.size() > 3);
        CHECK(*std::max_element(reports.begin(), reports.end()) > 0.6);
        stopAt = 0.3;
        const std::size_t all = std::exchange(reports, {}).size();
        const auto cancelled = allFormats().readFields(path, options);
        REQUIRE_FALSE(cancelled.ok());
        CHECK(hasCode(cancelled.faults(), "cancelled"));
        CHECK(cancelled.faults().front().message == "reading was cancelled");
        CHECK(reports.size() < all);
        CHECK(hasCode(triangles(allFormats().readMesh(path, options)).faults(),
                      "cancelled")); // the request is still there
    }
}

TEST_CASE("Formats: readers that go through the elements twice can be cancelled the second time, too") {
    const TemporaryFolder folder;
    const TriMesh mesh = twoRegionMesh(200, 100);
    for (const char *const id : {"su2", "obj"}) {
        CAPTURE(id);
        const auto path = folder / (std::string("mesh.") + id);
        REQUIRE(writeMesh(path, mesh, id).empty());
        double last = 0.0;
        bool again = false; // the reader has gone back
        std::stop_source stop;
        ImportOptions options;
        options.progress = {[&](std::string_view, double fraction) {
                                again = again || fraction < last;
                                last = fraction;
                                if (again) {
                                    stop.request_stop();
                                }
                            },
                            stop.get_token()};
        const auto cancelled = triangles(allFormats().readMesh(path, options));
        CHECK(again);
        REQUIRE_FALSE(cancelled.ok());
        CHECK(cancelled.faults().front().message == "reading was cancelled");
    }
}

TEST_CASE("Formats: round trip of a mesh of one region without names, edges or points") {
    const TemporaryFolder folder;
    TriMesh mesh = samples::square(2, 2);
    mesh.edges.clear();
    mesh.boundaryNames.clear();
    for (const FileFormat &format : allFormats().list()) {
        if (!format.writesMesh || !format.readsMesh) {
            continue;
        }
        CAPTURE(format.id);
        const auto path = folder / (std::string("mesh_") + format.id + format.extension);
        REQUIRE(writeMesh(path, mesh, format.id).empty());
        const auto back = triangles(allFormats().readMesh(path));
        REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
        CHECK(difference(mesh, format.hasOpenBoundaries ? shapeAlone(*back) : *back) == "");
        CHECK(back->regions == std::vector<std::int32_t>(mesh.elements.size(), 1));
        CHECK(back->boundaryNames.size() == (format.hasOpenBoundaries ? 1U : 0U)); // land
        CHECK(back->regionNames.empty());
    }
}

namespace {

const std::string kNetgen = R"(mesh3d
dimension
2
geomtype
0

# surfnr    bcnr   domin  domout      np      p1      p2      p3
surfaceelements
2
 2 1 0 0 3 1 2 3
 2 2 0 0 3 1 3 4

#  matnr      np      p1      p2      p3      p4
volumeelements
0

# surfid  0   p1   p2   trignum1    trignum2   domin/surfnr1    domout/surfnr2   ednr1   dist1   ednr2   dist2
edgesegmentsgi2
2
 1 0 1 2 -1 -1 1 0 1 0 1 0.5
 2 0 2 3 -1 -1 1 0 2 0 2 1

#          X             Y             Z
points
4
 0 0 0
 1 0 0
 1 1 0
 0 1 0

pointelements
1
 4 3

materials
1
1 sea

bcnames
2
1 in let
2 wall

endmesh
)";

Result<TriMesh> readNetgenText(const std::string &text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "mesh.vol") << text;
    return triangles(allFormats().readMesh(folder / "mesh.vol"));
}

/// Returns the text with the first occurrence of a part replaced.
std::string changed(std::string text, const std::string &part, const std::string &by) {
    return text.replace(text.find(part), part.size(), by);
}

} // namespace

TEST_CASE("Netgen: elements, regions, boundary parts and names are read") {
    const auto mesh = readNetgenText(kNetgen);
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->nodes == std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    CHECK(mesh->elements.size() == 2);
    CHECK(mesh->elements[1] == Element{NodeId{0}, NodeId{2}, NodeId{3}});
    CHECK(mesh->regions == std::vector<std::int32_t>{1, 2});
    REQUIRE(mesh->edges.size() == 2);
    CHECK(mesh->edges[1].b == NodeId{2});
    CHECK(mesh->edges[1].tag == 2);
    REQUIRE(mesh->points.size() == 1);
    CHECK(mesh->points[0].tag == 3);
    CHECK(mesh->regionNames.at(1) == "sea");
    CHECK(mesh->boundaryNames.at(1) == "in let");
    CHECK(verify(*mesh).empty());
}

TEST_CASE("Netgen: anything other than a plane mesh is refused with its line") {
    const auto fault = [](const std::string &part, const std::string &by) {
        const auto mesh = readNetgenText(changed(kNetgen, part, by));
        REQUIRE_FALSE(mesh.ok());
        CHECK(mesh.faults()[0].line > 0);
        return mesh.faults()[0].code;
    };
    CHECK(fault("0 0 3 1 2 3", "0 0 6 1 2 3 4 1 2") == "degenerate-element");
    CHECK(fault("0 0 3 1 2 3", "0 0 5 1 2 3 4 5") == "unknown-element");
    CHECK(fault("volumeelements\n0", "volumeelements\n1\n1 4 1 2 3 4") == "not-planar");
    CHECK(fault(" 0 1 0\n", " 0 1 5\n") == "not-planar");
    CHECK(fault("3 1 3 4", "3 1 3 9") == "bad-index");
    CHECK(fault("bcnames\n2", "bcnames\n20") == "bad-count");
    CHECK(fault("points\n4", "vertices\n4") == "bad-syntax");
}

TEST_CASE("Formats: the domain of a written mesh is the domain it covers") {
    const TemporaryFolder folder;
    const TriMesh mesh = twoRegionMesh();
    for (const char *id : {"msh2", "msh41", "msh41-binary"}) {
        const auto path = folder / "mesh.msh";
        REQUIRE(writeMesh(path, mesh, id).empty());
        const auto file = allFormats().readDomain(path);
        REQUIRE(file.ok());
        std::size_t boundary = 0;
        for (const DomainSegment &segment : file->domain.segments) {
            boundary += segment.role == SegmentRole::Boundary ? 1U : 0U;
        }
        CHECK(boundary == 26);
        CHECK(file->domain.segments.size() == mesh.edges.size());
        REQUIRE(file->domain.regionMarkers.size() == 2);
        CHECK(file->domain.regionMarkers[0].tag != file->domain.regionMarkers[1].tag);
        CHECK(file->domain.points.size() == 1);
        CHECK(boundaryName(file->domain.boundaryNames, 9) == "interface");
    }
}

TEST_CASE("Formats: the default of an extension, unknown formats and cancelling") {
    const TemporaryFolder folder;
    const TriMesh mesh = samples::square(3, 3);
    REQUIRE(writeMesh(folder / "a.MSH", mesh).empty());
    std::string first, version;
    std::ifstream(folder / "a.MSH") >> first >> version;
    CHECK(version == "2.2");
    CHECK(hasCode(writeMesh(folder / "a.xyz", mesh), "unknown-format"));
    CHECK(hasCode(writeMesh(folder / "a.msh", mesh, "project"), "unknown-format"));
    CHECK(hasCode(triangles(allFormats().readMesh(folder / "none.msh")).faults(), "cannot-read"));
    REQUIRE(writeFileAtomically(folder / "a.xyz", "what is this").empty());
    CHECK(hasCode(triangles(allFormats().readMesh(folder / "a.xyz")).faults(), "unknown-format"));
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    CHECK(hasCode(writeMesh(folder / "b.msh", mesh, {}, progress), "cancelled"));
    CHECK(!std::filesystem::exists(folder / "b.msh"));
}

TEST_CASE("Formats: what the list says of a format agrees with its functions") {
    std::set<std::string> programs;
    for (const Format &format : allFormats().formats()) {
        const FileFormat &about = format.about;
        CAPTURE(std::string(about.id));
        CHECK(about.readsDomain == format.canReadDomain());
        CHECK(about.readsMesh == (format.readMesh != nullptr));
        CHECK(about.writesMesh == format.canWriteMesh());
        CHECK(about.readsSpacing == (format.readSpacing != nullptr));
        CHECK(about.readsFields == (format.readFields != nullptr));
        CHECK((about.files.empty() && about.folder.empty()) == (format.writeFiles == nullptr));
        CHECK(about.holdsSolids == (format.writeSolid != nullptr || about.solidsOnly));
        CHECK(about.writesMesh == !std::string(about.keeps).empty());
        CHECK((!about.readsMesh || about.kind == FileKind::Mesh));
        CHECK((about.kind != FileKind::Mesh || about.readsMesh || about.writesMesh));
        CHECK((format.writeWith == nullptr || about.hasOpenBoundaries || about.tellsTagsApart || about.namesUnit ||
               std::string_view(about.id) == "ugrid")); // which names the reference system
        CHECK((!about.namesUnit || format.writeWith != nullptr));
        CHECK(about.tellsTagsApart == (format.noteKeptChanges != nullptr));
        CHECK((!about.hasOpenBoundaries || format.writeWith != nullptr || format.writeFiles != nullptr));
        CHECK(about.readsSpacing >= (format.readRaster != nullptr));
        CHECK((!about.hasLayers || about.kind == FileKind::Map || about.kind == FileKind::CadDrawing));
        if (const std::string program = about.program; !program.empty()) {
            CHECK(about.writesMesh);
            CHECK(programs.insert(program).second); // one format for each program
        }
    }
    CHECK(programs.contains("Gmsh"));
}

TEST_CASE("Formats: each extension is listed once, and each file of a set is named") {
    const std::vector<std::string> meshes =
        allFormats().allExtensions([](const FileFormat &format) { return format.readsMesh; });
    CHECK(std::count(meshes.begin(), meshes.end(), ".msh") == 1);
    CHECK(std::count(meshes.begin(), meshes.end(), ".ele") == 1);
    CHECK(std::count(meshes.begin(), meshes.end(), ".json") == 0);
    CHECK(allFormats().allExtensions([](const FileFormat &format) { return format.kind == FileKind::Project; }) ==
          std::vector<std::string>{".json", ".forefront"});
    const TemporaryFolder folder;
    for (const FileFormat &format : allFormats().list()) {
        if (!format.writesMesh) {
            continue;
        }
        CAPTURE(std::string(format.id));
        const auto place = folder / format.id;
        std::filesystem::create_directory(place);
        REQUIRE(writeMesh(place / ("plate" + std::string(format.extension)), samples::square(3, 3), format.id).empty());
        std::set<std::filesystem::path> written;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(place)) {
            if (!entry.is_directory()) {
                written.insert(entry.path());
            }
        }
        const auto named = filesOfMesh(place / ("plate" + std::string(format.extension)), format.id);
        CHECK(std::set<std::filesystem::path>(named.begin(), named.end()) == written);
    }
}

TEST_CASE("Formats: reading a .poly file opens the .node file beside it if that holds its nodes") {
    const TemporaryFolder folder;
    const auto poly = folder / "plate.poly", nodes = folder / "plate.node";
    REQUIRE(writeFileAtomically(poly, "# nodes elsewhere\n0 2 0 0\n").empty());
    CHECK(filesRead(poly) == std::vector<std::filesystem::path>{poly});
    REQUIRE(writeFileAtomically(nodes, "0 2 0 0\n").empty());
    CHECK(filesRead(poly) == std::vector<std::filesystem::path>{poly, nodes});
    REQUIRE(writeFileAtomically(poly, "3 2 0 0\n").empty());
    CHECK(filesRead(poly) == std::vector<std::filesystem::path>{poly});
}

TEST_CASE("Formats: content takes precedence over a wrong extension") {
    const TemporaryFolder folder;
    const TriMesh mesh = samples::square(3, 3);
    REQUIRE(writeMesh(folder / "mesh.txt", mesh, "msh2").empty());
    const auto back = triangles(allFormats().readMesh(folder / "mesh.txt"));
    REQUIRE(back.ok());
    CHECK(difference(mesh, *back) == "");
    REQUIRE(writeProject(folder / "project.txt", fullDocument()).empty());
    CHECK(readDocument(folder / "project.txt").ok());
    CHECK(hasCode(triangles(allFormats().readMesh(folder / "project.txt")).faults(), "unknown-format"));
}

TEST_CASE("TextScanner: numbers, comments and places") {
    const std::string text = "12 +3.5 # 99\n  -1.0D+2 .5 5. 1e-400\nx1 nan";
    const SourceText source = sourceOf(text, "f");
    TextScanner scanner(source, '#');
    std::int64_t whole = 0;
    double real = 0.0;
    CHECK(scanner.integer(whole, 0, 20, {"n"}));
    CHECK(whole == 12);
    const double expected[] = {3.5, -100.0, 0.5, 5.0, 0.0};
    for (const double value : expected) {
        CHECK(scanner.real(real, {"x"}));
        CHECK(real == value);
    }
    TextScanner other = scanner;
    CHECK(!scanner.real(real, {"the coordinates of node", 17}));
    REQUIRE(scanner.faults().size() == 1);
    CHECK(toString(scanner.faults()[0]) ==
          "f:3:1: error: expected a number for the coordinates of node 17, found 'x1' [bad-number]");
    CHECK(other.word() == "x1");
    CHECK(!other.real(real, {"x"}));
    CHECK(other.faults()[0].code == "non-finite");
    CHECK(other.faults()[0].column == 4);
}

TEST_CASE("TextScanner: a count larger than the file can hold is refused before anything is reserved") {
    const std::string text = "999999999999 1 2";
    const SourceText source = sourceOf(text);
    TextScanner scanner(source);
    std::size_t count = 0;
    CHECK(!scanner.count(count, 4, {"the number of nodes"}));
    CHECK(scanner.faults()[0].code == "bad-count");
    CHECK(count == 0);
}

TEST_CASE("parseReal: the entire text must be a number") {
    CHECK(parseReal("1.5") == 1.5);
    CHECK(parseReal("+1.5") == 1.5);
    CHECK(parseReal("1.5d3") == 1500.0);
    CHECK(parseReal("1e999") == std::numeric_limits<double>::infinity());
    CHECK(parseReal("1e-999") == 0.0);
    CHECK(parseReal("0." + std::string(400, '0') + "1") == 0.0);
    for (const char *wrong : {"", "+", "+-1", "1.5x", "1,5", "--1", "1d2d3", "0x10"}) {
        CAPTURE(wrong);
        CHECK(!parseReal(wrong));
    }
}

TEST_CASE("NodeTable: finds dense and sparse numbers and reports duplicates") {
    NodeTable dense, sparse, twins;
    for (const std::int64_t n : {5, 3, 4}) {
        dense.add(n);
    }
    for (const std::int64_t n : {std::numeric_limits<std::int64_t>::max(), std::int64_t{-7}, std::int64_t{12}}) {
        sparse.add(n);
    }
    CHECK(dense.finish() == kNoIndex);
    CHECK(dense.find(3) == 1);
    CHECK(dense.find(6) == kNoIndex);
    CHECK(dense.find(std::numeric_limits<std::int64_t>::min()) == kNoIndex);
    CHECK(sparse.finish() == kNoIndex);
    CHECK(sparse.find(-7) == 1);
    CHECK(sparse.find(std::numeric_limits<std::int64_t>::max()) == 0);
    CHECK(sparse.find(0) == kNoIndex);
    twins.add(1);
    twins.add(1'000'000'000);
    twins.add(1);
    CHECK(twins.finish() == 2);
    CHECK(NodeTable().finish() == kNoIndex);
    CHECK(NodeTable().find(0) == kNoIndex);
}

TEST_CASE("Formats: a mesh whose areas would overflow is refused") {
    ImportOptions options;
    const std::string far = "v 0 0 0\nv 1e200 0 0\nv 0 1e200 0\nf 1 2 3\n";
    options.content = std::make_shared<const std::string>(far);
    const auto read = allFormats().readMesh("far.obj", options);
    REQUIRE(!read);
    CHECK(read.faults().front().code == "out-of-range");
    CHECK(read.faults().front().message.starts_with("node 2 of the mesh"));
    CHECK(!allFormats().readFields("far.obj", options));
    CHECK(!allFormats().readDomain("far.obj", options));
}
