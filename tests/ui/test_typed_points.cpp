#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Typed points: X after the first corner asks for the opposite corner; a comma or Tab leads to its y") {
    Draughtsman driver;
    driver.key('R');
    driver.clickPlace({1, 1});
    driver.moveToPlace({4, 3});
    driver.keys("x7,6.5");
    driver.key(key::kEnter);
    driver.clickPlace({2, 2});
    driver.keys("x3");
    driver.key(key::kTab);
    driver.keys("2.5");
    driver.key(key::kEnter);
    driver.clickPlace({4, 2});
    driver.keys("y5");
    driver.key(key::kEnter); // the pointer still chooses x
    driver.clickPlace({6, 3});
    driver.key('K');
    driver.clickPlace({3, 3});
    driver.keys("x3.5,4");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 4);
    CHECK(boundsOf(*driver.document().shapes[0]) == Box2{{1, 1}, {7, 6.5}});
    CHECK(boundsOf(*driver.document().shapes[1]) == Box2{{2, 2}, {3, 2.5}});
    CHECK(boundsOf(*driver.document().shapes[2]) == Box2{{4, 2}, {6, 5}});
    CHECK(boundsOf(*driver.document().shapes[3]) == Box2{{3, 3}, {3.5, 4}});
}

TEST_CASE("Typed points: a minus sign or a decimal point begins the first number, too, and zooms or steps nothing") {
    Draughtsman driver;
    const double zoom = driver.context().view.camera.zoom;
    driver.key('R');
    driver.keys("-5");
    driver.key(key::kTab);
    driver.keys("-3");
    driver.key(key::kEnter);
    driver.keys(".5");
    driver.key(key::kTab);
    driver.keys("2");
    driver.key(key::kEnter);
    driver.key('C');
    driver.keys(".5");
    driver.key(key::kTab);
    driver.keys("-.25");
    driver.key(key::kEnter);
    driver.keys("1");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(boundsOf(*driver.document().shapes[0]) == Box2{{-5, -3}, {-4.5, -1}});
    CHECK(driver.document().shapes[1]->nodes[0] == Vec2{0.5, -0.25});
    CHECK(driver.context().view.camera.zoom <= zoom); // the numbers are shown
    CHECK(driver.context().settings.workspace == WorkspaceKind::Draw);
}

TEST_CASE("Typed numbers: width and height go right and up, negative ones left and down, wherever the pointer is") {
    Draughtsman driver;
    const auto box = [&](Vec2 corner, Vec2 pointer, const char *width, const char *height) {
        driver.clickPlace(corner);
        driver.moveToPlace(pointer);
        driver.keys(width);
        driver.key(key::kTab);
        driver.keys(height);
        driver.key(key::kEnter);
        return boundsOf(*driver.document().shapes.back());
    };
    for (const int tool : {int{'R'}, int{'K'}}) {
        driver.key(tool);
        CHECK(box({5, 5}, {2, 1}, "3", "4") == Box2{{5, 5}, {8, 9}});
        CHECK(box({7, 7}, {8, 9.5}, "-3", "-4") == Box2{{4, 3}, {7, 7}});
        CHECK(box({6, 6}, {9, 1}, "-2", "1") == Box2{{4, 6}, {6, 7}});
    }
    driver.clickPlace({1, 1});
    driver.keys("0");
    driver.key(key::kTab); // refused: the field stays open
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.size() == 6);
    driver.key(key::kEscape);
    driver.key(key::kEscape);
    driver.key('R'); // the first corner typed, too, and only the width: the pointer chooses the height
    driver.moveToPlace({7, 7});
    driver.keys("2");
    driver.key(key::kTab);
    driver.keys("3");
    driver.key(key::kEnter);
    driver.keys("4,1");
    driver.key(key::kEnter);
    CHECK(boundsOf(*driver.document().shapes.back()) == Box2{{2, 3}, {6, 4}});
}

TEST_CASE("Typed numbers: a regular polygon of a typed radius has a corner on the right, wherever the pointer is") {
    Draughtsman driver;
    driver.key('H');
    driver.clickPlace({5, 5});
    driver.moveToPlace({4, 7.2});
    driver.keys("2");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes[0] == Vec2{7, 5});
    driver.moveToPlace({3, 3});
    driver.clickPlace({5, 5});
    driver.moveToPlace({6, 6});
    driver.keys("2q180");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(distance(driver.document().shapes[1]->nodes[0], {3, 5}) < 1e-12);
}

TEST_CASE("Typed numbers: the view shows what is typed outside it, and keeps still otherwise") {
    Draughtsman driver;
    const View &view = driver.context().view;
    const auto shows = [&](const Box2 &box) {
        const Box2 visible = view.camera.visible();
        return visible.contains(box.min) && visible.contains(box.max);
    };
    const auto typed = [&](const char *first, const char *second) {
        driver.keys(first);
        driver.key(key::kTab);
        driver.keys(second);
        driver.key(key::kEnter);
        driver.settle();
    };
    driver.key('R');
    const Camera before = view.camera;
    driver.clickPlace({1, 1});
    typed("6", "5");
    CHECK(view.camera == before);
    const Box2 seen = before.visible();
    typed("20", "15"); // the corner, then the size
    CHECK(shows({{20, 15}, {20, 15}}));
    CHECK(shows({{1, 1}, {7, 6}})); // what was in view, too
    typed("40", "3");
    CHECK(shows({{20, 15}, {60, 18}}));
    CHECK(view.camera.visible().size().x < 4.2 * seen.size().x); // just enough
    driver.key('P');
    const double zoom = view.camera.zoom;
    typed("2", "3");
    typed("1", "90");
    CHECK(view.camera.zoom == zoom);
    typed("300", "180");
    CHECK(shows({{-298, 4}, {2, 4}}));
    driver.key(key::kEscape);
    // Zoomed in on purpose: what the pointer draws does not move the view, even if the shape is larger.
    driver.context().view.zoomAt(driver.pixel({20, 15}), 100.0);
    const Camera close = view.camera;
    driver.key('R');
    driver.clickPlace(close.toPlane(driver.canvas().centre()));
    driver.clickPlace(close.toPlane(driver.canvas().centre() + Pixel(80, 60)));
    CHECK(driver.document().shapes.size() == 3);
    CHECK(view.camera == close);
}

TEST_CASE("Paste: the view shows coordinates that lie outside it, and keeps still otherwise") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    const Camera before = driver.context().view.camera;
    driver.platform().setClipboard("2 2\n4 2\n4 4\n2 2\n");
    driver.key('V', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.context().view.camera == before);
    driver.platform().setClipboard("100 50\n120 50\n120 60\n100 50\n");
    driver.key('V', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 3);
    const Box2 visible = driver.context().view.camera.visible();
    CHECK(visible.contains({120, 60}));
    CHECK(visible.contains({1, 1}));
}

TEST_CASE("Typed numbers: the view follows a node that is dragged or set to a place outside it") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 6}});
    driver.key('V');
    driver.press(driver.pixel({9, 6}));
    driver.moveToPlace({8, 5});
    driver.type("30,20");
    driver.key(key::kEnter);
    driver.release(driver.pixel({8, 5}));
    driver.settle();
    CHECK(driver.context().view.camera.visible().contains({30, 20}));
    driver.fill("inspector/at/x", "-50");
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{-50, 20});
    CHECK(driver.context().view.camera.visible().contains({-50, 20}));
}

TEST_CASE("Typed points: a dragged node goes to a typed point or by a typed way; that is one undo step") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
    driver.key('V');
    const auto drag = [&](Vec2 from, std::string_view typed) {
        driver.press(driver.pixel(from));
        driver.moveToPlace(from - Vec2{1, 1});
        driver.type(typed);
        driver.key(key::kEnter);
        driver.moveToPlace({5, 5}); // the button is still down, but the move is over
        driver.release(driver.pixel({5, 5}));
        driver.frames(30);
    };
    drag({9, 9}, "7.25,8.125");
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{7.25, 8.125});
    CHECK(driver.undoLabel() == "Move node");
    drag({1, 9}, "@0.5,-1");
    CHECK(driver.document().shapes[0]->nodes[3] == Vec2{1.5, 8});
    driver.press(driver.pixel({9, 1}));
    driver.moveToPlace({8, 2});
    driver.keys("x8.5,1.75");
    driver.key(key::kEnter);
    driver.release(driver.pixel({8, 2}));
    CHECK(driver.document().shapes[0]->nodes[1] == Vec2{8.5, 1.75});
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->nodes[1] == Vec2{9, 1});
    CHECK(driver.run().state == RunState::Empty); // no digit was a shortcut
}

TEST_CASE("Typed points: x, y in one field of a position sets both") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 9}});
    driver.key('V');
    driver.clickPlace({9, 9});
    driver.fill("inspector/at/x", "8, 7.5");
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{8, 7.5});
    driver.fill("inspector/at/x", "8, no");
    CHECK(driver.document().shapes[0]->nodes[2] == Vec2{8, 7.5});
    CHECK(driver.has("inspector/at/x/fault"));
}

TEST_CASE("Rubber band: follows keys, undo and zoom while the pointer rests") {
    Draughtsman driver;
    const auto drawn = [&] { return driver.picture(); };
    const auto afterMove = [&](Vec2 place) { // the picture after the pointer has moved there
        driver.moveTo(driver.pixel(place) + Pixel(40, 0));
        driver.moveTo(driver.pixel(place));
        driver.settle();
        return driver.picture();
    };
    SUBCASE("undo of a shape that the pointer snapped to") {
        driver.rectangle({3, 3}, {6.37, 6.41});
        driver.key('L');
        driver.clickPlace({1, 1});
        const Vec2 near = driver.context().view.camera.toPlane(driver.pixel({6.37, 6.41}) + Pixel(4, 3));
        driver.moveToPlace(near); // snaps to the corner
        driver.context().document.undo();
        driver.context().animate();
        driver.settle();
        const auto shown = drawn();
        CHECK(shown.differences(afterMove(near), driver.canvas()) == 0);
    }
    SUBCASE("Backspace, which moves the foot of a perpendicular") {
        driver.rectangle({3, 3}, {8, 8});
        driver.key('L');
        driver.clickPlace({1, 5});
        driver.clickPlace({1.5, 4.2});
        driver.moveToPlace({3.02, 4.24});
        driver.key(key::kBackspace);
        driver.settle();
        const auto shown = drawn();
        CHECK(shown.differences(afterMove({3.02, 4.24}), driver.canvas()) == 0);
    }
    SUBCASE("zoom by key") {
        driver.rectangle({3, 3}, {5, 5});
        driver.key('L');
        driver.clickPlace({1, 1});
        driver.moveToPlace({6, 6});
        const Pixel rest = driver.pixel({6, 6});
        driver.key('F');
        driver.settle();
        const auto shown = drawn();
        CHECK(shown.differences(afterMove(driver.context().view.camera.toPlane(rest)), driver.canvas()) == 0);
    }
}

} // namespace forefront::test
