#include "core/domain/validate.hpp"
#include "core/io/common/line_outline.hpp"
#include "core/io/geojson/geojson.hpp"
#include "core/io/svg/svg.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::size_t boundaryCount(const Domain &domain) {
    return static_cast<std::size_t>(std::count_if(domain.segments.begin(), domain.segments.end(),
                                                  [](const auto &s) { return s.role == SegmentRole::Boundary; }));
}

Domain lines(std::initializer_list<std::pair<Vec2, Vec2>> segments) {
    Domain domain;
    for (const auto &[a, b] : segments) {
        DomainSegment segment;
        for (const auto &[place, end] : {std::pair{a, &segment.a}, std::pair{b, &segment.b}}) {
            const auto known = std::find(domain.nodes.begin(), domain.nodes.end(), place);
            *end = static_cast<std::uint32_t>(known - domain.nodes.begin());
            if (known == domain.nodes.end()) {
                domain.nodes.push_back(place);
            }
        }
        segment.role = SegmentRole::Constraint;
        domain.segments.push_back(segment);
    }
    return domain;
}

Result<Domain> geoJson(const std::string &geometry, ImportNotes &notes) {
    SourceText source = sourceOf(geometry, "lines.geojson");
    source.notes = &notes;
    return readGeoJson(source);
}

} // namespace

TEST_CASE("Lines as outline: lines that form a loop are the outline, and their free ends are not") {
    Domain domain = lines({{{0, 0}, {1, 0}}, {{1, 1}, {1, 0}}, {{1, 1}, {0, 1}}, {{0, 0}, {0, 1}}, {{1, 1}, {2, 2}}});
    CHECK(takeLinesAsOutline(domain) == 4);
    CHECK(domain.segments[4].role == SegmentRole::Constraint);
    CHECK(takeLinesAsOutline(domain) == 0); // it has a boundary now
}

TEST_CASE("Lines as outline: the outermost of nested lines are the outline") {
    // A square with a line across, and a square beside it that hangs on a bridge.
    Domain domain = lines({{{0, 0}, {1, 0}},
                           {{1, 0}, {1, 1}},
                           {{1, 1}, {0, 1}},
                           {{0, 1}, {0, 0}},
                           {{0, 0}, {1, 1}},
                           {{1, 1}, {3, 1}},
                           {{3, 1}, {4, 1}},
                           {{4, 1}, {3, 2}},
                           {{3, 2}, {3, 1}}});
    CHECK(takeLinesAsOutline(domain) == 7);
    CHECK(domain.segments[4].role == SegmentRole::Constraint);
    CHECK(domain.segments[5].role == SegmentRole::Constraint);
}

TEST_CASE("Lines as outline: open lines bound nothing") {
    Domain domain = lines({{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}});
    CHECK(takeLinesAsOutline(domain) == 0);
    CHECK(boundaryCount(domain) == 0);
    const Diagnostics faults = validate(domain);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].advice == "draw a closed outline, or turn a closed line into a boundary");
}

TEST_CASE("GeoJSON: a closed LineString, or separate ones that close, are the outline of a file without polygons") {
    for (const char *geometry :
         {R"({"type": "LineString", "coordinates": [[0,0],[4,0],[4,3],[0,3],[0,0]]})",
          R"({"type": "MultiLineString", "coordinates": [[[0,0],[4,0]],[[4,3],[4,0]],[[4,3],[0,3]],[[0,0],[0,3]]]})"}) {
        CAPTURE(geometry);
        ImportNotes notes;
        const auto domain = geoJson(geometry, notes);
        REQUIRE(domain.ok());
        CHECK(boundaryCount(*domain) == 4);
        CHECK(validate(*domain).empty());
        REQUIRE(notes.entries().size() == 1);
        CHECK(notes.entries()[0].code == "lines-as-outline");
    }
}

TEST_CASE("GeoJSON: a closed line inside a polygon stays a constraint") {
    ImportNotes notes;
    const auto domain = geoJson(R"({"type": "GeometryCollection", "geometries": [
        {"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,9],[0,0]]]},
        {"type": "LineString", "coordinates": [[2,2],[4,2],[4,4],[2,2]]}]})",
                                notes);
    REQUIRE(domain.ok());
    CHECK(boundaryCount(*domain) == 4);
    CHECK(notes.empty());
}

TEST_CASE("SVG: a set of lines that meet within rounding is an outline") {
    const auto domain = readSvg(sourceOf("<svg viewBox=\"0 0 10 10\"><line x1=\"0\" y1=\"0\" x2=\"4\" y2=\"0\"/>"
                                         "<line x1=\"4.0000000001\" y1=\"0\" x2=\"4\" y2=\"3\"/>"
                                         "<polyline points=\"4,3 0,3\"/><path d=\"M0 3V0\"/></svg>"));
    REQUIRE(domain.ok());
    CHECK(boundaryCount(*domain) == 4);
    CHECK(domain->nodes.size() == 4);
    CHECK(validate(*domain).empty());
}
