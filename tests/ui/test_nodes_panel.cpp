#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Draws two squares that share a corner, (3.25, 3), selects the first one and shows its nodes.
void tabulate(Draughtsman &driver) {
    Shape left, right;
    left.nodes = {{1, 1}, {3, 1}, {3.25, 3}, {1, 3.123456789012}};
    right.nodes = {{3.25, 3}, {5, 3}, {5, 5}, {3, 5}};
    driver.context().document.apply(*addShapes({}, {left, right}), "Draw");
    driver.context().selection.shapes = {1};
    driver.showPanel("nodes");
    driver.settle();
}

} // namespace

TEST_CASE("Nodes panel: all digits, and a typed place moves the node with those joined to it in one step") {
    Draughtsman driver;
    tabulate(driver);
    REQUIRE(driver.has("nodes/1/3/x"));
    CHECK_FALSE(driver.has("nodes/2/1/x"));
    driver.fill("nodes/1/3/x", "3.5");
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{3.5, 3});
    CHECK(driver.document().shapes[1]->nodes[0] == Vec2{3.5, 3});
    CHECK(driver.undoLabel() == "Move node");
    driver.key('Z', kControl);
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{3.25, 3});
    CHECK(driver.document().shapes[1]->nodes[0] == Vec2{3.25, 3});
    driver.click("nodes/copy");
    CHECK(driver.platform().clipboard() ==
          "shape\tnode\tx\ty\n1\t1\t1\t1\n1\t2\t3\t1\n1\t3\t3.25\t3\n1\t4\t1\t3.123456789012\n");
    driver.click("nodes/which/All shapes");
    driver.settle();
    CHECK(driver.has("nodes/2/1/x"));
}

TEST_CASE("Nodes panel: a refused text stays in its field, and a click on a number selects the node") {
    Draughtsman driver;
    tabulate(driver);
    driver.fill("nodes/1/2/y", "abc");
    CHECK(driver.has("nodes/1/2/y/fault"));
    CHECK(driver.document().shapes[0]->nodes[1] == Vec2{3, 1});
    driver.key('A', kControl);
    driver.type("1/2");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().shapes[0]->nodes[1] == Vec2{3, 0.5});
    driver.click("nodes/1/4");
    driver.settle();
    CHECK(driver.context().selection.nodes == std::set<NodeRef>{{1, 3}});
    CHECK(driver.has("nodes/1/4/x"));
}

TEST_CASE("Nodes panel: a pasted table is one step; a line at fault is corrected in place, and nothing moves before") {
    Draughtsman driver;
    tabulate(driver);
    driver.platform().setClipboard("1\t1\n3\t1\n4,5\tthree\n1\t3\n");
    driver.click("nodes/paste");
    driver.settle();
    REQUIRE(driver.has("nodes/fault"));
    REQUIRE(driver.has("nodes/pasted/2"));
    CHECK_FALSE(driver.has("nodes/pasted/1"));
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{3.25, 3});
    driver.click("nodes/pasted/2");
    driver.key('A', kControl);
    driver.type("4,5; two");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.has("nodes/pasted/2"));
    driver.click("nodes/pasted/2");
    driver.key('A', kControl);
    driver.type("4,5; 2,5"); // the table has tabs, which fields do not take
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("nodes/fault"));
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{1, 1}, {3, 1}, {4.5, 2.5}, {1, 3}});
    CHECK(driver.document().shapes[1]->nodes[0] == Vec2{4.5, 2.5}); // joined
    CHECK(driver.undoLabel() == "Place 2 nodes");
    driver.key('Z', kControl);
    CHECK(driver.document().shapes[0]->nodes[3] == Vec2{1, 3.123456789012});
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{3.25, 3});
}

TEST_CASE("Nodes panel: a pasted table can be tried again, and another document clears it") {
    Draughtsman driver;
    tabulate(driver);
    driver.context().selection.clear();
    driver.settle();
    driver.platform().setClipboard("1\t1\n3\t1\n4\t3\n1\t3\n");
    driver.click("nodes/paste");
    driver.settle();
    REQUIRE(driver.has("nodes/fault")); // two columns are the nodes of one shape
    driver.context().selection.shapes = {1};
    driver.settle();
    driver.click("nodes/again");
    driver.settle();
    CHECK_FALSE(driver.has("nodes/fault"));
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{4, 3});
    driver.platform().setClipboard("1\tone\n");
    driver.click("nodes/paste");
    driver.settle();
    REQUIRE(driver.has("nodes/fault"));
    driver.context().document.load(driver.document(), {});
    driver.settle();
    CHECK_FALSE(driver.has("nodes/fault"));
}

TEST_CASE("Nodes panel: a table of a large shape draws the rows in sight") {
    Draughtsman driver;
    Shape shape;
    shape.form = formOf(ShapeKind::Polyline);
    for (int k = 0; k < 20000; ++k) {
        shape.nodes.push_back({0.001 * k, k % 2 == 0 ? 0.0 : 1.0});
    }
    driver.context().document.apply(*addShape({}, shape), "Draw");
    driver.context().selection.shapes = {1};
    driver.showPanel("nodes");
    driver.settle();
    CHECK(driver.has("nodes/1/1/x"));
    CHECK_FALSE(driver.has("nodes/1/200/x"));
}
