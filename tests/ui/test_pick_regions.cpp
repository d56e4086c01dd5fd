// A click inside of a region picks it as one: selecting, moving, naming, copying and deleting faces on the canvas.
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/support/two_counties.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront::test {
namespace {

using Ids = std::set<std::uint32_t>;
using Nodes = std::vector<Vec2>;

/// Two counties from (1, 2) to (9, 5), and the select tool.
class Counties : public Draughtsman {
  public:
    explicit Counties(bool marked = true) {
        Document map = twoCounties({1, 2});
        if (!marked) {
            map.regionMarkers.clear();
        }
        show(std::move(map));
    }
    void show(Document drawing) {
        context().document.apply(std::move(drawing), "Import");
        key('V');
        context().selection.clear();
        context().snapping.gridStep = 0.5;
        settle();
        steps_ = context().document.history().position();
    }
    const Selection &selection() { return context().selection; }
    const Nodes &nodes(std::size_t shape) { return document().shapes[shape]->nodes; }
    std::size_t newSteps() { return context().document.history().position() - steps_; }
    void shiftClick(Vec2 place) {
        hold(kShift, true);
        clickPlace(place);
        hold(kShift, false);
        settle();
    }
    void rightClick(Vec2 place) {
        press(pixel(place), MouseButton::Right);
        release(pixel(place), MouseButton::Right);
        settle();
    }
    void undo() {
        key('Z', kControl);
        settle();
    }
    /// Names what is selected, by F2.
    void nameByKey(std::string_view name) {
        key(key::kF1 + 1);
        settle();
        key('A', kControl);
        type(name);
        key(key::kEnter);
        settle();
    }
    bool logSays(std::string_view text) {
        const auto &entries = context().log.entries();
        return std::any_of(entries.begin(), entries.end(), [&](const MessageLog::Entry &entry) {
            return entry.diagnostic.message.find(text) != std::string::npos;
        });
    }
    void select(Vec2 place) {
        clickPlace(place);
        settle();
    }

  private:
    std::size_t steps_ = 0;
};

Shape rectangle(Vec2 low, Vec2 high) {
    Shape shape;
    shape.form = RectangleForm{};
    shape.nodes = {low, high};
    return shape;
}

} // namespace

TEST_CASE("Pick regions: a click inside picks a county, Shift adds and removes others, a click outside clears") {
    Counties driver;
    driver.select({2, 4});
    CHECK(driver.selection().markers == Ids{0});
    CHECK(driver.selection().size() == 1);
    driver.shiftClick({8, 4});
    CHECK(driver.selection().markers == Ids{0, 1});
    driver.shiftClick({3, 4});
    CHECK(driver.selection().markers == Ids{1});
    driver.select({3, 4});
    CHECK(driver.selection().markers == Ids{0});
    driver.select({5, 7});
    CHECK(driver.selection().empty());
    CHECK(driver.newSteps() == 0);
}

TEST_CASE("Pick regions: the county under the pointer is lit, a picked one too, and its row is chosen") {
    Counties driver;
    driver.moveToPlace({2, 4});
    driver.settle();
    REQUIRE(driver.context().view.facePlace.has_value());
    CHECK(*driver.context().view.facePlace == driver.context().view.camera.toPlane(driver.pixel({2, 4})));
    driver.moveToPlace({5, 7});
    CHECK_FALSE(driver.context().view.facePlace.has_value());
    driver.click("shapes/region/1");
    driver.settle();
    CHECK(driver.selection().markers == Ids{1});
    driver.dragPlaces({8, 4}, {8, 4.5}); // as one picked on the canvas
    CHECK(driver.nodes(1).front() == Vec2{5, 5.5});
}

TEST_CASE("Pick regions: a picked county is dragged with its border, its neighbour follows, as one step") {
    Counties driver;
    driver.select({2, 4});
    driver.dragPlaces({2, 4}, {4, 4.5});
    driver.settle();
    CHECK(driver.nodes(0) == Nodes{{7, 2.5}, {3, 2.5}, {3, 5.5}, {7, 5.5}});
    CHECK(driver.nodes(1) == Nodes{{7, 5.5}, {9, 5}, {9, 2}, {7, 2.5}});
    CHECK(driver.nodes(2) == Nodes{{7, 2.5}, {7, 5.5}});
    CHECK(driver.document().regionMarkers[0].at == Vec2{4, 3.5});
    CHECK(driver.document().regionMarkers[1].at.x > 7.0); // not in the county that came over it
    CHECK(driver.context().preview->faults.empty());
    CHECK(driver.selection().markers == Ids{0});
    CHECK(driver.undoLabel() == "Move region");
    CHECK(driver.newSteps() == 1);
    driver.undo();
    CHECK(driver.nodes(1) == Nodes{{5, 5}, {9, 5}, {9, 2}, {5, 2}});
    CHECK(driver.document().regionMarkers[1].at == Vec2{5.5, 3});
    CHECK(driver.selection().markers == Ids{0});
}

TEST_CASE("Pick regions: a drag in a county that is not picked draws a box") {
    Counties driver;
    driver.dragPlaces({2, 4}, {4, 4.5});
    driver.settle();
    CHECK(driver.newSteps() == 0);
    CHECK(driver.selection().empty());
    driver.dragPlaces({0.5, 5.5}, {5.5, 1.5});
    CHECK(driver.selection().shapes == Ids{1, 3});
}

TEST_CASE("Pick regions: a county with a locked border is not moved, and the log says why") {
    Counties driver;
    driver.context().applyCommand(setLocked(driver.document(), {3}, true), "Lock");
    driver.settle();
    driver.select({2, 4});
    driver.dragPlaces({2, 4}, {4, 4.5});
    CHECK(driver.nodes(0).front() == Vec2{5, 2});
    CHECK(driver.logHas("border-locked"));
}

TEST_CASE("Pick regions: a picked county is dragged by its label, its marker by the dot") {
    Counties driver;
    driver.select({2, 4});
    driver.dragPlaces({2, 3}, {2.5, 3.5});
    CHECK(driver.document().regionMarkers[0].at == Vec2{2.5, 3.5});
    CHECK(driver.nodes(0).front() == Vec2{5, 2});
    CHECK(driver.undoLabel() == "Move region marker");
    driver.moveToPlace({5, 7});
    driver.settle();
    const auto *const label = driver.context().widgets.find("label/region/0");
    REQUIRE(label != nullptr);
    const Pixel from = label->rect.centre();
    driver.drag(from, {from.x, from.y - driver.pixel({0, 0}).y + driver.pixel({0, 1}).y});
    driver.settle();
    CHECK(driver.nodes(0).front() == Vec2{5, 3});
    CHECK(driver.document().regionMarkers[0].at == Vec2{2.5, 4.5});
    CHECK(driver.undoLabel() == "Move region");
}

TEST_CASE("Pick regions: the arrow keys move a picked county with its border") {
    Counties driver;
    driver.select({2, 4});
    driver.key(key::kUp, kShift);
    driver.settle();
    CHECK(driver.nodes(0) == Nodes{{5, 2.5}, {1, 2.5}, {1, 5.5}, {5, 5.5}});
    CHECK(driver.nodes(1) == Nodes{{5, 5.5}, {9, 5}, {9, 2}, {5, 2.5}});
    CHECK(driver.document().regionMarkers[0].at == Vec2{2, 3.5});
    CHECK(driver.undoLabel() == "Nudge");
}

TEST_CASE("Pick regions: Delete removes the region, says so, and leaves the borders") {
    Counties driver;
    driver.select({2, 4});
    driver.key(key::kDelete);
    driver.settle();
    CHECK(driver.document().shapes.size() == 3);
    REQUIRE(driver.document().regionMarkers.size() == 1);
    CHECK(driver.document().regionMarkers[0].tag == 3);
    CHECK(driver.logSays("Region West deleted; its border stays"));
    CHECK(driver.undoLabel() == "Delete region");
    CHECK(driver.newSteps() == 1);
    CHECK(driver.selection().empty());
    driver.undo();
    CHECK(driver.document().regionMarkers.size() == 2);
}

TEST_CASE("Pick regions: F2 names a picked county") {
    Counties driver;
    driver.select({2, 4});
    driver.nameByKey("Avon");
    CHECK(driver.document().regionNames.at(2) == "Avon");
    CHECK(driver.newSteps() == 1);
}

TEST_CASE("Pick regions: the inspector sets tag, area and size of one and of several") {
    Counties driver;
    driver.select({2, 4});
    driver.fill("inspector/maxarea", "0.25");
    CHECK(driver.document().regionMarkers[0].maxArea == 0.25);
    driver.shiftClick({8, 4});
    driver.fill("inspector/maxarea", "0.5");
    CHECK(driver.document().regionMarkers[0].maxArea == 0.5);
    CHECK(driver.document().regionMarkers[1].maxArea == 0.5);
    CHECK(driver.undoLabel() == "Limit area of regions");
    driver.fill("inspector/regionsize", "0.125");
    CHECK(driver.document().regionMarkers[0].size == 0.125);
    CHECK(driver.document().regionMarkers[1].size == 0.125);
    driver.fill("inspector/tag", "7");
    CHECK(driver.document().regionMarkers[0].tag == 7);
    CHECK(driver.document().regionMarkers[1].tag == 7);
    CHECK(driver.newSteps() == 4);
}

TEST_CASE("Pick regions: Select border picks the lines around a county, and a zoom fits it") {
    Counties driver;
    driver.select({2, 4});
    driver.context().actions.run("view.zoomSelection", driver.context());
    driver.settle();
    const Box2 visible = driver.context().view.camera.visible();
    CHECK(visible.contains({1, 2}));
    CHECK(visible.contains({5, 5}));
    CHECK(visible.size().y < 8.0);
    driver.context().actions.run("edit.selectBorder", driver.context());
    CHECK(driver.selection().shapes == Ids{1, 3});
    CHECK(driver.selection().size() == 2);
    driver.context().selection = {.markers = {0, 1}};
    driver.settle();
    driver.click("inspector/border");
    driver.settle();
    CHECK(driver.selection().shapes == Ids{1, 2, 3});
}

TEST_CASE("Pick regions: a copy is a closed shape with its region, and Cut leaves the borders") {
    Counties driver;
    driver.select({2, 4});
    driver.key('C', kControl);
    driver.key('V', kControl);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 4);
    CHECK(isClosed(*driver.document().shapes[3]));
    CHECK(areaOf(*driver.document().shapes[3]) == doctest::Approx(12.0));
    REQUIRE(driver.document().regionMarkers.size() == 3);
    CHECK(driver.document().regionMarkers[2].tag == 2);
    CHECK(driver.newSteps() == 1);
    driver.undo();
    driver.select({2, 4});
    driver.key('D', kControl);
    driver.settle();
    CHECK(driver.document().shapes.size() == 4);
    CHECK(driver.undoLabel() == "Duplicate");
    driver.undo();
    driver.select({2, 4});
    driver.key('X', kControl);
    driver.settle();
    CHECK(driver.document().shapes.size() == 3);
    CHECK(driver.document().regionMarkers.size() == 1);
    CHECK(driver.undoLabel() == "Cut region");
}

TEST_CASE("Pick regions: a face that is no region is picked, dragged and made a region by its name") {
    Counties driver(false);
    driver.select({2, 4});
    CHECK(driver.selection().markers.empty());
    REQUIRE(driver.selection().faces.size() == 1);
    driver.key(key::kDelete);
    CHECK(driver.document().shapes.size() == 3);
    CHECK(driver.logHas("unmarked-face"));
    driver.dragPlaces({2, 4}, {2, 4.5});
    driver.settle();
    CHECK(driver.nodes(0).front() == Vec2{5, 2.5});
    REQUIRE(driver.selection().faces.size() == 1);
    CHECK(driver.selection().faces.begin()->y == doctest::Approx(4.5));
    driver.nameByKey("Avon");
    REQUIRE(driver.document().regionMarkers.size() == 1);
    CHECK(driver.document().regionNames.at(driver.document().regionMarkers[0].tag) == "Avon");
    CHECK(driver.selection().markers == Ids{0});
    driver.undo();
    driver.undo();
    driver.undo();
    CHECK(driver.nodes(0).front() == Vec2{5, 2});
    CHECK(driver.selection().empty());
}

TEST_CASE("Pick regions: a dragged face comes back with Esc, and its place with it") {
    Counties driver(false);
    driver.select({2, 4});
    const Selection before = driver.selection();
    driver.press(driver.pixel({2, 4}));
    driver.moveToPlace({2.5, 4});
    driver.moveToPlace({3, 4});
    driver.frames(1);
    CHECK(driver.nodes(0).front() != Vec2{5, 2});
    driver.key(key::kEscape);
    driver.release(driver.pixel({3, 4}));
    driver.settle();
    CHECK(driver.nodes(0).front() == Vec2{5, 2});
    CHECK(driver.selection() == before);
}

TEST_CASE("Pick regions: a click inside of a closed shape picks the shape, a second one the region that it is") {
    Counties driver;
    driver.show(*addShape(*addRegionMarker({}, {{2, 3}, 2}), rectangle({1, 2}, {9, 7})));
    driver.select({3, 4});
    CHECK(driver.selection().shapes == Ids{1});
    CHECK(driver.selection().size() == 1);
    driver.select({3, 4});
    CHECK(driver.selection().markers == Ids{0});
    CHECK(driver.selection().size() == 1);
    driver.dragPlaces({3, 4}, {3.5, 4});
    CHECK(driver.nodes(0) == Nodes{{1.5, 2}, {9.5, 7}});
    CHECK(driver.document().regionMarkers[0].at == Vec2{2.5, 3});
    driver.shiftClick({5, 4});
    CHECK(driver.selection().empty());
}

TEST_CASE("Pick regions: in a divided shape a click picks the region, or the shape where there is none") {
    Counties driver;
    Shape line;
    line.form = PathForm{.closed = false};
    line.use = ShapeUse::Constraint;
    line.nodes = {{5, 2}, {5, 7}};
    driver.show(*addShapes(*addRegionMarker({}, {{2, 3}, 2}), {rectangle({1, 2}, {9, 7}), line}));
    driver.select({3, 4});
    CHECK(driver.selection().markers == Ids{0});
    driver.select({7, 4});
    CHECK(driver.selection().shapes == Ids{1});
    driver.select({7, 4});
    CHECK(driver.selection().faces.size() == 1);
    driver.select({3, 4});
    CHECK(driver.selection().markers == Ids{0});
}

TEST_CASE("Pick regions: a county within the closed outline of its map is picked and dragged") {
    Counties driver;
    Document map = twoCounties({1, 2});
    Shape outline;
    outline.nodes = {{1, 2}, {5, 2}, {9, 2}, {9, 5}, {5, 5}, {1, 5}};
    const std::shared_ptr<const Shape> between = map.shapes[2];
    map.shapes = {between};
    driver.show(*addShape(map, outline));
    driver.select({2, 4});
    CHECK(driver.selection().markers == Ids{0});
    driver.dragPlaces({2, 4}, {4, 4.5});
    driver.settle();
    CHECK(driver.nodes(0) == Nodes{{7, 2.5}, {7, 5.5}});
    CHECK(driver.nodes(1) == Nodes{{3, 2.5}, {7, 2.5}, {9, 2}, {9, 5}, {7, 5.5}, {3, 5.5}});
    CHECK(driver.context().preview->faults.empty());
}

TEST_CASE("Pick regions: in the frame of a map a click picks the county, and the frame beside the counties") {
    Counties driver;
    Document map = twoCounties({1, 2});
    for (auto &shape : map.shapes) {
        Shape inner = *shape;
        inner.use = ShapeUse::Constraint;
        shape = std::make_shared<const Shape>(inner);
    }
    driver.show(*addShape(map, rectangle({0.5, 1}, {9.5, 7})));
    driver.select({2, 4});
    CHECK(driver.selection().markers == Ids{0});
    driver.select({2, 6});
    CHECK(driver.selection().shapes == Ids{4});
}

TEST_CASE("Pick regions: the menu of a county has its commands, that of another face makes it a region") {
    Counties driver;
    driver.rightClick({2, 4});
    CHECK(driver.selection().markers == Ids{0});
    CHECK(driver.has("contextmenu/edit.selectBorder"));
    driver.key(key::kEscape);
    driver.context().applyCommand(deleteSelection(driver.document(), driver.selection()), "Delete");
    driver.settle();
    driver.rightClick({2, 4});
    REQUIRE(driver.has("contextmenu/region/make"));
    driver.click("contextmenu/region/make");
    driver.settle();
    CHECK(driver.document().regionMarkers.size() == 2);
}

} // namespace forefront::test
