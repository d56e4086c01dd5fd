#include "core/drawing/formulas/formulas.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Adds a parameter in the table of the open panel.
void addParameter(Draughtsman &driver, const std::string &name, const std::string &expression) {
    driver.showPanel("parameters");
    driver.settle();
    const std::string row = "parameters/" + std::to_string(driver.document().parameters.size());
    driver.click("parameters/add");
    driver.settle();
    driver.fill(row + "/name", name);
    driver.fill(row + "/expression", expression);
}

} // namespace

TEST_CASE("Parameters: fields accept expressions; a change updates all dependent numbers in one undo step") {
    Draughtsman driver;
    addParameter(driver, "r", "1.5");
    addParameter(driver, "gap", "r/3");
    REQUIRE(driver.document().parameters == std::vector<Parameter>{{"r", "1.5"}, {"gap", "r/3"}});
    driver.key('C');
    driver.dragPlaces({5, 5}, {6, 5});
    driver.key('V');
    driver.fill("inspector/radius", "2*r");
    CHECK(circleRadius(*driver.document().shapes[0]) == 3.0);
    CHECK(driver.document().formulas.at("shape/1/radius"_number) == "2*r");
    driver.showPanel("spacing");
    driver.fill("spacing/size", "gap");
    CHECK(*driver.document().spacing.size == doctest::Approx(0.5));
    driver.fill("spacing/expression", "gap + 0*x");
    driver.fill("parameters/0/expression", "1");
    CHECK(circleRadius(*driver.document().shapes[0]) == 2.0);
    CHECK(*driver.document().spacing.size == doctest::Approx(1.0 / 3.0));
    CHECK(driver.document().spacing.names.at("gap") == doctest::Approx(1.0 / 3.0));
    CHECK(driver.undoLabel() == "Change parameter r to 1");
    driver.key('Z', kControl);
    CHECK(circleRadius(*driver.document().shapes[0]) == 3.0);
    CHECK(driver.document().parameters[0].expression == "1.5");
    driver.dragPlaces({8, 5}, {7, 5}); // by hand: the radius no longer follows
    CHECK(circleRadius(*driver.document().shapes[0]) == 2.0);
    CHECK_FALSE(driver.document().formulas.contains("shape/1/radius"_number));
    CHECK(driver.document().formulas.contains("spacing/size"_number));
}

TEST_CASE("Parameters: a circle follows its diameter, by a number or a formula, and shows it again") {
    Draughtsman driver;
    addParameter(driver, "d", "3");
    driver.key('C');
    driver.dragPlaces({5, 5}, {6, 5});
    driver.key('V');
    driver.fill("inspector/diameter", "2.5");
    CHECK(circleRadius(*driver.document().shapes[0]) == 1.25);
    CHECK(driver.document().formulas.empty());
    driver.fill("inspector/diameter", "d + 1");
    CHECK(circleRadius(*driver.document().shapes[0]) == 2.0);
    CHECK(driver.document().formulas.at("shape/1/radius"_number) == "(d + 1)/2");
    driver.fill("parameters/0/expression", "2");
    CHECK(circleRadius(*driver.document().shapes[0]) == 1.5);
    driver.fill("inspector/diameter", "-1"); // refused
    CHECK(circleRadius(*driver.document().shapes[0]) == 1.5);
    driver.key(key::kEscape);
    driver.fill("inspector/diameter", "4");
    CHECK(circleRadius(*driver.document().shapes[0]) == 2.0);
    CHECK(driver.document().formulas.empty());
}

TEST_CASE("Parameters: a typed formula is shown in the field, and typing a number removes it") {
    Draughtsman driver;
    addParameter(driver, "w", "4");
    driver.rectangle({1, 1}, {5, 5}); // already as wide as w
    driver.key('V');
    driver.fill("inspector/size/x", "w");
    CHECK(driver.undoLabel() == "Change formula");
    CHECK(driver.document().formulas.at("shape/1/width"_number) == "w");
    driver.fill("inspector/size/x", "4");
    CHECK(driver.document().formulas.empty());
    driver.fill("inspector/corner/x", "w/4 + 1");
    CHECK(driver.document().formulas.at("shape/1/left"_number) == "w/4 + 1");
    CHECK(boundsOf(driver.document()).min == Vec2{2, 1});
}

TEST_CASE("Parameters: faults are shown beside the row and the field, and the drawing is unchanged") {
    Draughtsman driver;
    addParameter(driver, "r", "1");
    driver.fill("parameters/0/expression", "2*r");
    CHECK(driver.has("parameters/0/expression/fault"));
    CHECK(driver.document().parameters[0].expression == "1");
    driver.fill("parameters/0/expression", "2*");
    CHECK(driver.has("parameters/0/expression/fault"));
    driver.fill("parameters/0/expression", "2");
    CHECK_FALSE(driver.has("parameters/0/expression/fault"));
    CHECK(driver.document().parameters[0].expression == "2");
    driver.fill("parameters/0/name", "sin");
    CHECK(driver.has("parameters/0/name/fault"));
    CHECK(driver.document().parameters[0].name == "r");
    driver.key(key::kEscape);

    driver.rectangle({1, 1}, {5, 5});
    driver.key('V');
    driver.fill("inspector/size/x", "q");
    CHECK(driver.has("inspector/size/x/fault"));
    CHECK(driver.logHas("bad-number"));
    CHECK(driver.document().formulas.empty());
    driver.fill("inspector/size/x", "r");
    CHECK_FALSE(driver.has("inspector/size/x/fault"));
    driver.click("parameters/0/remove"); // the width follows it
    driver.settle();
    CHECK(driver.has("parameters/0/fault"));
    const Result<Document> removed = removeParameter(driver.document(), 0);
    REQUIRE_FALSE(removed);
    CHECK(removed.faults().front().message == "r is used by the width of rectangle 1");
    CHECK(driver.document().parameters.size() == 1);
    driver.fill("inspector/size/x", "3");
    driver.click("parameters/0/remove");
    driver.settle();
    CHECK(driver.document().parameters.empty());
}

TEST_CASE("Parameters: numbers typed on the canvas follow their expressions, and so do copies") {
    Draughtsman driver;
    addParameter(driver, "r", "1");
    const auto typed = [&](std::string_view text) {
        for (const char c : text) {
            driver.key(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
            driver.type(std::string(1, c));
        }
        driver.key(key::kEnter);
    };
    driver.key('C');
    driver.moveToPlace({5, 5});
    typed("4*r, 5");
    typed("2*r");
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(circleRadius(*driver.document().shapes[0]) == 2.0);
    CHECK(driver.document().formulas ==
          std::map<NumberAddress, std::string>{{"shape/1/radius"_number, "2*r"}, {"shape/1/x/0"_number, "4*r"}});
    driver.key('R');
    driver.clickPlace({1, 1});
    typed("3");
    CHECK(driver.document().shapes.size() == 1); // the height is missing
    driver.key(key::kTab);
    driver.key(key::kEscape);
    driver.clickPlace({1, 1});
    driver.moveToPlace({3, 3});
    driver.type("=r/2");
    driver.key(key::kTab);
    driver.type("1.5*r");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.document().formulas.at("shape/2/width"_number) == "r/2");
    CHECK(driver.document().formulas.at("shape/2/height"_number) == "1.5*r");
    driver.key('V');
    driver.key('C', kControl);
    driver.key('V', kControl);
    CHECK(driver.document().formulas.at("shape/3/width"_number) == "r/2");
    driver.context().document.apply(*overrideParameters(driver.document(), {{"r", "1.2"}}), "Change parameter");
    CHECK(circleRadius(*driver.document().shapes[0]) == doctest::Approx(2.4));
    CHECK(boundsOf(*driver.document().shapes[2]).size().x == doctest::Approx(0.6));
    driver.key('P'); // nodes of a path
    driver.moveToPlace({8, 8});
    typed("1*r, 9");
    driver.clickPlace({3, 9.5});
    driver.clickPlace({2, 9.8});
    driver.key(key::kEnter);
    CHECK(driver.document().formulas.at("shape/4/x/0"_number) == "1*r");
    CHECK(driver.context().settings.workspace == WorkspaceKind::Draw); // the blank was text, not the key of Play
}

TEST_CASE("Parameters: a new one is named and given a value without the mouse") {
    Draughtsman driver;
    driver.showPanel("parameters");
    driver.click("parameters/add");
    driver.frames(2);
    driver.key('A', kControl);
    driver.type("d");
    driver.key(key::kTab);
    driver.frames(2);
    driver.key('A', kControl);
    driver.type("16");
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().parameters.size() == 1);
    CHECK(driver.document().parameters[0].name == "d");
    CHECK(driver.document().parameters[0].expression == "16");
}

TEST_CASE("Parameters: a circle of radius d/2, with d a parameter, begins on its right wherever the pointer is") {
    Draughtsman driver;
    addParameter(driver, "d", "3");
    driver.key('C');
    driver.clickPlace({4, 4});
    driver.moveToPlace({6, 7});
    driver.key('D');
    driver.type("d/2");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{4, 4}, {5.5, 4}});
    CHECK(driver.document().formulas.at("shape/1/radius"_number) == "d/2");
}

TEST_CASE("Parameters: a negative width is drawn to the left and keeps its expression") {
    Draughtsman driver;
    addParameter(driver, "r", "2");
    driver.key('R');
    driver.clickPlace({7, 2});
    driver.type("=-r");
    driver.key(key::kTab);
    driver.type("1.5*r");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(boundsOf(*driver.document().shapes[0]) == Box2{{5, 2}, {7, 5}});
    CHECK(driver.document().formulas.at("shape/1/width"_number) == "-(-r)");
    CHECK(driver.document().formulas.at("shape/1/height"_number) == "1.5*r");
    driver.clickPlace({4, 4});
    driver.type("-1");
    driver.key(key::kTab);
    driver.type("-2");
    driver.key(key::kEnter);
    CHECK(boundsOf(*driver.document().shapes[1]) == Box2{{3, 2}, {4, 4}});
    driver.key('K'); // half of each is stored
    driver.clickPlace({4, 5});
    driver.type("2");
    driver.key(key::kTab);
    driver.type("2*r");
    driver.key(key::kEnter);
    CHECK(driver.document().formulas.size() == 4);
    CHECK(driver.document().formulas.at("shape/1/left"_number) == "7 - r"); // the right side stays
    CHECK(driver.document().formulas.at("shape/3/ry"_number) == "(2*r)/2");
}

TEST_CASE("Parameters: a path that undo brings back keeps the expressions of its nodes") {
    Draughtsman driver;
    addParameter(driver, "r", "2");
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.key('X');
    driver.type("x2*r");
    driver.key(key::kTab);
    driver.type("3");
    driver.key(key::kEnter);
    driver.key(key::kEscape);
    driver.key('Z', kControl);
    driver.clickPlace({1, 6});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes[1] == Vec2{4, 3});
    CHECK(driver.document().formulas.size() == 1);
}

TEST_CASE("Parameters: an end that meets its own path moves the node there with it") {
    Draughtsman driver;
    addParameter(driver, "w", "4");
    driver.key('L');
    driver.clickPlace({2, 2});
    driver.clickPlace({8, 2});
    driver.clickPlace({8, 6});
    driver.type("=w, 2");
    driver.key(key::kEnter);
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    REQUIRE(driver.document().shapes[0]->nodes.size() == 5);
    driver.context().document.apply(*overrideParameters(driver.document(), {{"w", "5"}}), "Change parameter");
    const std::vector<Vec2> &nodes = driver.document().shapes[0]->nodes;
    CHECK(nodes[1] == Vec2{5, 2});
    CHECK(nodes[4] == Vec2{5, 2});
}

TEST_CASE("Parameters: renaming one keeps the formulas that use it") {
    Draughtsman driver;
    addParameter(driver, "r", "1.5");
    driver.key('C');
    driver.dragPlaces({5, 5}, {6, 5});
    driver.key('V');
    driver.fill("inspector/radius", "r");
    driver.fill("parameters/0/name", "radius");
    CHECK(driver.document().formulas.at("shape/1/radius"_number) == "radius");
    driver.fill("parameters/0/expression", "2");
    CHECK(circleRadius(*driver.document().shapes[0]) == 2.0);
}
