#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/base/number_text.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

constexpr double kPi = std::numbers::pi;

Result<Domain> readStrokes(const std::string &content, ImportNotes *notes = nullptr, bool strict = false) {
    const std::string text =
        "<svg viewBox=\"0 0 100 100\" fill=\"none\" stroke=\"black\" stroke-width=\"4\">\n" + content + "\n</svg>\n";
    SourceText source = sourceOf(text, "strokes.svg");
    source.notes = notes;
    source.options.strokeAreas = true;
    source.options.strict = strict;
    source.options.curveTolerance = 1e-4;
    return readSvg(source);
}

/// Returns the area of a drawing of 100 by 100 whose strokes are 4 wide.
double area(const std::string &content) {
    CAPTURE(content);
    const auto domain = readStrokes(content);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return areas(*domain).at(1);
}

double areaOf(const std::string &path, const std::string &attributes) {
    return area("<path d=\"" + path + "\" " + attributes + "/>");
}

/// Checks an area that curves bound.
void checkArea(double found, double expected) {
    CHECK(found == doctest::Approx(expected).epsilon(1e-4));
}

} // namespace

TEST_CASE("SVG stroke areas: the ends of a line are cut straight, extended or round") {
    CHECK(areaOf("M10 10H50", "") == doctest::Approx(160));
    CHECK(areaOf("M10 10H50", "stroke-linecap='butt'") == doctest::Approx(160));
    CHECK(areaOf("M10 10H50", "stroke-linecap='square'") == doctest::Approx(176));
    checkArea(areaOf("M10 10H50", "stroke-linecap='round'"), 160 + 4 * kPi);
    CHECK(areaOf("M10 10L40 50", "") == doctest::Approx(200));
    checkArea(areaOf("M10 10C20 10 40 10 50 10", "stroke-linecap='round'"), 160 + 4 * kPi);
}

TEST_CASE("SVG stroke areas: corners are mitred up to a limit, bevelled or round") {
    CHECK(areaOf("M10 10H50V50", "") == doctest::Approx(320));
    CHECK(areaOf("M10 10H50V50", "stroke-linejoin='miter' stroke-miterlimit='1.5'") == doctest::Approx(320));
    CHECK(areaOf("M10 10H50V50", "stroke-miterlimit='1.4'") == doctest::Approx(318));
    CHECK(areaOf("M10 10H50V50", "stroke-linejoin='bevel'") == doctest::Approx(318));
    checkArea(areaOf("M10 10H50V50", "stroke-linejoin='round'"), 316 + kPi);
    CHECK(areaOf("M10 10H50V50H10Z", "") == doctest::Approx(44 * 44 - 36 * 36));
    CHECK(areaOf("M10 10H50H20", "") == doctest::Approx(160)); // turns back
    checkArea(areaOf("M10 10H50H20", "stroke-linejoin='round'"), 160 + 2 * kPi);
}

TEST_CASE("SVG stroke areas: directions rounded in the file make no tiny parts of the boundary") {
    for (const std::string path : {"M10 10H30L50 10.001", "M10 10H30A20 20 0 0 1 49.99 30.6"}) {
        const auto domain = readStrokes("<path d='" + path + "'/>");
        REQUIRE(domain.ok());
        for (const DomainSegment &segment : domain->segments) {
            CHECK(distance(domain->nodes[segment.a], domain->nodes[segment.b]) > 0.05);
        }
    }
    CHECK(readStrokes("<path d='M10 10H30L50 10.001'/>")->segments.size() == 6);
}

TEST_CASE("SVG stroke areas: a path that ends where it begins without being closed has ends there") {
    CHECK(areaOf("M30 10H50V50H10V10H30", "") == doctest::Approx(44 * 44 - 36 * 36));
    CHECK(areaOf("M10 10H50V50H10V10", "") == doctest::Approx(44 * 44 - 36 * 36 - 4));
}

TEST_CASE("SVG stroke areas: along circles, ellipses and cubics") {
    checkArea(area("<circle cx='50' cy='50' r='20'/>"), kPi * (22 * 22 - 18 * 18));
    checkArea(area("<circle cx='50' cy='50' r='1.5'/>"), kPi * 3.5 * 3.5);
    checkArea(areaOf("M10 50A20 20 0 0 1 50 50", ""), 0.5 * kPi * (22 * 22 - 18 * 18));
    // The perimeter of the ellipse, by the series of Ramanujan, times the width.
    const double h = 100.0 / 2500.0;
    const double perimeter = kPi * 50 * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
    checkArea(area("<ellipse cx='50' cy='50' rx='30' ry='20'/>"), 4 * perimeter);
    // A cubic that is a parabola: the arc length of y = x²/40 from -20 to 20.
    const double length = 40 * (0.5 * std::sqrt(2.0) + 0.5 * std::asinh(1.0));
    CHECK(areaOf("M10 10Q30 30 50 10", "") == doctest::Approx(4 * length).epsilon(2e-4));
}

TEST_CASE("SVG stroke areas: beyond the centre of a tight bend, the line across the path sweeps on") {
    // A half turn of radius 5 sweeps a half disc of radius 15 outside and, beyond the centre, one of radius 5.
    checkArea(areaOf("M45 50A5 5 0 0 1 55 50", "stroke-width='20'"), 0.5 * kPi * (15 * 15 + 5 * 5));
    // All but 0.002 radians of a turn; the part beyond the centre fills half of what is missing of the inner disc.
    checkArea(areaOf("M45 50A5 5 0 1 1 45 49.99", "stroke-width='20'"), 15 * 15 * kPi - 0.001 * (15 * 15 - 5 * 5));
    // Found by testing a grid of places.
    CHECK(areaOf("M40 60C40 40 60 40 60 60", "stroke-width='60'") == doctest::Approx(3315).epsilon(0.005));
}

TEST_CASE("SVG stroke areas: the corner at a cusp is round") {
    const double round = areaOf("M20 80C80 20 20 20 80 80", "stroke-width='16' stroke-linejoin='round'");
    CHECK(areaOf("M20 80C80 20 20 20 80 80", "stroke-width='16'") == doctest::Approx(round));
    CHECK(round == doctest::Approx(1649).epsilon(0.003));
}

TEST_CASE("SVG stroke areas: uneven scaling stretches strokes") {
    CHECK(areaOf("M5 10H25", "transform='scale(2 1)'") == doctest::Approx(160));
    CHECK(areaOf("M5 10V50", "transform='scale(2 1)'") == doctest::Approx(320));
    checkArea(areaOf("M5 10H25", "transform='scale(2 1)' stroke-linecap='round'"), 160 + 8 * kPi);
    const auto flat = readStrokes("<path d='M5 10H25' transform='scale(2 0)'/>");
    REQUIRE(flat.ok());
    CHECK(areas(*flat).empty());
}

TEST_CASE("SVG stroke areas: dashes, from an offset on, with ends of their own") {
    CHECK(areaOf("M10 10H50", "stroke-dasharray='10 5'") == doctest::Approx(120));
    CHECK(areaOf("M10 10H50", "stroke-dasharray='10, 5' stroke-dashoffset='5'") == doctest::Approx(100));
    CHECK(areaOf("M10 10H50", "stroke-dasharray='10, 5' stroke-dashoffset='-5'") == doctest::Approx(100));
    CHECK(areaOf("M10 10H50", "stroke-dasharray='8'") == doctest::Approx(96));
    CHECK(areaOf("M10 10H50", "stroke-dasharray='10 0'") == doctest::Approx(160));
    CHECK(areaOf("M10 10H50", "stroke-dasharray='none'") == doctest::Approx(160));
    CHECK(areaOf("M10 10H50", "stroke-dasharray='10 -1'") == doctest::Approx(160));
    CHECK(area("<rect x='20' y='20' width='60' height='60' stroke-width='10' stroke-dasharray='50 17'/>") ==
          doctest::Approx(1895).epsilon(0.001)); // one dash passes through the start
    CHECK(areaOf("M10 10H50V30", "stroke-dasharray='50 100'") == doctest::Approx(200));
    checkArea(areaOf("M10 10H55", "stroke-dasharray='0 10' stroke-linecap='round'"), 5 * 4 * kPi);
    checkArea(areaOf("M30 50A20 20 0 0 1 70 50", "stroke-dasharray='10 200'"), 40);
    CHECK(areaOf("M10 10H50", "stroke-dasharray='1e-5'") == doctest::Approx(160)); // too many
    CHECK(areaOf("M10 10H50", "stroke-dasharray='1 1' pathLength='4'") == doctest::Approx(80));
    CHECK(area("<g stroke-width='9' stroke-dashoffset='3'><path stroke-width='initial' stroke-dashoffset='initial' "
               "stroke-dasharray='10 5' d='M10 10H50'/></g>") == doctest::Approx(30));
    CHECK(area("<g stroke-dasharray='10 5'><path stroke-dasharray='unset' d='M10 10H50'/></g>") ==
          doctest::Approx(120));
    CHECK(area("<g stroke-linejoin='round'><path stroke-linejoin='foo' d='M10 10H50V50'/></g>") ==
          doctest::Approx(316 + kPi).epsilon(1e-4));
    CHECK(area("<g stroke-dasharray='10 5'><path d='M10 10H50'/></g>") == doctest::Approx(120));
}

TEST_CASE("SVG stroke areas: a path without length is a dot, if its ends are not cut straight") {
    checkArea(areaOf("M50 50h0", "stroke-linecap='round'"), 4 * kPi);
    CHECK(areaOf("M50 50z", "stroke-linecap='square'") == doctest::Approx(16));
    CHECK_FALSE(readStrokes("<path d='M50 50h0'/>").ok());
    CHECK_FALSE(readStrokes("<path d='M50 50' stroke-linecap='round'/>").ok());
}

TEST_CASE("SVG stroke areas: strokes and fills are merged and cut at the page") {
    CHECK(area("<rect x='10' y='10' width='20' height='20' fill='black'/>") == doctest::Approx(24 * 24));
    CHECK(area("<rect width='20' height='20' fill='black'/>") == doctest::Approx(22 * 22));
    CHECK(areaOf("M-10 10H10", "") == doctest::Approx(40));
    CHECK(areaOf("M-9000 50H10000", "stroke-dasharray='1000 1000' stroke-dashoffset='1000'") == doctest::Approx(400));
    CHECK(areaOf("M-5000 -50H5000", "stroke-width='110'") == doctest::Approx(500));
    CHECK(area("<path d='M10 10H50'/><path d='M30 0V20'/>") == doctest::Approx(160 + 80 - 16));
    CHECK(areaOf("M10 10H50", "stroke-width='0' /><path d='M10 10H50' stroke-width='2'") == doctest::Approx(80));
}

TEST_CASE("SVG stroke areas: parts of the boundary have the names of their paths") {
    const auto domain = readStrokes("<path id='bar' d='M10 10H50'/><path id='ring' d='M60 60H80V80Z'/>");
    REQUIRE(domain.ok());
    REQUIRE(domain->boundaryNames.size() == 2);
    CHECK(domain->boundaryNames.begin()->second == "bar");
}

TEST_CASE("SVG strokes of width 0 are lines, and a note says so, with or without stroke areas") {
    for (const bool areas : {false, true}) {
        ImportNotes notes;
        const std::string text =
            "<svg viewBox='0 0 9 9'><path fill='none' style='stroke:black;stroke-width:0' d='M1 1H8V8H1z'/></svg>";
        SourceText source = sourceOf(text);
        source.options.strokeAreas = areas;
        source.notes = &notes;
        REQUIRE(readSvg(source).ok());
        const auto coded = [&](const char *code) {
            return std::count_if(notes.entries().begin(), notes.entries().end(),
                                 [code](const ImportNote &note) { return note.code == code; });
        };
        CHECK(coded("svg-zero-stroke") == 1);
        CHECK(coded(kStrokeNote) == 0);
    }
}

TEST_CASE("SVG stroke areas: strokes that do not scale stay lines, with a note") {
    ImportNotes notes;
    const auto domain = readStrokes("<rect width='50' height='50' fill='black' stroke='none'/>"
                                    "<path d='M10 10H40' vector-effect='non-scaling-stroke'/>",
                                    &notes);
    REQUIRE(domain.ok());
    CHECK(areas(*domain).at(1) == doctest::Approx(2500));
    CHECK(notes.entries().front().code == kStrokeNote);
}

TEST_CASE("SVG stroke areas: bends whose radius is half the width of the stroke") {
    // Whether the stroke reaches past a centre of curvature is decided by rounding: all along the circle, and beside
    // the start of the curve, which stands there.
    const std::string circle = "M52 50a2 2 0 0 1-4 0 2 2 0 0 1 4 0z";
    const std::string quarters = "M52 50c0 1.1045695-.8954305 2-2 2s-2-.8954305-2-2 .8954305-2 2-2 2 .8954305 2 2z";
    checkArea(areaOf(circle, ""), 16 * kPi);
    for (int k = -10; k <= 10; ++k) {
        const std::string scale = std::to_string(1.0 + 1e-5 * k);
        CHECK(areaOf(quarters, "transform='scale(" + scale + ")'") == doctest::Approx(16 * kPi).epsilon(6e-4));
    }
    CHECK(areaOf("M79.3 48.6s-4.2 0-6 .3", "stroke-width='1'") == doctest::Approx(6.01).epsilon(1e-3));
}

namespace {

/// Returns the length of the shortest side: a curve or line of the outline.
double shortestSide(const Domain &domain) {
    std::map<std::uint32_t, double> curves;
    double size = 1e300;
    for (const DomainSegment &segment : domain.segments) {
        const double length = distance(domain.nodes[segment.a], domain.nodes[segment.b]);
        if (segment.stretch.follows()) {
            curves[segment.stretch.curve] += length;
        } else {
            size = std::min(size, length);
        }
    }
    for (const auto &[curve, length] : curves) {
        size = std::min(size, length);
    }
    return size;
}

} // namespace

TEST_CASE("SVG stroke areas: bends that files round leave no tiny sides") {
    // A line and arcs, two arcs, a cubic and an arc, all nearly smooth; and a dot written as a short line.
    for (const std::string path :
         {"M10 10H30A10 10 0 0 1 40 20.04A12 12 0 0 1 28 32", "M20 40A15 15 0 0 1 35.03 25V12",
          "M20 52C22 40 30 36 30 28A14 14 0 0 1 44.02 14", "M50 50h.02", "M50 50l.02 .02-.02 0"}) {
        CAPTURE(path);
        const auto domain = readStrokes("<path stroke-linecap='round' d='" + path + "'/>");
        REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
        CHECK(shortestSide(*domain) > 0.5);
    }
    checkArea(areaOf("M10 10H30A10 10 0 0 1 40.01 20.02V40", ""), 222.871); // 4 times its length
    checkArea(areaOf("M50 50h.02", "stroke-linecap='round'"), 4 * kPi + 0.08);
}

TEST_CASE("SVG stroke areas: how the sides of strokes are joined is no change of the file") {
    ImportNotes notes;
    const auto domain = readStrokes("<path d='M10 10H60V60z'/>\n<path d='M20 5V80M5 20Q40 40 80 20'/>\n"
                                    "<rect id='plate' x='10' y='10' width='30' height='20' fill='grey'/>",
                                    &notes, true);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    REQUIRE(notes.entries().size() == 2);
    CHECK(notes.entries()[0].code == "inner-outlines"); // the outline of the rectangle lies inside its stroke
    CHECK(notes.entries()[1].code == "close-nodes");    // a mitre ends beside another stroke
}

TEST_CASE("SVG stroke areas: a path that bends within its width everywhere covers what is near it") {
    // A random walk in steps of about a tenth of the width, with round ends and corners: the points within 2 of it.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> across(-0.5, 0.5), along(0.2, 0.6);
    std::vector<Vec2> nodes{{20.0, 50.0}};
    std::string path = "M20 50";
    for (int k = 0; k < 120; ++k) {
        const Vec2 c1 = nodes.back() + Vec2{across(random), across(random)};
        const Vec2 c2 = nodes.back() + Vec2{across(random), across(random)};
        const Vec2 end = nodes.back() + Vec2{along(random), across(random)};
        path += 'C';
        for (const Vec2 p : {c1, c2, end}) {
            path += exactText(p.x) + ' ' + exactText(p.y) + ' ';
        }
        const Curve curve = Curve::cubic(nodes.back(), c1, c2, end);
        for (int part = 1; part <= 16; ++part) {
            nodes.push_back(curve.point(part / 16.0));
        }
    }
    const auto domain = readStrokes("<path d=\"" + path + "\" stroke-linecap='round' stroke-linejoin='round'/>");
    REQUIRE(domain.ok());
    std::size_t covered = 0;
    constexpr double kStep = 0.05;
    for (double x = 15.0; x < 85.0; x += kStep) {
        for (double y = 40.0; y < 60.0; y += kStep) {
            covered += std::any_of(nodes.begin(), nodes.end(), [&](Vec2 node) {
                return distanceSquared(node, {x, y}) <= 4.0;
            });
        }
    }
    CHECK(areas(*domain).at(1) == doctest::Approx(static_cast<double>(covered) * kStep * kStep).epsilon(2e-3));
}

TEST_CASE("SVG stroke areas: very thin strokes of many parts keep their area, and hidden ones need no change") {
    std::string zigzag = "M10 10";
    double length = 0.0;
    for (int k = 0; k < 30; ++k) {
        zigzag += k % 2 == 0 ? "l2 1" : "l-1 2";
        length += std::sqrt(5.0);
    }
    for (const char *width : {"1e-6", "3e-7", "1e-8"}) {
        CAPTURE(width);
        const double found = areaOf(zigzag, "stroke-linejoin='bevel' stroke-width='" + std::string(width) + "'");
        CHECK(found == doctest::Approx(length * std::stod(width)).epsilon(1e-3));
    }
    const std::string background = "<rect width='100' height='100' fill='black' stroke='none'/>";
    ImportNotes notes;
    const auto strict = readStrokes(background + "<path d='M10 10L50 50M10 50L50 10'/>", &notes, true);
    REQUIRE(strict.ok());
    CHECK(strict->segments.size() == 4);
}

TEST_CASE("SVG stroke areas: malformed limits and dashes count as in browsers, patterns are noted") {
    const std::string corner = "M10 10H50V50", usual = "stroke-linejoin='miter'";
    CHECK(areaOf(corner, "stroke-miterlimit='1.4'") == doctest::Approx(318));
    CHECK(areaOf(corner, "stroke-miterlimit='1.4mm'") == areaOf(corner, usual)); // a limit has no unit
    const double solid = areaOf("M10 10H50", "");
    CHECK(areaOf("M10 10H50", "stroke-dasharray='4, 4'") == doctest::Approx(0.5 * solid));
    CHECK(areaOf("M10 10H50", "stroke-dasharray=' 4 ,4 '") == doctest::Approx(0.5 * solid));
    for (const char *list : {"4, 4,", ",4 4", "4,,4", "4 , , 4"}) {
        CAPTURE(list);
        CHECK(areaOf("M10 10H50", "stroke-dasharray='" + std::string(list) + "'") == doctest::Approx(solid));
    }
    ImportNotes notes;
    const std::string pattern =
        "<defs><pattern id='p' width='1' height='1'><rect width='1' height='1'/></pattern></defs>";
    REQUIRE(readStrokes(pattern + "<path d='M10 10H50' stroke='url(#p)'/>", &notes).ok());
    CHECK(std::any_of(notes.entries().begin(), notes.entries().end(),
                      [](const ImportNote &note) { return note.code == "svg-pattern"; }));
}

TEST_CASE("SVG stroke areas: many strokes that overlap are one area, with the names of their paths") {
    std::string apart, together;
    for (int k = 0; k < 12; ++k) {
        const std::string y = std::to_string(10 + 7 * k), x = std::to_string(12 + 7 * k);
        apart += "<path id='row" + y + "' d='M5 " + y + "H95'/>" + "<path id='column" + x + "' d='M" + x + " 5V95'/>";
        together += "M5 " + y + "H95M" + x + " 5V95";
    }
    const double expected = 24 * 90 * 4 - 144 * 16;
    CHECK(areaOf(together, "") == doctest::Approx(expected));
    const auto domain = readStrokes(apart);
    REQUIRE(domain.ok());
    CHECK(areas(*domain).at(1) == doctest::Approx(expected));
    CHECK(domain->boundaryNames.size() == 24);
    for (const DomainSegment &segment : domain->segments) { // each side has the name of the line that it belongs to
        const std::string &name = domain->boundaryNames.at(segment.tag);
        const Vec2 a = domain->nodes[segment.a], b = domain->nodes[segment.b];
        if (distance(a, b) < 3.5) { // between crossings; the ends are 4 wide
            CHECK(name.starts_with("row") == (a.y == b.y));
        }
    }
}
