#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/files.hpp"
#include "core/files/triangle/triangle.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace forefront;
using namespace forefront::testing;

namespace {

const std::string kSquareWithHole = "# a square with a hole, numbered from 0\n"
                                    "9 2 1 1\n"
                                    "0 0 0 7.5 1\n1 4 0 7.5 1\n2 4 4 7.5 1\n3 0 4 7.5 1\n"
                                    "4 1 1 0 0\n5 2 1 0 0\n6 2 2 0 0\n7 1 2 0 0 # inner\n"
                                    "8 3 3 0 6\n"
                                    "8 1\n"
                                    "0 0 1 3\n1 1 2 0\n2 2 3 -2\n3 3 0 3\n4 4 5 9\n5 5 6 9\n6 6 7 9\n7 7 4 9\n"
                                    "1\n0 1.5 1.5\n"
                                    "2\n0 0.5 0.5 4 0.1\n1 3.5 3.5 2.5 -1\n";

Diagnostics faultsOf(const std::string &text) {
    const auto domain = readPoly(sourceOf(text, "bad.poly"));
    return domain ? Diagnostics{} : domain.faults();
}

} // namespace

TEST_CASE("Triangle .poly: nodes, markers, holes, regions and isolated nodes are read") {
    const auto domain = readPoly(sourceOf(kSquareWithHole));
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    CHECK(domain->domain.insideRule == InsideRule::HoleMarkers);
    CHECK(domain->domain.nodes.size() == 9);
    REQUIRE(domain->domain.segments.size() == 8);
    CHECK(domain->domain.segments[0].tag == 3);
    CHECK(domain->domain.segments[1].tag == 10); // free tags: 9 is the greatest in use
    CHECK(domain->domain.segments[2].tag == 11);
    CHECK(domain->domain.boundaryNames == std::map<std::int32_t, std::string>{{10, "boundary_0"}, {11, "boundary_-2"}});
    CHECK(domain->domain.segments[4].tag == 9);
    CHECK(domain->domain.segments[7].role == SegmentRole::Boundary);
    CHECK(domain->domain.holeMarkers == std::vector<Vec2>{{1.5, 1.5}});
    REQUIRE(domain->domain.regionMarkers.size() == 2);
    CHECK(domain->domain.regionMarkers[0].tag == 4);
    CHECK(domain->domain.regionMarkers[1].tag == 5);
    CHECK(domain->domain.regionNames.at(5) == "region_2.5");
    REQUIRE(domain->domain.points.size() == 1);
    CHECK(domain->domain.points[0].node == 8);
    CHECK(domain->domain.points[0].tag == 6);
}

TEST_CASE("Triangle .poly: nodes may be in a .node file beside it, numbered from 1") {
    const TemporaryFolder folder;
    REQUIRE(writeFileAtomically(folder / "a.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n").empty());
    REQUIRE(writeFileAtomically(folder / "a.poly", "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n").empty());
    const auto domain = allFormats().readDomain(folder / "a.poly");
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    CHECK(domain->domain.nodes.size() == 3);
    CHECK(domain->domain.segments[2].b == 0);
    REQUIRE(std::filesystem::remove(folder / "a.node"));
    const auto without = allFormats().readDomain(folder / "a.poly");
    REQUIRE(!without.ok());
    CHECK(without.faults()[0].file == (folder / "a.node").string());
    REQUIRE(writeFileAtomically(folder / "a.node", "3 2 0 0\n1 0 0\n2 1 x\n3 0 1\n").empty());
    const auto damaged = allFormats().readDomain(folder / "a.poly");
    REQUIRE(!damaged.ok());
    CHECK(damaged.faults()[0].file == (folder / "a.node").string());
    CHECK(damaged.faults()[0].line == 3);
    CHECK(damaged.faults()[0].column == 5);
}

TEST_CASE("Triangle .poly: chains with free ends become constraints, but a lone open ring stays a boundary") {
    const auto domain = readPoly(sourceOf("5 2 0 0\n1 0 0\n2 4 0\n3 0 4\n4 1 1\n5 2 1\n"
                                          "5 0\n1 1 2\n2 2 3\n3 3 1\n4 5 4\n5 1 4\n0\n"));
    REQUIRE(domain.ok());
    CHECK(domain->domain.segments[2].role == SegmentRole::Boundary);
    CHECK(domain->domain.segments[3].role == SegmentRole::Constraint);
    CHECK(domain->domain.segments[4].role == SegmentRole::Constraint);
    const auto open = readPoly(sourceOf("3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n2 0\n1 1 2\n2 2 3\n0\n"));
    REQUIRE(open.ok());
    CHECK(open->domain.segments[0].role == SegmentRole::Boundary);
}

TEST_CASE("Triangle .poly: every fault has a location") {
    struct Case {
        const char *text;
        const char *code;
        int line, column;
    };
    for (const Case &c : {Case{"", "bad-syntax", 1, 1}, Case{"3 3 0 0\n", "bad-count", 1, 1},
                          Case{"2 3 0 0\n1 0 0 0\n2 1 1 1\n", "out-of-range", 1, 3},
                          Case{"3 2 0 0\n1 0 0\n2 1 nan\n3 0 1\n", "non-finite", 3, 5},
                          Case{"3 2 0 0\n1 0 0\n2 1\n3 0 1\n0\n0\n", "bad-number", 3, 4},
                          Case{"2 2 0 0\n1 0 0\n1 1 1\n1 0\n1 1 1\n0\n", "duplicate-node", 3, 6},
                          Case{"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 3\n0\n", "bad-index", 5, 6},
                          Case{"2 2 0 0\n1 0 0\n2 1 1\n99999999999 0\n1 1 2\n0\n", "bad-count", 4, 1},
                          Case{"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n", "bad-syntax", 6, 1},
                          Case{"2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n1\n1 1e999 0\n", "non-finite", 7, 3}}) {
        CAPTURE(c.text);
        const Diagnostics faults = faultsOf(c.text);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].code == c.code);
        CHECK(faults[0].line == c.line);
        CHECK(faults[0].column == c.column);
    }
}

TEST_CASE("Triangle .poly: the collection of real domains is read") {
    const char *data = std::getenv("FOREFRONT_DATA");
    if (data == nullptr) {
        MESSAGE("skipped: FOREFRONT_DATA is not set");
        return;
    }
    std::size_t files = 0;
    for (const auto &entry : std::filesystem::directory_iterator(data)) {
        if (entry.path().extension() == ".poly") {
            CAPTURE(entry.path());
            const auto domain = allFormats().readDomain(entry.path());
            REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
            CHECK(domain->domain.segments.size() == domain->domain.nodes.size());
            CHECK(domain->domain.points.empty());
            ++files;
        }
    }
    CHECK(files > 0);
}

TEST_CASE("Triangle .poly: the maximum area of a region is read, and -1 means no limit") {
    const auto domain = readPoly(sourceOf("4 2\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"
                                          "3\n1 1 1 7 0.01\n2 2 2 8 -1\n3 3 3 9\n"));
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    REQUIRE(domain->domain.regionMarkers.size() == 3);
    const std::vector<RegionSize> limits{{.at = domain->domain.regionMarkers[0].at, .maxArea = 0.01}};
    CHECK(domain->spacing.placed.regions == limits); // the others have no limit
}
