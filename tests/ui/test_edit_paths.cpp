#include "core/drawing/commands/path_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Draws a leaf of two smooth curves from (2, 5) to (8, 5) and back.
void drawLeaf(Draughtsman &driver) {
    driver.key('P');
    driver.dragPlaces({2, 5}, {2, 8});
    driver.dragPlaces({8, 5}, {8, 2});
    driver.key(key::kEnter);
}

} // namespace

TEST_CASE("Pen: a drag makes a smooth node with two control points, and two of them close a path") {
    Draughtsman driver;
    drawLeaf(driver);
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape &leaf = *driver.document().shapes[0];
    CHECK(leaf.kind() == ShapeKind::Polygon);
    CHECK(leaf.nodes == std::vector<Vec2>{{2, 5}, {8, 5}});
    REQUIRE(leaf.path().curves.size() == 2);
    CHECK(leaf.path().curves[0] == Curve::cubic({2, 5}, {2, 8}, {8, 8}, {8, 5}));
    CHECK(leaf.path().curves[1] == Curve::cubic({8, 5}, {8, 2}, {2, 2}, {2, 5}));
    CHECK(driver.undoLabel() == "Draw polygon");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Pen: corners and smooth nodes mix; a click on the first node closes") {
    Draughtsman driver;
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.dragPlaces({9, 1}, {10, 3});
    driver.clickPlace({5, 8});
    driver.clickPlace({1, 1});
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape &shape = *driver.document().shapes[0];
    REQUIRE(shape.path().curves.size() == 3);
    CHECK(shape.path().curves[0] == Curve::cubic({1, 1}, {1, 1}, {8, -1}, {9, 1}));
    CHECK(shape.path().curves[1] == Curve::cubic({9, 1}, {10, 3}, {5, 8}, {5, 8}));
    CHECK(shape.path().curves[2] == Curve());
}

TEST_CASE("Ellipse: drawn from corner to corner of its box, or with typed width and height") {
    Draughtsman driver;
    driver.key('K');
    driver.dragPlaces({1, 2}, {9, 6});
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Ellipse);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{5, 4}, {9, 4}, {5, 6}});
    driver.clickPlace({4, 4});
    driver.moveToPlace({5, 5});
    driver.type("2");
    driver.key(key::kTab);
    driver.type("1");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.document().shapes[1]->nodes == std::vector<Vec2>{{5, 4.5}, {6, 4.5}, {5, 5}});
    CHECK(driver.undoLabel() == "Draw ellipse");
}

TEST_CASE("Rectangle: the corner radius of the options rounds the next one; the inspector changes it") {
    Draughtsman driver;
    driver.key('R');
    driver.fill("options/cornerradius", "1.5");
    driver.dragPlaces({1, 1}, {9, 7});
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 1.5);
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(48.0 - 2.25 * (4.0 - std::numbers::pi)));
    driver.key('V');
    driver.showPanel("inspector");
    driver.fill("inspector/cornerradius", "0.5");
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 0.5);
    driver.click("inspector/topath");
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(driver.document().shapes[0]->nodes.size() == 8);
}

TEST_CASE("Regular polygon: sides from the options, radius and angle typed") {
    Draughtsman driver;
    driver.key('H');
    driver.fill("options/sides", "5");
    driver.clickPlace({5, 5});
    driver.moveToPlace({7, 7});
    driver.type("3");
    driver.key(key::kTab);
    driver.type("90");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape &shape = *driver.document().shapes[0];
    REQUIRE(shape.nodes.size() == 5);
    CHECK(distance(shape.nodes[0], {5, 8}) <= 1e-12);
    for (const Vec2 node : shape.nodes) {
        CHECK(distance(node, {5, 5}) == doctest::Approx(3.0));
    }
}

TEST_CASE("Arc: by three points, and by its ends and a radius") {
    Draughtsman driver;
    driver.key('A');
    driver.clickPlace({2, 5});
    driver.clickPlace({8, 5});
    driver.clickPlace({5, 8});
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape &half = *driver.document().shapes[0];
    CHECK(half.kind() == ShapeKind::Polyline);
    CHECK(half.use == ShapeUse::Constraint);
    REQUIRE(half.path().curves.size() == 1);
    CHECK(half.path().curves[0].length() == doctest::Approx(3.0 * std::numbers::pi));
    driver.clickPlace({2, 2});
    driver.clickPlace({8, 2});
    driver.moveToPlace({5, 1});
    driver.type("5");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    const auto numbers = driver.document().shapes[1]->path().curves[0].numbers();
    CHECK(length({numbers[2], numbers[3]}) == doctest::Approx(5.0));
    CHECK(driver.document().shapes[1]->path().curves[0].point(0.5).y == doctest::Approx(1.0));
    CHECK(driver.undoLabel() == "Draw arc");
}

TEST_CASE("Select: control points of a selected node can be dragged; one drag is one undo step") {
    Draughtsman driver;
    drawLeaf(driver);
    driver.key('V');
    driver.clickPlace({2, 5});
    REQUIRE(driver.context().selection.nodes.size() == 1);
    driver.dragPlaces({2, 8}, {3, 9});
    const Shape &leaf = *driver.document().shapes[0];
    CHECK(leaf.path().curves[0] == Curve::cubic({2, 5}, {3, 9}, {8, 8}, {8, 5}));
    CHECK(leaf.path().curves[1].numbers()[4] ==
          doctest::Approx(1.0)); // the opposite one follows: the node is symmetric
    CHECK(leaf.path().curves[1].numbers()[5] == doctest::Approx(1.0));
    CHECK(driver.context().selection.nodes.size() == 1);
    CHECK(driver.undoLabel() == "Move control point");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->path().curves[0] == Curve::cubic({2, 5}, {2, 8}, {8, 8}, {8, 5}));
}

TEST_CASE("Paths: keys change nodes and segments, split and join") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    const Modifiers shift{Modifiers::kShift};
    driver.key('V');
    driver.clickPlace({9, 9});
    driver.key('Y', shift);
    CHECK(nodeKind(*driver.document().shapes[0], 2) == NodeKind::Symmetric);
    CHECK(driver.undoLabel() == "Symmetric node");
    driver.key('C', shift);
    CHECK(nodeKind(*driver.document().shapes[0], 2) == NodeKind::Corner);
    driver.key('S', shift);
    CHECK(nodeKind(*driver.document().shapes[0], 2) != NodeKind::Corner);
    driver.key('B', shift);
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Polyline);
    CHECK(driver.document().shapes[0]->nodes.front() == Vec2{9, 9});
    driver.context().selection.clear();
    driver.context().selection.nodes = {{1, 0}, {1, 4}};
    driver.key('J', shift);
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Polygon);
    driver.context().selection.clear();
    driver.context().selection.segments = {{1, 2}};
    driver.key('U', shift);
    REQUIRE(driver.document().shapes[0]->path().curves.size() == 4);
    CHECK(driver.document().shapes[0]->path().curves[2].kind() == CurveKind::Cubic);
    driver.key('L', shift);
    CHECK(driver.document().shapes[0]->path().curves[2].kind() == CurveKind::Line);
}

TEST_CASE("Paths: with whole shapes selected, keys change the kind of all their nodes") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    driver.key('V');
    driver.key('A', {Modifiers::kControl});
    REQUIRE(driver.context().selection.nodes.empty());
    for (const auto &[key, kind] : {std::pair('S', NodeKind::Smooth), std::pair('C', NodeKind::Corner)}) {
        driver.key(key, {Modifiers::kShift});
        for (std::uint32_t k = 0; k < 4; ++k) {
            CHECK((nodeKind(*driver.document().shapes[0], k) == NodeKind::Corner) == (kind == NodeKind::Corner));
        }
    }
    driver.key('Z', {Modifiers::kControl});
    CHECK(nodeKind(*driver.document().shapes[0], 3) != NodeKind::Corner);
}

TEST_CASE("Paths: joining two paths leaves no missing shapes in the selection") {
    Draughtsman driver;
    driver.key('L');
    for (const Vec2 start : {Vec2{1, 1}, Vec2{6, 1}}) {
        driver.clickPlace(start);
        driver.clickPlace(start + Vec2{2, 3});
        driver.key(key::kEnter);
    }
    REQUIRE(driver.document().shapes.size() == 2);
    driver.key('V');
    driver.context().selection.clear();
    driver.context().selection.nodes = {{1, 1}, {2, 0}};
    driver.key('J', {Modifiers::kShift});
    REQUIRE(driver.document().shapes.size() == 1);
    for (const NodeRef node : driver.context().selection.nodes) {
        CHECK(node.shape == driver.document().shapes[0]->id);
    }
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kDelete);
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Paths: converting several shapes to paths is one undo step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {3, 3});
    driver.rectangle({5, 5}, {8, 8});
    driver.key('A', {Modifiers::kControl});
    driver.click("menu/Edit");
    driver.click("menu/edit.toPath");
    CHECK(isPath(*driver.document().shapes[0]));
    CHECK(isPath(*driver.document().shapes[1]));
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Rectangle);
    CHECK(driver.document().shapes[1]->kind() == ShapeKind::Rectangle);
}

TEST_CASE("Trim tool: a click removes the part between two crossings, or extends an open end to the next line") {
    Draughtsman driver;
    driver.key('L');
    driver.clickPlace({1, 5});
    driver.clickPlace({9, 5});
    driver.key(key::kEnter);
    for (const double x : {3.0, 6.0}) {
        driver.clickPlace({x, 2});
        driver.clickPlace({x, 8});
        driver.key(key::kEnter);
    }
    driver.key('J');
    CHECK(std::string(driver.context().tools.current().id()) == "trim");
    driver.moveToPlace({4.2, 5});
    driver.settle(); // or the node spacing would come with the second picture
    const Driver::Picture before = driver.picture();
    driver.moveToPlace({4.2, 6.5});
    // The part between the lines was shown, and is not now; the picture beside it is as before.
    const auto along = [&](Vec2 from, Vec2 to) {
        const Pixel a = driver.pixel(from), b = driver.pixel(to);
        return PixelRect{a.x, a.y - 2.0, b.x - a.x, 5.0};
    };
    const Driver::Picture after = driver.picture();
    CHECK(after.differences(before, along({4.6, 5}, {5.8, 5})) > 100);
    CHECK(after.differences(before, along({6.2, 5}, {8.8, 5})) == 0);
    driver.clickPlace({4.2, 5});
    CHECK(driver.undoLabel() == "Trim");
    REQUIRE(driver.document().shapes.size() == 4);
    CHECK(driver.document().shapes[0]->nodes.back().x == doctest::Approx(3));
    driver.clickPlace({8.9, 5});
    driver.clickPlace({2, 5}); // what is left ends at the crossing, and extended it meets nothing
    CHECK(driver.document().shapes.size() == 4);
    driver.key('L');
    driver.clickPlace({7, 3});
    driver.clickPlace({8, 3});
    driver.key(key::kEnter);
    driver.key('J');
    driver.clickPlace({7, 3});
    CHECK(driver.undoLabel() == "Extend");
    CHECK(driver.document().shapes.back()->nodes.front().x == doctest::Approx(6));
    driver.clickPlace({8, 3});
    CHECK(driver.undoLabel() == "Extend"); // nothing in its way: refused
}

TEST_CASE("Pen: choosing another tool keeps a path that is too short, and undo brings it back with its tool") {
    Draughtsman driver;
    driver.key('P');
    driver.clickPlace({2, 2});
    driver.moveToPlace({4, 2});
    driver.type("3");
    driver.key(key::kEnter);
    driver.key('R');
    const auto tool = [&] { return std::string(driver.context().tools.current().id()); };
    CHECK(tool() == "rectangle");
    CHECK(driver.document().shapes.empty());
    CHECK(driver.logHas("unfinished-path"));
    driver.key('Z', {Modifiers::kControl});
    CHECK(tool() == "polygon");
    driver.clickPlace({2, 6});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{2, 2}, {5, 2}, {2, 6}});
}

TEST_CASE("Pen: undo does not bring back a discarded path once another tool has begun a shape") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('P');
    driver.clickPlace({2, 2});
    driver.clickPlace({4, 2});
    driver.key(key::kEscape);
    driver.key('U');
    driver.clickPlace({3, 5});
    driver.clickPlace({6, 5});
    driver.key('R'); // drops the slot
    driver.key('Z', {Modifiers::kControl});
    CHECK(std::string(driver.context().tools.current().id()) == "rectangle");
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Select: the end of a line that is dropped on a side becomes a node of both, in one step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('L');
    driver.clickPlace({3, 3});
    driver.clickPlace({5, 5});
    driver.key(key::kEnter);
    driver.key('V');
    driver.dragPlaces({5, 5}, {8.97, 6.3});
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    const Shape &side = *driver.document().shapes[0], &line = *driver.document().shapes[1];
    const Vec2 end = line.nodes.back();
    CHECK(end.x == 9.0);
    CHECK(std::find(side.nodes.begin(), side.nodes.end(), end) != side.nodes.end());
    CHECK(driver.context().preview->faults.empty());
    CHECK(driver.context().selection.nodes == std::set<NodeRef>{{line.id, 1}});
    CHECK(driver.undoLabel() == "Move node");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Rectangle);
    CHECK(driver.document().shapes[1]->nodes.back() == Vec2{5, 5});
}
