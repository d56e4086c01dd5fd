#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

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

TEST_CASE("Unit: both co-ordinates typed into one field may have units of their own") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::Millimetre);
    driver.context().selection.shapes.clear();
    driver.showPanel("nodes");
    driver.click("nodes/which/All shapes");
    driver.settle();
    driver.fill("nodes/1/3/x", "2 in, 3 cm");
    CHECK(corner(driver).x == doctest::Approx(50.8));
    CHECK(corner(driver).y == doctest::Approx(30.0));
}

TEST_CASE("Unit: a mesh has the unit that it was made in, or the one chosen for the same numbers") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::Centimetre);
    const RunControl &run = driver.context().run;
    driver.context().run.mesh();
    driver.settle();
    REQUIRE(run.now().complete);
    openUnit(driver);
    driver.click("dialog/unit/unit/mm");
    driver.settle();
    driver.click("dialog/unit/ok");
    driver.settle();
    CHECK(driver.document().unit == LengthUnit::Millimetre);
    CHECK(run.outOfDate());
    CHECK(run.shownUnit() == LengthUnit::Centimetre);
    driver.key('Z', kControl);
    driver.settle();
    openUnit(driver);
    driver.click("dialog/unit/unit/in");
    driver.settle();
    driver.click("dialog/unit/way/Keep the numbers");
    driver.click("dialog/unit/ok");
    driver.settle();
    CHECK(driver.document().unit == LengthUnit::Inch);
    CHECK_FALSE(run.outOfDate());
    CHECK(run.shownUnit() == LengthUnit::Inch);
}

TEST_CASE("Unit: scaled coordinates keep their formulas") {
    Draughtsman driver;
    drawIn(driver, LengthUnit::Centimetre);
    const NumberAddress width{NumberOwner::ofShape(1), Quantity::Width, 0};
    Document document = setFormula(driver.document(), width, "w");
    document.parameters = {{"w", "4"}};
    document.spacing.names = parameterValues(document.parameters);
    driver.context().document.apply(document, "Formula");
    REQUIRE(driver.document().formulas.contains(width));
    openUnit(driver);
    driver.click("dialog/unit/unit/mm");
    driver.settle();
    driver.click("dialog/unit/ok");
    driver.settle();
    REQUIRE(driver.document().formulas.contains(width));
    CHECK(driver.document().formulas.at(width) == "w*cm");
    CHECK(driver.document().parameters == std::vector<Parameter>{{"w", "4"}, {"cm", "10"}});
    CHECK(driver.context().log.entries().back().diagnostic.message ==
          "Expressions name the unit of their parameters: cm = 10");
    driver.key('Z', kControl);
    driver.settle();
    CHECK(driver.document().formulas.at(width) == "w");
    CHECK(driver.document().parameters == std::vector<Parameter>{{"w", "4"}});
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
    driver.click("dialog/unit/unit/cm");
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
    driver.click("dialog/unit/unit/m");
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
