#include "core/drawing_files/common/line_outline.hpp"
#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>

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

bool hasNote(const ImportNotes &notes, std::string_view code) {
    return std::any_of(notes.entries().begin(), notes.entries().end(),
                       [&](const ImportNote &note) { return note.code == code; });
}

/// Returns the warning of an outline that does not close; empty if there is none.
std::string warningIn(const ImportNotes &notes) {
    for (const ImportNote &note : notes.entries()) {
        if (note.code == "open-outline") {
            CHECK(note.severity == Severity::Warning);
            return note.message;
        }
    }
    return {};
}

} // namespace

TEST_CASE("Lines as outline: lines that form a loop are the outline, and their free ends are not") {
    Domain domain = lines({{{0, 0}, {1, 0}}, {{1, 1}, {1, 0}}, {{1, 1}, {0, 1}}, {{0, 0}, {0, 1}}, {{1, 1}, {2, 2}}});
    CHECK(takeLinesAsOutline(domain).segments == 4);
    CHECK(domain.segments[4].role == SegmentRole::Constraint);
    CHECK(takeLinesAsOutline(domain).segments == 0); // it has a boundary now
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
    CHECK(takeLinesAsOutline(domain).segments == 7);
    CHECK(domain.segments[4].role == SegmentRole::Constraint);
    CHECK(domain.segments[5].role == SegmentRole::Constraint);
}

TEST_CASE("Lines as outline: open lines bound nothing") {
    Domain domain = lines({{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}});
    CHECK(takeLinesAsOutline(domain).segments == 0);
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

TEST_CASE("GeoJSON: borders that polygons share are not reported as lines near the boundary") {
    ImportNotes notes;
    const auto domain = geoJson(R"({"type": "GeometryCollection", "geometries": [
        {"type": "Polygon", "coordinates": [[[0,0],[10,0],[10,0.05],[0,0.05],[0,0]]]},
        {"type": "Polygon", "coordinates": [[[0,0.05],[10,0.05],[10,5],[0,5],[0,0.05]]]}]})",
                                notes);
    REQUIRE(domain.ok());
    CHECK(domain->segments.size() > boundaryCount(*domain));
    CHECK_FALSE(hasNote(notes, "near-lines"));
}

TEST_CASE("SVG: lines that decide most of the mesh are reported") {
    for (const auto &[count, teeth] : {std::pair{400, 0}, {600, 0}, {600, 1000}}) {
        CAPTURE(count);
        std::string path = "<svg viewBox='0 0 100 100'><path d='M0 0H100V100H0V99";
        for (int k = 1; k <= teeth; ++k) { // the outline is a comb
            path += 'L' + std::to_string(k % 2) + ' ' + std::to_string(99 - 0.09 * k);
        }
        path += "z'/><path fill='none' stroke='black' d='M10 50";
        for (int k = 1; k <= count; ++k) {
            path += 'L' + std::to_string(10.0 + 0.1 * k) + ' ' + std::to_string(50 + k % 2);
        }
        path += "'/></svg>";
        SourceText source = sourceOf(path, "lines.svg");
        ImportNotes notes;
        source.notes = &notes;
        REQUIRE(readSvg(source).ok());
        CHECK(hasNote(notes, "many-lines") == (count == 600 && teeth == 0));
    }
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

namespace {

Result<Domain> unfilled(const std::string &content, ImportNotes &notes) {
    const std::string text = "<svg viewBox='0 0 100 50' fill='none' stroke='black'>" + content + "</svg>";
    SourceText source = sourceOf(text, "lines.svg");
    source.notes = &notes;
    return readSvg(source);
}

double areaOf(const Domain &domain) {
    return areas(domain).at(1);
}

} // namespace

TEST_CASE("SVG: loops of lines bound a drawing without fills beside its closed outlines") {
    const std::string plate = "<path d='M10 10H90'/><path d='M90 10V40'/><path d='M90 40H10'/><path d='M10 40V10'/>";
    const std::string closed = "<path d='M10 10H90V40H10z'/>", square = "<path d='M40 20h10v10h-10z'/>";
    const std::string loose = "<path d='M40 20h10v10'/><path d='M40 20v10h10'/>";
    for (const std::string &content : {plate + square, closed + loose, plate + loose}) {
        CAPTURE(content);
        ImportNotes notes;
        const auto domain = unfilled(content, notes);
        REQUIRE(domain.ok());
        CHECK(areaOf(*domain) == doctest::Approx(2300));
        CHECK(hasNote(notes, "lines-as-outline"));
    }
    ImportNotes notes;
    const auto beside = unfilled(closed + "<path d='M92 10h6'/><path d='M98 10v10'/><path d='M98 20h-6v-10'/>", notes);
    REQUIRE(beside.ok());
    CHECK(areaOf(*beside) == doctest::Approx(2460));
}

TEST_CASE("SVG: lines across a closed outline divide it, and open ones outside are dropped") {
    // Centre lines that cross each other, a line from side to side, and a dimension line.
    ImportNotes notes;
    const auto domain = unfilled("<path d='M10 10H90V40H10z'/><path d='M20 20H60M20 30H60M30 15V35M50 15V35'/>"
                                 "<path d='M80 10V40'/><path d='M10 5H90M10 3V10M90 3V10'/>",
                                 notes);
    REQUIRE(domain.ok());
    CHECK(areaOf(*domain) == doctest::Approx(2400));
    CHECK(boundaryCount(*domain) == 6);
    CHECK_FALSE(hasNote(notes, "lines-as-outline"));
}

TEST_CASE("SVG: centre lines, axes and dimension lines are no outlines, and a note says so") {
    const std::string plate = "<path d='M20 10H80V40H20z'/>";
    const std::string holes = "<circle cx='30' cy='20' r='3'/><circle cx='70' cy='20' r='3'/>"
                              "<circle cx='30' cy='30' r='3'/><circle cx='70' cy='30' r='3'/>";
    const std::string centres = "<path d='M25 20H75M25 30H75M30 15V35M70 15V35'/>";
    const std::string axes = "<path d='M10 5H90M10 45H90M15 2V48M85 2V48'/>";
    const std::string dimensions = "<path d='M20 11V2M80 11V2'/><path d='M19 4H81'/><path d='M19 7H81'/>";
    for (const auto &[lines, area] :
         {std::pair{holes + centres, 1800 - 36 * 3.14159265}, std::pair{axes, 1800.0}, std::pair{dimensions, 1800.0}}) {
        CAPTURE(lines);
        ImportNotes notes;
        const auto domain = unfilled(plate + lines, notes);
        REQUIRE(domain.ok());
        CHECK(areaOf(*domain) == doctest::Approx(area).epsilon(1e-3));
        CHECK(hasNote(notes, "line-loops"));
    }
}

TEST_CASE("SVG: an outline that does not close is warned of, with the tolerance that closes it") {
    ImportNotes notes;
    REQUIRE(unfilled("<path d='M10 10H90V40'/><path d='M90 40.3H10V10'/><circle cx='50' cy='25' r='8'/>", notes).ok());
    CHECK(warningIn(notes) == "the outline does not close at (90, 10) by 0.3, so the area within it is not meshed; "
                              "--weld 0.315 closes it");
    ImportNotes dashes;
    REQUIRE(unfilled("<path d='M10 10H90V40H10z'/><path d='M20 5H40'/><path d='M40.3 5H60'/>", dashes).ok());
    CHECK(warningIn(dashes).empty());
    const auto found = std::find_if(dashes.entries().begin(), dashes.entries().end(),
                                    [](const ImportNote &note) { return note.code == "line-gaps"; });
    REQUIRE(found != dashes.entries().end());
    CHECK(found->message.starts_with("2 ends of lines nearly meet another end, at most 0.3 away, first at (40"));
    CHECK(found->message.ends_with("; --weld 0.315 joins them"));
}

TEST_CASE("SVG: a hole that does not close is warned of") {
    ImportNotes notes;
    REQUIRE(unfilled("<path d='M10 10H90V40H10z'/><path d='M40 20H60V30H40V20.1'/>", notes).ok());
    const std::string warning = warningIn(notes);
    CHECK(warning.starts_with("an inner outline does not close at (40, "));
    CHECK(warning.ends_with(" by 0.1, so it bounds neither a hole nor a part; --weld 0.105 closes it"));
}

TEST_CASE("GeoJSON: an outline of lines that does not close is warned of") {
    ImportNotes notes;
    const auto read =
        geoJson("{\"type\":\"MultiLineString\",\"coordinates\":[[[0,0],[10,0],[10,5]],[[10,5.01],[0,5],[0,0.01]],"
                "[[3,2],[6,2],[6,3],[3,3],[3,2]]]}",
                notes);
    REQUIRE(read.ok());
    const std::string warning = warningIn(notes);
    CHECK(warning.starts_with("the outline does not close at ("));
    CHECK(warning.ends_with(
        " by 0.01, nor at another place, so the area within it is not meshed; --weld 0.0105 closes it"));
}

TEST_CASE("SVG: a larger weld tolerance is advised only where it loses nothing") {
    ImportNotes notes;
    REQUIRE(unfilled("<path d='M10 10H90V40'/><path d='M90 40.3H10V10'/><circle cx='50' cy='25' r='.1'/>", notes).ok());
    CHECK(warningIn(notes) == "the outline does not close at (90, 10) by 0.3, so the area within it is not meshed; "
                              "close it in the drawing");
    ImportNotes others;
    REQUIRE(unfilled("<path d='M10 10H90V40'/><path d='M90 40.01H10V10'/><path d='M20 5h9m.9 0h9'/>"
                     "<circle cx='50' cy='25' r='.5'/>",
                     others)
                .ok());
    CHECK(warningIn(others).ends_with("; --weld 0.0105 closes it"));
}

TEST_CASE("SVG: an outline drawn twice counts once, wherever it begins and in either direction") {
    const std::string plate = "<path d='M10 10H90V40H10z'/>", hole = "<path d='M40 20h10v10h-10z'/>";
    const std::string turned = "<path d='M50 30v-10h-10v10z'/>", round = "<circle cx='70' cy='25' r='5'/>";
    for (const std::string &content :
         {plate + hole + hole, plate + hole + turned, plate + plate + hole, plate + hole + turned + plate + hole}) {
        CAPTURE(content);
        ImportNotes notes;
        const auto domain = unfilled(content, notes);
        REQUIRE(domain.ok());
        CHECK(areaOf(*domain) == doctest::Approx(2300));
        CHECK(hasNote(notes, "svg-duplicate"));
    }
    ImportNotes notes;
    const auto circles = unfilled(plate + round + round, notes);
    REQUIRE(circles.ok());
    CHECK(areaOf(*circles) == doctest::Approx(2400 - 25 * 3.14159265).epsilon(1e-3));
    const auto named = unfilled("<path d='M10 10H90V40H10z'/><path id='rim' d='M10 10H90V40H10z'/>", notes);
    REQUIRE(named.ok());
    CHECK(named->boundaryNames.size() == 1);
    const std::string twice = "<svg fill='none' stroke='black'>" + plate + hole + hole + "</svg>";
    SourceText source = sourceOf(twice);
    source.options.strict = true;
    CHECK_FALSE(readSvg(source).ok());
}

TEST_CASE("SVG: an invisible frame around open strokes is no outline") {
    const std::string text = "<svg viewBox='0 0 24 24' fill='none'><path d='M0 0H24V24H0z'/>"
                             "<path stroke='black' d='M2 2H9M4 5V20'/></svg>";
    const auto domain = readSvg(sourceOf(text));
    REQUIRE(domain.ok());
    CHECK(boundaryCount(*domain) == 0);
    SourceText source = sourceOf(text);
    source.options.strokeAreas = true;
    const auto areas = readSvg(source);
    REQUIRE(areas.ok());
    CHECK(boundaryCount(*areas) > 0);
}

TEST_CASE("SVG: a domain that is only a part of the drawing is reported") {
    const std::string part = "<path d='M40 20h10v10h-10z'/>";
    ImportNotes open;
    REQUIRE(unfilled("<path d='M10 10H90V40H10V20'/>" + part, open).ok());
    CHECK(warningIn(open).starts_with("the outline does not close at (10, "));
    CHECK(warningIn(open).ends_with(" by 10, so the area within it is not meshed; close it in the drawing"));
    CHECK_FALSE(hasNote(open, "small-domain"));
    ImportNotes notes;
    REQUIRE(unfilled("<path d='M10 10H90'/><path d='M10 40H90'/>" + part, notes).ok());
    CHECK(warningIn(notes).empty());
    CHECK(std::any_of(notes.entries().begin(), notes.entries().end(), [](const ImportNote &note) {
        return note.code == "small-domain" && note.message.find("from (40, 20) to (50, 30)") != std::string::npos;
    }));
}
