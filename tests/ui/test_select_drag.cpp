#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

namespace forefront::test {

TEST_CASE("Select tool: keys do not act on what is being dragged; Esc cancels the drag") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 4});
    driver.key('V');
    driver.settle();
    const std::size_t steps = driver.context().document.history().position();
    driver.press(driver.pixel({1, 2}));
    driver.moveToPlace({3, 3});
    driver.key(key::kDelete);
    driver.key('Z', kControl);
    driver.key('P');
    driver.moveToPlace({4, 4});
    driver.release(driver.pixel({4, 4}));
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.undoLabel() == "Move shape");
    CHECK(driver.context().document.history().position() == steps + 1);
    CHECK(std::string(driver.context().tools.current().id()) == "select");
    const std::vector<Vec2> moved = driver.document().shapes[0]->nodes;
    driver.press(driver.pixel(moved[0] + Vec2{0, 1}));
    driver.moveToPlace({8, 8});
    driver.key(key::kEscape);
    driver.moveToPlace({9, 9});
    driver.release(driver.pixel({9, 9}));
    driver.settle();
    CHECK(driver.document().shapes[0]->nodes == moved);
    // Nor on what a box is drawn in, which would select a shape that is gone.
    const Vec2 inside = moved[0] + Vec2{1.5, 1.5};
    driver.context().selection = {.shapes = {1}};
    driver.press(driver.pixel(inside));
    driver.key(key::kDelete);
    driver.release(driver.pixel(inside));
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1});
}

} // namespace forefront::test
