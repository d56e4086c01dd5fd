#include "core/drawing/commands/transform.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

Document mapped(const Document &document, const Selection &selection, const PlaneMap &map) {
    Result<Document> result = transformSelection(document, selection, map);
    REQUIRE(result.ok());
    return *std::move(result);
}

/// A path with a line, an arc and a cubic.
Shape curvedPath() {
    Shape path = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 2}});
    path.path().curves = {Curve(), arcThrough({4, 0}, {5, 1}, {4, 2}), Curve::cubic({4, 2}, {3, 4}, {0, 3}, {0, 0})};
    return path;
}

} // namespace

TEST_CASE("PlaneMap: quarter turns and mirrors are exact, and maps compose") {
    const PlaneMap turn = PlaneMap::rotation(90.0, {1, 1});
    CHECK(turn({2, 1}) == Vec2{1, 2});
    CHECK(PlaneMap::rotation(-270.0, {1, 1})({2, 1}) == Vec2{1, 2});
    CHECK(PlaneMap::reflection(90.0, {3, 0})({1, 5}) == Vec2{5, 5});
    CHECK(PlaneMap::reflection(0.0, {0, 2})({1, 5}) == Vec2{1, -1});
    const PlaneMap both = PlaneMap::translation({10, 0}).after(PlaneMap::scaling({2, 3}, {}));
    CHECK(both({1, 1}) == Vec2{12, 3});
    CHECK(PlaneMap::rotation(30.0, {5, 5}).isSimilarity());
    CHECK_FALSE(both.isSimilarity());
}

TEST_CASE("transformSelection: every kind of shape keeps its area under rotation, and scales it as the map says") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{1, 1}, {5, 3}});
    rounded.as<RectangleForm>().radius = 0.5;
    const Document document = documentOf({curvedPath(), makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 1}}), rounded,
                                          makeShape(ShapeKind::Circle, {{2, 2}, {3, 2}}),
                                          makeShape(ShapeKind::Ellipse, {{1, 1}, {3, 1}, {1, 2}}), square({0, 0}, 2)});
    const Selection all = selectAll(document);
    const struct {
        PlaneMap map;
        double area;
    } cases[] = {{PlaneMap::rotation(90.0, {1, 2}), 1.0},     {PlaneMap::rotation(33.0, {1, 2}), 1.0},
                 {PlaneMap::reflection(90.0, {1, 2}), 1.0},   {PlaneMap::scaling({2, 2}, {1, 2}), 4.0},
                 {PlaneMap::scaling({2, -0.5}, {1, 2}), 1.0}, {PlaneMap::scaling({3, 1}, {0, 0}), 3.0}};
    for (const auto &test : cases) {
        CAPTURE(test.map.u);
        const Document result = mapped(document, all, test.map);
        for (std::size_t k = 0; k < document.shapes.size(); ++k) {
            CAPTURE(k);
            CHECK(areaOf(*result.shapes[k]) == doctest::Approx(test.area * areaOf(*document.shapes[k])));
            CHECK(checkShape(*result.shapes[k]).empty());
        }
    }
}

TEST_CASE("transformSelection: shapes keep their kind where the image is of that kind") {
    Shape box = makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 1}});
    box.segmentTags = {1, 2, 3, 4};
    const Document document = documentOf({box, makeShape(ShapeKind::Circle, {{2, 2}, {3, 2}})});
    const Selection all = selectAll(document);
    const Document turned = mapped(document, all, PlaneMap::rotation(90.0, {}));
    CHECK(turned.shapes[0]->kind() == ShapeKind::Rectangle);
    CHECK(turned.shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {-1, 4}});
    CHECK(turned.shapes[0]->segmentTags == std::vector<std::int32_t>{4, 3, 2, 1}); // its lower side was the left one
    CHECK(turned.shapes[1]->kind() == ShapeKind::Circle);
    const Document stretched = mapped(document, all, PlaneMap::scaling({2, 1}, {}));
    CHECK(stretched.shapes[0]->kind() == ShapeKind::Rectangle);
    CHECK(stretched.shapes[1]->kind() == ShapeKind::Ellipse);
    CHECK(stretched.shapes[1]->nodes == std::vector<Vec2>{{4, 2}, {6, 2}, {4, 3}});
    CHECK(mapped(document, all, PlaneMap::rotation(20.0, {})).shapes[0]->kind() == ShapeKind::Polygon);
}

TEST_CASE("transformSelection: single nodes, sources and markers are mapped; a map to a line is refused") {
    Document document = documentOf({square({0, 0}, 2)});
    SizeSource source;
    source.a = {1, 0};
    source.radius = 1.0;
    document.spacing.sources = {source};
    document.regionMarkers = {{{1, 1}, 2, 0.0}};
    Selection some;
    some.nodes = {{1, 2}};
    some.sources = {0};
    some.markers = {0};
    const Document result = mapped(document, some, PlaneMap::scaling({3, 3}, {}));
    CHECK(result.shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {2, 0}, {6, 6}, {0, 2}});
    CHECK(result.spacing.sources[0].a == Vec2{3, 0});
    CHECK(result.spacing.sources[0].radius == doctest::Approx(3.0));
    CHECK(result.regionMarkers[0].at == Vec2{3, 3});
    CHECK(codeOf(transformSelection(document, some, PlaneMap::scaling({1, 0}, {}))) == "bad-number");
}

TEST_CASE("transformSelection: a curve with both ends selected is mapped as in a whole shape") {
    Shape dome = makeShape(ShapeKind::Polyline, {{-1, -2}, {1, 0}, {-1, 0}, {-3, 0}});
    dome.path().curves = {Curve::cubic({-1, -2}, {0, -3}, {2, -1}, {1, 0}), arcThrough({1, 0}, {0, 1}, {-1, 0}),
                          Curve()};
    dome.cuts = {{0.5, 1.0}, {0.5, 1.0}, {}};
    const Document document = documentOf({dome});
    Selection top, nodes;
    top.segments = {{1, 1}};
    nodes.nodes = {{1, 1}, {1, 2}};
    for (const Selection &selection : {top, nodes}) {
        const Shape mirrored = *mapped(document, selection, PlaneMap::reflection(90.0, {})).shapes[0];
        CHECK(mirrored.nodes[1] == Vec2{-1, 0});
        CHECK(mirrored.nodes[2] == Vec2{1, 0});
        CHECK(distance(mirrored.path().curves[1].point(0.5), {0, 1}) < 1e-12); // still a dome, not a bowl
        CHECK(checkShape(mirrored).empty());
        const Shape stretched = *mapped(document, selection, PlaneMap::scaling({1, 3}, {})).shapes[0];
        CHECK(distance(stretched.path().curves[1].point(0.5), {0, 3}) < 1e-12);
        CHECK(stretched.cuts == std::vector<std::vector<double>>{{0.5, 1.0}, {}, {}}); // those of another curve
    }
}

TEST_CASE("transformSelection: all handles of a shape are mapped like the shape itself") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{1, 1}, {5, 3}});
    rounded.as<RectangleForm>().radius = 0.5;
    Shape lens = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}});
    lens.path().curves = {Curve::cubic({0, 0}, {1, -1}, {3, -2}, {4, 0}), arcThrough({4, 0}, {2, 1}, {0, 0})};
    for (const Shape &shape :
         {curvedPath(), lens, rounded, makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 1}}),
          makeShape(ShapeKind::Circle, {{2, 2}, {3, 2}}), makeShape(ShapeKind::Ellipse, {{1, 1}, {3, 1}, {1, 2}})}) {
        CAPTURE(shape.kind());
        const Document document = documentOf({shape});
        Selection nodes, segments;
        for (std::uint32_t k = 0; k < handleCount(shape); ++k) {
            nodes.nodes.insert({1, k});
        }
        for (std::uint32_t k = 0; k < taggedSegments(shape); ++k) {
            segments.segments.insert({1, k});
        }
        for (const PlaneMap &map :
             {PlaneMap::rotation(90.0, {1, 2}), PlaneMap::rotation(33.0, {1, 2}), PlaneMap::reflection(20.0, {1, 2}),
              PlaneMap::scaling({2, -0.5}, {1, 2}), PlaneMap::translation({0.1, 0.7})}) {
            const Shape whole = *mapped(document, selected({1}), map).shapes[0];
            CHECK(*mapped(document, nodes, map).shapes[0] == whole);
            CHECK(*mapped(document, segments, map).shapes[0] == whole);
        }
    }
}

TEST_CASE("alignSelection, distributeSelection: shapes line up at each side, and gaps become equal") {
    const Document document = documentOf({square({0, 0}, 1), square({3, 5}, 2), square({9, 2}, 3)});
    const Selection all = selectAll(document);
    const auto boxes = [&](const Result<Document> &result) {
        REQUIRE(result.ok());
        std::vector<Box2> list;
        for (const auto &shape : result->shapes) {
            list.push_back(boundsOf(*shape));
        }
        return list;
    };
    for (const Box2 &box : boxes(alignSelection(document, all, Alignment::Left))) {
        CHECK(box.min.x == 0.0);
    }
    for (const Box2 &box : boxes(alignSelection(document, all, Alignment::Top))) {
        CHECK(box.max.y == 7.0);
    }
    for (const Box2 &box : boxes(alignSelection(document, all, Alignment::CentreX))) {
        CHECK(box.centre().x == 6.0);
    }
    const std::vector<Box2> spread = boxes(distributeSelection(document, all, true));
    CHECK(spread[0].min.x == 0.0);
    CHECK(spread[1].min.x == doctest::Approx(4.0));
    CHECK(spread[2].min.x == 9.0);
    CHECK(codeOf(alignSelection(document, selected({1}), Alignment::Left)) == "not-possible");
    CHECK(codeOf(distributeSelection(document, selected({1, 2}), true)) == "not-possible");
    Selection nodes;
    nodes.nodes = {{1, 0}, {1, 2}, {2, 1}};
    const Result<Document> row = alignSelection(document, nodes, Alignment::Bottom);
    REQUIRE(row.ok());
    CHECK(row->shapes[0]->nodes[2] == Vec2{1, 0});
    CHECK(row->shapes[1]->nodes[1] == Vec2{5, 0});
}

TEST_CASE("copySelection: copies markers; refuses an empty selection and too many copies") {
    Document document = documentOf({square({0, 0}, 2)});
    document.regionMarkers = {{{1, 1}, 2, 0.5}};
    Selection marker, node, copies;
    marker.markers = {0};
    node.nodes = {{1, 0}};
    const Result<Document> row = linearArray(document, marker, 3, {4, 0}, &copies);
    REQUIRE(row.ok());
    REQUIRE(row->regionMarkers.size() == 3);
    CHECK(row->regionMarkers[2].at == Vec2{9, 1});
    CHECK(row->regionMarkers[2].tag == 2);
    CHECK(copies.markers == std::set<std::uint32_t>{1, 2});
    CHECK(codeOf(linearArray(document, node, 3, {4, 0})) == "not-possible");
    const Document crowd = documentOf(std::vector<Shape>(2000, square({0, 0}, 2)));
    const Result<Document> many = linearArray(crowd, selectAll(crowd), 10000, {1, 0});
    REQUIRE_FALSE(many.ok());
    CHECK(many.faults().front().message == "the copies would have 79992000 nodes; expected at most 1000000");
    CHECK(linearArray(crowd, selectAll(crowd), 5, {1, 0})->shapes.size() == 10000);
}

TEST_CASE("Transformations: messages name the refused value and say what to enter") {
    const Document document = documentOf({square({0, 0}, 2)});
    const auto says = [](const Result<Document> &result, std::string_view text) {
        REQUIRE_FALSE(result.ok());
        CHECK(result.faults().front().message.find(text) != std::string::npos);
        CHECK_FALSE(result.faults().front().advice.empty());
    };
    says(transformSelection(document, selected({1}), PlaneMap::scaling({0, 1}, {})), "multiplied by 0;");
    says(copySelection(document, selected({1}), std::vector{PlaneMap::scaling({0, 1}, {})}), "multiplied by 0;");
    says(linearArray(document, selected({1}), 2.5, {1, 0}), "items 2.5;");
    says(linearArray(document, selected({1}), 3, {0, 0}), "step (0, 0);");
    says(polarArray(document, selected({1}), 3, {}, 400, true), "angle 400;");
}

TEST_CASE("alignSelection: nodes of many shapes, even of circles, each move to the line") {
    const Document document =
        documentOf({makeShape(ShapeKind::Circle, {{4, 0}, {5, 1}}), square({7, 1}, 2),
                    makeShape(ShapeKind::Rectangle, {{2, 5}, {3, 6}}), makeShape(ShapeKind::Point, {{9, 9}})});
    Selection nodes;
    nodes.nodes = {{1, 0}, {1, 1}, {2, 0}, {2, 3}, {3, 2}, {4, 0}, {7, 0}};
    const Result<Document> row = alignSelection(document, nodes, Alignment::Right);
    REQUIRE(row.ok());
    CHECK(row->shapes[0]->nodes == std::vector<Vec2>{{9, 0}, {9, 1}});
    CHECK(row->shapes[1]->nodes == std::vector<Vec2>{{9, 1}, {9, 1}, {9, 3}, {9, 3}});
    CHECK(row->shapes[2]->nodes == std::vector<Vec2>{{2, 5}, {9, 6}});
    CHECK(row->shapes[3]->nodes == std::vector<Vec2>{{9, 9}});
}

TEST_CASE("linearArray, polarArray: copies stand where they should, and are selected") {
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{4, 0}, {5, 0}})});
    Selection made;
    const Result<Document> row = linearArray(document, selected({1}), 4, {3, 1}, &made);
    REQUIRE(row.ok());
    REQUIRE(row->shapes.size() == 4);
    CHECK(row->shapes[3]->nodes[0] == Vec2{13, 3});
    CHECK(made.shapes == std::set<std::uint32_t>{2, 3, 4});
    const Result<Document> ring = polarArray(document, selected({1}), 4, {0, 0}, 360.0, true);
    REQUIRE(ring.ok());
    REQUIRE(ring->shapes.size() == 4);
    CHECK(ring->shapes[1]->nodes == std::vector<Vec2>{{0, 4}, {0, 5}});
    CHECK(ring->shapes[2]->nodes == std::vector<Vec2>{{-4, 0}, {-5, 0}});
    const Result<Document> fan = polarArray(document, selected({1}), 3, {0, 0}, 180.0, false);
    REQUIRE(fan.ok());
    CHECK(fan->shapes[2]->nodes == std::vector<Vec2>{{-4, 0}, {-3, 0}});
    CHECK(codeOf(linearArray(document, selected({1}), 1, {1, 0})) == "bad-number");
    CHECK(codeOf(linearArray(document, selected({1}), 2.5, {1, 0})) == "bad-number");
    CHECK(codeOf(polarArray(document, selected({1}), 3, {0, 0}, 0.0, true)) == "bad-number");
}
