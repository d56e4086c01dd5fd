#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace forefront;
using namespace forefront::test;

TEST_CASE("Handles: a corner scales the selection, Shift keeps proportions, Ctrl keeps the centre; one undo step") {
    Draughtsman driver;
    driver.rectangle({3, 3}, {6, 5});
    driver.key('V');
    driver.settle();
    const auto box = [&] { return boundsOf(*driver.document().shapes[0]); };
    const Pixel right = driver.pixel({6, 4}) + Pixel{12, 0}, corner = driver.pixel({6, 5}) + Pixel{12, -12};
    const double unit = driver.pixel({1, 0}).x - driver.pixel({0, 0}).x;
    const auto pull = [&](Pixel from, Vec2 by, Modifiers modifiers) {
        driver.drag(from, from + Pixel{by.x * unit, -by.y * unit}, 8, modifiers);
        driver.frames(30);
    };
    pull(right, {1, 0}, {});
    CHECK(box().max.x == doctest::Approx(7.0));
    CHECK(box().min == Vec2{3, 3});
    driver.press(driver.pixel({7, 4}) + Pixel{12, 0});
    driver.key(key::kEscape); // before anything moved: nothing to give up
    driver.release(driver.pixel({7, 4}) + Pixel{12, 0});
    CHECK(box().max.x == doctest::Approx(7.0));
    CHECK(driver.undoLabel() == "Scale");
    driver.key('Z', kControl);
    CHECK(box() == Box2{{3, 3}, {6, 5}});
    CHECK(driver.undoLabel() == "Draw rectangle");
    pull(corner, {1.5, 0.9}, kShift);
    CHECK(box().size().x / box().size().y == doctest::Approx(1.5));
    CHECK(box().min == Vec2{3, 3});
    driver.key('Z', kControl);
    pull(right, {1, 0}, kControl);
    CHECK(box().min.x == doctest::Approx(2.0));
    CHECK(box().max.x == doctest::Approx(7.0));
    driver.key('Z', kControl);
    driver.press(right);
    driver.moveTo(right + Pixel{40, 0});
    driver.type("1.5");
    CHECK(box().max.x == doctest::Approx(7.5));
    driver.key(key::kEnter);
    driver.moveTo(right + Pixel{80, 0}); // the typed factor stays
    driver.release(right + Pixel{80, 0});
    CHECK(box().max.x == doctest::Approx(7.5));
    driver.key('Z', kControl);
    driver.press(right);
    driver.moveTo(right + Pixel{40, 0});
    driver.key(key::kEscape);
    driver.moveTo(right + Pixel{60, 0});
    driver.release(right + Pixel{60, 0});
    CHECK(box() == Box2{{3, 3}, {6, 5}});
    CHECK(driver.undoLabel() == "Draw rectangle");
}

TEST_CASE("Handles: the round one rotates about the centre, Shift by steps of 15 degrees, or by a typed angle") {
    Draughtsman driver;
    driver.polygon({{3, 3}, {7, 3}, {7, 5}, {3, 5}});
    driver.key('V');
    driver.settle();
    const Pixel handle = driver.pixel({7, 5}) + Pixel{26, -26};
    const Vec2 centre{5, 4};
    const Vec2 from = driver.context().view.camera.toPlane(handle);
    const auto turned = [&](double degrees) { return driver.pixel(PlaneMap::rotation(degrees, centre)(from)); };
    driver.drag(handle, turned(40), 8, kShift);
    CHECK(driver.undoLabel() == "Rotate");
    const Vec2 corner = driver.document().shapes[0]->nodes[0];
    CHECK(distance(corner, PlaneMap::rotation(45, centre)({3, 3})) < 1e-9);
    driver.key('Z', kControl);
    driver.settle();
    driver.press(handle);
    driver.moveTo(turned(20));
    driver.keys("90");
    driver.key(key::kEnter);
    driver.release(turned(20));
    CHECK(driver.document().shapes[0]->nodes[0] == Vec2{6, 2});
    driver.key('Z', kControl);
    CHECK(driver.document().shapes[0]->nodes[0] == Vec2{3, 3});
    driver.key(key::kEscape); // without a selection there are no handles
    driver.drag(handle, turned(20));
    CHECK(driver.document().shapes[0]->nodes[0] == Vec2{3, 3});
}

TEST_CASE("Handles: only one number can be typed, neither a pair nor another field") {
    Draughtsman driver;
    driver.rectangle({3, 3}, {6, 5});
    driver.key('V');
    driver.settle();
    const auto width = [&] { return boundsOf(*driver.document().shapes[0]).size().x; };
    const Pixel right = driver.pixel({6, 4}) + Pixel{12, 0}, corner = driver.pixel({6, 5}) + Pixel{26, -26};
    driver.press(right);
    driver.moveTo(right + Pixel{40, 0});
    driver.keys("1");
    driver.type(".5,3");
    driver.key(key::kEnter); // not accepted
    driver.key(key::kBackspace);
    driver.key(key::kBackspace);
    CHECK(width() == doctest::Approx(4.5));
    driver.keys("x"); // not the field of x: part of the text, which is no number now
    driver.key(key::kBackspace);
    CHECK(width() == doctest::Approx(4.5));
    driver.key(key::kEnter);
    driver.release(right + Pixel{80, 0});
    CHECK(width() == doctest::Approx(4.5));
    driver.key('Z', kControl);
    driver.settle();
    driver.press(corner);
    driver.moveTo(corner + Pixel{0, 40});
    driver.keys("90d");
    driver.key(key::kBackspace);
    driver.type(",1");
    driver.key(key::kEnter); // not accepted
    driver.key(key::kBackspace);
    driver.key(key::kBackspace);
    driver.key(key::kEnter);
    driver.release(corner);
    CHECK(width() == doctest::Approx(2.0));
}
