#include "core/files/common/names.hpp"
#include "core/files/files.hpp"
#include "core/files/unv/unv.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A triangle of 6 nodes, one edge and one point, whose names and tags differ in the file.
Mesh unvSample() {
    samples::BlockMaker maker({{0, 0}, {4, 0}, {0, 4}});
    maker.add(CellKind::Triangle6, {samples::node(0), samples::node(1), samples::node(2)}, 2);
    maker.tag(samples::node(0), samples::node(1), 2);
    maker.mesh.points = {{samples::node(2), 7}};
    maker.mesh.boundaryNames = {{2, "in let"}};
    return std::move(maker.mesh);
}

const std::string kUnvNodes = "    -1\n  2411\n"
                              "         1         1         1        11\n 0.D+00 0.D+00 0.D+00\n"
                              "         2         1         1        11\n 4.D+00 0.D+00 0.D+00\n"
                              "         3         1         1        11\n 4.D+00 4.D+00 0.D+00\n"
                              "        14         1         1        11\n 0.D+00 4.D+00 0.D+00\n    -1\n";
const std::string kUnvCells = "    -1\n  2412\n 1 91 3 1 7 3\n 1 2 3\n 2 94 4 1 7 4\n 1 2 3 14\n"
                              " 3 21 5 1 7 2\n 0 1 1\n 1 2\n    -1\n";

std::string unvRefusal(const std::string &text) {
    const Result<Mesh> mesh = readUnv(sourceOf(text));
    REQUIRE_FALSE(mesh.ok());
    CHECK(allLocated(mesh.faults()));
    return messages(mesh.faults());
}

} // namespace

TEST_CASE("UNV: the text of a small mesh; nodes of second order run around an element") {
    const std::string text = written(writeUnv, unvSample());
    CHECK(text.starts_with("# group 2 boundary 2 \"in%20let\"\n# group 1002 region 2 \"region_2\"\n"
                           "# group 7 point 7 \"boundary_7\"\n"
                           "    -1\n  2411\n         1         1         1        11\n"
                           "   0.0000000000000000D+00   0.0000000000000000D+00   0.0000000000000000D+00\n"
                           "         2         1         1        11\n"
                           "   4.0000000000000000D+00   0.0000000000000000D+00   0.0000000000000000D+00\n"));
    CHECK(
        text.ends_with("    -1\n  2412\n         1        92      1002      1002         7         6\n"
                       "         1         4         2         5         3         6\n"
                       "         2        24         2         2         7         3\n"
                       "         0         1         1\n         1         4         2\n    -1\n"
                       "    -1\n  2467\n"
                       "      1002         0         0         0         0         0         0         1\nregion_2\n"
                       "         8         1         0         0\n"
                       "         2         0         0         0         0         0         0         1\nin_let\n"
                       "         8         2         0         0\n"
                       "         7         0         0         0         0         0         0         1\nboundary_7\n"
                       "         7         3         0         0\n    -1\n"));
    CHECK(messages(noteUnvChanges(unvSample())).find("boundary 'in let' is in_let") != std::string::npos);
}

TEST_CASE("UNV: groups of other programs give tags and names; cells outside them, and groups of nodes") {
    ImportNotes notes;
    const std::string groups = "    -1\n  2467\n 9 0 0 0 0 0 0 2\nwest side\n 8 1 0 0 8 3 0 0\n"
                               " 10 0 0 0 0 0 0 2\nnodes\n 7 1 0 0 7 2 0 0\n 11 0 0 0 0 0 0 1\n\n 7 14 0 0\n"
                               " 12 0 0 0 0 0 0 2\nagain\n 8 1 0 0 8 99 0 0\n    -1\n";
    const std::string text =
        "    -1\n   164\n 1 x\n    -1\n" + kUnvCells + kUnvNodes + groups + "    -1\n  2414\n 3\n    -1\n";
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const Result<Mesh> mesh = readUnv(source);
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->blocks[0].regions == std::vector<std::int32_t>{9});
    CHECK(mesh->blocks[1].regions != std::vector<std::int32_t>{9});
    REQUIRE(mesh->edges.size() == 1);
    CHECK(mesh->edges[0].tag == 9);
    CHECK(mesh->regionNames.at(9) == "west side");
    CHECK(mesh->boundaryNames.at(9) == "west side");
    REQUIRE(mesh->points.size() == 1);
    CHECK(mesh->points[0].node == NodeId{3});
    CHECK(mesh->points[0].tag == 11);
    CHECK(notes.numbers().nodes.of(3) == 14);
    const std::string said = messages(notes.diagnostics());
    for (const char *words : {"dataset 2414 is ignored", "'nodes' of nodes is ignored",
                              "other than the nodes and elements", "keep the group before"}) {
        CHECK_MESSAGE(said.find(words) != std::string::npos, said);
    }
}

TEST_CASE("UNV: without groups, the properties are tags") {
    const Result<Mesh> mesh = readUnv(sourceOf(kUnvNodes + kUnvCells));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->blocks[0].regions == std::vector<std::int32_t>{3});
    CHECK(mesh->blocks[1].regions == std::vector<std::int32_t>{4});
    CHECK(mesh->edges.at(0).tag == 5);
}

TEST_CASE("UNV: what cannot be read is refused with its place") {
    CHECK(unvRefusal(kUnvNodes).find("no dataset 2412") != std::string::npos);
    CHECK(unvRefusal(kUnvCells).find("no dataset 2411") != std::string::npos);
    CHECK(unvRefusal(kUnvNodes + "    -1\n  2412\n 1 91 3 1 7 3\n").find("is not closed") != std::string::npos);
    CHECK(unvRefusal(kUnvNodes + "    -1\n  2412\n 1 111 3 1 7 4\n 1 2 3 14\n    -1\n").find("element 1 of type 111") !=
          std::string::npos);
    CHECK(unvRefusal(kUnvNodes + "    -1\n  2412\n 1 91 3 1 7 3\n 1 2 4\n    -1\n")
              .find("node 4, which does not exist") != std::string::npos);
    CHECK(unvRefusal(kUnvNodes + kUnvCells + kUnvCells).find("occurs twice") != std::string::npos);
    CHECK(unvRefusal(kUnvNodes + kUnvCells + "    -1\n  2467\n 1 0 0 0 0 0 0 9999\nx\n    -1\n").find("bad-count") !=
          std::string::npos);
}

TEST_CASE("UNV: the content shows the format") {
    CHECK(looksLikeUnv("    -1\n   151\n"));
    CHECK(looksLikeUnv("# group\n\n    -1\r\n  2411\r\n"));
    CHECK_FALSE(looksLikeUnv("-1 0\n2411\n"));
    CHECK_FALSE(looksLikeUnv("    -1\nx\n"));
    CHECK_FALSE(looksLikeUnv("3 2 0 1\n    -1\n 2411\n"));
}
