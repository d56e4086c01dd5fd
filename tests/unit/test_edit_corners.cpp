#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/offset_shapes.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/dimensions.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

using std::numbers::pi;

/// Returns the largest turn of a path in one of its nodes, in radians.
double sharpest(const Shape &shape) {
    const Outline outline = outlineOf(shape);
    double worst = 0.0;
    const std::size_t count = outline.segmentCount();
    for (std::size_t k = 0; k < (outline.closed ? count : count - 1); ++k) {
        const Vec2 a = outline.curve(k).tangent(1.0), b = outline.curve((k + 1) % count).tangent(0.0);
        worst = std::max(worst, std::fabs(std::atan2(cross(a, b), dot(a, b))));
    }
    return worst;
}

/// A half disc of radius 2 on a cubic.
Shape mixedPath() {
    Shape path = makeShape(ShapeKind::Polygon, {{-2, 0}, {2, 0}});
    path.path().curves = {Curve::cubic({-2, 0}, {-1, 1}, {1, -1}, {2, 0}), arcThrough({2, 0}, {0, 2}, {-2, 0})};
    path.tag = 3;
    return path;
}

} // namespace

TEST_CASE("filletCorners: a square loses its corners to quarter circles; the sides keep their tags") {
    Shape plate = square({0, 0}, 4);
    plate.segmentTags = {1, 2, 3, 4};
    const Result<Document> result = filletCorners(documentOf({plate}), selected({1}), 1.0);
    REQUIRE(result.ok());
    const Shape &shape = *result->shapes[0];
    CHECK(shape.nodes.size() == 8);
    CHECK(areaOf(shape) == doctest::Approx(16.0 - 4.0 + pi));
    CHECK(sharpest(shape) < 1e-9);
    CHECK(segmentTag(shape, 0) == 4); // the arc at the first corner continues the last side
    CHECK(segmentTag(shape, 1) == 1);
}

TEST_CASE("filletCorners: single nodes, both turns, and a radius that takes whole sides") {
    const Shape arrow = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
    const Document document = documentOf({arrow});
    Selection reflex;
    reflex.nodes = {{1, 3}};
    const Result<Document> inner = filletCorners(document, reflex, 0.5);
    REQUIRE(inner.ok());
    CHECK(inner->shapes[0]->nodes.size() == 6);
    CHECK(areaOf(*inner->shapes[0]) > areaOf(arrow));
    const Result<Document> disc = filletCorners(documentOf({square({0, 0}, 4)}), selected({1}), 2.0);
    REQUIRE(disc.ok());
    CHECK(disc->shapes[0]->nodes.size() == 4);
    CHECK(areaOf(*disc->shapes[0]) == doctest::Approx(4.0 * pi));
    CHECK(codeOf(filletCorners(documentOf({square({0, 0}, 4)}), selected({1}), 2.1)) == "not-possible");
    CHECK(codeOf(filletCorners(document, reflex, 0.0)) == "bad-number");
    CHECK(codeOf(filletCorners(documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})}), selected({1}), 1)) ==
          "not-possible");
}

TEST_CASE("filletCorners: arcs and cubics as sides get a circle that is tangent to both") {
    const Document document = documentOf({mixedPath()});
    for (const double radius : {0.05, 0.2, 0.5}) {
        CAPTURE(radius);
        const Result<Document> result = filletCorners(document, selected({1}), radius);
        REQUIRE(result.ok());
        const Shape &shape = *result->shapes[0];
        CHECK(shape.nodes.size() == 4);
        CHECK(sharpest(shape) < 1e-6);
        CHECK(areaOf(shape) < areaOf(mixedPath()));
        CHECK(validate(toDomain(*result)).empty());
    }
}

TEST_CASE("filletCorners: the ends of an open path stay; selected ends and smooth nodes are refused") {
    const Document document = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {4, 0}, {4, 4}, {4, 6}})});
    const Result<Document> result = filletCorners(document, selected({1}), 1.0);
    REQUIRE(result.ok());
    CHECK(result->shapes[0]->nodes.size() == 5);
    CHECK(lengthOf(*result->shapes[0]) == doctest::Approx(10.0 - 2.0 + 0.5 * pi));
    Selection end, straight;
    end.nodes = {{1, 0}};
    straight.nodes = {{1, 2}};
    CHECK(codeOf(filletCorners(document, end, 1.0)) == "not-possible");
    CHECK(codeOf(filletCorners(document, straight, 1.0)) == "not-possible");
}

TEST_CASE("filletCorners: refuses a rounded rectangle with advice, and a bad number with its value") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}});
    rounded.as<RectangleForm>().radius = 1.0;
    const Result<Document> result = filletCorners(documentOf({rounded}), selected({1}), 0.5);
    REQUIRE_FALSE(result.ok());
    CHECK(result.faults().front().message == "rectangle 1 already has rounded corners");
    CHECK(result.faults().front().advice == "set its radius to 0, or convert it to a path");
    const Result<Document> bad = chamferCorners(documentOf({square({0, 0}, 1)}), selected({1}), -3);
    REQUIRE_FALSE(bad.ok());
    CHECK(bad.faults().front().message == "invalid corner size -3; expected a finite number above 0");
    CHECK_FALSE(bad.faults().front().advice.empty());
}

TEST_CASE("filletCorners, chamferCorners: corners that use up a side, and several shapes at once") {
    const Shape path = makeShape(ShapeKind::Polyline, {{0, 0}, {2, 0}, {2, 2}, {4, 2}});
    const Document document = documentOf({path, square({0, 0}, 2), square({5, 5}, 4)});
    Selection some;
    some.shapes = {3};
    some.nodes = {{1, 2}, {2, 0}};
    const Result<Document> cut = chamferCorners(document, some, 2.0);
    REQUIRE(cut.ok());
    CHECK(cut->shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {2, 0}, {4, 2}});
    CHECK(cut->shapes[1]->nodes == std::vector<Vec2>{{0, 2}, {2, 0}, {2, 2}});
    CHECK(areaOf(*cut->shapes[2]) == doctest::Approx(8.0));
    const Result<Document> ends = chamferCorners(document, selected({1}), 1.0);
    REQUIRE(ends.ok());
    CHECK(ends->shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {1, 0}, {2, 1}, {3, 2}, {4, 2}});
    CHECK(codeOf(chamferCorners(document, selected({1, 9}), 1.0)) == "no-such-shape");
}

TEST_CASE("hasCorners: paths and sharp rectangles, selected as a whole or by a node") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}});
    rounded.as<RectangleForm>().radius = 1.0;
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}}), square({0, 0}, 1), rounded});
    CHECK_FALSE(hasCorners(document, {}));
    CHECK_FALSE(hasCorners(document, selected({1, 3})));
    CHECK(hasCorners(document, selected({1, 2})));
    Selection node;
    node.nodes = {{3, 0}};
    CHECK_FALSE(hasCorners(document, node));
    node.nodes.insert({2, 3});
    CHECK(hasCorners(document, node));
}

TEST_CASE("chamferCorners: cuts at a distance along both sides, straight or curved") {
    const Result<Document> cut = chamferCorners(documentOf({square({0, 0}, 4)}), selected({1}), 1.0);
    REQUIRE(cut.ok());
    CHECK(cut->shapes[0]->nodes.size() == 8);
    CHECK(areaOf(*cut->shapes[0]) == doctest::Approx(14.0));
    const Shape mixed = mixedPath();
    const Result<Document> curved = chamferCorners(documentOf({mixed}), selected({1}), 0.25);
    REQUIRE(curved.ok());
    const Outline outline = outlineOf(*curved->shapes[0]);
    double bent = 0.0;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        bent += outline.isCurved(k) ? outline.curve(k).length() : 0.0;
    }
    CHECK(bent == doctest::Approx(lengthOf(mixed) - 1.0));
    CHECK(codeOf(chamferCorners(documentOf({square({0, 0}, 1)}), selected({1}), 1.5)) == "not-possible");
}

TEST_CASE("offsetShapes: areas follow Steiner's formula outside, and shrink by it inside") {
    Shape plate = square({0, 0}, 4);
    plate.segmentTags = {1, 2, 3, 4};
    plate.name = "plate";
    Selection made;
    const Result<Document> outside = offsetShapes(documentOf({plate}), {1}, 0.5, &made);
    REQUIRE(outside.ok());
    REQUIRE(outside->shapes.size() == 2);
    const Shape &wide = *outside->shapes[1];
    CHECK(made.shapes == std::set<std::uint32_t>{wide.id});
    CHECK(areaOf(wide) == doctest::Approx(16.0 + 16.0 * 0.5 + 0.25 * pi));
    CHECK(wide.name == "plate");
    CHECK(wide.nodes.size() == 8);
    CHECK(sharpest(wide) < 1e-6);
    const Result<Document> inside = offsetShapes(documentOf({plate}), {1}, -0.5);
    REQUIRE(inside.ok());
    REQUIRE(inside->shapes.size() == 2);
    CHECK(areaOf(*inside->shapes[1]) == doctest::Approx(9.0));
    CHECK(inside->shapes[1]->segmentTags.size() == 4);
    CHECK(codeOf(offsetShapes(documentOf({plate}), {1}, -2.5)) == "not-possible");
    CHECK(codeOf(offsetShapes(documentOf({plate}), {1}, 0.0)) == "bad-number");
}

TEST_CASE("offsetShapes: circles, ellipses and mixed paths; parallels stay tangent to their wedges") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}});
    rounded.as<RectangleForm>().radius = 1.0;
    const std::vector<Shape> shapes = {makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}), rounded,
                                       makeShape(ShapeKind::Ellipse, {{0, 0}, {3, 0}, {0, 2}}), mixedPath()};
    for (const Shape &shape : shapes) {
        CAPTURE(shape.kind());
        const double d = 0.3;
        const Result<Document> outside = offsetShapes(documentOf({shape}), {1}, d);
        REQUIRE(outside.ok());
        REQUIRE(outside->shapes.size() == 2);
        CHECK(validate(toDomain(*outside)).empty());
        if (shape.kind() != ShapeKind::Polygon) { // convex, so that the formula holds
            CHECK(areaOf(*outside->shapes[1]) ==
                  doctest::Approx(areaOf(shape) + d * lengthOf(shape) + pi * d * d).epsilon(1e-6));
            const Result<Document> inside = offsetShapes(documentOf({shape}), {1}, -d);
            REQUIRE(inside.ok());
            CHECK(areaOf(*inside->shapes[1]) ==
                  doctest::Approx(areaOf(shape) - d * lengthOf(shape) + pi * d * d).epsilon(1e-6));
        }
        CHECK(outside->shapes[1]->tag == shape.tag);
    }
    const Result<Document> circle = offsetShapes(documentOf({shapes[0]}), {1}, -0.5);
    REQUIRE(circle.ok());
    CHECK(circle->shapes[1]->kind() == ShapeKind::Circle);
    CHECK(circleRadius(*circle->shapes[1]) == doctest::Approx(1.5));
}

TEST_CASE("offsetShapes: a waist that closes divides a shape; an open path becomes a band") {
    const Shape dumbbell =
        makeShape(ShapeKind::Polygon,
                  {{0, 0}, {3, 0}, {3, 1}, {6, 1}, {6, 0}, {9, 0}, {9, 3}, {6, 3}, {6, 2}, {3, 2}, {3, 3}, {0, 3}});
    const Result<Document> inside = offsetShapes(documentOf({dumbbell}), {1}, -0.6);
    REQUIRE(inside.ok());
    CHECK(inside->shapes.size() == 3);
    const Document line = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {4, 0}, {4, 3}})});
    const Result<Document> band = offsetShapes(line, {1}, 0.5);
    REQUIRE(band.ok());
    REQUIRE(band->shapes.size() == 2);
    // Two straight bands of width 1, two half discs at the ends, a quarter disc at the corner less the overlap there.
    CHECK(areaOf(*band->shapes[1]) == doctest::Approx(7.0 + 0.25 * pi + 0.25 * 0.25 * pi - 0.25));
}

TEST_CASE("slotAround: two half circles and two lines around a line") {
    Shape slot = slotAround({1, 1}, {4, 5}, 0.5);
    CHECK(slot.kind() == ShapeKind::Slot);
    CHECK(isSlot(slot));
    CHECK(checkShape(slot).empty());
    CHECK(areaOf(slot) == doctest::Approx(5.0 + 0.25 * pi));
    CHECK(lengthOf(slot) == doctest::Approx(10.0 + pi));
    CHECK(slotAround({1, 1}, {1, 1}, 0.5).kind() == ShapeKind::Circle);
    CHECK(isSlot(slot));
    CHECK_FALSE(isSlot(slotAround({1, 1}, {1, 1}, 0.5)));
    becomePath(slot);
    CHECK(slot.kind() == ShapeKind::Polygon);
    CHECK(areaOf(slot) == doctest::Approx(5.0 + 0.25 * pi));
    Shape turned = slot; // another node is the first one
    std::rotate(turned.nodes.begin(), turned.nodes.begin() + 1, turned.nodes.end());
    std::rotate(turned.path().curves.begin(), turned.path().curves.begin() + 1, turned.path().curves.end());
    CHECK(isSlot(turned));
    Shape straight = slot;
    straight.path().curves[1] = Curve();
    CHECK_FALSE(isSlot(straight));
    const Result<Document> wide =
        transformSelection(documentOf({slot}), {.shapes = {1}}, PlaneMap::scaling({2, 1}, {}));
    REQUIRE(wide.ok());
    CHECK_FALSE(isSlot(*wide->shapes[0])); // its ends are elliptical
}

TEST_CASE("filletCorners: a rectangle rounded at all corners stays a rectangle; a single corner makes it a path") {
    Shape plate = makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}});
    plate.segmentTags = {1, 2, 3, 4};
    const Document document = documentOf({plate});
    Selection corners;
    corners.nodes = {{1, 0}, {1, 1}, {1, 2}, {1, 3}};
    for (const Selection &selection : {selected({1}), corners}) {
        const Result<Document> result = filletCorners(document, selection, 1.0);
        REQUIRE(result.ok());
        const Shape &shape = *result->shapes[0];
        CHECK(shape.kind() == ShapeKind::Rectangle);
        CHECK(shape.as<RectangleForm>().radius == 1.0);
        CHECK(shape.segmentTags == std::vector<std::int32_t>{1, 2, 3, 4, 1, 2, 3, 4}); // each arc as the side before it
        CHECK(areaOf(shape) == doctest::Approx(24.0 - 4.0 + pi));
    }
    CHECK(filletCorners(document, selected({1}), 2.0)->shapes[0]->as<RectangleForm>().radius == 2.0);
    CHECK(codeOf(filletCorners(document, selected({1}), 2.1)) == "not-possible");
    corners.nodes.erase({1, 2});
    CHECK(filletCorners(document, corners, 1.0)->shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(chamferCorners(document, selected({1}), 1.0)->shapes[0]->kind() == ShapeKind::Polygon);
}

TEST_CASE("Slot: handles change the ends and the width; commands that need nodes make it a path") {
    Shape slot = slotAround({0, 0}, {4, 0}, 1.0);
    slot.segmentTags = {1, 2, 3, 4};
    const Document document = documentOf({slot});
    CHECK(handlesOf(slot) == std::vector<Vec2>{{0, 0}, {4, 0}, {2, 1}});
    CHECK(setHandle(document, {1, 2}, {7, -3})->shapes[0]->as<SlotForm>().radius == 3.0);
    CHECK(setHandle(document, {1, 1}, {0, 5})->shapes[0]->nodes[1] == Vec2{0, 5});
    CHECK(codeOf(setHandle(document, {1, 1}, {0, 0})) == "bad-shape");
    CHECK(codeOf(setHandle(document, {1, 1}, {1e-310, 0})) == "bad-shape"); // too near for a direction
    CHECK(setSegmentLength(document, {1, 2}, 6.0)->shapes[0]->nodes[1] == Vec2{6, 0});
    CHECK(codeOf(setSegmentLength(document, {1, 1}, 6.0)) == "not-possible");
    const Shape split = *insertNode(document, {1, 2}, {3, 1})->shapes[0];
    CHECK(split.kind() == ShapeKind::Polygon);
    CHECK(split.nodes.size() == 5);
    CHECK(split.segmentTags == std::vector<std::int32_t>{1, 2, 3, 3, 4});
    const Shape mirrored = *transformSelection(document, selected({1}), PlaneMap::reflection(0.0, {0, 0}))->shapes[0];
    CHECK(mirrored.kind() == ShapeKind::Slot);
    CHECK(mirrored.segmentTags == std::vector<std::int32_t>{3, 2, 1, 4}); // the lower side is now the upper one
    CHECK(transformSelection(document, selected({1}), PlaneMap::scaling({2, 1}, {}))->shapes[0]->kind() ==
          ShapeKind::Polygon);
    CHECK(offsetShapes(document, {1}, 0.5)->shapes[1]->as<SlotForm>().radius == 1.5);
    CHECK(offsetShapes(document, {1}, -0.5)->shapes[1]->as<SlotForm>().radius == 0.5);
    CHECK(codeOf(offsetShapes(document, {1}, -1.5)) == "not-possible");
    CHECK(codeOf(setNodeSize(document, {{1, 0}}, PartSize{0.1, 0.2})) == "no-such-node");
    CHECK(contains(slot, {4.9, 0}));
    CHECK_FALSE(contains(slot, {4.9, 0.9}));
    CHECK(boundsOf(slot) == Box2{{-1, -1}, {5, 1}});
    const Domain domain = toDomain(document);
    CHECK(validate(domain).empty());
    Shape path = slot;
    becomePath(path);
    CHECK(sortedNodes(domain) == sortedNodes(toDomain(documentOf({path})))); // the slots keep their places
}

TEST_CASE("Slot: one without a direction or a width is a single place, which validation reports") {
    for (const Shape &slot : {slotAround({0, 0}, {1e-310, 0}, 1.0), slotAround({0, 0}, {4, 0}, 0.0),
                              slotAround({0, 0}, {4, 0}, std::nan("")), slotAround({0, 0}, {1e-8, 0}, 1e308)}) {
        CHECK_FALSE(checkShape(slot).empty());
        const Outline outline = outlineOf(slot);
        CHECK(std::all_of(outline.nodes.begin(), outline.nodes.end(), isFinite));
        CHECK(isFinite(handlesOf(slot)[1]));
        Document document;
        document.shapes.push_back(std::make_shared<const Shape>(slot));
        CHECK_FALSE(validate(toDomain(document)).empty());
        CHECK(dimensionsOf(document).size() <= 2);
    }
}

TEST_CASE("convertToSlot: a path with the form of a slot becomes one, with the same outline and tags") {
    Shape slot = slotAround({1, 1}, {4, 5}, 0.5);
    slot.segmentTags = {1, 2, 3, 4};
    for (const bool mirrored : {false, true}) {
        CAPTURE(mirrored);
        Document document = documentOf({slot});
        document = *convertToPath(document, 1);
        if (mirrored) { // runs clockwise, and begins with an end
            document = *transformSelection(document, selected({1}), PlaneMap::reflection(0.0, {}));
            Shape turned = *document.shapes[0];
            std::rotate(turned.nodes.begin(), turned.nodes.begin() + 1, turned.nodes.end());
            std::rotate(turned.path().curves.begin(), turned.path().curves.begin() + 1, turned.path().curves.end());
            std::rotate(turned.segmentTags.begin(), turned.segmentTags.begin() + 1, turned.segmentTags.end());
            document = *replaceShape(document, turned);
        }
        const Result<Document> result = convertToSlot(document, 1);
        REQUIRE(result.ok());
        const Shape &made = *result->shapes[0];
        CHECK(made.kind() == ShapeKind::Slot);
        CHECK(made.as<SlotForm>().radius == doctest::Approx(0.5));
        CHECK(areaOf(made) == doctest::Approx(areaOf(slot)));
        const Outline before = outlineOf(*document.shapes[0]), after = outlineOf(made);
        for (std::uint32_t k = 0; k < 4; ++k) {
            for (std::uint32_t s = 0; s < 4; ++s) {
                if (distance(before.curve(k).point(0.5), after.curve(s).point(0.5)) < 1e-9) {
                    CHECK(segmentTag(*document.shapes[0], k) == segmentTag(made, s));
                }
            }
        }
    }
    Document sized = *convertToPath(documentOf({slotAround({1, 1}, {4, 5}, 0.5)}), 1);
    CHECK(codeOf(convertToSlot(documentOf({square({0, 0}, 2)}), 1)) == "not-possible");
    sized = *setNodeSize(sized, {{1, 0}}, PartSize{0.1, 0.2});
    CHECK(codeOf(convertToSlot(sized, 1)) == "not-possible");
}
