#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace forefront;
using namespace forefront::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// Returns the largest turn of a path between segments, in radians.
double sharpest(const Shape &shape) {
    const Outline outline = outlineOf(shape);
    double worst = 0.0;
    const std::size_t count = outline.segmentCount();
    for (std::size_t k = 0; k + (outline.closed ? 0 : 1) < count; ++k) {
        const Vec2 a = outline.curve(k).tangent(1.0), b = outline.curve((k + 1) % count).tangent(0.0);
        worst = std::max(worst, std::fabs(std::atan2(cross(a, b), dot(a, b))));
    }
    return worst;
}

} // namespace

TEST_CASE("Arc by centre: the hand chooses the direction, also beyond half a turn") {
    Draughtsman driver;
    driver.key('A');
    driver.click("options/arc/Centre");
    driver.clickPlace({5, 5});
    driver.clickPlace({7, 5});
    driver.moveToPlace({5, 3}); // clockwise
    driver.moveToPlace({3, 5});
    driver.clickPlace({5, 7});
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.undoLabel() == "Draw arc");
    const Curve long270 = driver.document().shapes[0]->path().curves.at(0);
    CHECK(long270.length() == doctest::Approx(1.5 * kPi * 2.0));
    CHECK(distance(long270.point(1.0 / 3.0), {5, 3}) < 1e-9);
    driver.clickPlace({5, 5});
    driver.clickPlace({6, 5});
    driver.moveToPlace({6, 5.5}); // counter-clockwise
    driver.type("270");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(distance(driver.document().shapes[1]->path().curves.at(0).point(1.0 / 3.0), {5, 6}) < 1e-9);
    driver.clickPlace({5, 5});
    driver.key(key::kBackspace);
    CHECK(driver.context().tools.current().undoLabel(driver.context()).empty());
    driver.click("options/arc/Three points");
    driver.clickPlace({1, 1});
    driver.clickPlace({3, 1});
    driver.clickPlace({2, 2});
    CHECK(radiusOf(driver.document().shapes[2]->path().curves.at(0)) == doctest::Approx(1.0));
}

TEST_CASE("Pen: an outline of lines and tangent arcs is drawn in one go, and closed by an arc") {
    Draughtsman driver;
    driver.key('P');
    driver.clickPlace({3, 3});
    driver.clickPlace({7, 3});
    driver.key('A');
    CHECK(driver.context().tools.current().statusText(driver.context()).find("L: line") != std::string::npos);
    driver.clickPlace({7, 5}); // half a circle
    driver.key('L');
    driver.clickPlace({3, 5});
    driver.key('A');
    driver.clickPlace({3, 3}); // the first node
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape &stadium = *driver.document().shapes[0];
    CHECK(stadium.kind() == ShapeKind::Polygon);
    CHECK(stadium.nodes.size() == 4);
    CHECK(areaOf(stadium) == doctest::Approx(8.0 + kPi));
    CHECK(sharpest(stadium) < 1e-9);
    CHECK(driver.undoLabel() == "Draw polygon");
    CHECK(std::string(driver.context().tools.current().id()) == "polygon"); // A and L did not change the tool
    driver.key('Z', kControl);
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Pen: arcs by a typed radius and angle, and through a point; undo removes them one by one") {
    Draughtsman driver;
    driver.context().document.apply(*setParameters(driver.document(), {{"r", "1"}}), "Set parameters");
    driver.frames(2);
    driver.key('L');
    driver.clickPlace({1, 2});
    driver.clickPlace({4, 2});
    driver.key('A');
    driver.moveToPlace({5, 3}); // to the left
    driver.type("=2*r");
    driver.key(key::kTab);
    driver.type("90");
    driver.key(key::kEnter);
    driver.click("options/segment/Through");
    driver.clickPlace({7, 7});
    driver.key(key::kBackspace); // the point
    driver.clickPlace({7, 5});
    driver.clickPlace({8, 4});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape drawn = *driver.document().shapes[0];
    REQUIRE(drawn.nodes.size() == 4);
    CHECK(distance(drawn.nodes[2], {6, 4}) < 1e-9);
    CHECK(radiusOf(drawn.path().curves[1]) == doctest::Approx(2.0));
    CHECK(distance(drawn.path().curves[2].point(0.5), {7, 5}) < 1e-6);
    CHECK(driver.document().formulas.at("shape/1/arcRadius/1"_number) == "2*r");
    driver.context().document.apply(*overrideParameters(driver.document(), {{"r", "0.5"}}), "Change parameter");
    const Shape &smaller = *driver.document().shapes[0];
    CHECK(distance(smaller.nodes[2], {5, 3}) < 1e-9);
    CHECK(radiusOf(smaller.path().curves[1]) == doctest::Approx(1.0));
    CHECK(distance(smaller.path().curves[1].tangent(0.0), {1, 0}) < 1e-6);

    driver.clickPlace({2, 8});
    driver.key('A'); // without a segment before it: through a point
    driver.clickPlace({3, 9});
    driver.clickPlace({4, 8});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(radiusOf(driver.document().shapes[1]->path().curves.at(0)) == doctest::Approx(1.0));
    driver.clickPlace({1, 1});
    driver.clickPlace({2, 1}); // a line again
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.at(2)->path().curves.empty());
}

TEST_CASE("Inspector: the radius of an arc of a path can be changed") {
    Draughtsman driver;
    driver.key('A');
    driver.clickPlace({3, 3});
    driver.clickPlace({5, 3});
    driver.clickPlace({4, 4});
    driver.key('V');
    driver.context().selection.clear();
    driver.context().selection.segments.insert({1, 0});
    driver.frames(3);
    driver.fill("inspector/arcradius", "2");
    CHECK(radiusOf(driver.document().shapes[0]->path().curves.at(0)) == doctest::Approx(2.0));
    CHECK(driver.undoLabel() == "Change radius");
    driver.fill("inspector/arcradius", "0.5");
    CHECK(driver.logHas("bad-number"));
    CHECK(radiusOf(driver.document().shapes[0]->path().curves.at(0)) == doctest::Approx(2.0));
}
