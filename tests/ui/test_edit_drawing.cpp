#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <numbers>

namespace forefront::test {

TEST_CASE("Pen: clicks and Enter draw a polygon, and one inside it is a hole") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    driver.polygon({{3, 3}, {6, 3}, {6, 6}});
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    CHECK(driver.undoLabel() == "Draw polygon");
    CHECK(driver.context().preview->faults.empty());
    CHECK(driver.context().preview->estimatedElements > 0.0);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{2});
}

TEST_CASE("Pen: a click on the first node closes the path; Backspace and undo remove nodes, and redo restores them") {
    Draughtsman driver;
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.clickPlace({9, 1});
    driver.clickPlace({9, 9});
    driver.clickPlace({5, 5});
    driver.key(key::kBackspace);
    driver.key('Z', {Modifiers::kControl});
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    driver.clickPlace({1, 9});
    CHECK(driver.document().shapes.empty());
    // A few pixels from the first node are close enough.
    driver.clickAt(driver.pixel({1, 1}) + Pixel(3, -3));
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{1, 1}, {9, 1}, {9, 9}, {1, 9}});
}

TEST_CASE("Pen: undo brings back a path that Esc has dropped, until the drawing changes") {
    Draughtsman driver;
    driver.key('P');
    const std::vector<Vec2> corners{{2, 2}, {6, 2}, {6, 5}};
    const auto drop = [&] {
        for (const Vec2 corner : corners) {
            driver.clickPlace(corner);
        }
        driver.key(key::kEscape);
        driver.key(key::kEnter);
        CHECK(driver.document().shapes.empty());
    };
    drop();
    driver.key('Z', {Modifiers::kControl});
    driver.clickPlace({3, 6});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{2, 2}, {6, 2}, {6, 5}, {3, 6}});

    driver.key('Z', {Modifiers::kControl}); // the shape
    REQUIRE(driver.document().shapes.empty());
    drop();
    driver.context().actions.run("edit.redo", driver.context());
    driver.key('Z', {Modifiers::kControl}); // the shape again, not the dropped path
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Pen: Esc cancels the path, and choosing another tool finishes it") {
    Draughtsman driver;
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.clickPlace({9, 1});
    driver.clickPlace({9, 9});
    driver.key(key::kEscape);
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.empty());
    driver.clickPlace({1, 1});
    driver.clickPlace({9, 1});
    driver.clickPlace({9, 9});
    driver.click("tool/select");
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Numeric entry: typed distances, angles, coordinates and pairs place nodes exactly") {
    Draughtsman driver;
    driver.key('P');
    driver.key('X');
    driver.type("1.25");
    driver.key(key::kEnter);
    driver.key('Y');
    driver.type("2");
    driver.key(key::kEnter); // both are known, so the node is placed
    driver.moveToPlace({6, 2.03});
    driver.type("4.5");
    driver.key(key::kEnter); // in the direction of the pointer, which snaps to (6, 2)
    driver.key('D');
    driver.type("2");
    driver.key(key::kTab);
    driver.type("90");
    driver.key(key::kEnter);
    driver.type("1.25,6.125");
    driver.key(key::kEnter);
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    const std::vector<Vec2> &nodes = driver.document().shapes[0]->nodes;
    REQUIRE(nodes.size() == 4);
    CHECK(nodes[0] == Vec2{1.25, 2});
    CHECK(nodes[1].x == doctest::Approx(5.75));
    CHECK(nodes[1].y == doctest::Approx(2));
    CHECK(nodes[2].x == doctest::Approx(5.75));
    CHECK(nodes[2].y == doctest::Approx(4));
    CHECK(nodes[3] == Vec2{1.25, 6.125});
}

TEST_CASE("Numeric entry: typing width, Tab, height draws a rectangle, with a live preview") {
    Draughtsman driver;
    driver.key('R');
    driver.clickPlace({1, 1});
    driver.moveToPlace({4, 3});
    driver.keys("6");
    const auto wide = driver.picture();
    driver.key(key::kTab);
    driver.keys("5");
    CHECK(driver.context().view.panels); // Tab did not hide the panels
    CHECK(driver.picture().differences(wide, driver.canvas()) > 100);
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(boundsOf(*driver.document().shapes[0]) == Box2{{1, 1}, {7, 6}});
}

TEST_CASE("Numeric entry: letters open distance and angle, and digits before the first node do not mesh") {
    Draughtsman driver;
    driver.key('L');
    driver.keys("2");
    driver.key(key::kTab);
    driver.keys("3");
    driver.key(key::kEnter);
    driver.keys("d4q90");
    driver.key(key::kEnter);
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    const std::vector<Vec2> &nodes = driver.document().shapes[0]->nodes;
    REQUIRE(nodes.size() == 2);
    CHECK(nodes[0] == Vec2{2, 3});
    CHECK(distance(nodes[1], {2, 7}) < 1e-12);
    CHECK(driver.run().state == RunState::Empty);
}

TEST_CASE("Snapping: the pointer snaps to nodes, Ctrl disables snapping, and Shift snaps to 15 degrees") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}});
    driver.key('L');
    driver.clickAt(driver.pixel({9, 9}) + Pixel(4, 3));
    driver.frames(30);
    // Shift: from (9, 9) down to the left, near 225 degrees.
    driver.context().widgets.find("canvas");
    driver.editor().input().push(
        {.kind = InputKind::Key, .code = key::kLeftShift, .pressed = true, .modifiers = {Modifiers::kShift}});
    driver.clickPlace({6.1, 6.2});
    driver.editor().input().push({.kind = InputKind::Key, .code = key::kLeftShift, .pressed = false});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    const Shape &line = *driver.document().shapes[1];
    CHECK(line.use == ShapeUse::Constraint);
    CHECK(line.kind() == ShapeKind::Polyline);
    CHECK(line.nodes[0] == Vec2{9, 9});
    CHECK(line.nodes[1].x == doctest::Approx(line.nodes[1].y));
}

TEST_CASE("Polyline: a line between two boundaries connects them, and the drawing can be meshed") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('L');
    driver.clickAt(driver.pixel({1, 4.2}) + Pixel(3, 0)); // snaps to the segment
    driver.frames(30);
    driver.clickPlace({5, 5});
    driver.clickAt(driver.pixel({9, 6.3}) - Pixel(2, 0));
    driver.frames(30);
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.document().shapes[0]->nodes.size() == 6);
    CHECK(driver.context().preview->faults.empty());
    CHECK(driver.undoLabel() == "Draw polyline");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Rectangle);
}

TEST_CASE("Rectangle and circle: by drag, by two clicks, by typed size") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('C');
    driver.clickPlace({5, 5});
    driver.type("1.5");
    driver.key(key::kEnter);
    driver.key('R');
    driver.clickPlace({2, 2});
    driver.type("0.5,0.25");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 3);
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(56));
    CHECK(areaOf(*driver.document().shapes[1]) == doctest::Approx(2.25 * std::numbers::pi));
    CHECK(driver.document().shapes[2]->nodes[1] == Vec2{2.5, 2.25});
    driver.settle();
    CHECK(driver.context().preview->faults.empty());
}

TEST_CASE("Select: dragging a node with snapping is one command that can be undone and redone") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    driver.key('V');
    driver.dragPlaces({9, 9}, {8.02, 7.03});
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{8, 7});
    CHECK(driver.undoLabel() == "Move node");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{9, 9});
    CHECK(driver.undoLabel() == "Draw polygon");
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{8, 7});
}

TEST_CASE("Select: clicks on outlines select shapes, unless a node lies right there or is drawn") {
    Draughtsman driver;
    for (const double x : {1.0, 4.0, 7.0}) {
        driver.rectangle({x, 2.0}, {x + 2.0, 4.0});
    }
    driver.key('V');
    driver.context().selection.clear();
    const double pixel = driver.context().view.camera.length(1.0);
    const auto beside = [&](double x) { return Vec2{x + 6.0 * pixel, 2.0}; };
    const auto shiftClick = [&](Vec2 place) {
        driver.drag(driver.pixel(place), driver.pixel(place), 1, {Modifiers::kShift});
        driver.frames(30);
    };
    const Selection &selection = driver.context().selection;
    driver.clickPlace(beside(1.0));
    CHECK(selection.shapes.size() == 1);
    CHECK(selection.nodes.empty());
    shiftClick(beside(4.0));
    shiftClick({7.0, 2.0}); // a node: beside shapes, its shape
    CHECK(selection.shapes.size() == 3);
    CHECK(selection.nodes.empty());
    shiftClick({7.0, 2.0});
    CHECK(selection.shapes.size() == 2);
    CHECK(selection.nodes.empty());

    driver.clickPlace({5.0, 8.0}); // nothing
    driver.clickPlace({4.0, 2.0});
    CHECK(selection.nodes.size() == 1);
    driver.clickPlace({5.0, 8.0});
    driver.clickPlace(beside(4.0));
    driver.clickPlace(beside(4.0)); // its nodes are drawn now
    CHECK(selection.nodes.size() == 1);
}

TEST_CASE("Select: Esc during a drag restores everything and leaves nothing to undo") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    driver.key('V');
    driver.press(driver.pixel({1, 3}));
    driver.moveTo(driver.pixel({3, 3}));
    driver.moveTo(driver.pixel({4, 3}));
    CHECK(boundsOf(driver.document()).min.x > 1.0);
    driver.key(key::kEscape);
    driver.release(driver.pixel({4, 3}));
    CHECK(boundsOf(driver.document()) == Box2{{1, 1}, {5, 5}});
    CHECK(driver.undoLabel() == "Draw rectangle");
}

TEST_CASE("Select: double-clicking a segment inserts a node, and Delete removes it") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    driver.key('V');
    driver.key(key::kEscape);
    driver.doubleClickPlace({5, 1});
    REQUIRE(driver.document().shapes[0]->nodes.size() == 5);
    CHECK(driver.document().shapes[0]->nodes[1].y == 1.0);
    CHECK(driver.context().selection.nodes == std::set<NodeRef>{{1, 1}});
    driver.key(key::kDelete);
    CHECK(driver.document().shapes[0]->nodes.size() == 4);
    CHECK(driver.undoLabel() == "Delete");
}

TEST_CASE("Select: a double-click that inserts a node into a rounded rectangle selects that node") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    Document rounded = driver.document();
    Shape box = *rounded.shapes[0];
    box.as<RectangleForm>().radius = 1.0;
    rounded.shapes[0] = std::make_shared<const Shape>(box);
    driver.context().document.apply(std::move(rounded), "Round");
    driver.key('V');
    driver.key(key::kEscape);
    driver.doubleClickPlace({9, 5}); // of eight segments, the fourth
    const std::vector<Vec2> &nodes = driver.document().shapes[0]->nodes;
    REQUIRE(nodes.size() == 9);
    REQUIRE(driver.context().selection.nodes.size() == 1);
    const Vec2 selected = nodes[driver.context().selection.nodes.begin()->node];
    CHECK(selected.x == doctest::Approx(9));
    CHECK(selected.y == doctest::Approx(5).epsilon(0.02));
}

TEST_CASE("Select: a box selects entire shapes, Ctrl+A selects all, Ctrl+D duplicates, and arrow keys nudge") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {3, 3});
    driver.rectangle({5, 5}, {8, 8});
    driver.key('V');
    driver.dragPlaces({4.5, 4.5}, {8.5, 8.5});
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{2});
    driver.key('D', {Modifiers::kControl});
    CHECK(driver.document().shapes.size() == 3);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{3});
    const Box2 before = boundsOf(*driver.document().shapes[2]);
    driver.key(key::kRight);
    driver.key(key::kRight);
    CHECK(boundsOf(*driver.document().shapes[2]).min.x > before.min.x);
    CHECK(driver.undoLabel() == "Nudge");
    driver.key('A', {Modifiers::kControl});
    CHECK(driver.context().selection.shapes.size() == 3);
    driver.key(key::kDelete);
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Select: a drag with Alt is a lasso, which leaves out what lies in its bay") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {2, 2});
    driver.rectangle({4, 1}, {5, 2});
    driver.rectangle({4, 4}, {5, 5});
    driver.key('V');
    driver.context().selection.clear();
    const std::vector<Vec2> way = {{0.5, 0.5}, {5.5, 0.5}, {5.5, 5.5}, {3.5, 5.5}, {3.5, 2.5}, {3, 2.5}, {0.5, 2.4}};
    driver.hold({Modifiers::kAlt}, true);
    driver.press(driver.pixel(way.front()));
    for (const Vec2 place : way) {
        driver.moveToPlace(place);
    }
    driver.release(driver.pixel(way.back()));
    driver.hold({Modifiers::kAlt}, false);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1, 2, 3});
    const std::vector<Vec2> bay = {{0.5, 0.5}, {5.5, 0.5}, {5.5, 5.5}, {5.2, 5.5}, {5.2, 2.5}, {0.5, 2.5}};
    driver.hold({Modifiers::kAlt}, true);
    driver.press(driver.pixel(bay.front()));
    for (const Vec2 place : bay) {
        driver.moveToPlace(place);
    }
    driver.release(driver.pixel(bay.back()));
    driver.hold({Modifiers::kAlt}, false);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1, 2});
}

TEST_CASE("Select: a lasso may end where it began, and Alt and a click select nothing") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {2, 2});
    driver.rectangle({4, 4}, {5, 5});
    driver.key('V');
    driver.context().selection.clear();
    driver.hold({Modifiers::kAlt}, true);
    driver.press(driver.pixel({0.5, 0.5}));
    for (const Vec2 place : {Vec2{2.5, 0.5}, Vec2{2.5, 2.5}, Vec2{0.5, 2.5}, Vec2{0.5, 0.5}}) {
        driver.moveToPlace(place);
    }
    driver.release(driver.pixel({0.5, 0.5}));
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1});
    driver.clickPlace({0.5, 0.5});
    driver.hold({Modifiers::kAlt}, false);
    CHECK(driver.context().selection.empty());
}

TEST_CASE("Select: a second click on a shape selects one segment, which can have its own tag and name") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key(key::kEscape);
    driver.clickPlace({5, 1});
    CHECK(driver.context().selection.shapes.size() == 1);
    driver.clickPlace({5, 1});
    CHECK(driver.context().selection.segments == std::set<SegmentRef>{{1, 0}});
    const auto shiftClick = [&](Vec2 place) {
        driver.drag(driver.pixel(place), driver.pixel(place), 1, {Modifiers::kShift});
        driver.frames(30);
    };
    shiftClick({9, 4}); // adds another segment of the shape, not the shape
    CHECK(driver.context().selection.segments == std::set<SegmentRef>{{1, 0}, {1, 1}});
    CHECK(driver.context().selection.shapes.empty());
    shiftClick({9, 4});
    CHECK(driver.context().selection.segments == std::set<SegmentRef>{{1, 0}});
    driver.clickPlace({9, 4}); // another segment of the shape, not the shape
    CHECK(driver.context().selection.segments == std::set<SegmentRef>{{1, 1}});
    CHECK(driver.context().selection.shapes.empty());
    driver.clickPlace({5, 1});
    driver.click("inspector/tag");
    driver.key('A', {Modifiers::kControl});
    driver.type("7");
    driver.key(key::kEnter);
    CHECK(segmentTag(*driver.document().shapes[0], 0) == 7);
    CHECK(segmentTag(*driver.document().shapes[0], 1) == 1);
    driver.click("inspector/tag/name");
    driver.key('A', {Modifiers::kControl});
    driver.type("inlet");
    driver.key(key::kEnter);
    CHECK(driver.document().boundaryNames.at(7) == "inlet");
}

TEST_CASE("Inspector: naming one segment keeps the names of other shapes; the names panel renames everywhere") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.fill("options/tag", "1"); // else the hole would have its own
    driver.rectangle({3, 3}, {5, 5});
    driver.key('V');
    driver.key(key::kEscape);
    driver.clickPlace({5, 1});
    driver.clickPlace({5, 1});
    REQUIRE(driver.context().selection.segments == std::set<SegmentRef>{{1, 0}});
    driver.click("inspector/tag/name");
    driver.key('A', {Modifiers::kControl});
    driver.type("inlet");
    driver.key(key::kEnter);
    CHECK(driver.document().boundaryNames == std::map<std::int32_t, std::string>{{2, "inlet"}});
    CHECK(segmentTag(*driver.document().shapes[0], 0) == 2);
    CHECK(segmentTag(*driver.document().shapes[0], 1) == 1);
    CHECK(driver.document().shapes[1]->tag == 1);
    driver.showPanel("names");
    driver.click("names/boundary/1");
    driver.key('A', {Modifiers::kControl});
    driver.type("wall");
    driver.key(key::kEnter);
    CHECK(driver.document().boundaryNames.at(1) == "wall");
    CHECK(driver.document().shapes[1]->tag == 1);
}

TEST_CASE("Inspector: typed numbers change the shape; a click on the canvas commits them first") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 4});
    driver.rectangle({6, 6}, {8, 8});
    driver.key('V');
    driver.click("inspector/corner/x");
    driver.key('A', {Modifiers::kControl});
    driver.type("5.5");
    driver.clickPlace({1, 2}); // on the other rectangle: the field commits its text, then that rectangle is selected
    CHECK(boundsOf(*driver.document().shapes[1]) == Box2{{5.5, 6}, {7.5, 8}});
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1});
    CHECK(boundsOf(*driver.document().shapes[0]) == Box2{{1, 1}, {5, 4}});
}

TEST_CASE("Shapes: union, difference, intersection, exclusion and divide are one command each, by key and by menu") {
    const struct {
        char key;
        const char *id, *label;
        std::size_t shapes;
    } operations[] = {{'U', "edit.union", "Union", 1},
                      {'D', "edit.difference", "Difference", 1},
                      {'I', "edit.intersection", "Intersection", 1},
                      {'X', "edit.exclusion", "Exclusion", 2},
                      {'V', "edit.divide", "Divide", 2}};
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    CHECK_FALSE(driver.context().actions.find("edit.union")->enabled(driver.context()));
    driver.rectangle({3, 3}, {8, 8});
    for (const auto &operation : operations) {
        CAPTURE(operation.label);
        driver.key('A', {Modifiers::kControl});
        REQUIRE(driver.context().actions.find(operation.id)->enabled(driver.context()));
        driver.key(operation.key, {Modifiers::kControl | Modifiers::kShift});
        driver.settle();
        CHECK(driver.undoLabel() == operation.label);
        CHECK(driver.document().shapes.size() == operation.shapes);
        CHECK(driver.context().selection.shapes.size() == operation.shapes);
        CHECK(driver.context().preview->faults.empty());
        driver.key('Z', {Modifiers::kControl});
        CHECK(driver.document().shapes.size() == 2);
    }
    driver.key('A', {Modifiers::kControl});
    driver.click("menu/Shape");
    driver.click("menu/edit.union");
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Regions: a click fills a face, a second click selects its region, and a click outside is refused") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.rectangle({3, 3}, {5, 5});
    driver.key('G');
    driver.clickPlace({2, 2});
    driver.clickPlace({7, 7});
    CHECK(driver.document().regionMarkers.size() == 1);
    CHECK(driver.context().selection.markers.size() == 1);
    driver.clickPlace({4, 4});
    CHECK(driver.document().regionMarkers.size() == 1);
    CHECK(driver.logHas("region-marker-outside"));
    CHECK(driver.has("canvas/error/goto"));
    CHECK(driver.document().regionMarkers[0].tag == 2);
}

} // namespace forefront::test
