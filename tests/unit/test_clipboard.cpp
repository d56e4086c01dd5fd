#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/clipboard.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

const Shape &only(const Result<Document> &drawing) {
    REQUIRE(drawing.ok());
    REQUIRE(drawing->shapes.size() == 1);
    return *drawing->shapes[0];
}

} // namespace

TEST_CASE("Clipboard: what is copied comes back exactly, and other programs see an SVG drawing of it") {
    Shape leaf = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}});
    leaf.path().curves = {Curve::cubic({0, 0}, {1, 1}, {3, 1}, {4, 0}), arcThrough({4, 0}, {2, -1}, {0, 0})};
    leaf.name = "leaf";
    Document document = *addShapes({}, {leaf, makeShape(ShapeKind::Circle, {{7, 7}, {8, 7}})});
    document.regionMarkers = {{{2, 0.1}, 3, 0.0}};
    document.boundaryNames[1] = "edge";
    Selection some;
    some.shapes = {1};
    some.markers = {0};
    const std::string text = clipboardText(document, some);
    CHECK(text.starts_with("<svg"));
    const Result<Document> read = readClipboard(text);
    CHECK(only(read) == *document.shapes[0]);
    CHECK(read->regionMarkers == document.regionMarkers);
    CHECK(read->boundaryNames.at(1) == "edge");
    std::string plain = text; // as after a detour through another program
    plain.erase(plain.find("<metadata"), plain.find("</metadata>") + 11 - plain.find("<metadata"));
    const Result<Document> drawing = readClipboard(plain);
    CHECK(only(drawing).kind() == ShapeKind::Polygon);
    CHECK(areaOf(only(drawing)) == doctest::Approx(areaOf(leaf)).epsilon(1e-3));
    CHECK(clipboardText(document, {}).empty());
}

TEST_CASE("insertCopied: each paste avoids what is there, even for sources and markers alone") {
    const Vec2 step{2, -2};
    Document box = *addShapes({}, {square({0, 0}, 1)}), source, marker;
    source.spacing.sources = {{SourceShape::Line, {1, 1}, {2, 1}, 0.0, 0.1, 0.2, "wake"}};
    marker.regionMarkers = {{{5, 5}, 3, 0.0}};
    for (const Document &copied : {box, source, marker}) {
        Document document = copied;
        for (int k = 1; k <= 3; ++k) {
            Insertion insertion;
            Result<Document> next = insertCopied(document, copied, step, &insertion);
            REQUIRE(next.ok());
            CHECK(boundsOf(*next, insertion.added).min == boundsOf(copied, selectAll(copied)).min + k * step);
            document = *std::move(next);
        }
        CHECK(boundsOf(*insertCopied({}, copied, step, nullptr), selectAll(copied)).min ==
              boundsOf(copied, selectAll(copied)).min);
    }
    const Document far = *addShapes({}, {square({1e9, 1e9}, 10)});
    CHECK(insertCopied(far, far, {1e-9, 0}, nullptr)->shapes.size() == 2); // the step is lost in rounding
}

TEST_CASE("Clipboard: two columns of a spreadsheet, with any separators, become a polygon or a polyline") {
    const std::vector<Vec2> triangle{{0, 0}, {1.5, 0}, {1, 2.25}, {0.25, 1}};
    for (const char *text : {"0\t0\n1.5\t0\n1\t2.25\n0.25\t1\n", "x y\n0 0\n1.5 0\n1 2.25\n0.25 1",
                             "0,0\r\n1.5,0\r\n1,2.25\r\n.25,1\r\n0,0\r\n", "0;0\n1,5;0\n1;2,25\n0,25;1\n",
                             "(0, 0)\n(1.5, 0)\n(1, 2.25)\n(0.25, 1)", "0 0 9\n+1.5 0 9\n1 2.25 9\n0.25 1 9"}) {
        CAPTURE(text);
        const Result<Document> drawing = readClipboard(text);
        CHECK(only(drawing).kind() == ShapeKind::Polygon);
        CHECK(only(drawing).use == ShapeUse::Boundary);
        CHECK(only(drawing).nodes == triangle);
    }
    const Result<Document> open = readClipboard("0 0\n1 0\n2 0\n3 1\n");
    CHECK(only(open).kind() == ShapeKind::Polyline);
    CHECK(only(open).use == ShapeUse::Constraint);
    CHECK(only(readClipboard("-1e-3 2")).kind() == ShapeKind::Point);
}

TEST_CASE("Clipboard: in cells the last point or comma is the decimal sign, and the other separates thousands") {
    const std::vector<std::pair<const char *, Vec2>> cases = {
        {"1.234,5;2,0", {1234.5, 2}}, {"1,234.5\t-2", {1234.5, -2}}, {"1.5,2.5\tnode 7", {1.5, 2.5}},
        {" 1,5 ; 2 ;3", {1.5, 2}},    {"\"1,5e2\"\t7", {150, 7}},    {"1.2.3,4\t5", {123.4, 5}},
        {"1.5, 2.5;", {1.5, 2.5}}};
    for (const auto &[text, place] : cases) {
        CAPTURE(text);
        const Result<Document> drawing = readClipboard(text);
        CHECK(only(drawing).nodes == std::vector<Vec2>{place});
    }
}

TEST_CASE("Clipboard: blank lines divide paths; text without numbers is refused") {
    const Result<Document> two = readClipboard("0 0\n1 0\n\n5 5\n6 6\n7 5\n");
    REQUIRE(two.ok());
    CHECK(two->shapes.size() == 2);
    for (const char *text : {"", "hello", "1\n2\n3\n", "nan inf", "<html><body>1 2</body></html>"}) {
        CAPTURE(text);
        const Result<Document> none = readClipboard(text);
        REQUIRE_FALSE(none.ok());
        CHECK(none.faults().front().code == "no-drawing");
    }
}

TEST_CASE("Clipboard: shapes of other programs that a transformation has flattened can be saved and opened again") {
    for (const char *const flat : {"scale(1 0)", "matrix(1 1 1 1 0 0)", "scale(0 0)"}) {
        CAPTURE(flat);
        const Result<Document> pasted = readClipboard(
            "<svg viewBox=\"0 0 9 9\"><rect width=\"9\" height=\"9\"/><g transform=\"" + std::string(flat) +
            "\"><path d=\"M1 1 A 2 1 0 0 1 3 3 L 5 1 Z\"/><circle cx=\"4\" cy=\"4\" r=\"2\"/></g></svg>");
        REQUIRE(pasted.ok());
        const std::string text = projectText(*pasted);
        const Result<Document> again = parseProject(text, "test");
        REQUIRE(again.ok());
        CHECK(projectText(*again) == text);
    }
}
