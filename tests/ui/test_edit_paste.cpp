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
    CHECK(shapes[0]->kind == ShapeKind::Polygon);
    CHECK(shapes[0]->nodes.size() == 4);
    CHECK(shapes[0]->use == ShapeUse::Boundary);
    CHECK(shapes[1]->kind == ShapeKind::Circle);
    CHECK(shapes[1]->use == ShapeUse::Boundary);
    CHECK(shapes[2]->kind == ShapeKind::Polyline);
    CHECK(shapes[2]->use == ShapeUse::Constraint);
    CHECK(shapes[2]->curves.size() == 1);
    CHECK(distance(shapes[2]->nodes.front(), shapes[2]->nodes.back()) == doctest::Approx(std::hypot(4, 6)));
    for (const char *code : {"svg-shapes", "svg-duplicate", "svg-stroke", "svg-element"}) {
        CAPTURE(code);
        CHECK(driver.logHas(code));
    }
}
