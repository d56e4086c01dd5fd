// Joined nodes stay together while they are dragged, nudged, typed, inserted and deleted in the editor.
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront::test {
namespace {

constexpr Modifiers kAltDrag{Modifiers::kAlt};

/// Two squares with a common border from (4, 2) to (4, 5), and the select tool.
class TwoSquares : public Draughtsman {
  public:
    TwoSquares() {
        polygon({{1, 2}, {4, 2}, {4, 5}, {1, 5}});
        polygon({{4, 2}, {7, 2}, {7, 5}, {4, 5}});
        key('V');
        context().selection.clear();
        settle();
        REQUIRE(document().shapes.size() == 2);
        REQUIRE(left() == std::vector<Vec2>{{1, 2}, {4, 2}, {4, 5}, {1, 5}});
        REQUIRE(right() == std::vector<Vec2>{{4, 2}, {7, 2}, {7, 5}, {4, 5}});
        steps_ = context().document.history().position();
    }
    const std::vector<Vec2> &left() { return document().shapes[0]->nodes; }
    const std::vector<Vec2> &right() { return document().shapes[1]->nodes; }
    std::size_t newSteps() { return context().document.history().position() - steps_; }
    void undo() {
        key('Z', kControl);
        settle();
    }
    void lockRight() {
        context().applyCommand(setLocked(document(), {document().shapes[1]->id}, true), "Lock");
        settle();
        steps_ = context().document.history().position();
    }
    bool labelHas(std::string_view text) {
        for (const CanvasPainter::Placed &label : editor().canvas().labels()) {
            if (label.text.find(text) != std::string::npos) {
                return true;
            }
        }
        return false;
    }

  private:
    std::size_t steps_ = 0;
};

} // namespace

TEST_CASE("Joints: dragging a shared node moves it in both shapes, as one undo step") {
    TwoSquares driver;
    driver.dragPlaces({4, 5}, {5, 6});
    driver.settle();
    CHECK(driver.left() == std::vector<Vec2>{{1, 2}, {4, 2}, {5, 6}, {1, 5}});
    CHECK(driver.right() == std::vector<Vec2>{{4, 2}, {7, 2}, {7, 5}, {5, 6}});
    CHECK(driver.newSteps() == 1);
    CHECK(driver.undoLabel() == "Move node");
    driver.undo();
    CHECK(driver.left()[2] == Vec2{4, 5});
    CHECK(driver.right()[3] == Vec2{4, 5});
}

TEST_CASE("Joints: with Alt, a drag detaches the node") {
    TwoSquares driver;
    driver.drag(driver.pixel({4, 5}), driver.pixel({5, 6}), 8, kAltDrag);
    driver.settle();
    const bool leftMoved = driver.left()[2] == Vec2{5, 6}, rightMoved = driver.right()[3] == Vec2{5, 6};
    CHECK(leftMoved != rightMoved);
    CHECK((leftMoved ? driver.right()[3] : driver.left()[2]) == Vec2{4, 5});
    CHECK(driver.newSteps() == 1);
    CHECK(driver.context().tools.current().id() == std::string_view("select"));
}

TEST_CASE("Joints: the result does not depend on the way of the pointer") {
    TwoSquares driver;
    driver.press(driver.pixel({4, 5}));
    driver.moveToPlace({6, 7});
    driver.moveToPlace({2, 4});
    driver.moveToPlace({5, 6});
    driver.release(driver.pixel({5, 6}));
    driver.settle();
    CHECK(driver.left() == std::vector<Vec2>{{1, 2}, {4, 2}, {5, 6}, {1, 5}});
    CHECK(driver.right() == std::vector<Vec2>{{4, 2}, {7, 2}, {7, 5}, {5, 6}});
    CHECK(driver.newSteps() == 1);
}

TEST_CASE("Joints: a dragged shape takes the common border along, a detached one does not") {
    TwoSquares driver;
    driver.dragPlaces({7, 3.3}, {8, 3.3});
    driver.settle();
    CHECK(driver.left() == std::vector<Vec2>{{1, 2}, {5, 2}, {5, 5}, {1, 5}});
    CHECK(driver.right() == std::vector<Vec2>{{5, 2}, {8, 2}, {8, 5}, {5, 5}});
    driver.drag(driver.pixel({8, 3.3}), driver.pixel({9, 3.3}), 8, kAltDrag);
    driver.settle();
    CHECK(driver.left() == std::vector<Vec2>{{1, 2}, {5, 2}, {5, 5}, {1, 5}});
    CHECK(driver.right() == std::vector<Vec2>{{6, 2}, {9, 2}, {9, 5}, {6, 5}});
}

TEST_CASE("Joints: nudged and typed nodes take joined ones along") {
    TwoSquares driver;
    driver.clickPlace({4, 5});
    driver.key(key::kUp, kShift);
    driver.settle();
    CHECK(driver.left()[2].y > 5.0);
    CHECK(driver.left()[2] == driver.right()[3]);
    driver.fill("inspector/at/x", "4.5");
    driver.fill("inspector/at/y", "5.75");
    CHECK(driver.left()[2] == Vec2{4.5, 5.75});
    CHECK(driver.right()[3] == Vec2{4.5, 5.75});
    CHECK(driver.newSteps() == 3);
    driver.undo();
    CHECK(driver.left()[2].y != 5.75);
    CHECK(driver.left()[2] == driver.right()[3]);
}

TEST_CASE("Joints: a node of a border is inserted and deleted on both sides; a joint that others need stays") {
    TwoSquares driver;
    driver.doubleClickPlace({4, 3.2});
    driver.settle();
    REQUIRE(driver.left().size() == 5);
    REQUIRE(driver.right().size() == 5);
    CHECK(driver.left()[2] == driver.right()[4]);
    driver.key(key::kDelete);
    driver.settle();
    CHECK(driver.left().size() == 4);
    CHECK(driver.right().size() == 4);
    CHECK(driver.newSteps() == 2);
    driver.clickPlace({4, 5});
    driver.key(key::kDelete);
    driver.settle();
    CHECK(driver.left().size() == 4);
    CHECK(driver.right().size() == 4);
    CHECK(driver.newSteps() == 2);
    CHECK(driver.logHas("joined-node"));
    CHECK(driver.context().selection.nodes.size() == 1);
}

TEST_CASE("Joints: a node joined with a locked shape does not move, and the reason is at the pointer") {
    TwoSquares driver;
    driver.lockRight();
    driver.press(driver.pixel({4, 5}));
    driver.moveToPlace({4.5, 5.5});
    driver.moveToPlace({5, 6});
    driver.frames(2);
    CHECK(driver.labelHas("is locked and joined"));
    driver.release(driver.pixel({5, 6}));
    driver.settle();
    CHECK_FALSE(driver.labelHas("is locked and joined"));
    CHECK(driver.left()[2] == Vec2{4, 5});
    CHECK(driver.right()[3] == Vec2{4, 5});
    CHECK(driver.newSteps() == 0);
    driver.drag(driver.pixel({4, 5}), driver.pixel({5, 6}), 8, kAltDrag);
    driver.settle();
    CHECK(driver.left()[2] == Vec2{5, 6});
    CHECK(driver.right()[3] == Vec2{4, 5});
}

TEST_CASE("Joints: a transformed shape takes neighbours along, but not where it covers its old place") {
    TwoSquares driver;
    driver.context().selection.shapes = {driver.document().shapes[1]->id};
    REQUIRE(driver.context().actions.run("shape.turnLeft", driver.context()));
    driver.settle();
    CHECK(driver.newSteps() == 1);
    CHECK(driver.left() == std::vector<Vec2>{{1, 2}, {4, 2}, {4, 5}, {1, 5}});
    driver.undo();
    driver.context().selection.shapes = {driver.document().shapes[1]->id};
    REQUIRE(driver.context().actions.run("shape.transform", driver.context()));
    driver.settle();
    driver.fill("dialog/transform/x", "0.5");
    driver.settle();
    CHECK(driver.left() == std::vector<Vec2>{{1, 2}, {4.5, 2}, {4.5, 5}, {1, 5}});
    CHECK(driver.right() == std::vector<Vec2>{{4.5, 2}, {7.5, 2}, {7.5, 5}, {4.5, 5}});
}

TEST_CASE("Joints: rings mark the joined nodes of the selected shape") {
    TwoSquares driver;
    driver.moveToPlace({0.2, 0.2});
    driver.context().selection.shapes = {driver.document().shapes[1]->id};
    driver.settle();
    const auto joined = driver.picture();
    Document apart = driver.document();
    apart.shapes.erase(apart.shapes.begin());
    driver.context().document.apply(std::move(apart), "Remove");
    driver.settle();
    const auto alone = driver.picture();
    // The ring passes 7.5 pixels from the node, where nothing else is drawn outside both squares.
    const auto around = [&](Vec2 place) {
        const Pixel at = driver.pixel(place);
        const PixelRect area{at.x - 7.0, at.y - 7.0, 3.0, 3.0};
        return joined.differences(alone, area);
    };
    CHECK(around({4, 5}) > 0);
    CHECK(around({7, 5}) == 0);
}

TEST_CASE("Joints: a constrained node that is dragged takes its neighbour along, and Alt detaches it") {
    TwoSquares driver;
    const std::uint32_t id = driver.document().shapes[0]->id;
    REQUIRE(driver.context().applyCommand(
        addConstraint(driver.document(), ConstraintKind::Horizontal, {{id, SketchPartKind::Segment, 2}}), "Add"));
    const std::vector<Vec2> left = driver.left(), right = driver.right();
    driver.dragPlaces({4, 5}, {5, 6});
    driver.settle();
    CHECK(distance(driver.left()[2], {5, 6}) < 0.05);
    CHECK(driver.right()[3] == driver.left()[2]);
    CHECK(driver.left()[3].y == driver.left()[2].y); // the upper side stays horizontal
    CHECK(driver.right()[2] == Vec2{7, 5});
    CHECK(driver.newSteps() == 2);
    driver.undo();
    CHECK(driver.left() == left);
    CHECK(driver.right() == right);

    driver.drag(driver.pixel({4, 5}), driver.pixel({5, 6}), 8, kAltDrag);
    driver.settle();
    CHECK(distance(driver.left()[2], driver.right()[3]) > 1.0);
    CHECK(driver.left()[3].y == driver.left()[2].y);
    CHECK(driver.newSteps() == 2);
}

TEST_CASE("Joints: a dimension that is typed on the canvas moves both sides of a border") {
    TwoSquares driver;
    const std::uint32_t id = driver.document().shapes[0]->id;
    const auto add = [&](ConstraintKind kind, const SketchPart &part) {
        REQUIRE(driver.context().applyCommand(addConstraint(driver.document(), kind, {part}), "Add"));
    };
    add(ConstraintKind::Fixed, {id, SketchPartKind::Node, 0});
    add(ConstraintKind::Length, {id, SketchPartKind::Segment, 0});
    driver.settle();
    const std::string value = "sketch/" + std::to_string(driver.document().constraints.back()->id) + "/0";
    REQUIRE(driver.has(value));
    const PixelRect rect = driver.context().widgets.find(value)->rect;
    const Pixel middle{rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height};
    driver.clickAt(middle);
    driver.clickAt(middle);
    driver.settle();
    driver.key('A', kControl);
    driver.type("3.5");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(distance(driver.left()[0], driver.left()[1]) == doctest::Approx(3.5));
    CHECK(driver.left()[0] == Vec2{1, 2});
    CHECK(driver.right()[0] == driver.left()[1]);
    CHECK(driver.right()[1] == Vec2{7, 2});
}

} // namespace forefront::test
