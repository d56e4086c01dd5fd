#include "core/drawing_files/geojson/geojson.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/part_names.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A rectangle 4 x 3 with a square hole, both with the tag 1; the hole is given counter-clockwise.
Domain holedPlate() {
    Domain domain;
    addLoop(domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    addLoop(domain, {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
    return domain;
}

/// Returns the middles of the segments with a name.
std::vector<Vec2> middlesOf(const Domain &domain, const std::string &name) {
    std::vector<Vec2> places;
    for (const DomainSegment &segment : domain.segments) {
        if (boundaryName(domain.boundaryNames, segment.tag) == name) {
            places.push_back(midpoint(domain.nodes[segment.a], domain.nodes[segment.b]));
        }
    }
    return places;
}

std::vector<Vec2> named(Domain domain, Vec2 from, Vec2 to) {
    const PartName part{"sea", from, to};
    const Diagnostics remarks = nameParts({&part, 1}, domain);
    CHECK_FALSE(hasErrors(remarks));
    CHECK(remarks.size() == 1);
    return middlesOf(domain, "sea");
}

std::string refusedName(Domain domain, std::vector<PartName> parts) {
    const Diagnostics remarks = nameParts(parts, domain);
    CHECK(hasErrors(remarks));
    return messages(remarks);
}

} // namespace

TEST_CASE("Part names: a stretch runs with the domain on the left, around holes clockwise") {
    using Places = std::vector<Vec2>;
    CHECK(named(holedPlate(), {0.1, 0.1}, {4.1, -0.1}) == Places{{2, 0}});
    CHECK(named(holedPlate(), {4, 0}, {0, 0}) == Places{{4, 1.5}, {2, 3}, {0, 1.5}});
    CHECK(named(holedPlate(), {1, 1}, {2, 1}) == Places{{2, 1.5}, {1.5, 2}, {1, 1.5}});
    CHECK(named(holedPlate(), {2, 1}, {1, 1}) == Places{{1.5, 1}});
    CHECK(named(holedPlate(), {1, 1}, {1, 1}).size() == 4);
    Domain turned = holedPlate();
    for (DomainSegment &segment : turned.segments) {
        std::swap(segment.a, segment.b);
    }
    CHECK(named(turned, {4, 0}, {0, 0}) == Places{{4, 1.5}, {2, 3}, {0, 1.5}});
}

TEST_CASE("Part names: where loops touch, a stretch stays at its face") {
    Domain domain; // two triangles that meet at (2, 0)
    domain.nodes = {{0, 0}, {2, 0}, {0, 2}, {4, 0}, {4, 2}};
    domain.segments = {{0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 4}, {4, 1}};
    CHECK(named(domain, {0, 0}, {0, 2}) == std::vector<Vec2>{{1, 0}, {1, 1}});
    CHECK(named(domain, {4, 0}, {2, 0}) == std::vector<Vec2>{{4, 1}, {3, 1}});
}

TEST_CASE("Part names: a known name keeps its tag, later stretches win, and the note tells what was named") {
    Domain domain = holedPlate();
    domain.segments[2].tag = 7;
    domain.boundaryNames[7] = "sea";
    const std::vector<PartName> parts = {{"sea", {0, 0}, {4, 0}}, {"mouth", {0, 0}, {4, 0}}, {"sea", {4, 0}, {4, 3}}};
    const Diagnostics remarks = nameParts(parts, domain);
    REQUIRE_FALSE(hasErrors(remarks));
    CHECK(domain.segments[1].tag == 7);
    CHECK(middlesOf(domain, "mouth") == std::vector<Vec2>{{2, 0}});
    CHECK(messages(remarks).find("'mouth' is named: 1 segment, 4 long, from (0, 0) to (4, 0)") != std::string::npos);
    CHECK(messages(remarks).find("to (4, 0), and joins the other segment that has this name; 'mouth'") !=
          std::string::npos);
    CHECK(nameParts({}, domain).empty());
}

TEST_CASE("Part names: what cannot be named is refused with the reason") {
    CHECK(refusedName(holedPlate(), {{"sea", {25, 60}, {4, 0}}}).find("(25, 60)") != std::string::npos);
    CHECK(refusedName(holedPlate(), {{"sea", {0, 0}, {0.2, 0}}}).find("nearest to the node (0, 0)") !=
          std::string::npos);
    CHECK(refusedName(holedPlate(), {{"sea", {0, 0}, {1, 1}}}).find("different loops") != std::string::npos);
    Domain crossed = holedPlate();
    crossed.nodes[2] = {-1, 1};
    CHECK(refusedName(crossed, {{"sea", {0, 0}, {4, 0}}}).find("cross") != std::string::npos);
    CHECK_FALSE(refusedName(Domain(), {{"sea", {0, 0}, {0, 0}}}).empty());
}

TEST_CASE("Part names: places of a map are in its coordinates, also where it is projected") {
    const std::string text =
        R"({"type": "Polygon", "coordinates": [[[25, 60], [26, 60], [26, 61], [25, 61], [25, 60]]]})";
    for (const DegreeRule rule : {DegreeRule::Keep, DegreeRule::Local}) {
        ImportOptions options;
        options.degrees = rule;
        options.partNames = {{"sea", {26.01, 59.99}, {25.99, 61.02}}};
        const Result<Domain> domain = readGeoJson({text, "map.geojson", {}, options});
        REQUIRE(domain);
        const std::vector<Vec2> sea = middlesOf(*domain, "sea");
        REQUIRE(sea.size() == 1);
        CHECK(sea[0].x == doctest::Approx(rule == DegreeRule::Keep ? 26.0 : 27380.0).epsilon(0.01));
        options.partNames[0].from = {384000, 6670000};
        CHECK_FALSE(readGeoJson({text, "map.geojson", {}, options}));
    }
}
