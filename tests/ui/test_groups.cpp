#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/panels/shape_tree.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace forefront;
using namespace forefront::test;

namespace {

using Ids = std::set<std::uint32_t>;

/// Draws three circles and makes the first two a group.
void drawGroup(Draughtsman &driver) {
    std::vector<Shape> shapes(3);
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const double x = 2.0 + 3.0 * static_cast<double>(k);
        shapes[k].form = formOf(ShapeKind::Circle);
        shapes[k].nodes = {{x, 4}, {x + 1, 4}};
    }
    driver.context().document.apply(*addShapes({}, shapes), "Draw");
    driver.key('V');
    driver.context().selection.shapes = {1, 2};
    driver.key('G', kControl);
    driver.settle();
    driver.context().selection.clear();
}

Ids selected(Draughtsman &driver) {
    return driver.context().selection.shapes;
}

} // namespace

TEST_CASE("Groups: a click selects the group, Ctrl a shape of it, Shift adds and removes the group") {
    Draughtsman driver;
    drawGroup(driver);
    CHECK(driver.undoLabel() == "Group");
    const auto said = [&] { return driver.context().log.entries().back().diagnostic.message; };
    CHECK(said().starts_with("Grouped 2 shapes"));
    ShapeTree tree;
    tree.follow(driver.document(), driver.context().document.revision());
    CHECK(rowDetail(driver.document(), tree.rows()[1]) == "group 1, boundary_1");
    CHECK(rowDetail(driver.document(), tree.rows()[3]) == "boundary_1");
    driver.clickPlace({2, 5});
    CHECK(selected(driver) == Ids{1, 2});
    driver.context().selection.clear();
    driver.hold(kControl, true);
    driver.clickPlace({5, 5});
    driver.hold(kControl, false);
    CHECK(selected(driver) == Ids{2});
    driver.clickPlace({8, 5});
    CHECK(selected(driver) == Ids{3});
    driver.hold(kShift, true);
    driver.clickPlace({5, 5});
    CHECK(selected(driver) == Ids{1, 2, 3});
    driver.clickPlace({2, 5});
    driver.hold(kShift, false);
    CHECK(selected(driver) == Ids{3});
}

TEST_CASE("Groups: a group is dragged as one, a box that holds one of its shapes selects all, and it dissolves") {
    Draughtsman driver;
    drawGroup(driver);
    driver.dragPlaces({2, 5}, {2, 6});
    CHECK(driver.document().shapes[0]->nodes[0].y == doctest::Approx(5.0));
    CHECK(driver.document().shapes[1]->nodes[0].y == doctest::Approx(5.0));
    CHECK(driver.document().shapes[2]->nodes[0].y == 4.0);
    driver.context().selection.clear();
    driver.dragPlaces({0.5, 3.5}, {3.4, 6.6});
    CHECK(selected(driver) == Ids{1, 2});
    driver.key('G', kControlShift);
    driver.settle();
    CHECK(driver.undoLabel() == "Ungroup");
    driver.context().selection.clear();
    driver.clickPlace({2, 6});
    CHECK(selected(driver) == Ids{1});
}

TEST_CASE("Groups: a drag with Ctrl moves the whole group, a click with Ctrl and Shift adds one shape") {
    Draughtsman driver;
    drawGroup(driver);
    driver.hold(kControl, true);
    driver.dragPlaces({2, 5}, {2, 6});
    driver.hold(kControl, false);
    CHECK(driver.document().shapes[0]->nodes[0].y > 4.5);
    CHECK(driver.document().shapes[1]->nodes[0].y == doctest::Approx(driver.document().shapes[0]->nodes[0].y));
    CHECK(selected(driver) == Ids{1, 2});
    driver.context().selection.shapes = {3};
    driver.hold(kControlShift, true);
    driver.clickPlace({5, 6});
    driver.hold(kControlShift, false);
    CHECK(selected(driver) == Ids{2, 3});
}
