#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Draws a triangle to which later nodes may be level, and finds relations.
void drawReference(Draughtsman &driver) {
    Shape shape;
    shape.nodes = {{1, 1}, {3, 1}, {3, 3}};
    driver.context().document.apply(*addShape({}, shape), "Draw");
    driver.context().snapping.infers = true;
    driver.context().snapping.toGrid = false;
    driver.settle();
}

/// Clicks at a place some pixels away from where it is.
void clickNear(Draughtsman &driver, Vec2 place, Pixel away) {
    driver.clickAt(driver.pixel(place) + away);
    driver.frames(30);
}

const Shape &drawn(Draughtsman &driver) {
    REQUIRE(driver.document().shapes.size() == 2);
    return *driver.document().shapes[1];
}

} // namespace

TEST_CASE("Relations: corners of rectangles and centres of circles are level with nodes; Ctrl refuses") {
    Draughtsman driver;
    drawReference(driver);
    driver.key('R');
    clickNear(driver, {5, 1}, {0, 3});
    clickNear(driver, {6, 3}, {0, 3});
    CHECK(drawn(driver).nodes[0].y == 1.0);
    CHECK(drawn(driver).nodes[1].y == 3.0);
    driver.key('Z', kControl);
    driver.key('C');
    clickNear(driver, {5, 3}, {0, -3});
    clickNear(driver, {7, 4}, {0, 0});
    CHECK(drawn(driver).nodes[0].y == 3.0);
    driver.key('Z', kControl);
    driver.key('C');
    driver.hold(kControl, true);
    clickNear(driver, {5, 3}, {0, -3});
    driver.hold(kControl, false);
    clickNear(driver, {7, 4}, {0, 0});
    CHECK(drawn(driver).nodes[0].y != 3.0);
}

TEST_CASE("Relations: a circle gets the radius of a circle beside it, and Ctrl refuses it") {
    Draughtsman driver;
    driver.context().document.apply(*addShape({},
                                              [] {
                                                  Shape circle;
                                                  circle.form = CircleForm{};
                                                  circle.nodes = {{2.5, 2.5}, {4.5, 2.5}};
                                                  return circle;
                                              }()),
                                    "Draw");
    driver.context().snapping.infers = true;
    driver.context().snapping.addsConstraints = true;
    driver.context().snapping.toGrid = false;
    driver.settle();
    driver.key('C');
    clickNear(driver, {6.1, 5.2}, {0, 0});
    clickNear(driver, {8.1, 5.2}, {1, 1});
    CHECK(circleRadius(drawn(driver)) == doctest::Approx(2.0).epsilon(1e-9));
    REQUIRE(driver.document().constraints.size() == 1);
    CHECK(driver.document().constraints[0]->kind == ConstraintKind::Equal);
    driver.key('Z', kControl);
    driver.key('C');
    clickNear(driver, {6.1, 5.2}, {0, 0});
    driver.hold(kControl, true);
    clickNear(driver, {8.1, 5.2}, {1, 1});
    driver.hold(kControl, false);
    CHECK(circleRadius(drawn(driver)) != doctest::Approx(2.0).epsilon(1e-9));
    CHECK(driver.document().constraints.empty());
}

TEST_CASE("Relations: the axis of a slot and the first radius of a regular polygon become horizontal") {
    Draughtsman driver;
    drawReference(driver);
    driver.key('U');
    clickNear(driver, {5, 6.5}, {0, 0});
    clickNear(driver, {8, 6.5}, {0, 3});
    clickNear(driver, {7, 7.2}, {0, 0});
    CHECK(drawn(driver).nodes[0].y == drawn(driver).nodes[1].y);
    driver.key('Z', kControl);
    driver.key('H');
    clickNear(driver, {6, 6.5}, {0, 0});
    clickNear(driver, {8, 6.5}, {0, 3});
    const std::vector<Vec2> &nodes = drawn(driver).nodes;
    Vec2 centre;
    for (const Vec2 node : nodes) {
        centre = centre + (1.0 / static_cast<double>(nodes.size())) * node;
    }
    CHECK(nodes[0].y == doctest::Approx(centre.y).epsilon(1e-12));
}

TEST_CASE("Relations: tangent arcs keep their tangents, and the closing side its direction, as constraints") {
    Draughtsman driver;
    driver.context().snapping.addsConstraints = true;
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.clickPlace({4, 1});
    driver.key('A'); // tangent to the side before
    driver.clickPlace({4, 3});
    driver.key('L');
    driver.clickPlace({1, 3});
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    std::vector<std::vector<SketchPart>> tangents;
    bool upright = false;
    for (const auto &constraint : driver.document().constraints) {
        if (constraint->kind == ConstraintKind::Tangent) {
            tangents.push_back(constraint->parts);
        }
        upright = upright || (constraint->kind == ConstraintKind::Vertical &&
                              constraint->parts == std::vector<SketchPart>{{1, SketchPartKind::Segment, 3}});
    }
    CHECK(upright);
    REQUIRE(tangents.size() == 2);
    CHECK(tangents[0] == std::vector<SketchPart>{{1, SketchPartKind::Segment, 0},
                                                 {1, SketchPartKind::Segment, 1},
                                                 {1, SketchPartKind::Node, 1},
                                                 {1, SketchPartKind::Node, 1}});
    CHECK(tangents[1] == std::vector<SketchPart>{{1, SketchPartKind::Segment, 2},
                                                 {1, SketchPartKind::Segment, 1},
                                                 {1, SketchPartKind::Node, 2},
                                                 {1, SketchPartKind::Node, 2}});
    // A dragged node keeps them.
    driver.key('V');
    driver.key(key::kEscape);
    driver.dragPlaces({4, 1}, {5, 0.6});
    driver.settle();
    const Outline outline = outlineOf(*driver.document().shapes[0]);
    for (const std::size_t k : {1U, 2U}) {
        CHECK(std::fabs(cross(outline.curve(k - 1).tangent(1.0), outline.curve(k).tangent(0.0))) < 1e-6);
    }
    CHECK(driver.document().shapes[0]->nodes[0].x == driver.document().shapes[0]->nodes[3].x);
}
