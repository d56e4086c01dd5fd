#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/dxf/dxf.hpp"
#include "core/drawing_files/dxf/dxf_drawing.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/files/format.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace dxf_tests {

constexpr double kPi = std::numbers::pi;

/// Returns groups from a list such as "0 LINE 8 A 10 1", a line each.
std::string groups(const std::string &list) {
    std::string text = list;
    std::replace(text.begin(), text.end(), ' ', '\n');
    return text + '\n';
}

std::string section(const std::string &name, const std::string &content) {
    return groups("0 SECTION 2 " + name) + content + groups("0 ENDSEC");
}

std::string drawing(const std::string &entities, const std::string &before = {}) {
    return before + section("ENTITIES", groups(entities)) + groups("0 EOF");
}

DxfPaths pathsIn(const std::string &text, ImportNotes *notes = nullptr, const ImportOptions &options = {}) {
    SourceText source = sourceOf(text, "part.dxf");
    source.notes = notes;
    source.options = options;
    const auto file = readDxfFile(source);
    REQUIRE_MESSAGE(file.ok(), messages(file.faults()));
    const auto drawn = drawDxf(*file, source);
    REQUIRE_MESSAGE(drawn.ok(), messages(drawn.faults()));
    return *drawn;
}

double lengthOf(const DxfPaths &paths) {
    double length = 0.0;
    for (const Curve &curve : paths.curves) {
        length += curve.length();
    }
    return length;
}

Box2 boundsOf(const DxfPaths &paths) {
    Box2 box;
    for (const Curve &curve : paths.curves) {
        box.add(curve.bounds());
    }
    return box;
}

Domain domainIn(const std::string &text, ImportNotes *notes = nullptr, const ImportOptions &options = {}) {
    SourceText source = sourceOf(text, "part.dxf");
    source.notes = notes;
    source.options = options;
    const auto domain = readDxf(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    CHECK(validate(*domain).empty());
    return *domain;
}

Diagnostics faultsIn(const std::string &text, const ImportOptions &options = {}) {
    SourceText source = sourceOf(text, "part.dxf");
    source.options = options;
    const auto domain = readDxf(source);
    REQUIRE_FALSE(domain.ok());
    CHECK(allLocated(domain.faults()));
    return domain.faults();
}

std::size_t countOf(const ImportNotes &notes, std::string_view words) {
    std::size_t count = 0;
    for (const ImportNote &note : notes.entries()) {
        count += note.message.find(words) != std::string::npos ? note.count : 0;
    }
    return count;
}

/// Twice the signed area of the boundary, by its chords.
double chordArea(const Domain &domain) {
    double area = 0.0;
    for (const DomainSegment &s : domain.segments) {
        area += s.role == SegmentRole::Boundary ? 0.5 * cross(domain.nodes[s.a], domain.nodes[s.b]) : 0.0;
    }
    return std::fabs(area);
}

bool sameBox(const Box2 &box, Vec2 min, Vec2 max, double error = 1e-9) {
    return distance(box.min, min) <= error && distance(box.max, max) <= error;
}

const std::string kSquare = "0 LWPOLYLINE 8 OUTLINE 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";

} // namespace dxf_tests

using namespace dxf_tests;

TEST_CASE("DXF: a plate with holes becomes a domain with layers as boundary parts") {
    ImportNotes notes;
    const std::string header = section("HEADER", groups("9 $ACADVER 1 AC1015 9 $INSUNITS 70 4"));
    const Domain domain =
        domainIn(drawing(kSquare + " 0 CIRCLE 8 HOLES 10 3 20 5 40 1 0 ARC 8 HOLES 10 7 20 5 40 1 50 0 51 180"
                                   " 0 LINE 8 HOLES 10 6 20 5 11 8 21 5",
                         header),
                 &notes);
    std::vector<std::string> names;
    for (const auto &[tag, name] : domain.boundaryNames) {
        names.push_back(name);
    }
    CHECK(names == std::vector<std::string>{"OUTLINE", "HOLES"});
    CHECK(domain.curves.size() >= 2);
    for (const DomainSegment &segment : domain.segments) {
        if (segment.stretch.follows()) {
            const Curve &curve = domain.curves[segment.stretch.curve];
            CHECK(distance(curve.point(segment.stretch.t0), domain.nodes[segment.a]) < 1e-12);
            CHECK(distance(curve.point(segment.stretch.t1), domain.nodes[segment.b]) < 1e-12);
        }
    }
    CHECK(std::all_of(domain.segments.begin(), domain.segments.end(),
                      [](const DomainSegment &s) { return s.role == SegmentRole::Boundary; }));
    CHECK(countOf(notes, "the coordinates are millimetres") == 1);
    CHECK(notes.contents().unit == "millimetres");
    CHECK(notes.contents().layers == std::vector<std::string>{"OUTLINE", "HOLES"});
    CHECK(notes.contents().layer == "OUTLINE,HOLES");
}

TEST_CASE("DXF: a side that two outlines share stays as a line between them") {
    ImportNotes notes;
    const Domain domain = domainIn(
        drawing(kSquare + " 0 LWPOLYLINE 8 SECOND 90 4 70 1 10 10 20 0 10 20 20 0 10 20 20 10 10 10 20 10"), &notes);
    CHECK(chordArea(domain) == doctest::Approx(200.0));
    std::size_t between = 0;
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role == SegmentRole::Constraint) {
            ++between;
            CHECK(domain.nodes[segment.a].x == 10.0);
            CHECK(domain.nodes[segment.b].x == 10.0);
        }
    }
    CHECK(between == 1);
    CHECK(countOf(notes, "runs back along itself") == 0);
    CHECK(countOf(notes, "shared by neighbours into an inner line") == 1);
    // Where an outline goes out and back, nothing is left.
    const Domain spike =
        domainIn(drawing("0 LWPOLYLINE 8 A 90 6 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 15 20 10 10 10 "
                         "20 10 10 0 20 10"));
    CHECK(spike.segments.size() == 4);
}

TEST_CASE("DXF: arcs, ellipses and bulges keep their exact lengths and bounds") {
    CHECK(lengthOf(pathsIn(drawing("0 CIRCLE 10 1 20 2 40 3"))) == doctest::Approx(6 * kPi).epsilon(1e-12));
    const DxfPaths arc = pathsIn(drawing("0 ARC 10 0 20 0 40 2 50 350 51 370"));
    CHECK(lengthOf(arc) == doctest::Approx(2 * kPi / 9).epsilon(1e-12));
    CHECK(boundsOf(arc).max.x == doctest::Approx(2.0));
    const DxfPaths half = pathsIn(drawing("0 ELLIPSE 10 0 20 0 11 4 21 0 40 0.5 41 0 42 3.141592653589793"));
    CHECK(sameBox(boundsOf(half), {-4, 0}, {4, 2}, 1e-12));
    CHECK_FALSE(half.paths[0].closed);
    CHECK(pathsIn(drawing("0 ELLIPSE 10 0 20 0 11 4 21 0 40 0.5 41 0 42 6.283185307179586")).paths[0].closed);
    // A bulge of 1 is a semicircle to the right of the segment, of -1 to its left.
    const DxfPaths bulge = pathsIn(drawing("0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 1 10 2 20 0"));
    CHECK(lengthOf(bulge) == doctest::Approx(kPi).epsilon(1e-12));
    CHECK(sameBox(boundsOf(bulge), {0, -1}, {2, 0}, 1e-12));
    CHECK(
        sameBox(boundsOf(pathsIn(drawing("0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 -1 10 2 20 0"))), {0, 0}, {2, 1}, 1e-12));
    const DxfPaths round = pathsIn(drawing("0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 1 10 2 20 0 42 1"));
    CHECK(lengthOf(round) == doctest::Approx(2 * kPi).epsilon(1e-12));
    CHECK(round.paths[0].closed);
    CHECK(pathsIn(drawing("0 LWPOLYLINE 90 2 10 0 20 0 42 1e-9 10 2 20 0")).curves[0].kind() == CurveKind::Line);
}

TEST_CASE("DXF: polylines of R12, with bulges, splined, and as meshes") {
    const std::string vertices = " 0 VERTEX 8 A 10 0 20 0 42 1 0 VERTEX 8 A 10 2 20 0 0 VERTEX 8 A 10 2 20 3 0 SEQEND";
    const DxfPaths closed = pathsIn(drawing("0 POLYLINE 8 A 66 1 70 1" + vertices));
    CHECK(lengthOf(closed) == doctest::Approx(kPi + 3 + std::sqrt(13.0)).epsilon(1e-12));
    CHECK(closed.curves.size() == 3);
    CHECK(pathsIn(drawing("0 POLYLINE 8 A 66 1 70 0" + vertices)).curves.size() == 2);
    CHECK(
        pathsIn(drawing("0 POLYLINE 8 A 66 1 70 4 0 VERTEX 70 16 10 9 20 9 0 VERTEX 70 8 10 0 20 0 0 VERTEX 70 8 10 1 "
                        "20 1 0 SEQEND 0 LINE 10 0 20 0 11 1 21 0"))
            .curves.size() == 2);
    ImportNotes notes;
    CHECK(pathsIn(drawing("0 POLYLINE 70 64 0 VERTEX 10 0 20 0 0 VERTEX 10 1 20 0 0 SEQEND"), &notes).paths.empty());
    CHECK(countOf(notes, "3D entities are left out") == 1);
}

TEST_CASE("DXF: splines of every kind") {
    // A quarter circle as a rational quadratic.
    const DxfPaths quarter = pathsIn(drawing("0 SPLINE 70 4 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 "
                                             "0.7071067811865476 41 1 10 1 20 0 10 1 20 1 10 0 20 1"));
    CHECK(lengthOf(quarter) == doctest::Approx(kPi / 2).epsilon(1e-7));
    for (const Curve &curve : quarter.curves) {
        CHECK(std::fabs(length(curve.point(0.37)) - 1.0) < 1e-7);
    }
    // One Bézier span is that cubic.
    const DxfPaths cubic = pathsIn(
        drawing("0 SPLINE 70 8 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 3 20 2 10 4 20 0"));
    REQUIRE(cubic.curves.size() == 1);
    CHECK(cubic.curves[0] == Curve::cubic({0, 0}, {1, 2}, {3, 2}, {4, 0}));
    // Degree 1 is a polyline; an unclamped periodic cubic over a square closes smoothly.
    CHECK(pathsIn(drawing("0 SPLINE 70 8 71 1 40 0 40 0 40 1 40 2 40 2 10 0 20 0 10 1 20 2 10 3 20 2")).curves.size() ==
          2);
    const DxfPaths periodic = pathsIn(drawing("0 SPLINE 70 11 71 3 40 0 40 1 40 2 40 3 40 4 40 5 40 6 40 7 40 8 40 9 "
                                              "40 10 10 0 20 0 10 6 20 0 10 6 20 6 10 0 "
                                              "20 6 10 0 20 0 10 6 20 0 10 6 20 6"));
    REQUIRE(periodic.curves.size() == 4);
    CHECK(distance(periodic.curves.front().point(0), periodic.curves.back().point(1)) < 1e-12);
    CHECK(distance(periodic.curves.front().tangent(0), periodic.curves.back().tangent(1)) < 1e-12);
    // Degree 4 by its derivative: (t, t^4) from Bézier points.
    const DxfPaths quartic =
        pathsIn(drawing("0 SPLINE 70 8 71 4 40 0 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 40 1 10 0 20 "
                        "0 10 0.25 20 0 10 0.5 20 0 10 0.75 20 0 10 1 20 1"));
    for (const Curve &curve : quartic.curves) {
        const Vec2 p = curve.point(0.43);
        CHECK(std::fabs(p.y - std::pow(p.x, 4)) < 1e-7);
    }
    // Points to pass through, open and closed.
    const DxfPaths through = pathsIn(drawing("0 SPLINE 70 8 71 3 74 3 11 0 21 0 11 1 21 1 11 2 21 0"));
    REQUIRE(through.curves.size() == 2);
    CHECK(through.curves[0].point(1) == Vec2{1, 1});
    const DxfPaths ring = pathsIn(drawing("0 SPLINE 70 9 71 3 74 4 11 1 21 0 11 0 21 1 11 -1 21 0 11 0 21 -1"));
    REQUIRE(ring.curves.size() == 4);
    CHECK(length(ring.curves[1].point(0.5)) == doctest::Approx(0.6875 * std::sqrt(2.0))); // by symmetry
    CHECK(distance(ring.curves.front().point(0), ring.curves.back().point(1)) < 1e-12);
}

TEST_CASE("DXF: blocks are inserted nested, turned, scaled unevenly and in arrays") {
    const std::string blocks = section(
        "BLOCKS", groups("0 BLOCK 2 inner 70 0 10 1 20 0 0 CIRCLE 8 0 10 1 20 0 40 1 0 ENDBLK "
                         "0 BLOCK 2 OUTER 10 0 20 0 0 INSERT 8 0 2 INNER 10 0 20 0 41 2 0 LINE 8 KEPT 10 0 20 0 "
                         "11 1 21 0 0 ENDBLK"));
    const DxfPaths turned = pathsIn(drawing("0 INSERT 8 TOP 2 outer 10 5 20 5 50 90", blocks));
    REQUIRE(turned.paths.size() == 2);
    CHECK(turned.layers == std::vector<std::string>{"TOP", "KEPT"}); // layer 0 takes that of the insert
    CHECK(sameBox(turned.curves[0].bounds(), {4, 3}, {6, 7}));       // an ellipse, 2 high
    CHECK(distance(turned.curves[1].point(1), {5, 6}) < 1e-12);
    const DxfPaths array = pathsIn(drawing("0 INSERT 2 INNER 10 0 20 0 50 90 70 3 71 2 44 10 45 20", blocks));
    CHECK(array.paths.size() == 6);
    CHECK(sameBox(boundsOf(array), {-21, -1}, {1, 21}));
    const DxfPaths mirrored = pathsIn(drawing("0 INSERT 2 OUTER 10 5 20 0 210 0 220 0 230 -1", blocks));
    CHECK(distance(mirrored.curves[1].point(1), {-6, 0}) < 1e-12);
    CHECK(hasCode(faultsIn(drawing("0 INSERT 2 A", section("BLOCKS", groups("0 BLOCK 2 A 0 INSERT 2 A 0 ENDBLK")))),
                  "nested-block"));
    ImportNotes notes;
    CHECK(pathsIn(drawing("0 INSERT 2 NONE 10 0 20 0"), &notes).paths.empty());
    CHECK(countOf(notes, "no block 'none'") == 1);
    CHECK(notes.entries()[0].severity == Severity::Warning);
}

TEST_CASE("DXF: the extrusion direction 0, 0, -1 mirrors circles and polylines, but no lines and splines") {
    const std::string down = " 210 0 220 0 230 -1";
    CHECK(sameBox(boundsOf(pathsIn(drawing("0 CIRCLE 10 5 20 1 40 1" + down))), {-6, 0}, {-4, 2}));
    CHECK(sameBox(boundsOf(pathsIn(drawing("0 ARC 10 5 20 0 40 1 50 0 51 90" + down))), {-6, 0}, {-5, 1}, 1e-12));
    CHECK(sameBox(boundsOf(pathsIn(drawing("0 LWPOLYLINE 90 2 10 1 20 0 42 1 10 3 20 0" + down))), {-3, -1}, {-1, 0},
                  1e-12));
    CHECK(sameBox(boundsOf(pathsIn(drawing("0 LINE 10 1 20 0 11 3 21 1" + down))), {1, 0}, {3, 1}));
    // The half of an ellipse from its major axis on lies on the other side.
    CHECK(sameBox(boundsOf(pathsIn(drawing("0 ELLIPSE 10 0 20 0 11 2 21 0 40 .5 41 0 42 3.141592653589793" + down))),
                  {-2, -1}, {2, 0}, 1e-12));
    ImportNotes notes;
    CHECK(pathsIn(drawing("0 CIRCLE 10 0 20 0 40 1 210 1 220 0 230 0"), &notes).paths.empty());
    CHECK(countOf(notes, "tilted") == 1);
}

TEST_CASE("DXF: layers are chosen by name, and those that are not shown are left out") {
    const std::string tables = section(
        "TABLES",
        groups("0 TABLE 2 LAYER 0 LAYER 2 HIDDEN 70 0 62 -7 0 LAYER 2 COLD 70 1 62 7 0 LAYER 2 A 70 0 62 7 0 ENDTAB"));
    const std::string text = drawing(
        kSquare + " 0 CIRCLE 8 HIDDEN 10 3 20 3 40 1 0 CIRCLE 8 COLD 10 7 20 7 40 1 0 CIRCLE 8 Defpoints 10 5 20 8 40 "
                  "1 0 CIRCLE 8 A 10 7 20 3 40 1",
        tables);
    ImportNotes notes;
    CHECK(domainIn(text, &notes).boundaryNames.size() == 2);
    CHECK(countOf(notes, "is left out") == 3);
    ImportOptions options;
    options.layer = "outline,Cold, a";
    CHECK(domainIn(text, nullptr, options).boundaryNames.size() == 3);
    options.layer = "outline,none";
    const Diagnostics faults = faultsIn(text, options);
    CHECK(hasCode(faults, "unknown-layer"));
    CHECK(faults[0].message == "unknown layer 'none'");
    CHECK(faults[0].advice.find("'OUTLINE', 'HIDDEN'") != std::string::npos);
    const std::string bare = drawing(
        kSquare + " 0 TEXT 8 Title 1 x",
        section("TABLES", groups("0 TABLE 2 LAYER 0 LAYER 2 Title 70 0 62 7 0 LAYER 2 OUTLINE 70 0 62 7 0 ENDTAB")));
    options.layer = "TITLE";
    CHECK(faultsIn(bare, options)[0].message == "the layer 'TITLE' has no lines or curves to read");
    options.layer = "Outlines";
    CHECK(faultsIn(bare, options)[0].message == "unknown layer 'Outlines'");
}

TEST_CASE("DXF: an outline of lines that does not close is warned of, and meshed with the tolerance advised") {
    const std::string sides = "0 LINE 10 0 20 0 11 9.99 21 0 0 LINE 10 10 20 0 11 10 21 6 0 LINE 10 10 20 6 11 0 21 6 "
                              "0 LINE 10 0 20 6 11 0 21 0.01";
    const std::string text = drawing(sides + " 0 CIRCLE 10 5 20 3 40 1.5");
    ImportNotes notes;
    CHECK(chordArea(domainIn(text, &notes)) == doctest::Approx(2.25 * kPi).epsilon(0.01));
    CHECK(countOf(notes, "the outline does not close at (0, 0) by 0.01, nor at another place, so the area within it "
                         "is not meshed; --weld 0.0105 closes it") == 1);
    CHECK(std::any_of(notes.entries().begin(), notes.entries().end(), [](const ImportNote &note) {
        return note.code == "open-outline" && note.severity == Severity::Warning;
    }));
    ImportOptions options;
    options.weldTolerance = 0.0105;
    ImportNotes welded;
    CHECK(chordArea(domainIn(text, &welded, options)) > 50.0);
    CHECK(countOf(welded, "does not close") == 0);
    ImportNotes closed;
    domainIn(drawing(kSquare + " 0 LINE 10 2 20 2 11 4 21 2 0 LINE 10 4 20 2 11 4 21 4 0 LINE 10 4 20 4 11 2 21 2.01"),
             &closed);
    CHECK(countOf(closed, "an inner outline does not close at (2, 2") == 1);
}

TEST_CASE("DXF: what is no line in the plane is left out with its count") {
    ImportNotes notes;
    domainIn(drawing(kSquare +
                     " 0 TEXT 1 x 0 MTEXT 1 y 0 DIMENSION 0 HATCH 0 3DFACE 10 0 0 POINT 10 1 20 1 0 CIRCLE 10 5 20 5 "
                     "40 0 0 LINE 67 1 10 0 20 0 11 1 21 1 0 LINE 60 1 10 0 20 0 11 1 21 1"),
             &notes);
    CHECK(countOf(notes, "texts are left out") == 2);
    CHECK(countOf(notes, "dimensions are left out") == 1);
    CHECK(countOf(notes, "hatches are left out") == 1);
    CHECK(countOf(notes, "3D entities are left out") == 1);
    CHECK(countOf(notes, "points are left out") == 1);
    CHECK(countOf(notes, "without a positive radius") == 1);
    CHECK(countOf(notes, "paper space") == 1);
    CHECK(countOf(notes, "invisible") == 1);
    ImportNotes heights;
    pathsIn(drawing("0 LINE 10 0 20 0 30 1 11 1 21 0 31 1"), &heights);
    CHECK(countOf(heights, "z coordinates are ignored") == 1);
}

TEST_CASE("DXF: lines bound the domain, gaps are closed by welding, repeated curves count once") {
    const std::string open = "0 LINE 10 0 20 0 11 4 21 0 0 LINE 10 4 20 0 11 4 21 3 0 LINE 10 4.001 20 3 11 0 21 0.001";
    ImportOptions options;
    options.weldTolerance = 0.01;
    const Domain welded = domainIn(drawing(open), nullptr, options);
    CHECK(chordArea(welded) == doctest::Approx(6.0).epsilon(1e-3));
    const Diagnostics faults = [&] {
        const std::string text = drawing(open);
        const auto read = readDxf(sourceOf(text));
        REQUIRE(read.ok());
        return validate(*read);
    }();
    REQUIRE_FALSE(faults.empty());
    CHECK(faults[0].code == "empty-domain");
    CHECK(faults[0].message.find("0.001 from the nearest other end") != std::string::npos);
    ImportNotes twice;
    const Domain ring = domainIn(drawing(kSquare + " 0 CIRCLE 10 5 20 5 40 1 0 CIRCLE 10 5 20 5 40 1"), &twice);
    CHECK(countOf(twice, "drawn twice") == 1);
    ImportNotes lines;
    domainIn(drawing(kSquare + " 0 LINE 10 2 20 2 11 4 21 2 0 LINE 10 4 20 2 11 2 21 2 0 LINE 10 2 20 2 11 4 21 4"),
             &lines);
    CHECK(countOf(lines, "lines drawn twice are used once") == 1);
    CHECK(std::any_of(ring.segments.begin(), ring.segments.end(), [](const auto &s) { return s.stretch.follows(); }));
}

TEST_CASE("DXF: ends that meet up to rounding are no change, even with the option strict") {
    ImportOptions strict;
    strict.strict = true;
    ImportNotes notes;
    const std::string round = "0 LINE 10 0 20 0 11 105 21 0 0 ARC 10 105 20 15 40 15 50 270 51 90"
                              " 0 LINE 10 105 20 30 11 0 21 30 0 LINE 10 0 20 30 11 0 21 0";
    CHECK(chordArea(domainIn(drawing(round), &notes, strict)) > 3150.0);
    CHECK(countOf(notes, "moved") == 0);
    std::string apart = round;
    apart.replace(apart.find("11 105"), 6, "11 105.00001");
    CHECK(faultsIn(drawing(apart), strict).front().code == "welded-nodes");
}

TEST_CASE("DXF: outlines that overlap are warned of, with their layers and places") {
    const auto warningOf = [](const std::string &entities) {
        ImportNotes notes;
        domainIn(drawing(entities), &notes);
        std::string text;
        for (const ImportNote &note : notes.entries()) {
            if (note.severity == Severity::Warning) {
                text += note.message + '\n';
                CHECK(note.line > 0);
            }
        }
        return text;
    };
    const auto square = [](const std::string &layer, double x, double y, double side) {
        const auto corner = [](double u, double v) { return " 10 " + std::to_string(u) + " 20 " + std::to_string(v); };
        return " 0 LWPOLYLINE 8 " + layer + " 90 4 70 1" + corner(x, y) + corner(x + side, y) +
               corner(x + side, y + side) + corner(x, y + side);
    };
    const std::string crossed = warningOf(kSquare + square("TAB", 8, 4, 4));
    CHECK(crossed.find("closed outlines overlap in 1 place, 8 in area") != std::string::npos);
    CHECK(crossed.find("'OUTLINE' (line 7) and 'TAB' (line ") != std::string::npos);
    CHECK(crossed.find(" at (") != std::string::npos);
    // A circle over a side, inside a frame that contains both; sides that lie on each other in part.
    CHECK(warningOf(square("FRAME", -20, -20, 60) + ' ' + kSquare + " 0 CIRCLE 8 HOLES 10 10 20 5 40 1")
              .find("'OUTLINE' (line ") != std::string::npos);
    CHECK_FALSE(warningOf(kSquare + " 0 LWPOLYLINE 8 B 90 4 70 1 10 5 20 0 10 15 20 0 10 15 20 10 10 5 20 10").empty());
    // Nested, side by side, and in touch.
    CHECK(warningOf(kSquare + square("HOLES", 2, 2, 4) + square("ISLANDS", 3, 3, 1)).empty());
    CHECK(warningOf(kSquare + square("NEXT", 10, 0, 10)).empty());
    CHECK(warningOf(kSquare + square("CORNER", 10, 10, 4)).empty());
    CHECK(warningOf(kSquare + square("NOTCH", 0, 3, 4)).empty());
    CHECK(warningOf(kSquare + " 0 CIRCLE 8 HOLES 10 5 20 5 40 5").empty());
    // Rectangles of lines.
    const auto lines = [](const std::string &layer, double x, double y, double side) {
        const Vec2 corners[] = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
        std::string text;
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec2 a = corners[k], b = corners[(k + 1) % 4];
            text += " 0 LINE 8 " + layer + " 10 " + std::to_string(a.x) + " 20 " + std::to_string(a.y) + " 11 " +
                    std::to_string(b.x) + " 21 " + std::to_string(b.y);
        }
        return text;
    };
    const std::string crossing = warningOf(lines("A", 0, 0, 10).substr(1) + lines("B", 5, 5, 10));
    CHECK(crossing.find("outlines made of lines cross in 2 places, such as those of 'A' (line ") != std::string::npos);
    CHECK(crossing.find("first at (10, 5), (5, 10)") != std::string::npos);
    CHECK(warningOf(lines("A", 0, 0, 10).substr(1) + lines("B", 2, 2, 5)).empty());
    CHECK(warningOf(lines("A", 0, 0, 10).substr(1) + lines("B", 10, 10, 5)).empty());
}

TEST_CASE("DXF: names in code pages and escapes become UTF-8") {
    const std::string header = section("HEADER", groups("9 $ACADVER 1 AC1015 9 $DWGCODEPAGE 3 ANSI_1252"));
    CHECK(pathsIn(drawing("0 CIRCLE 8 M\xfcller 10 0 20 0 40 1", header)).layers[0] == "M\xc3\xbcller");
    CHECK(pathsIn(drawing("0 CIRCLE 8 a\\U+00e9 10 0 20 0 40 1")).layers[0] == "a\xc3\xa9");
    CHECK(pathsIn(drawing("0 CIRCLE 8 M\xc3\xbcller 10 0 20 0 40 1", section("HEADER", groups("9 $ACADVER 1 AC1021"))))
              .layers[0] == "M\xc3\xbcller");
}

TEST_CASE("DXF: faults name their line, and what to do") {
    const auto faultOf = [](const std::string &text) { return faultsIn(text)[0]; };
    CHECK(faultOf(drawing("0 LINE 10 x 20 0")).line == 8);
    CHECK(faultOf(drawing("0 LINE 10 x 20 0")).code == "bad-number");
    CHECK(faultOf(groups("0 SECTION 2 ENTITIES 0 LINE 10")).code == "bad-syntax");
    CHECK(faultOf(groups("0 SECTION 2 ENTITIES x LINE")).code == "bad-syntax");
    CHECK(faultOf(groups("0 SECTION 2 ENTITIES 0 LINE 10 0 20 0")).message.find("does not end") != std::string::npos);
    CHECK(faultOf(drawing("0 SPLINE 71 3 10 0 20 0 10 1 20 1")).code == "bad-value");
    CHECK(faultOf(drawing("0 TEXT 1 x")).code == "empty-domain");
    CHECK(faultOf(drawing("0 LINE 10 0 20 0 11 1")).message ==
          "the LINE has no group 21, a coordinate; expected groups 10 and 20, 11 and 21");
    CHECK(faultOf(drawing("0 CIRCLE 10 0 40 1")).message ==
          "the CIRCLE has no group 20, a coordinate; expected groups 10 and 20");
    ImportNotes notes;
    pathsIn(section("ENTITIES", groups("0 CIRCLE 10 0 20 0 40 1")), &notes);
    CHECK(countOf(notes, "end mark EOF is missing") == 1);
}

TEST_CASE("DXF: units that this program does not know are named or said to be unknown") {
    const auto notesOn = [](const std::string &unit) {
        ImportNotes notes;
        domainIn(drawing(kSquare, section("HEADER", groups("9 $INSUNITS 70 " + unit))), &notes);
        return notes;
    };
    CHECK(countOf(notesOn("21"), "the coordinates are US survey feet") == 1);
    CHECK(countOf(notesOn("99"), "the unit 99 of the coordinates ($INSUNITS) is not known") == 1);
    CHECK(countOf(notesOn("0"), "coordinates") == 0);
}

TEST_CASE("DXF: a spline whose weights overflow is refused without being divided") {
    const std::string spline =
        "0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 1e308 41 1e308 10 0 20 0 10 1e9 20 0 "
        "10 1e9 20 1e9";
    const std::string text = drawing(spline);
    const SourceText source = sourceOf(text, "part.dxf");
    const auto file = readDxfFile(source);
    REQUIRE(file.ok());
    const auto drawn = drawDxf(*file, source);
    CHECK((!drawn.ok() || drawn->curves.size() == 1));
    CHECK(!faultsIn(text).empty());
}

TEST_CASE("DXF: files are recognised by their content") {
    CHECK(looksLikeDxf("  0\r\nSECTION\r\n  2\r\nHEADER\r\n"));
    CHECK(looksLikeDxf("999\ndxfrw 0.6.3\n  0\nSECTION\n"));
    CHECK(looksLikeDxf(" 999\r\nmade by hand\r\n999\r\n\r\n0\r\nSECTION\r\n"));
    CHECK_FALSE(looksLikeDxf("0 1 2"));
    CHECK_FALSE(looksLikeDxf("999"));
    CHECK_FALSE(looksLikeDxf(""));
    const FileFormat *const format = allFormats().detect("part.txt", drawing(kSquare));
    REQUIRE(format != nullptr);
    CHECK(std::string(format->id) == "dxf");
    CHECK(format->hasLayers);
    CHECK(format->arranges);
}
