#include "core/drawing/formulas/spacing_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace forefront;
using namespace forefront::test;

TEST_CASE("Paste: the shapes of another program stay apart, and the log says what was not read") {
    Draughtsman driver;
    driver.platform().setClipboard(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">
        <rect x="1" y="1" width="8" height="8" fill="#ccc"/>
        <rect x="1" y="1" width="8" height="8" fill="none" stroke="#000"/>
        <circle cx="5" cy="5" r="2" fill="#f00"/>
        <path d="M 12 2 C 14 2 14 8 16 8" fill="none" stroke="#000"/>
        <text x="1" y="1">title</text></svg>)");
    driver.key('V', {Modifiers::kControl});
    driver.settle();
    const auto &shapes = driver.document().shapes;
    REQUIRE(shapes.size() == 3);
    CHECK(shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(shapes[0]->nodes.size() == 4);
    CHECK(shapes[0]->use == ShapeUse::Boundary);
    CHECK(shapes[1]->kind() == ShapeKind::Circle);
    CHECK(shapes[1]->use == ShapeUse::Boundary);
    CHECK(shapes[2]->kind() == ShapeKind::Polyline);
    CHECK(shapes[2]->use == ShapeUse::Constraint);
    CHECK(shapes[2]->path().curves.size() == 1);
    CHECK(distance(shapes[2]->nodes.front(), shapes[2]->nodes.back()) == doctest::Approx(std::hypot(4, 6)));
    for (const char *code : {"svg-shapes", "svg-duplicate", "svg-stroke", "svg-element"}) {
        CAPTURE(code);
        CHECK(driver.logHas(code));
    }
}

TEST_CASE("Paste: boundary parts and points keep their sizes in another drawing, but do not change its parts") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    const PartSize size{0.25, 0.1};
    driver.context().document.apply(*setPartSize(driver.document(), 1, size), "Size");
    driver.key('V');
    driver.key('A', {Modifiers::kControl});
    driver.key('C', {Modifiers::kControl});
    driver.key('N', {Modifiers::kControl});
    driver.settle();
    driver.click("dialog/unsaved/discard");
    driver.settle();
    REQUIRE(driver.document().shapes.empty());
    driver.key('V', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    REQUIRE(driver.document().spacing.partSizes.contains(1));
    CHECK(driver.document().spacing.partSizes.at(1) == size);
    driver.context().document.apply(*setPartSize(driver.document(), 1, PartSize{0.5, 0.1}), "Size");
    driver.key('V', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.document().shapes.size() == 2);
    CHECK(driver.document().spacing.partSizes.at(1) == PartSize{0.5, 0.1});
}

TEST_CASE("Clipboard: copy, paste beside the original, and cut") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {3, 2});
    driver.key('V');
    driver.key('C', kControl);
    driver.key('V', kControl);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.document().shapes[1]->nodes != driver.document().shapes[0]->nodes);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{2});
    CHECK(driver.undoLabel() == "Paste");
    driver.key('X', kControl);
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.undoLabel() == "Cut");
    driver.key('N', kControl); // another drawing, as in another window
    driver.settle();
    driver.click("dialog/unsaved/discard");
    driver.settle();
    REQUIRE(driver.document().shapes.empty());
    driver.key('V', kControl);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Rectangle);
}

TEST_CASE("Clipboard: a second paste is offset from the first") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {3, 2});
    driver.key('V');
    driver.key('C', kControl);
    driver.key('V', kControl);
    driver.key('V', kControl);
    REQUIRE(driver.document().shapes.size() == 3);
    const auto corner = [&](std::size_t k) { return driver.document().shapes[k]->nodes[0]; };
    CHECK(corner(1) != corner(0));
    CHECK(corner(2) != corner(0));
    CHECK(corner(2) != corner(1));
}

TEST_CASE("Clipboard: cut removes only what it copies") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {3, 1}, {3, 3}, {1, 3}});
    driver.polygon({{5, 1}, {7, 1}, {7, 3}, {5, 3}});
    driver.context().selection.shapes = {1};
    driver.context().selection.nodes = {{2, 0}};
    driver.context().selection.segments = {{2, 2}};
    driver.key('X', kControl);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{5, 1}, {7, 1}, {7, 3}, {5, 3}});
    driver.key('V', kControl);
    CHECK(driver.document().shapes.size() == 2);
}

TEST_CASE("Clipboard: two columns of a spreadsheet become a shape; other text is refused") {
    Draughtsman driver;
    driver.platform().setClipboard("1\t0\n0.5\t0.1\n0\t0\n0.5\t-0.1\n");
    driver.key('V', kControl);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{1, 0}, {0.5, 0.1}, {0, 0}, {0.5, -0.1}});
    driver.platform().setClipboard("nothing to draw");
    driver.key('V', kControl);
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.logHas("no-drawing"));
}
