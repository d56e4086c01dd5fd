// Joints in sketches: shapes that meet stay together when constraints, dimensions and parameters move one of them.
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_drag.hpp"
#include "core/drawing/constraints/settle.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

namespace {

const std::vector<Vec2> &nodesOf(const Document &document, std::uint32_t shape) {
    return findShape(document, shape)->nodes;
}

/// Two squares with a common border from (4, 0) to (4, 4); the left one stands at its corner and keeps its lower side.
Document neighbours() {
    Document document = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    constrain(document, Kind::Fixed, {node(1, 0)});
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    constrain(document, Kind::Length, {segment(1, 0)});
    return document;
}
constexpr std::uint32_t kLowerSide = 5; ///< id of its length

/// A rectangle of the width w from (0, 0) to (4, 3), and another one beside it.
Document parametricPair(std::vector<Shape> beside) {
    std::vector<Shape> shapes = {makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}})};
    shapes.insert(shapes.end(), beside.begin(), beside.end());
    Document document = documentOf(std::move(shapes));
    document.parameters = {{"w", "4"}};
    document.spacing.names = {{"w", 4.0}};
    return setFormula(document, {NumberOwner::ofShape(1), Quantity::Width, 0}, "w");
}

Result<Document> withWidth(const Document &document, const std::string &width) {
    return overrideParameters(document, {{"w", width}});
}

/// Returns the places of a shape as text, rounded to nine digits.
std::string placesOf(const Document &document, std::uint32_t shape) {
    std::string text;
    for (const Vec2 place : nodesOf(document, shape)) {
        constexpr double kDigits = 1e9;
        text +=
            placeText({std::round(kDigits * place.x) / kDigits + 0.0, std::round(kDigits * place.y) / kDigits + 0.0});
    }
    return text;
}

std::string adviceOf(const Result<Document> &result) {
    return result ? std::string() : result.faults().front().advice;
}

bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("Sketch joints: a dimension moves the border of both neighbours") {
    const Document document = neighbours();
    const Result<Document> wider = setDimension(document, kLowerSide, 5.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(placesOf(*wider, 1) == "(0, 0)(5, 0)(4, 4)(0, 4)");
    CHECK(placesOf(*wider, 2) == "(5, 0)(8, 0)(8, 4)(4, 4)");
    const Result<Document> back = setDimension(*wider, kLowerSide, 4.0);
    REQUIRE(back.ok());
    CHECK(nodesOf(*back, 2)[0] == nodesOf(*back, 1)[1]);
    CHECK(distance(nodesOf(*back, 2)[0], {4, 0}) < 1e-9);
}

TEST_CASE("Sketch joints: several shapes at one place follow, also through a chain of rectangles") {
    Document document = documentOf(
        {makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}}), makeShape(ShapeKind::Rectangle, {{4, 0}, {8, 3}}),
         makeShape(ShapeKind::Rectangle, {{4, 3}, {8, 6}}), makeShape(ShapeKind::Point, {{4, 3}})});
    constrain(document, Kind::Fixed, {node(1, 0)});
    constrain(document, Kind::Length, {segment(1, 0)});
    const Result<Document> wider = setDimension(document, document.constraints.back()->id, 6.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(placesOf(*wider, 1) == "(0, 0)(6, 3)");
    CHECK(placesOf(*wider, 2) == "(6, 0)(8, 3)");
    CHECK(placesOf(*wider, 3) == "(6, 3)(8, 6)");
    CHECK(placesOf(*wider, 4) == "(6, 3)");
}

TEST_CASE("Sketch joints: a drag of a constrained node takes the neighbour along and leads back to the start") {
    const Document document = neighbours();
    const auto start = std::make_shared<const Document>(document);
    const Joints joints(start);
    ConstraintDrag drag(start);
    const auto dragTo = [&](Vec2 to) { return drag.carry(*joints.carry(*setHandle(document, {1, 1}, to))); };
    for (const Vec2 to : {Vec2{4.5, 1.0}, Vec2{9.0, 3.0}, Vec2{3.0, -1.0}}) { // it can only stay where it is
        const Document at = dragTo(to);
        CHECK(distance(nodesOf(at, 1)[1], {4, 0}) < 0.05);
        CHECK(nodesOf(at, 2)[0] == nodesOf(at, 1)[1]);
        checkAllHold(at);
        CHECK(settle(document, at)->shapes == at.shapes);
    }
    CHECK(nodesOf(dragTo({4, 0}), 1) == nodesOf(document, 1));
    CHECK(nodesOf(dragTo({4, 0}), 2) == nodesOf(document, 2));

    const Document free = removeConstraints(document, {kLowerSide});
    const auto freeStart = std::make_shared<const Document>(free);
    ConstraintDrag second(freeStart);
    const Document at = second.carry(*Joints(freeStart).carry(*setHandle(free, {2, 0}, {5.5, 1.0})));
    CHECK(nodesOf(at, 1)[1] == nodesOf(at, 2)[0]);
    CHECK(distance(nodesOf(at, 1)[1], {5.5, 0}) < 0.05); // its lower side stays horizontal
}

TEST_CASE("Sketch joints: a node dragged apart leaves its neighbour, the others keep theirs") {
    const Document document = removeConstraints(neighbours(), {kLowerSide});
    ConstraintDrag drag(std::make_shared<const Document>(document), {{1, 1}});
    const Document at = drag.carry(*setHandle(document, {1, 1}, {5, 0}));
    CHECK(distance(nodesOf(at, 1)[1], {5, 0}) < 1e-9);
    CHECK(nodesOf(at, 2) == nodesOf(document, 2));
    const Result<Document> settled = settleCommand(document, at);
    REQUIRE(settled.ok());
    CHECK(settled->shapes == at.shapes);
}

TEST_CASE("Sketch joints: corners on a neighbour's side stay on it, and the neighbour stays if it can") {
    Document document = documentOf(
        {makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}}), makeShape(ShapeKind::Rectangle, {{4, -2}, {9, 8}})});
    constrain(document, Kind::Length, {segment(1, 0)});
    Result<Document> wider = setDimension(document, 3, 5.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(nodesOf(*wider, 1)[1].x == doctest::Approx(4.0));
    CHECK(nodesOf(*wider, 1)[0].x == doctest::Approx(-1.0));
    CHECK(nodesOf(*wider, 2) == nodesOf(document, 2));

    constrain(document, Kind::Fixed, {node(1, 0)});
    wider = setDimension(document, 3, 5.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(nodesOf(*wider, 1)[1].x == doctest::Approx(5.0));
    CHECK(nodesOf(*wider, 2)[0].x == doctest::Approx(5.0));
    CHECK(nodesOf(*wider, 2)[1] == Vec2{9, 8});
}

TEST_CASE("Sketch joints: nodes on a side that moves stay on it; an end stays between its corners") {
    Shape ending = makeShape(ShapeKind::Polyline, {{7, 2}, {4, 2}}, ShapeUse::Constraint);
    Document document =
        documentOf({square({0, 0}, 4), ending, makeShape(ShapeKind::Polygon, {{4, 1}, {8, 1}, {6, -3}})});
    constrain(document, Kind::Fixed, {node(1, 0)});
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    constrain(document, Kind::Vertical, {segment(1, 1)});
    constrain(document, Kind::Horizontal, {segment(1, 2)});
    constrain(document, Kind::Vertical, {segment(1, 3)});
    constrain(document, Kind::Length, {segment(1, 0)});
    constrain(document, Kind::Length, {segment(1, 1)});
    const std::uint32_t height = document.constraints.back()->id, width = height - 1;
    const Result<Document> wider = setDimension(document, width, 5.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(distance(nodesOf(*wider, 2)[1], {5, 2}) < 1e-9);
    CHECK(distance(nodesOf(*wider, 3)[0], {5, 1}) < 1e-9);
    const Result<Document> lower = setDimension(document, height, 1.5);
    REQUIRE_MESSAGE(lower.ok(), messageOf(lower));
    CHECK(placesOf(*lower, 2) == "(7, 2)(4, 1.5)"); // not beyond the corner
    CHECK(nodesOf(*lower, 3) == nodesOf(document, 3));
}

TEST_CASE("Sketch joints: a parameter moves the neighbour of what has its formula, without any constraint") {
    const Document document = parametricPair({makeShape(ShapeKind::Rectangle, {{4, 0}, {8, 3}}),
                                              makeShape(ShapeKind::Polygon, {{4, 3}, {6, 3}, {5, 5}, {2, 3}})});
    const Result<Document> wider = withWidth(document, "5");
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(nodesOf(*wider, 1) == std::vector<Vec2>{{0, 0}, {5, 3}});
    CHECK(nodesOf(*wider, 2) == std::vector<Vec2>{{5, 0}, {8, 3}});
    CHECK(nodesOf(*wider, 3)[0] == Vec2{5, 3});
    CHECK(nodesOf(*wider, 3)[3].y == doctest::Approx(3.0));
    CHECK(wider->formulas == document.formulas);
    CHECK(withWidth(document, "4")->shapes == document.shapes);
}

TEST_CASE("Sketch joints: a node on an upright side of a rectangle stays on it to the bit") {
    const Document document = parametricPair({makeShape(ShapeKind::Rectangle, {{4, -1}, {8, 5}})});
    for (const char *width : {"3", "5", "3.3", "4.7"}) {
        CAPTURE(std::string(width));
        const Result<Document> settled = withWidth(document, width);
        REQUIRE_MESSAGE(settled.ok(), messageOf(settled));
        const std::vector<Vec2> &left = nodesOf(*settled, 1), &right = nodesOf(*settled, 2);
        CHECK(left[1].x == right[0].x);
        CHECK(left[1].x - left[0].x == doctest::Approx(std::stod(width)).epsilon(1e-14));
    }
}

TEST_CASE("Sketch joints: the ends of an open path that meet stay together") {
    Document document = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {4, 0}, {4, 3}, {0, 0}})});
    document.parameters = {{"w", "0"}};
    document.spacing.names = {{"w", 0.0}};
    document = setFormula(document, {NumberOwner::ofShape(1), Quantity::X, 0}, "w");
    const Result<Document> moved = withWidth(document, "1");
    REQUIRE_MESSAGE(moved.ok(), messageOf(moved));
    CHECK(nodesOf(*moved, 1).front() == Vec2{1, 0});
    CHECK(nodesOf(*moved, 1).back() == Vec2{1, 0});
}

TEST_CASE("Sketch joints: a neighbour that would be turned over is a conflict of joints") {
    const Document document = parametricPair({makeShape(ShapeKind::Rectangle, {{4, 0}, {8, 3}})});
    const Result<Document> over = withWidth(document, "9");
    REQUIRE_FALSE(over.ok());
    CHECK(messageOf(over).find("the joints would make") != std::string::npos);
    CHECK(messageOf(over).find("turned over") != std::string::npos);
    CHECK(withWidth(document, "7").ok());
}

TEST_CASE("Sketch joints: formulas that place both sides of a joint may part them; one side alone takes the other") {
    Document document = parametricPair({square({4, 0}, 3)});
    document.formulas = {{{NumberOwner::ofShape(1), Quantity::Left, 0}, "0*w"},
                         {{NumberOwner::ofShape(1), Quantity::X, 1}, "w"},
                         {{NumberOwner::ofShape(2), Quantity::X, 0}, "8-w"},
                         {{NumberOwner::ofShape(2), Quantity::X, 3}, "8-w"}};
    const Result<Document> apart = withWidth(document, "3");
    REQUIRE_MESSAGE(apart.ok(), messageOf(apart));
    CHECK(nodesOf(*apart, 1)[1] == Vec2{3, 3});
    CHECK(nodesOf(*apart, 2)[0] == Vec2{5, 0});
}

TEST_CASE("Sketch joints: a locked neighbour holds, and is named where nothing else gives way") {
    Document document = neighbours();
    document = *setLocked(document, {2}, true);
    const Result<Document> wider = setDimension(document, kLowerSide, 5.0);
    REQUIRE(!wider.ok());
    CHECK(codeOf(wider) == "constraint-conflict");
    INFO(messageOf(wider));
    CHECK(contains(messageOf(wider), "Length 1"));
    CHECK(contains(messageOf(wider), "the joint of polygon 1 and polygon 2 at (4, 0)"));
    CHECK(contains(adviceOf(wider), "Alt"));
    const Result<Document> free = setDimension(removeConstraints(document, {3}), kLowerSide, 5.0);
    REQUIRE_MESSAGE(free.ok(), messageOf(free));
    CHECK(nodesOf(*free, 1)[0].x == doctest::Approx(-1.0));
}

TEST_CASE("Sketch joints: a contradiction of dimensions across a joint names both and the joint") {
    Document document = documentOf(
        {makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}}), makeShape(ShapeKind::Rectangle, {{4, 0}, {8, 3}})});
    constrain(document, Kind::Length, {segment(1, 1)});
    constrain(document, Kind::Length, {segment(2, 1)}); // equal for now
    CHECK(sketchState(document).redundant.empty());
    const Result<Document> higher = setDimension(document, 3, 5.0);
    REQUIRE(!higher.ok());
    INFO(messageOf(higher));
    CHECK(contains(messageOf(higher), "constraints Length 1, Length 2"));
    CHECK(contains(messageOf(higher), "the joint of rectangle 1 and rectangle 2 at (4, "));
    CHECK(contains(adviceOf(higher), "remove one of them"));
}

TEST_CASE("Sketch joints: an explicit relation that a joint implies is no fault, nor is the joint") {
    Document document = neighbours();
    const std::size_t degrees = sketchState(document).degrees;
    constrain(document, Kind::Coincident, {node(1, 1), node(2, 0)});
    constrain(document, Kind::Coincident, {node(1, 2), node(2, 3)});
    const SketchState state = sketchState(document);
    CHECK(state.redundant.empty());
    CHECK(state.violated.empty());
    CHECK(degrees == 4 + 4); // two nodes of each square
    CHECK(state.degrees == degrees);
    const Result<Document> twice = addConstraint(document, Kind::Coincident, {node(1, 1), node(2, 0)});
    CHECK(codeOf(twice) == "constraint-redundant");
    const Result<Document> wider = setDimension(document, kLowerSide, 5.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(placesOf(*wider, 2) == "(5, 0)(8, 0)(8, 4)(4, 4)");
}

TEST_CASE("Sketch joints: what a joint is tied to counts as determined; all shapes count as free as they are") {
    Document document = documentOf({square({0, 0}, 4), square({4, 0}, 4), square({9, 9}, 1)});
    for (const std::uint32_t k : {0U, 1U, 2U, 3U}) {
        constrain(document, Kind::Fixed, {node(1, k)});
    }
    constexpr std::size_t kApart = 8; // numbers of the square that nothing is tied to
    CHECK(sketchState(document).degrees == 4 + kApart);
    constrain(document, Kind::Horizontal, {segment(2, 0)});
    const SketchState state = sketchState(document);
    CHECK(state.degrees == 3 + kApart); // of two corners, one of them level with the joint
    CHECK(state.isDetermined(node(2, 0)));
    CHECK(state.isDetermined(node(2, 3)));
    CHECK(!state.isDetermined(node(2, 1)));
}

TEST_CASE("Sketch joints: a curved border that two shapes share keeps one curve, with a radius or a control point") {
    Shape left = square({0, 0}, 4), right = square({4, 0}, 4);
    left.path().curves.assign(4, Curve());
    right.path().curves.assign(4, Curve());
    const Vec2 a{4, 0}, b{4, 4}, bulge{4.5, 2};
    left.path().curves[1] = arcThrough(a, bulge, b);
    right.path().curves[3] = arcThrough(b, bulge, a);
    Document document = documentOf({left, right});
    const auto middles = [](const Document &now) {
        return std::pair(findShape(now, 1)->path().curves[1].point(0.5),
                         findShape(now, 2)->path().curves[3].point(0.5));
    };
    Document constrained = document;
    constrain(constrained, Kind::Fixed, {node(1, 1)});
    constrain(constrained, Kind::Fixed, {node(1, 2)});
    constrain(constrained, Kind::Radius, {segment(1, 1)});
    const Result<Document> flat = setDimension(constrained, constrained.constraints.back()->id, 6.0);
    REQUIRE_MESSAGE(flat.ok(), messageOf(flat));
    const auto [first, second] = middles(*flat);
    CHECK(distance(first, second) < 1e-9);
    CHECK(first.x == doctest::Approx(4.0 + 6.0 - std::sqrt(32.0)));

    document.parameters = {{"r", "4.25"}};
    document.spacing.names = {{"r", 4.25}};
    document = setFormula(document, {NumberOwner::ofShape(1), Quantity::ArcRadius, 1}, "r");
    const Result<Document> bent = overrideParameters(document, {{"r", "6"}});
    REQUIRE_MESSAGE(bent.ok(), messageOf(bent));
    CHECK(distance(middles(*bent).first, first) < 1e-9);
    CHECK(distance(middles(*bent).second, first) < 1e-9);

    left.path().curves[1] = Curve::cubic(a, {5, 1}, {5, 3}, b);
    right.path().curves[3] = Curve::cubic(b, {5, 3}, {5, 1}, a);
    Document smooth = documentOf({left, right});
    for (const std::uint32_t k : {0U, 1U, 2U, 3U}) {
        constrain(smooth, Kind::Fixed, {node(1, k)});
    }
    constrain(smooth, Kind::HorizontalDistance, {node(1, 1), {1, SketchPartKind::StartControl, 1}});
    const Result<Document> wide = setDimension(smooth, smooth.constraints.back()->id, 2.0);
    REQUIRE_MESSAGE(wide.ok(), messageOf(wide));
    CHECK(findShape(*wide, 1)->path().curves[1].numbers()[2] == doctest::Approx(6.0));
    CHECK(findShape(*wide, 2)->path().curves[3].numbers()[4] == doctest::Approx(6.0));
}

TEST_CASE("Sketch joints: what constraints do not reach keeps its bits") {
    Document document = documentOf({square({0, 0}, 4), square({4, 0}, 4), square({8, 0}, 4), square({20, 0}, 1)});
    constrain(document, Kind::Fixed, {node(1, 0)});
    constrain(document, Kind::Length, {segment(1, 0)});
    const Result<Document> wider = setDimension(document, document.constraints.back()->id, 5.0);
    REQUIRE_MESSAGE(wider.ok(), messageOf(wider));
    CHECK(nodesOf(*wider, 1)[1] == nodesOf(*wider, 2)[0]);
    CHECK(wider->shapes[2] == document.shapes[2]);
    CHECK(wider->shapes[3] == document.shapes[3]);
}

} // namespace forefront::constraint_test
