#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>

namespace forefront::test {

namespace {

/// A meshed square with other runs beside it.
class Comparing : public MeshedSquare {
  public:
    Comparing() {
        script("click menu/Learn\nclick menu/learn.sides\nsettle");
        settle();
    }
    SideBySide &sides() { return context().sides; }
};

} // namespace

TEST_CASE("Side by side: runs with the other grids stand at the advance of the canvas, with the same mesh") {
    Comparing driver;
    REQUIRE(driver.sides().size() == 2);
    CHECK(driver.sides().variant(0).grid == GridKind::None);
    CHECK(driver.sides().variant(1).grid == GridKind::Uniform);
    CHECK(driver.has("sides/0"));
    CHECK(driver.has("sides/1"));
    driver.key(key::kHome);
    driver.settle();
    for (int k = 0; k < 5; ++k) {
        driver.key(key::kPeriod);
        driver.settle();
        for (std::size_t run = 0; run < 2; ++run) {
            CHECK(driver.sides().now(run).advance == driver.run().advance);
            CHECK(driver.sides().now(run).stateHash == driver.run().stateHash);
        }
    }
    driver.key(key::kEnd);
    driver.settle();
    for (std::size_t run = 0; run < 2; ++run) {
        CHECK(driver.sides().now(run).meshHash == driver.run().meshHash);
        for (const char *figure : {"advances", "elements", "front", "neighbours", "tests", "cells", "time"}) {
            CHECK(driver.has(std::string("sides/") + figure + '/' + std::to_string(run + 1)));
        }
    }
}

TEST_CASE("Side by side: the other method runs beside the one shown") {
    Comparing driver;
    driver.click("sides/comparison/Methods");
    driver.settle();
    REQUIRE(driver.sides().size() == 1);
    CHECK(driver.sides().variant(0).method == Method::Classic);
    CHECK(driver.sides().now(0).complete);
    CHECK_FALSE(driver.has("sides/1"));
}

TEST_CASE("Side by side: dragging and scrolling over a view moves the camera of all views") {
    Comparing driver;
    const WidgetRegistry::Widget *const view = driver.context().widgets.find("sides/0");
    REQUIRE(view != nullptr);
    const Pixel middle = view->rect.centre();
    const Camera before = driver.context().view.camera;
    driver.drag(middle, middle + Pixel(40.0, 25.0));
    CHECK(distance(driver.context().view.camera.centre, before.centre) > 0.1 * 40.0 / before.zoom);
    driver.scroll(middle, 2.0);
    CHECK(driver.context().view.camera.zoom > before.zoom);
}

TEST_CASE("Side by side: a new mesh is compared anew, and closing gives the canvas its width back") {
    Comparing driver;
    const double narrow = driver.canvas().width;
    const std::uint64_t first = driver.sides().now(0).meshHash;
    Document finer = driver.document();
    finer.spacing.size = 0.7;
    driver.context().document.apply(std::move(finer), "Size");
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.sides().now(0).meshHash == driver.run().meshHash);
    CHECK(driver.sides().now(0).meshHash != first);
    driver.click("sides/close");
    driver.settle();
    CHECK(driver.sides().size() == 0);
    CHECK(driver.canvas().width > 2.5 * narrow);
}

} // namespace forefront::test
