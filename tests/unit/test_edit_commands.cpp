#include "core/drawing/commands/join_segments.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using namespace forefront::edit_test;

namespace {} // namespace

TEST_CASE("addShape: refuses invalid shapes and never reuses an id") {
    CHECK(codeOf(addShape({}, makeShape(ShapeKind::Polygon, {{0, 0}, {1, 1}}))) == "bad-shape");
    CHECK(codeOf(addShape({}, makeShape(ShapeKind::Circle, {{1, 1}, {1, 1}}))) == "bad-shape");
    CHECK(codeOf(addShape({}, makeShape(ShapeKind::Rectangle, {{0, 0}, {0, 1}}))) == "bad-shape");
    CHECK(codeOf(addShape({}, makeShape(ShapeKind::Point, {{0, std::nan("")}}))) == "bad-number");
    CHECK(codeOf(addShape({}, makeShape(ShapeKind::Point, {{0, 0}}, ShapeUse::Constraint, 0))) == "bad-tag");
    Document document = documentOf({square({0, 0}, 1), square({2, 0}, 1)});
    document = removeShapes(document, {2});
    CHECK(addShape(document, square({4, 0}, 1))->shapes.back()->id == 3);
}

TEST_CASE("setHandle: a rectangle stays a rectangle, and a circle moves with its centre") {
    const Document document =
        documentOf({makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 2}}), makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        const Result<Document> moved = setHandle(document, {1, corner}, {7, 9});
        REQUIRE(moved.ok());
        const std::vector<Vec2> before = handlesOf(*document.shapes[0]), after = handlesOf(*moved->shapes[0]);
        CHECK(after[corner] == Vec2{7, 9});
        CHECK(after[(corner + 2) % 4] == before[(corner + 2) % 4]);
    }
    const Result<Document> centre = setHandle(document, {2, 0}, {5, 5});
    CHECK(centre->shapes[1]->nodes == std::vector<Vec2>{{5, 5}, {6, 5}});
    CHECK(codeOf(setHandle(document, {2, 2}, {5, 5})) == "no-such-node");
    CHECK(codeOf(setHandle(document, {9, 0}, {5, 5})) == "no-such-shape");
}

TEST_CASE("insertNode: deleting the new node restores the shape with its tags") {
    Shape tagged = square({0, 0}, 4);
    tagged.segmentTags = {1, 2, 3, 4};
    const Document document = documentOf({tagged});
    for (std::uint32_t segment = 0; segment < 4; ++segment) {
        const Result<Document> longer = insertNode(document, {1, segment}, {9, 9});
        REQUIRE(longer.ok());
        CHECK(longer->shapes[0]->nodes.size() == 5);
        CHECK(longer->shapes[0]->nodes[segment + 1] == Vec2{9, 9});
        CHECK(longer->shapes[0]->segmentTags[segment] == longer->shapes[0]->segmentTags[segment + 1]);
        Selection node;
        node.nodes = {{1, segment + 1}};
        CHECK(sameContent(deleteSelection(*longer, node), document));
    }
    CHECK(codeOf(insertNode(document, {1, 4}, {9, 9})) == "no-such-segment");
}

TEST_CASE("insertNode: a rectangle becomes a path, a circle is refused with advice") {
    const Document document =
        documentOf({makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 2}}), makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    const Result<Document> cut = insertNode(document, {1, 1}, {5, 1});
    REQUIRE(cut.ok());
    CHECK(cut->shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(cut->shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {4, 0}, {5, 1}, {4, 2}, {0, 2}});
    const Result<Document> refused = insertNode(document, {2, 0}, {1, 1});
    CHECK(codeOf(refused) == "not-possible");
    CHECK_FALSE(refused.faults().front().advice.empty());
}

TEST_CASE("deleteSelection: removes a shape with too few nodes left") {
    const Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {1, 0}, {0, 1}})});
    Selection node;
    node.nodes = {{1, 0}};
    CHECK(deleteSelection(document, node).shapes.empty());
}

TEST_CASE("deleteSelection: a polygon without two of its segments leaves two polylines with their tags") {
    Shape tagged = square({0, 0}, 4);
    tagged.segmentTags = {1, 2, 3, 4};
    const Document document = documentOf({tagged});
    Selection sides;
    sides.segments = {{1, 1}, {1, 3}};
    const Document open = deleteSelection(document, sides);
    REQUIRE(open.shapes.size() == 2);
    CHECK(open.shapes[0]->kind() == ShapeKind::Polyline);
    CHECK(open.shapes[0]->id != open.shapes[1]->id);
    const Domain domain = toDomain(open);
    REQUIRE(domain.segments.size() == 2);
    CHECK(domain.segments[0].tag == 3);
    CHECK(domain.segments[1].tag == 1);
    sides.segments = {{1, 2}};
    const Document chain = deleteSelection(document, sides);
    REQUIRE(chain.shapes.size() == 1);
    CHECK(chain.shapes[0]->nodes == std::vector<Vec2>{{0, 4}, {0, 0}, {4, 0}, {4, 4}});
    CHECK(chain.shapes[0]->segmentTags == std::vector<std::int32_t>{4, 1, 2});
}

TEST_CASE("moveSelection: moves entire shapes, both ends of segments, sources and markers") {
    Document document = documentOf({square({0, 0}, 1), makeShape(ShapeKind::Rectangle, {{2, 0}, {3, 1}})});
    document = *addSource(document, {SourceShape::Line, {0, 0}, {1, 1}, 0.0, 0.1, 0.2, ""});
    document = *addRegionMarker(document, {{0.5, 0.5}, 3});
    Selection selection;
    selection.segments = {{1, 2}, {2, 0}};
    selection.sources = {0};
    selection.markers = {0};
    const Result<Document> moved = moveSelection(document, selection, {10, 20});
    REQUIRE(moved.ok());
    CHECK(moved->shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {1, 0}, {11, 21}, {10, 21}});
    CHECK(boundsOf(*moved->shapes[1]) == Box2{{12, 1}, {13, 20}});
    CHECK(moved->spacing.sources[0].b == Vec2{11, 21});
    CHECK(moved->regionMarkers[0].at == Vec2{10.5, 20.5});
    CHECK(codeOf(moveSelection(document, selection, {0, std::nan("")})) == "bad-number");
}

TEST_CASE("moveSelection: a circle with centre and point selected moves once") {
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    Selection both;
    both.nodes = {{1, 0}, {1, 1}};
    CHECK(moveSelection(document, both, {2, 3})->shapes[0]->nodes == std::vector<Vec2>{{2, 3}, {3, 3}});
}

TEST_CASE("duplicateSelection: copies lie beside the originals and become the selection") {
    Document document = documentOf({square({0, 0}, 1), square({5, 5}, 1)});
    document = *addSource(document, {SourceShape::Point, {1, 1}, {}, 0.0, 0.1, 0.2, "head"});
    Selection all = selectAll(document), copies;
    const Result<Document> twice = duplicateSelection(document, all, {1, 0}, &copies);
    REQUIRE(twice.ok());
    CHECK(twice->shapes.size() == 4);
    CHECK(copies.shapes == std::set<std::uint32_t>{3, 4});
    CHECK(copies.sources == std::set<std::uint32_t>{1});
    CHECK(twice->shapes[3]->nodes[0] == Vec2{6, 5});
    CHECK(sameContent(deleteSelection(*twice, copies), document));
}

TEST_CASE("setRadius and setSegmentLength keep the direction") {
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{1, 1}, {4, 5}}), square({0, 0}, 2)});
    CHECK(setRadius(document, 1, 10)->shapes[0]->nodes[1] == Vec2{7, 9});
    CHECK(codeOf(setRadius(document, 1, 0)) == "bad-number");
    CHECK(codeOf(setRadius(document, 2, 1)) == "not-possible");
    CHECK(setSegmentLength(document, {2, 0}, 5)->shapes[1]->nodes[1] == Vec2{5, 0});
    CHECK(setSegmentLength(document, {2, 3}, 5)->shapes[1]->nodes[0] == Vec2{0, -3});
    CHECK(codeOf(setSegmentLength(document, {2, 4}, 5)) == "no-such-segment");
    CHECK(codeOf(setSegmentLength(document, {2, 0}, -5)) == "bad-number");
}

TEST_CASE("joinToSegments: where a line ends on other shapes, their segments get a node and keep their tags") {
    Shape tagged = square({0, 0}, 4);
    tagged.segmentTags = {1, 2, 3, 4};
    Document document = documentOf({tagged, makeShape(ShapeKind::Rectangle, {{6, 0}, {8, 4}})});
    const Document before = document;
    document = *addShape(document, makeShape(ShapeKind::Polyline, {{4, 3}, {6, 1}, {6, 3}, {4, 1}, {4, 4}, {2, 2}},
                                             ShapeUse::Constraint));
    const Document joined = joinToSegments(document, 3);
    CHECK(joined.shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {4, 0}, {4, 1}, {4, 3}, {4, 4}, {0, 4}});
    CHECK(joined.shapes[0]->segmentTags == std::vector<std::int32_t>{1, 2, 2, 2, 3, 4});
    CHECK(joined.shapes[1]->kind() == ShapeKind::Polygon);
    CHECK(joined.shapes[1]->nodes == std::vector<Vec2>{{6, 0}, {8, 0}, {8, 4}, {6, 4}, {6, 3}, {6, 1}});
    CHECK(sameContent(joinToSegments(joined, 3), joined));
    CHECK(sameContent(joinToSegments(before, 1), before));
    CHECK(sameContent(joinToSegments(before, 99), before));
}

TEST_CASE("toggleClosed: opening and closing a polygon restores it") {
    Shape tagged = square({0, 0}, 4);
    tagged.segmentTags = {1, 2, 3, 4};
    const Document document = documentOf({tagged});
    const Result<Document> open = toggleClosed(document, 1);
    REQUIRE(open.ok());
    CHECK(open->shapes[0]->kind() == ShapeKind::Polyline);
    CHECK(sortedSegments(toDomain(*open)) == sortedSegments(toDomain(document)));
    CHECK(sameContent(*toggleClosed(*open, 1), document));
}

TEST_CASE("setSegmentTag: equal tags collapse to the tag of the shape") {
    const Document document = documentOf({square({0, 0}, 1), makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    const Result<Document> one = setSegmentTag(document, {{1, 2}, {2, 0}}, 8);
    REQUIRE(one.ok());
    CHECK(one->shapes[0]->segmentTags == std::vector<std::int32_t>{1, 1, 8, 1});
    CHECK(one->shapes[1]->tag == 8);
    const Result<Document> back = setSegmentTag(*one, {{1, 2}, {2, 0}}, 1);
    CHECK(sameContent(*back, document));
    CHECK(boundaryTags(*one) == std::vector<std::int32_t>{1, 8});
    CHECK(codeOf(setSegmentTag(document, {{1, 4}}, 2)) == "no-such-segment");
    CHECK(codeOf(setSegmentTag(document, {{1, 0}}, 0)) == "bad-tag");
    CHECK(codeOf(setShapeTag(document, {1, 77}, 2)) == "no-such-shape");
}

TEST_CASE("Selection: prune drops references to missing items") {
    const Document document = documentOf({square({0, 0}, 1)});
    Selection selection;
    selection.shapes = {1, 5};
    selection.nodes = {{1, 3}, {1, 4}, {9, 0}};
    selection.segments = {{1, 3}, {1, 4}};
    selection.sources = {0};
    selection.markers = {0};
    selection.prune(document);
    CHECK(selection.shapes == std::set<std::uint32_t>{1});
    CHECK(selection.nodes == std::set<NodeRef>{{1, 3}});
    CHECK(selection.segments == std::set<SegmentRef>{{1, 3}});
    CHECK(selection.size() == 3);
}

TEST_CASE("Selection: prune drops hidden and locked shapes with their nodes and segments") {
    Document document = documentOf({square({0, 0}, 1), square({2, 0}, 1), square({4, 0}, 1)});
    document = *setLocked(*setHidden(document, {1}, true), {2}, true);
    Selection selection;
    selection.shapes = {1, 2, 3};
    selection.nodes = {{1, 0}, {2, 0}, {3, 0}};
    selection.segments = {{1, 0}, {2, 0}, {3, 0}};
    selection.prune(document);
    CHECK(selection.shapes == std::set<std::uint32_t>{3});
    CHECK(selection.nodes == std::set<NodeRef>{{3, 0}});
    CHECK(selection.segments == std::set<SegmentRef>{{3, 0}});
}

TEST_CASE("Spacing commands: check their values; blank text means none") {
    const Document document;
    CHECK(setSize(document, 0.5)->spacing.size == 0.5);
    CHECK(setSize(*setSize(document, 0.5), {})->spacing.automatic());
    CHECK(codeOf(setSize(document, 0.0)) == "bad-size");
    CHECK(codeOf(setSize(document, std::nan(""))) == "bad-size");
    CHECK(setExpression(document, "0.1+x").spacing.expression == "0.1+x");
    CHECK_FALSE(setExpression(setExpression(document, "x"), "  ").spacing.expression.has_value());
    CHECK(codeOf(setLimits(document, 2, 1)) == "bad-size");
    CHECK(setLimits(document, 1, 2)->spacing.maximum == 2);
    CHECK(codeOf(setGradation(document, -1)) == "bad-size");
    CHECK(codeOf(addSource(document, {SourceShape::Circle, {}, {}, 0.0, 1, 0.2, ""})) == "bad-source");
    CHECK(codeOf(addSource(document, {SourceShape::Point, {}, {}, 0.0, -1, 0.2, ""})) == "bad-source");
    CHECK(codeOf(addSource(document, {SourceShape::Point, {}, {}, 0.0, 1, -0.2, ""})) == "bad-source");
    CHECK(codeOf(replaceSource(document, 0, {})) == "no-such-source");
    CHECK(codeOf(removeSource(document, 0)) == "no-such-source");
    CHECK(displayName(SizeSource{}, 1) == "point source 2");
}

TEST_CASE("Region commands: markers, names and free tags") {
    Document document = *addRegionMarker({}, {{1, 2}, 4});
    CHECK(codeOf(addRegionMarker(document, {{0, 0}, 0})) == "bad-tag");
    CHECK(freeRegionTag(document) == 5);
    document = *setRegionName(document, 9, "land");
    CHECK(regionTags(document) == std::vector<std::int32_t>{1, 4, 9});
    document = *setRegionName(document, 9, "");
    CHECK(regionTags(document) == std::vector<std::int32_t>{1, 4});
    CHECK(moveRegionMarker(document, 0, {3, 3})->regionMarkers[0].at == Vec2{3, 3});
    CHECK(setRegionTag(document, 0, 7)->regionMarkers[0].tag == 7);
    CHECK(removeRegionMarker(document, 0)->regionMarkers.empty());
    CHECK(codeOf(removeRegionMarker(document, 1)) == "no-such-marker");
    CHECK(codeOf(setCircleTolerance(document, 0)) == "bad-tolerance");
}
