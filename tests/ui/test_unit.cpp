#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Draws a rectangle 4 wide and 2 high in a unit, and selects it.
void drawIn(Draughtsman &driver, LengthUnit unit) {
    Shape shape;
    shape.form = formOf(ShapeKind::Rectangle);
    shape.nodes = {{1, 1}, {5, 3}};
    Document document = *addShapes({}, {shape});
    document.unit = unit;
    document.spacing.size = 0.5;
    driver.context().document.apply(document, "Draw");
    driver.context().selection.shapes = {1};
    driver.settle();
}

void openUnit(Draughtsman &driver) {
    driver.context().actions.run("edit.unit", driver.context());
    driver.settle();
    REQUIRE(driver.has("dialog/unit/ok"));
}

Vec2 corner(Draughtsman &driver) {
    return driver.document().shapes[0]->nodes[1];
}

} // namespace

TEST_CASE("Unit: a length typed in another unit is converted, also where both co-ordinates are typed at once") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::Millimetre);
    driver.fill("inspector/size/x", "2 in");
    CHECK(corner(driver).x == doctest::Approx(1 + 50.8));
    driver.fill("inspector/size/y", "5cm");
    CHECK(corner(driver).y == doctest::Approx(1 + 50.0));
    driver.fill("inspector/size/y", "7 mm");
    CHECK(corner(driver).y == doctest::Approx(1 + 7.0));
    driver.showPanel("spacing");
    driver.settle();
    driver.fill("spacing/size", "0.1 cm");
    CHECK(driver.document().spacing.size == 1.0);
}

TEST_CASE("Unit: a unit is refused where the drawing has none, and where the field holds no length") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::None);
    driver.fill("inspector/size/x", "2 in");
    CHECK(driver.has("inspector/size/x/fault"));
    CHECK(
        driver.context().fieldFault.text.starts_with("the drawing has no unit; enter 2 alone, or choose Edit > Unit"));
    CHECK(corner(driver).x == 5.0);
}

TEST_CASE("Unit: the dialog scales the drawing or keeps its numbers, in one step that is undone") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::Millimetre);
    openUnit(driver);
    driver.click("dialog/unit/unit/cm"); // centimetres
    driver.settle();
    REQUIRE(driver.has("dialog/unit/way/Scale the coordinates"));
    driver.click("dialog/unit/ok");
    driver.settle();
    CHECK(driver.document().unit == LengthUnit::Centimetre);
    CHECK(corner(driver).x == doctest::Approx(0.5));
    CHECK(*driver.document().spacing.size == doctest::Approx(0.05));
    CHECK(driver.undoLabel() == "Change unit to cm");
    driver.key('Z', kControl);
    CHECK(driver.document().unit == LengthUnit::Millimetre);
    CHECK(corner(driver).x == 5.0);
    openUnit(driver);
    driver.click("dialog/unit/unit/m"); // metres
    driver.click("dialog/unit/way/Keep the numbers");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().unit == LengthUnit::Metre);
    CHECK(corner(driver).x == 5.0);
    openUnit(driver);
    driver.click("dialog/unit/unit/None");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/unit/way/Scale the coordinates"));
    driver.click("dialog/unit/cancel");
    driver.settle();
    CHECK(driver.document().unit == LengthUnit::Metre);
}

TEST_CASE("Unit: the corner of the rulers opens the dialog") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::Kilometre);
    driver.context().settings.rulers = true;
    driver.settle();
    driver.click("canvas/ruler/unit");
    driver.settle();
    CHECK(driver.has("dialog/unit/ok"));
}
