#include "core/drawing/picking/dragged_parts.hpp"
#include "core/drawing/picking/pointer_snap.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/platform/steady_seconds.hpp"
#include "ui/workspace/edit_state.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Returns true if a label at the pointer says this.
bool says(Draughtsman &driver, const std::string &words) {
    const auto &labels = driver.editor().canvas().labels();
    return std::any_of(labels.begin(), labels.end(), [&](const auto &label) { return label.text == words; });
}

/// Presses at a place, moves by way of the middle and stays there with the button down.
void grab(Draughtsman &driver, Vec2 from, Vec2 to) {
    driver.press(driver.pixel(from));
    driver.moveToPlace(midpoint(from, to));
    driver.moveToPlace(to);
    driver.frames(3);
}

void draw(Draughtsman &driver, std::vector<Shape> shapes) {
    Document drawing = driver.document();
    for (Shape &shape : shapes) {
        shape.id = drawing.nextId++;
        drawing.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
    }
    driver.context().document.apply(std::move(drawing), "Draw");
    driver.key('V');
    driver.frames(3);
}

Shape shapeOf(ShapeKind kind, std::vector<Vec2> nodes, ShapeUse use = ShapeUse::Constraint) {
    Shape shape;
    shape.form = formOf(kind);
    shape.use = use;
    shape.nodes = std::move(nodes);
    return shape;
}

} // namespace

TEST_CASE("Snapping: a dragged node finds tangents and perpendiculars of its segments, with a word") {
    Draughtsman driver;
    draw(driver, {shapeOf(ShapeKind::Polyline, {{1, 2}, {3, 5.5}}), shapeOf(ShapeKind::Circle, {{6, 4}, {6, 2}}),
                  shapeOf(ShapeKind::Polyline, {{1.2, 7.3}, {4.2, 8.8}})});
    // The tangent from (1, 2) to the upper side of the circle.
    const Vec2 arm = Vec2{6, 4} - Vec2{1, 2};
    const double lift = std::asin(2.0 / length(arm)), way = std::sqrt(dot(arm, arm) - 4.0);
    const double angle = std::atan2(arm.y, arm.x) + lift;
    const Vec2 touch = Vec2{1, 2} + way * Vec2{std::cos(angle), std::sin(angle)};
    grab(driver, {3, 5.5}, touch + Vec2{0.03, -0.02});
    CHECK(says(driver, "tangent"));
    CHECK(distance(driver.document().shapes[0]->nodes[1], touch) < 1e-9);
    const Vec2 along = (1.0 / std::sqrt(5.0)) * Vec2{2, 1};
    const Vec2 foot = Vec2{1.2, 7.3} + dot(Vec2{1, 2} - Vec2{1.2, 7.3}, along) * along;
    CHECK(dot(foot - Vec2{1.2, 7.3}, along) < 0.0); // not on the segment, so there is no perpendicular
    driver.moveToPlace({5.93, 5.96});
    driver.frames(3);
    CHECK_FALSE(says(driver, "tangent"));
    driver.release(driver.pixel({5.93, 5.96}));
    driver.frames(30);
    grab(driver, {1, 2}, {5.5, 0.9});
    driver.release(driver.pixel({5.5, 0.9}));
    driver.frames(30);
    CHECK(driver.document().shapes[0]->nodes[0] != Vec2{1, 2});
}

TEST_CASE("Snapping: a dragged node meets a segment at a right angle and snaps to its own path") {
    Draughtsman driver;
    draw(driver,
         {shapeOf(ShapeKind::Polyline, {{1, 1}, {2.3, 4.2}}), shapeOf(ShapeKind::Polyline, {{4, 1.3}, {8, 3.3}}),
          shapeOf(ShapeKind::Polygon, {{1, 6}, {4, 6}, {4, 8}, {2.5, 9}, {1, 8}}, ShapeUse::Boundary)});
    const Vec2 along = (1.0 / std::sqrt(5.0)) * Vec2{2, 1};
    driver.dragPlaces({1, 1}, {5.03, 5.02});
    REQUIRE(driver.document().shapes[0]->nodes[0] == Vec2{5, 5});
    const Vec2 foot = Vec2{4, 1.3} + dot(Vec2{5, 5} - Vec2{4, 1.3}, along) * along;
    grab(driver, {2.3, 4.2}, foot + Vec2{0.04, 0.05});
    CHECK(says(driver, "perpendicular"));
    CHECK(distance(driver.document().shapes[0]->nodes[1], foot) < 1e-9);
    driver.key(key::kEscape);
    driver.release(driver.pixel(foot));
    driver.frames(30);

    grab(driver, {1, 6}, {3.97, 8.02});
    CHECK(says(driver, "node"));
    CHECK(driver.document().shapes[2]->nodes[0] == Vec2{4, 8});
    driver.moveToPlace({4.03, 7.02});
    driver.frames(3);
    CHECK(says(driver, "midpoint"));
    driver.key(key::kEscape);
    driver.release(driver.pixel({4, 7}));
}

TEST_CASE("Snapping: grid, angles and locks are named at the pointer") {
    Draughtsman driver;
    draw(driver, {shapeOf(ShapeKind::Polyline, {{1, 1}, {4, 4}})});
    grab(driver, {4, 4}, {6.02, 3.01});
    CHECK(says(driver, "grid"));
    driver.type("x");
    driver.frames(2);
    driver.key('X');
    driver.type("5");
    driver.moveToPlace({6.32, 7.29});
    driver.frames(3);
    CHECK(says(driver, "x locked, grid"));
    CHECK(driver.document().shapes[0]->nodes[1].x == 5.0);
    driver.key(key::kEscape);
    driver.key(key::kEscape);
    driver.release(driver.pixel({6, 7}));
    driver.frames(30);
    driver.key('L');
    driver.clickPlace({2, 8});
    driver.editor().input().push(
        {.kind = InputKind::Key, .code = key::kLeftShift, .pressed = true, .modifiers = {Modifiers::kShift}});
    driver.moveToPlace({5.1, 7.05});
    driver.frames(3);
    CHECK(says(driver, "angle 345\xc2\xb0"));
    driver.editor().input().push({.kind = InputKind::Key, .code = key::kLeftShift, .pressed = false});
}

TEST_CASE("Snapping: a shape dragged by a side keeps its nodes on the grid") {
    Draughtsman driver;
    driver.context().snapping.gridStep = 0.5;
    driver.rectangle({1, 1}, {3, 3});
    driver.key('V');
    driver.dragPlaces({2.37, 1}, {5.02, 4.31});
    REQUIRE(driver.document().shapes.size() == 1);
    const Box2 box = boundsOf(*driver.document().shapes[0]);
    CHECK(distance(box.min, {3.5, 4.5}) < 1e-12);
    CHECK(distance(box.max, {5.5, 6.5}) < 1e-12);
}

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*'
TEST_CASE("Bench: a dragged node of a drawing with 10,000 nodes" * doctest::skip()) {
    Draughtsman driver;
    std::vector<Vec2> nodes;
    for (int k = 0; k < 10'000; ++k) {
        const double turn = 2.0 * std::numbers::pi * k / 10'000.0, r = 3.5 + 0.4 * std::sin(40.0 * turn);
        nodes.push_back(Vec2{5, 5} + r * Vec2{std::cos(turn), std::sin(turn)});
    }
    draw(driver, {shapeOf(ShapeKind::Polygon, nodes, ShapeUse::Boundary)});
    driver.context().view.camera.zoom *= 20.0;
    driver.context().view.camera.centre = nodes[0];
    driver.frames(10);
    driver.press(driver.pixel(nodes[0]));
    driver.frames(2);
    std::vector<double> times;
    for (int k = 0; k < 200; ++k) {
        const Pixel to = driver.pixel(nodes[0]) + Pixel(5.0 + 0.3 * k, 0.2 * k);
        driver.editor().input().push({.kind = InputKind::MouseMove, .x = to.x, .y = to.y});
        const double begin = steadySeconds();
        driver.frames(1);
        times.push_back(1e3 * (steadySeconds() - begin));
    }
    driver.release({700, 400});
    const std::uint32_t id = driver.document().shapes[0]->id;
    Selection dragged;
    dragged.nodes = {{id, 0}};
    const PickIndex index(driver.context().document.current());
    SnapQuery query;
    query.tolerance = EditState::reach(driver.context(), 9.0);
    query.gridPitch = 0.01;
    query.lines = linesToNode(driver.document(), dragged, {id, 0});
    query.filter = targetsOfDrag(driver.document(), dragged);
    constexpr int kQueries = 10'000;
    const double begin = steadySeconds();
    for (int k = 0; k < kQueries; ++k) {
        query.at = nodes[static_cast<std::size_t>(k)] + Vec2{0.3, 0.1} * query.tolerance;
        static_cast<void>(snap(index, query));
    }
    std::printf("snap: %.2f us\n", 1e6 * (steadySeconds() - begin) / kQueries);
    std::sort(times.begin(), times.end());
    std::printf("drag of one node of 10000: median %.2f ms, 95 %% %.2f ms a frame\n", times[100], times[190]);
}

} // namespace forefront::test
