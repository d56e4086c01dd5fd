#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/edge_chains.hpp"
#include "core/files/sms/two_dm.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::vector<NodeId> nodeList(std::initializer_list<std::uint32_t> numbers) {
    std::vector<NodeId> nodes;
    for (const std::uint32_t n : numbers) {
        nodes.push_back(NodeId{n});
    }
    return nodes;
}

std::string twoDmRefusal(const std::string &text) {
    const Result<Mesh> mesh = readTwoDm(sourceOf(text));
    REQUIRE_FALSE(mesh.ok());
    CHECK_MESSAGE(allLocated(mesh.faults()), messages(mesh.faults()));
    return messages(mesh.faults());
}

const std::string kTwoDmNodes = "MESH2D\nND 1 0 0 -1.5\nND 2 4 0 -2\nND 3 4 4 -3\nND 4 0 4 0\n";

} // namespace

TEST_CASE("2DM: the text of a small mesh; node strings are chains with the numbers of boundary parts") {
    samples::BlockMaker maker({{0, 0}, {4, 0}, {0, 4}});
    maker.add(CellKind::Triangle6, {samples::node(0), samples::node(1), samples::node(2)}, 2);
    maker.tag(samples::node(1), samples::node(2), 5);
    maker.tag(samples::node(0), samples::node(1), 5);
    maker.mesh.points = {{samples::node(2), 7}};
    maker.mesh.boundaryNames = {{5, "in let"}};
    const std::string text = written(writeTwoDm, maker.mesh);
    CHECK(text == "MESH2D\nNUM_MATERIALS_PER_ELEM 1\n# boundary 5 \"in let\"\n# boundary 7 \"boundary_7\"\n"
                  "# region 2 \"region_2\"\n# point 3 7\nE6T 1 1 4 2 5 3 6 2\nND 1 0 0 0\nND 2 4 0 0\nND 3 0 4 0\n"
                  "ND 4 2 0 0\nND 5 2 2 0\nND 6 0 2 0\nNS 1 4 2 5 -3 5\n");
    CHECK(messages(noteTwoDmChanges(maker.mesh)).find("elevation 0") != std::string::npos);
}

TEST_CASE("2DM: elevations are values of nodes; node strings by number, by name or by neither") {
    const std::string text = kTwoDmNodes +
                             "E3T 1 1 2 3 8\nE4Q 2 1 2 3 4\nNS 1 2\nNS -3\nNS 3 -4 17\nNS 4 -1 \"far end\"\n"
                             "NS -2\nBC 1\n";
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const Result<MeshFields> file = readTwoDmFields(source);
    REQUIRE_MESSAGE(file.ok(), messages(file.faults()));
    CHECK(file->fields.at("elevation") == std::vector<double>{-1.5, -2, -3, 0});
    const Mesh &mesh = file->mesh;
    CHECK(mesh.blocks[0].regions == std::vector<std::int32_t>{8});
    CHECK(mesh.blocks[1].regions == std::vector<std::int32_t>{1});
    REQUIRE(mesh.edges.size() == 4);
    CHECK(mesh.edges[0].tag == mesh.edges[1].tag);
    CHECK(mesh.edges[1].b == NodeId{2});
    CHECK(mesh.edges[2].tag == 17);
    CHECK(mesh.boundaryNames.at(mesh.edges[3].tag) == "far end");
    const std::string said = messages(notes.diagnostics());
    CHECK(said.find("card 'BC' is ignored") != std::string::npos);
    CHECK(said.find("single node") != std::string::npos);
}

TEST_CASE("2DM: what cannot be read is refused with its place") {
    const auto refuses = [](const std::string &text, const char *words) {
        const std::string said = twoDmRefusal(text);
        CHECK_MESSAGE(said.find(words) != std::string::npos, said);
    };
    refuses("MESH2D\n", "no nodes (ND)");
    refuses(kTwoDmNodes + "E3T 1 1 2 9 1\n", "node 9, which does not exist");
    refuses(kTwoDmNodes + "E3T 1 1 2 2 1\n", "refers to a node twice");
    refuses(kTwoDmNodes + "E3T 1 1 2\n", "the line ends here");
    refuses(kTwoDmNodes + "E2L 1 1 2 1\n", "line elements E2L");
    refuses(kTwoDmNodes + "NS 1 9 -2\n", "node 9, which does not exist");
    refuses(kTwoDmNodes + "NS 1 2\n", "is not negative");
    refuses(kTwoDmNodes + "NS 1 1 -2\n", "refers to a node twice");
    refuses(kTwoDmNodes + "ND 2 0 0 0\n", "repeats the number");
    refuses(kTwoDmNodes + "ND 5 x 0 0\n", "found 'x'");
}

TEST_CASE("Chains: edges are joined until a branch or an end, each once, in the direction of the first") {
    TriMesh mesh = samples::square(2, 2); // nodes in rows of three
    const auto edge = [&](std::uint32_t a, std::uint32_t b) { mesh.edges.push_back({NodeId{a}, NodeId{b}, 1}); };
    mesh.edges.clear();
    edge(4, 5);
    edge(1, 4);
    edge(4, 7);
    edge(0, 1);
    edge(7, 8);
    edge(8, 5);
    edge(3, 6);
    const std::vector<std::uint32_t> all = {0, 1, 2, 3, 4, 5, 6};
    const std::vector<EdgeChain> chains = joinEdges(mesh, all);
    REQUIRE(chains.size() == 3);
    CHECK(chains[0].nodes == nodeList({4, 5, 8, 7, 4}));
    CHECK(chains[0].closed());
    CHECK(chains[1].nodes == nodeList({0, 1, 4}));
    CHECK_FALSE(chains[1].closed());
    CHECK(chains[2].nodes == nodeList({3, 6}));
    const std::vector<std::uint32_t> ring = {2, 4, 5, 0};
    CHECK(joinEdges(mesh, ring).at(0).nodes == nodeList({4, 7, 8, 5, 4}));
}
