#include "core/files/components/component.hpp"
#include "core/files/files.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/xdmf/xdmf.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace xdmf_test {

std::string item(const std::string &dimensions, const std::string &numbers) {
    return "<DataItem Dimensions=\"" + dimensions + "\" Format=\"XML\">" + numbers + "</DataItem>";
}

std::string topology(const std::string &type, const std::string &dimensions, const std::string &numbers) {
    return "<Topology TopologyType=\"" + type + "\">" + item(dimensions, numbers) + "</Topology>";
}

std::string attribute(const std::string &name, const std::string &centre, const std::string &dimensions,
                      const std::string &numbers) {
    return "<Attribute Name=\"" + name + "\" Center=\"" + centre + "\">" + item(dimensions, numbers) + "</Attribute>";
}

const std::string kSquare = "<Geometry GeometryType=\"XY\">" + item("4 2", "0 0 2 0 2 1 0 1") + "</Geometry>";

std::string grid(const std::string &name, const std::string &content) {
    return "<Grid Name=\"" + name + "\">" + content + "</Grid>";
}

std::string file(const std::string &grids) {
    return "<?xml version=\"1.0\"?><!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []><Xdmf Version=\"3.0\"><Domain>" + grids +
           "</Domain></Xdmf>";
}

const std::string kTriangles = topology("Triangle", "2 3", "0 1 2\n0 2 3");

std::string bytesOf(const std::filesystem::path &path) {
    return readFileBytes(path, std::size_t{1} << 24).value_or(std::string());
}

} // namespace xdmf_test

TEST_CASE("XDMF: all kinds of cells, values and names come back, and the same mesh gives the same bytes") {
    const TemporaryFolder folder;
    Mesh mesh = samples::allKindsSample();
    mesh.regionNames[mesh.blocks.front().regions.front()] = "steel & \"copper\" <1>";
    MeshView view(mesh);
    std::vector<double> elevations;
    for (const Vec2 node : mesh.nodes) {
        elevations.push_back(0.1 * node.x - node.y);
    }
    view.elevations = elevations;
    REQUIRE(writeMesh(folder / "a.xdmf", view).empty());
    REQUIRE(writeMesh(folder / "b.xdmf", view).empty());
    CHECK(folder.fileCount() == 4);
    CHECK(xdmf_test::bytesOf(folder / "a.h5").substr(1, 3) == "HDF");
    CHECK(xdmf_test::bytesOf(folder / "a.h5") == xdmf_test::bytesOf(folder / "b.h5"));
    const Result<MeshFields> back = readFields(folder / "a.xdmf");
    REQUIRE_MESSAGE(back.ok(), messages(back ? Diagnostics() : back.faults()));
    CHECK(meshHash(back->mesh) == meshHash(mesh));
    CHECK(back->mesh.regionNames == mesh.regionNames);
    CHECK(back->mesh.boundaryNames == mesh.boundaryNames);
    CHECK(back->fields.at("elevation") == elevations);
    CHECK(back->elementFields.empty());
}

TEST_CASE("XDMF: arrays in the text, several kinds of cells in one, and tags of other programs") {
    using namespace xdmf_test;
    // As FEniCSx writes tags: grids of their own, of edges and of elements in another order.
    const std::string all = file(
        grid("mesh", kTriangles + kSquare) +
        grid("cells", topology("Triangle", "2 3", "2 3 0 2 0 1") + kSquare + attribute("x", "Cell", "2 1", "7 5")) +
        grid("facets", topology("Mixed", "8", "2 2 0 1 2 2 1 2") + kSquare + attribute("y", "Cell", "2", "3 4")) +
        "<Grid GridType=\"Collection\" CollectionType=\"Temporal\">" +
        grid("u", attribute("u", "Node", "4 1", "1 2 3 4.5")) + grid("u", attribute("u", "Node", "4 1", "0 0 0 0")) +
        "</Grid>");
    SourceText source = sourceOf(all, "a.xdmf");
    ImportNotes notes;
    source.notes = &notes;
    const Result<MeshFields> fields = readXdmfFields(source);
    REQUIRE_MESSAGE(fields.ok(), messages(fields ? Diagnostics() : fields.faults()));
    CHECK(fields->mesh.blocks.front().regions == std::vector<std::int32_t>{5, 7});
    REQUIRE(fields->mesh.edges.size() == 2);
    CHECK(fields->mesh.edges[0].tag == 3);
    CHECK(fields->mesh.edges[1].tag == 4);
    CHECK(fields->fields.at("u") == std::vector<double>{1, 2, 3, 4.5});
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().code == "xdmf-time");
    // As meshio writes tags: the only array of whole numbers; other arrays are values.
    const Result<MeshFields> one =
        readXdmfFields(sourceOf(file(grid("Grid", kTriangles + kSquare + attribute("marks", "Cell", "2", "4 9")))));
    REQUIRE(one.ok());
    CHECK(one->mesh.blocks.front().regions == std::vector<std::int32_t>{4, 9});
    const Result<MeshFields> values =
        readXdmfFields(sourceOf(file(grid("Grid", kTriangles + kSquare + attribute("heat", "Cell", "2", "4 9.5")))));
    REQUIRE(values.ok());
    CHECK(values->elementFields.at("heat") == std::vector<double>{4, 9.5});
    CHECK(values->mesh.blocks.front().regions == std::vector<std::int32_t>{1, 1});
}

TEST_CASE("XDMF: broken files are refused with the place") {
    using namespace xdmf_test;
    const std::string quad = topology("Quadrilateral", "1 4", "0 1 2 3");
    const struct {
        std::string text;
        const char *code;
    } cases[] = {
        {"<Xdmf><Domain", "xml-syntax"},
        {"<Xdmf></Xdmf>", "bad-syntax"},
        {file(""), "no-elements"},
        {file(grid("a", topology("PolyLine", "1 2", "0 1") + kSquare)), "no-elements"},
        {file(grid("a", kTriangles)), "bad-syntax"},
        {file(grid("a", topology("Tetrahedron", "1 4", "0 1 2 3") + kSquare)), "unknown-element"},
        {file(grid("a", topology("Mixed", "5", "6 0 1 2 3") + kSquare)), "unknown-element"},
        {file(grid("a", topology("Mixed", "3", "4 0 1") + kSquare)), "bad-count"},
        {file(grid("a", topology("Triangle", "1 4", "0 1 2 3") + kSquare)), "bad-count"},
        {file(grid("a", topology("Triangle", "2 3", "0 1 2") + kSquare)), "bad-count"},
        {file(grid("a", topology("Triangle", "99999999 9999999999", "0 1 2") + kSquare)), "bad-count"},
        {file(grid("a", topology("Triangle", "-1 3", "0 1 2") + kSquare)), "bad-number"},
        {file(grid("a", topology("Triangle", "1 3", "0 1 x") + kSquare)), "bad-number"},
        {file(grid("a", topology("Triangle", "1 3", "0 1 4") + kSquare)), "bad-index"},
        {file(grid("a", topology("Triangle", "1 3", "0 1 1.5") + kSquare)), "bad-index"},
        {file(grid("a", topology("Triangle", "1 3", "0 1 1e300") + kSquare)), "bad-index"},
        {file(grid("a", topology("Triangle", "1 3", "0 1 nan") + kSquare)), "bad-index"},
        {file(grid("a", quad + "<Geometry GeometryType=\"XY\">" + item("4 2", "0 0 1 0 1 inf 0 1") + "</Geometry>")),
         "non-finite"},
        {file(grid("a", quad + "<Geometry>" + item("4 3", "0 0 0 1 0 0 1 1 1 0 1 0") + "</Geometry>")), "not-planar"},
        {file(grid("a", quad + "<Geometry GeometryType=\"XYZ\">" + item("2 2", "0 0 1 0") + "</Geometry>")),
         "bad-count"},
        {file(grid("a", quad + "<Geometry GeometryType=\"VXVYVZ\">" + item("1", "0") + "</Geometry>")), "bad-syntax"},
        {file(grid("a", "<Topology TopologyType=\"Triangle\"><DataItem Format=\"HDF\">a.h5:/x</DataItem></Topology>")),
         "cannot-read"},
        {file(grid("a", "<Topology TopologyType=\"Triangle\"><DataItem Format=\"Binary\">a</DataItem></Topology>")),
         "bad-syntax"},
    };
    for (const auto &[text, code] : cases) {
        CAPTURE(text);
        const Result<Mesh> mesh = readXdmf(sourceOf(text, "a.xdmf"));
        REQUIRE(!mesh.ok());
        CHECK(mesh.faults().front().code == code);
        CHECK(allLocated(mesh.faults()));
    }
    // A deep nest of grids must not exhaust the stack.
    std::string deep;
    for (int k = 0; k < 50'000; ++k) {
        deep += "<Grid GridType=\"Tree\">";
    }
    for (int k = 0; k < 50'000; ++k) {
        deep += "</Grid>";
    }
    CHECK(!readXdmf(sourceOf(file(deep))).ok());
}

TEST_CASE("XDMF: a missing, cut or changed HDF5 file is refused") {
    const TemporaryFolder folder;
    REQUIRE(writeMesh(folder / "a.xdmf", twoRegionMesh()).empty());
    const std::string bytes = xdmf_test::bytesOf(folder / "a.h5");
    const auto refused = [&](const std::string &changed) {
        std::ofstream(folder / "a.h5", std::ios::binary) << changed;
        const Result<Mesh> mesh = readMesh(folder / "a.xdmf");
        return !mesh && mesh.faults().front().code == "cannot-read";
    };
    CHECK(refused(""));
    CHECK(refused("no HDF5"));
    CHECK(refused(bytes.substr(0, bytes.size() / 2)));
    std::filesystem::remove(folder / "a.h5");
    const Result<Mesh> alone = readMesh(folder / "a.xdmf");
    REQUIRE(!alone.ok());
    CHECK(alone.faults().front().message.find("was not found") != std::string::npos);
    ImportOptions small;
    small.maxBytes = 2000; // of the text, and of each array
    std::ofstream(folder / "a.h5", std::ios::binary) << bytes;
    CHECK(!readMesh(folder / "a.xdmf", small).ok());
}

TEST_CASE("Components: one that does not exist is a fault that names what to install") {
    const Result<const void *> none = loadComponent("nothing", "libnothing-dev");
    REQUIRE(!none.ok());
    CHECK(none.faults().front().code == "missing-component");
    CHECK(none.faults().front().advice.find("libnothing-dev") != std::string::npos);
    CHECK(none.faults().front().advice.find("forefront-nothing") != std::string::npos);
}
