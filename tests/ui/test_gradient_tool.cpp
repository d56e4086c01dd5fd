#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Gradient: two ends cover the plane, can be dragged later, and are one undo step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    driver.settle();
    driver.key('D');
    driver.fill("options/gradient/size", "0.1");
    driver.fill("options/gradient/endsize", "0.5");
    driver.dragPlaces({2, 5}, {6, 5});
    driver.settle();
    CHECK(driver.undoLabel() == "Add gradient");
    REQUIRE(driver.document().spacing.sources.size() == 1);
    const SizeSource &source = driver.document().spacing.sources[0];
    CHECK(source.plane);
    CHECK(source.endSize == 0.5);
    const auto rho = [&](Vec2 at) { return driver.context().preview->spacing->at(at); };
    CHECK(rho({1.2, 8.8}) == doctest::Approx(0.1));
    CHECK(rho({4, 8.8}) == doctest::Approx(0.3));
    CHECK(rho({8.8, 1.2}) == doctest::Approx(0.5));
    driver.key('V');
    driver.dragPlaces({6, 5}, {8, 5}); // its second end
    driver.settle();
    CHECK(driver.undoLabel() == "Move source");
    CHECK(rho({4, 8.8}) == doctest::Approx(0.1 + 0.4 / 3.0));
    driver.key('Z', {Modifiers::kControl});
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.document().spacing.sources.empty());
    CHECK(driver.undoLabel() == "Draw rectangle");
}

TEST_CASE("Gradient: equal factors, and paint inside the selected shapes only") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    driver.rectangle({2, 2}, {8, 5});
    driver.settle();
    const double outside = driver.context().preview->spacing->at({5, 7.5});
    driver.key('V');
    driver.context().selection.shapes = {driver.document().shapes[1]->id};
    driver.key('D');
    driver.click("options/gradient/geometric");
    driver.click("options/gradient/selection");
    driver.fill("options/gradient/size", "0.1");
    driver.fill("options/gradient/endsize", "0.4");
    driver.dragPlaces({2, 3}, {8, 3});
    driver.settle();
    CHECK(driver.undoLabel() == "Paint gradient");
    CHECK(driver.document().spacing.sources.empty());
    const auto rho = [&](Vec2 at) { return driver.context().preview->spacing->at(at); };
    CHECK(rho({5, 3.5}) == doctest::Approx(0.2).epsilon(0.02));
    CHECK(rho({2.1, 4}) == doctest::Approx(0.1).epsilon(0.05));
    CHECK(rho({5, 8.5}) == doctest::Approx(outside).epsilon(0.4));
    CHECK(rho({5, 8.5}) > 0.2);
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().spacing.paint.tiles.empty());
    // Without a selection it says so.
    driver.context().selection.clear();
    driver.dragPlaces({2, 3}, {7, 3});
    CHECK(driver.document().spacing.paint.tiles.empty());
    CHECK(driver.context().log.entries().back().announced);
}

TEST_CASE("Gradient tool: a right click keeps the shapes that the gradient is painted into") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {8, 8});
    driver.key('D');
    driver.settle();
    driver.click("options/gradient/selection");
    driver.press(driver.pixel({5, 5}), MouseButton::Right);
    driver.release(driver.pixel({5, 5}), MouseButton::Right);
    driver.settle();
    CHECK(driver.has("contextmenu"));
    CHECK(driver.context().selection.shapes.size() == 1);
}

TEST_CASE("Gradient tool: under a gradient, the inspector names no other rule where there is none") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {8, 8});
    driver.key('D');
    driver.dragPlaces({2, 2}, {7, 7});
    driver.key('V');
    driver.moveToPlace({4, 5});
    driver.settle();
    REQUIRE(driver.document().spacing.hasGradient());
    CHECK(driver.has("inspector/here"));
    CHECK_FALSE(driver.has("inspector/runnerup")); // it was a thousand times the size of the domain
}

} // namespace forefront::test
