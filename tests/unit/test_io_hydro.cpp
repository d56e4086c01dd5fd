#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/shoreline.hpp"
#include "core/files/files.hpp"
#include "core/files/hydro/hydro.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::string gridText(void (*write)(const MeshView &, const ExportOptions &, TextWriter &), const MeshView &mesh,
                     std::vector<std::int32_t> open) {
    StringSink sink;
    TextWriter out(sink);
    write(mesh, {std::move(open)}, out);
    out.flush();
    return std::move(sink.text);
}

std::vector<std::uint32_t> numbersOf(const ShoreStretch &stretch) {
    std::vector<std::uint32_t> numbers;
    for (const NodeId node : stretch.nodes) {
        numbers.push_back(static_cast<std::uint32_t>(node));
    }
    return numbers;
}

using Numbers = std::vector<std::uint32_t>;
using Kind = ShoreStretch::Kind;

/// A square of 4 x 4 cells in rows of five nodes, with the sides tagged 1 to 4, without some of its cells.
TriMesh withHoles(std::initializer_list<std::size_t> cells) {
    TriMesh mesh = samples::square(4, 4);
    std::vector<Element> left;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (std::find(cells.begin(), cells.end(), e / 2) == cells.end()) {
            left.push_back(mesh.elements[e]);
        }
    }
    mesh.elements = left;
    return mesh;
}

} // namespace

TEST_CASE("Grids of water: the text of a small mesh for ADCIRC and SCHISM") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    mesh.elements = {{NodeId{0}, NodeId{1}, NodeId{2}}, {NodeId{0}, NodeId{2}, NodeId{3}}};
    mesh.edges = {{NodeId{1}, NodeId{0}, 1}, {NodeId{1}, NodeId{2}, 2}, {NodeId{3}, NodeId{0}, 4}};
    const std::string head = "Plane triangle mesh\n2 4\n1 0 0 0\n2 2 0 0\n3 2 1 0\n4 0 1 0\n1 3 1 2 3\n2 3 1 3 4\n";
    CHECK(gridText(writeAdcirc, mesh, {4, 2}) == head + "2\n4\n2\n4\n1\n2\n2\n3\n2\n4\n2 20\n1\n2\n2 20\n3\n4\n");
    CHECK(gridText(writeSchism, mesh, {}) == head + "0\n0\n1\n5\n5 0\n1\n2\n3\n4\n1\n");
    CHECK(messages(noteDepths(mesh)).find("depth 0") != std::string::npos);
    const TemporaryFolder folder;
    REQUIRE(writeMesh(folder / "fort.14", mesh, {}, {}, {{4, 2}}).empty());
    CHECK(*readFileBytes(folder / "fort.14", 1000) == gridText(writeAdcirc, mesh, {4, 2}));
    CHECK(hasOpenBoundaries("x.gr3"));
    CHECK_FALSE(hasOpenBoundaries("x.2dm"));
    CHECK(hasCode(writeMesh(folder / "a.14", samples::sampleMesh(CellKind::Quadrilateral4)), "unsupported-elements"));
    CHECK(writeMesh(folder / "a.gr3", samples::sampleMesh(CellKind::Quadrilateral4)).empty());
}

TEST_CASE("Shoreline: stretches are open in the order of the tags, then land, then islands, with water on the left") {
    const TriMesh mesh = withHoles({5}); // one cell within
    const std::vector<std::int32_t> open = {3, 1};
    const auto shore = shoreline(mesh, open);
    REQUIRE(shore.size() == 5);
    CHECK(shore[0].kind == Kind::Open);
    CHECK(numbersOf(shore[0]) == Numbers{24, 23, 22, 21, 20});
    CHECK(numbersOf(shore[1]) == Numbers{0, 1, 2, 3, 4});
    CHECK(shore[2].kind == Kind::Land);
    CHECK(numbersOf(shore[2]) == Numbers{4, 9, 14, 19, 24});
    CHECK(numbersOf(shore[3]) == Numbers{20, 15, 10, 5, 0});
    CHECK(shore[4].kind == Kind::Island);
    CHECK(numbersOf(shore[4]) == Numbers{6, 11, 12, 7});
}

TEST_CASE("Shoreline: loops that meet in a node stay apart; an open island and an open mesh are closed stretches") {
    TriMesh mesh = withHoles({5, 10}); // cells that meet at node 12
    auto shore = shoreline(mesh, {});
    REQUIRE(shore.size() == 2); // water does not lie between the islands: one walk around both
    CHECK(shore[0].nodes.front() == shore[0].nodes.back());
    CHECK(shore[1].nodes.size() == 8);
    mesh = withHoles({0, 5}); // an island that touches the outside
    shore = shoreline(mesh, {});
    CHECK(shore.size() == 1);
    mesh = withHoles({5});
    for (const std::uint32_t n : {6U, 11U, 12U, 7U}) {
        mesh.edges.push_back({NodeId{n}, NodeId{n == 6 ? 11U : n == 11 ? 12U : n == 12 ? 7U : 6U}, 8});
    }
    const std::vector<std::int32_t> island = {8};
    shore = shoreline(mesh, island);
    REQUIRE(shore.size() == 2);
    CHECK(shore[0].kind == Kind::Open);
    CHECK(numbersOf(shore[0]) == Numbers{6, 11, 12, 7, 6});
    CHECK(shore[1].nodes.size() == 17);
}

TEST_CASE("Shoreline: each side without a neighbour is in one stretch, with its element on the left") {
    samples::Random random(3);
    for (int round = 0; round < 40; ++round) {
        TriMesh mesh = samples::square(6, 5);
        std::erase_if(mesh.elements, [&](const Element &) { return random() < 0.3; });
        std::set<std::pair<NodeId, NodeId>> sides;
        for (const Element &element : mesh.elements) {
            for (std::size_t k = 0; k < 3; ++k) {
                sides.emplace(element[k], element[(k + 1) % 3]);
            }
        }
        std::erase_if(sides, [all = sides](const auto &side) { return all.contains({side.second, side.first}); });
        std::size_t found = 0;
        const std::vector<std::int32_t> open = {2};
        for (const ShoreStretch &stretch : shoreline(mesh, open)) {
            auto nodes = stretch.nodes;
            if (stretch.kind == Kind::Island) {
                nodes.push_back(nodes.front());
            }
            for (std::size_t k = 0; k + 1 < nodes.size(); ++k, ++found) {
                CHECK(sides.contains({nodes[k], nodes[k + 1]}));
            }
        }
        CHECK(found == sides.size());
    }
}

namespace {

/// Two triangles and a quadrilateral with an island side, as other programs write them: comments after the numbers.
const std::string kGridOfWater = R"( Bay of nothing
 3  7 ! elements, nodes
 10 0.0 0.0  1.50
 20 2.0 0.0  2.0 deep
 30 2.0 1.0 -0.5
 40 0.0 1.0  0
 50 3.0 0.0  1
 60 3.0 1.0  1
 70 2.5 2.0  1
 1 3 10 20 30
 2 3 10 30 40
 3 4 20 50 60 30
 1 = Number of open boundaries
 2 = Total number of open boundary nodes
 2 = Number of nodes for open boundary 1
 40
 10
 3 = Number of land boundaries
 8 = Total number of land boundary nodes
 3 20 = Number of nodes for land boundary 1
 10
 20
 50
 3 21
 20
 50
 60
 2 24
 60 30 1.5 1 1
 50 20 1.5 1 1
)";

std::string refusedGrid(const std::string &text) {
    const Result<Mesh> read = readHydro(sourceOf(text));
    CHECK_FALSE(read.ok());
    return read ? std::string() : messages(read.faults());
}

std::string replacedOnce(std::string text, const std::string &from, const std::string &to) {
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("Grids of water: what they hold is read, with comments, islands and barriers") {
    const Result<MeshFields> read = readHydroFields(sourceOf(kGridOfWater));
    REQUIRE(read);
    const MeshView mesh(read->mesh);
    CHECK(mesh.nodes.size() == 7);
    CHECK(mesh.elementCount() == 3);
    CHECK(read->fields.at("elevation")[0] == -1.5);
    CHECK(read->fields.at("elevation")[2] == 0.5);
    std::map<std::string, std::size_t> edges;
    for (const TaggedEdge &edge : mesh.edges) {
        ++edges[boundaryName(mesh.boundaryNames, edge.tag)];
    }
    CHECK(edges == std::map<std::string, std::size_t>{{"open_1", 1}, {"land", 2}, {"island", 3}, {"type_24", 2}});
    const std::string alone = kGridOfWater.substr(0, kGridOfWater.find(" 1 = Number"));
    REQUIRE(readHydro(sourceOf(alone)));
    CHECK(readHydro(sourceOf(alone))->edges.empty());
}

TEST_CASE("Grids of water: what is written is read back, its parts by kind") {
    const TriMesh mesh = withHoles({5});
    for (const auto write : {writeAdcirc, writeSchism}) {
        const std::string text = gridText(write, mesh, {3});
        const Result<Mesh> back = readHydro(sourceOf(text));
        REQUIRE(back);
        CHECK(gridText(write, *back, {1}) == text); // open_1
        CHECK(std::equal(back->nodes.begin(), back->nodes.end(), mesh.nodes.begin(), mesh.nodes.end()));
    }
}

TEST_CASE("Grids of water: faults name their line") {
    CHECK(refusedGrid("").find("found the end") != std::string::npos);
    CHECK(refusedGrid("title\n1000000 3\n").find(":2:") != std::string::npos);
    CHECK(refusedGrid(replacedOnce(kGridOfWater, "2 3 10 30 40", "2 5 10 30 40")).find(":11:") != std::string::npos);
    CHECK(refusedGrid(replacedOnce(kGridOfWater, "2 3 10 30 40", "2 3 10 30 41")).find("node 41") != std::string::npos);
    CHECK(refusedGrid(replacedOnce(kGridOfWater, " 20 2.0", " 10 2.0")).find("repeats") != std::string::npos);
    CHECK(refusedGrid(replacedOnce(kGridOfWater, "60 30 1.5", "60")).find("barrier") != std::string::npos);
    for (std::size_t length = 0; length + 1 < kGridOfWater.size(); length += 7) {
        const Result<Mesh> read = readHydro(sourceOf(kGridOfWater.substr(0, length)));
        CHECK((read.ok() || allLocated(read.faults())));
    }
}
