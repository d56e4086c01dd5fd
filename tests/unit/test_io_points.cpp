#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/wkt/wkt.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/files/femm/femm.hpp"
#include "core/files/points/points.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace points_tests {

template <class Content>
Content readOf(Result<Content> (*read)(const SourceText &), const std::string &text, ImportNotes *notes = nullptr) {
    SourceText source = sourceOf(text);
    source.notes = notes;
    Result<Content> content = read(source);
    REQUIRE_MESSAGE(content.ok(), messages(content.faults()));
    return *std::move(content);
}

template <class Content>
Diagnostic faultOf(Result<Content> (*read)(const SourceText &), const std::string &text, bool strict = false) {
    SourceText source = sourceOf(text);
    source.options.strict = strict;
    const Result<Content> content = read(source);
    REQUIRE_FALSE(content.ok());
    CHECK(allLocated(content.faults()));
    return content.faults().front();
}

/// Returns the area inside loops that all run counter-clockwise around it, by their chords.
double areaInside(const Domain &domain) {
    double area = 0.0;
    for (const DomainSegment &s : domain.segments) {
        area += s.role == SegmentRole::Boundary ? 0.5 * cross(domain.nodes[s.a], domain.nodes[s.b]) : 0.0;
    }
    return area;
}

std::size_t countOf(const Domain &domain, std::int32_t tag) {
    std::size_t count = 0;
    for (const DomainSegment &s : domain.segments) {
        count += s.tag == tag ? 1 : 0;
    }
    return count;
}

} // namespace points_tests

namespace pt = points_tests;

TEST_CASE("CSV: paths of points with every separator, names of columns and of paths") {
    for (const char *text : {"0,0\n4,0\n4,3\n0,0\n", "x;y\n0;0\n4,0;0\n4;3\n", "# c\n0\t0\n4\t0\r\n4\t3\n\n",
                             "0 0\n 4  0\n4 3", "\"x [m]\",\"y [m]\"\n0,0\n\"4\",0\n4,3\n", "y,x\n0,0\n0,4\n3,4\n"}) {
        CAPTURE(std::string(text));
        const Domain domain = pt::readOf(readCsv, text).domain;
        CHECK(domain.nodes.size() == 3);
        CHECK(domain.segments.size() == 3);
        CHECK(std::fabs(pt::areaInside(domain)) == doctest::Approx(6.0));
        CHECK(validate(domain).empty());
    }
    const Domain parts = pt::readOf(readCsv, "x,y,part\n0,0,wall\n4,0,wall\n4,3,wall\n2,0.5,\"in, side\"\n3,0.5,\"in, "
                                             "side\"\n3,1,gauge\n")
                             .domain;
    CHECK(parts.boundaryNames.at(1) == "wall");
    CHECK(parts.boundaryNames.at(2) == "in, side");
    REQUIRE(parts.segments.size() == 4);
    CHECK(parts.segments.back().role == SegmentRole::Constraint);
    CHECK(parts.points.size() == 1);
    CHECK(pt::readOf(readCsv, "0,0\n9,0\n9,9\n\n5,1\n6,1\n6,2\n").domain.segments.size() == 6);
    ImportNotes notes;
    pt::readOf(readCsv, "x,y,depth\n0,0,1\n4,0,1\n4,3,1\n", &notes);
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].message.find("'depth'") != std::string::npos);
}

TEST_CASE("CSV: of several columns that may name paths, part comes before path and name") {
    ImportNotes notes;
    const Domain domain = pt::readOf(readCsv, "name,x,y,part\np,0,0,1\nq,4,0,1\nr,4,2,1\ns,0,2,1\n", &notes).domain;
    CHECK(domain.boundaryNames == std::map<std::int32_t, std::string>{{1, "1"}});
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].message.find("'name'") != std::string::npos);
}

TEST_CASE("CSV: faults name the place") {
    const Diagnostic number = pt::faultOf(readCsv, "x,y\n0,0\n1,zwei\n");
    CHECK(number.code == "bad-number");
    CHECK(number.line == 3);
    CHECK(number.column == 3);
    CHECK(pt::faultOf(readCsv, "0,0\n1\n").code == "bad-count");
    CHECK(pt::faultOf(readCsv, "lon,lat\n0,0\n1,1\n").code == "bad-syntax");
    CHECK(pt::faultOf(readCsv, "0,0\n1,1\n").code == "empty-domain");
    CHECK(pt::faultOf(readCsv, "0,inf\n1,1\n").code == "bad-number");
}

TEST_CASE("Airfoils: both layouts give the same outline, blunt or sharp") {
    const char *const selig = "FOIL 1\n1 0\n0.5 0.06\n0.1 0.05\n0 0\n0.1 -0.03\n0.5 -0.02\n1 0\n";
    const char *const lednicer = "FOIL 1\n 4. 4.\n\n0 0\n0.1 0.05\n0.5 0.06\n1 0\n\n0 0\n0.1 -0.03\n0.5 -0.02\n1 0\n";
    const Domain a = pt::readOf(readAirfoil, selig).domain, b = pt::readOf(readAirfoil, lednicer).domain;
    CHECK(a.nodes == b.nodes);
    REQUIRE(a.segments.size() == 6);
    CHECK(pt::countOf(a, 1) == 3);
    CHECK(pt::countOf(a, 2) == 3);
    CHECK(pt::countOf(b, 1) == 3);
    CHECK(a.boundaryNames.at(1) == "upper");
    CHECK(pt::areaInside(a) == doctest::Approx(0.056));
    const Domain blunt = pt::readOf(readAirfoil, "1 0.01\n0.5 0.06\n0 0\n0.5 -0.02\n1 -0.01\n").domain;
    CHECK(pt::countOf(blunt, 3) == 1);
    CHECK(blunt.boundaryNames.at(3) == "trailing_edge");
    CHECK(pt::readOf(readAirfoil, "1 0\n0.5 -0.02\n0 0\n0.5 0.06\n").domain.boundaryNames.at(1) == "lower");
    CHECK(pt::faultOf(readAirfoil, "FOIL\n 4. 5.\n0 0\n0.1 0.05\n0.5 0.06\n1 0\n").code == "bad-count");
    CHECK(pt::faultOf(readAirfoil, "FOIL\n1 0\n0.5 x\n").line == 3);
    CHECK(pt::faultOf(readAirfoil, "FOIL\n1 0 3\n").code == "bad-syntax");
    CHECK(pt::faultOf(readAirfoil, "FOIL\n1 0\n").code == "bad-count");
}

TEST_CASE("WKT: polygons with holes, lines, points and collections") {
    const Domain one = pt::readOf(readWkt, "polygon z ((0 0 1,4 0 1,4 3 1,0 3 1,0 0 1),\n (1 1 1,1 2 1,2 2 1,1 1 1))");
    CHECK(one.segments.size() == 7);
    CHECK(one.regionMarkers.empty());
    const Domain many =
        pt::readOf(readWkt, "GEOMETRYCOLLECTION(MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((5 0,6 0,6 1,5 0))),"
                            "LINESTRING EMPTY,MULTIPOINT((5.9 .5),0.5 0.25),MULTILINESTRING((0.3 0.1,0.8 0.3)))");
    CHECK(many.regionMarkers.size() == 2);
    CHECK(many.points.size() == 2);
    CHECK(pt::readOf(readWkt, "LINESTRING(0 0,1 0,1 1,0 0)\nPOINTZ(0.7 0.2 1)").segments.size() == 3);
    ImportNotes open;
    pt::readOf(readWkt, "MULTILINESTRING((0 0,10 0,10 5,0 5,0 0.01),(3 2,6 2,6 3,3 3,3 2))", &open);
    CHECK(std::any_of(open.entries().begin(), open.entries().end(), [](const ImportNote &note) {
        return note.code == "open-outline" && note.severity == Severity::Warning &&
               note.message.ends_with(" by 0.01, so the area within it is not meshed; --weld 0.0105 closes it");
    }));
    ImportNotes notes;
    pt::readOf(readWkt, "SRID=4326;POLYGON((0 0,1 0,1 1,0 0))", &notes);
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].severity == Severity::Warning);
    CHECK(pt::faultOf(readWkt, "SRID=4326;POLYGON((0 0,1 0,1 1,0 0))", true).code == "degrees");
    CHECK(pt::faultOf(readWkt, "CURVEPOLYGON(CIRCULARSTRING(0 0,4 0,4 4,0 4,0 0))").code == "unknown-geometry");
    const Diagnostic number = pt::faultOf(readWkt, "POLYGON((0 0,1 0,\n1 x,0 0))");
    CHECK(number.code == "bad-number");
    CHECK(number.line == 2);
    CHECK(pt::faultOf(readWkt, "POLYGON((0 0,1 0,1 1,0 0)").message.find("end of the file") != std::string::npos);
    CHECK(pt::faultOf(readWkt, "POLYGON((0 0,1 0,0 0))").code == "bad-count");
    CHECK(pt::faultOf(readWkt, "POINT(1 2)").code == "empty-domain");
}

TEST_CASE("FEMM: segments, arcs, labels, holes and areas") {
    const std::string text =
        "[Format]      =  4.0\n[LengthUnits] =  centimeters\n[ProblemType] =  planar\n[PointProps]   = 0\n"
        "[BdryProps]  = 1\n  <BeginBdry>\n    <BdryName> = \"A=0\"\n    <BdryType> = 0\n  <EndBdry>\n"
        "[BlockProps]  = 2\n  <BeginBlock>\n    <BlockName> = \"Air\"\n  <EndBlock>\n  <BeginBlock>\n    <BlockName> = "
        "\"Iron\"\n  <EndBlock>\n[NumPoints] = "
        "6\n0\t0\t0\t0\n4\t0\t0\t0\n4\t4\t0\t0\n0\t4\t0\t0\n1\t2\t0\t0\n3\t2\t0\t0\n"
        "[NumSegments] = 4\n0\t1\t-1\t1\t0\t0\n1\t2\t-1\t1\t0\t0\n2\t3\t0.5\t0\t0\t0\n3\t0\t-1\t0\t0\t0\n"
        "[NumArcSegments] = 2\n4\t5\t180\t5\t0\t0\t0\n5\t4\t180\t5\t0\t0\t0\n[NumHoles] = 0\n"
        "[NumBlockLabels] = 2\n0.5\t0.5\t1\t-1\t0\t0\t0\t1\t0\n2\t2\t2\t0.5\t0\t0\t0\t1\t0\n";
    ImportNotes notes;
    const DomainFile file = pt::readOf(readFemm, text, &notes);
    const Domain &domain = file.domain;
    CHECK(validate(domain).empty());
    CHECK(domain.curves.size() == 2);
    CHECK(domain.boundaryNames.at(1) == "A=0");
    CHECK(pt::countOf(domain, 1) == 2);
    CHECK(domain.regionNames.at(1) == "Air");
    CHECK(domain.regionNames.at(2) == "Iron");
    REQUIRE(file.spacing.placed.regions.size() == 1);
    CHECK(file.spacing.placed.regions[0].maxArea == doctest::Approx(std::numbers::pi / 16));
    CHECK(notes.entries().size() == 2); // the unit, a size of a segment
    for (const DomainSegment &s : domain.segments) {
        if (s.stretch.follows()) {
            CHECK(std::fabs(distance(domain.nodes[s.a], {2, 2}) - 1.0) < 1e-12);
        }
    }
    // The first arc runs counter-clockwise from (1, 2), below the centre.
    CHECK(domain.curves[0].point(0.5).y == doctest::Approx(1.0));
    const auto changed = [&text](const std::string &from, const std::string &to) {
        std::string other = text;
        return other.replace(other.find(from), from.size(), to);
    };
    CHECK(pt::readOf(readFemm, changed("[NumHoles] = 0\n", "[NumHoles] = 1\n2 2 0\n")).domain.holeMarkers.size() == 1);
    CHECK(pt::faultOf(readFemm, changed("4\t5\t180", "4\t9\t180")).code == "bad-index");
    CHECK(pt::faultOf(readFemm, changed("4\t5\t180", "4\t5\t360")).code == "bad-value");
    CHECK(pt::faultOf(readFemm, changed("0\t1\t-1\t1", "0\t1\t-1\t7")).code == "bad-index");
    CHECK(pt::faultOf(readFemm, changed("[NumPoints] = 6", "[NumPoints] = x")).code == "bad-count");
    CHECK(pt::faultOf(readFemm, changed("4\t0\t0\t0\n", "4\tx\t0\t0\n")).line == 19);
    CHECK(pt::faultOf(readFemm, "[Format] = 4.0\n[NumPoints] = 3\n0 0 0 0\n").code == "bad-count");
    CHECK(pt::faultOf(readFemm, "[Format] = 4.0\n").code == "empty-domain");
}

TEST_CASE("FEMM: what lies outside is left out, lone nodes and point properties are points") {
    // A square with a square hole at its left side, so that the side between them bounds nothing; a lone node inside,
    // one in the hole, one outside with a property; a default label outside.
    const std::string text =
        "[Format] = 4.0\n[LengthUnits] = inches\n[PointProps] = 1\n<BeginPoint>\n<PointName> = \"fixed\"\n<EndPoint>\n"
        "[BlockProps] = 2\n<BeginBlock>\n<BlockName> = \"Air\"\n<EndBlock>\n<BeginBlock>\n<BlockName> = \"Iron\"\n"
        "<EndBlock>\n[NumPoints] = 11\n0 0 0 0\n4 0 1 0\n4 4 0 0\n0 4 0 0\n0 1 0 0\n1 1 0 0\n1 2 0 0\n0 2 0 0\n"
        "3 3 0 0\n0.5 1.5 0 0\n9 9 1 0\n"
        "[NumSegments] = 8\n0 1 -1 0 0 0\n1 2 -1 0 0 0\n2 3 -1 0 0 0\n3 7 -1 0 0 0\n7 4 -1 0 0 0\n4 0 -1 0 0 0\n"
        "4 5 -1 0 0 0\n5 6 -1 0 0 0\n";
    const std::string end =
        "[NumHoles] = 1\n0.5 1.4 0\n[NumBlockLabels] = 2\n2 2 1 -1 0 0 0 1 0\n8 8 2 0.5 0 0 0 1 2\n";
    const auto withSides = [&text](const std::string &count, const std::string &sides) {
        std::string other = text;
        return other.replace(other.find("= 8\n") + 2, 1, count) + sides;
    };
    ImportNotes notes;
    const DomainFile file = pt::readOf(readFemm, withSides("9", "6 7 -1 0 0 0\n") + end, &notes);
    const Domain &domain = file.domain;
    CHECK(validate(domain).empty());
    CHECK(domain.nodes.size() == 9);
    CHECK(domain.segments.size() == 8);
    CHECK(domain.holeMarkers.empty());
    REQUIRE(domain.points.size() == 2);
    CHECK(domain.nodes[domain.points[0].node] == Vec2{4, 0});
    CHECK(domain.boundaryNames.at(domain.points[0].tag) == "fixed");
    CHECK(domain.nodes[domain.points[1].node] == Vec2{3, 3});
    REQUIRE(domain.regionMarkers.size() == 1);
    CHECK(domain.regionNames.at(domain.regionMarkers[0].tag) == "Air");
    CHECK(domain.regionNames.at(1) == "Iron"); // of faces without a label
    std::vector<std::string> left;
    for (const ImportNote &note : notes.entries()) {
        left.push_back(note.code + ' ' + std::to_string(note.line));
    }
    CHECK(left == std::vector<std::string>{"femm-units 2", "femm-outside 31", "femm-outside 40", "femm-outside 24",
                                           "femm-outside 37"});
    // Crossing segments are left to validation, with all parts in place.
    const DomainFile crossing = pt::readOf(readFemm, withSides("10", "6 0 -1 0 0 0\n1 7 -1 0 0 0\n") + end);
    CHECK(crossing.domain.nodes.size() == 11);
    // Problems other than magnetic ones have shorter labels.
    const DomainFile heat =
        pt::readOf(readFemm, withSides("9", "6 7 -1 0 0 0\n") +
                                 "[NumHoles] = 0\n[NumBlockLabels] = 2\n2 2 1 -1 0 0\n8 8 2 0 0 2\n");
    CHECK(heat.domain.regionNames.at(1) == "Iron");
}

TEST_CASE("Formats: the content decides where the extension is ambiguous") {
    const auto detected = [](const char *path, std::string_view content) {
        const FileFormat *const format = allFormats().detect(path, content);
        return format == nullptr ? std::string() : std::string(format->id);
    };
    CHECK(detected("a.txt", "POLYGON((0 0,1 0,1 1,0 0))") == "wkt");
    CHECK(detected("a.txt", "MultiPolygonZ (((0 0 1, 1 0 1, 1 1 1, 0 0 1)))") == "wkt");
    CHECK(detected("a.txt", "SRID=3067;POINT(1 2)") == "wkt");
    CHECK(detected("a.txt", "[Format] = 4.0\n[Frequency] = 0\n[LengthUnits] = inches\n") == "femm");
    CHECK(detected("a.dat", "NACA 0012\n1 0\n0.5 0.1\n") == "airfoil");
    CHECK(detected("a.csv", "x,y\n0,0\n") == "csv");
    CHECK(detected("a.geo", "Point(1) = {0, 0, 0, lc};").empty());
    CHECK(detected("a.txt", "point").empty());
}
