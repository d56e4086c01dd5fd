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
