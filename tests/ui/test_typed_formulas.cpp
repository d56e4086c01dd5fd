#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Draws with expressions of the parameters L = 4, w = 2 and r = 1.
class Parametric : public Draughtsman {
  public:
    Parametric() {
        context().document.apply(*setParameters(document(), {{"L", "4"}, {"w", "2"}, {"r", "1"}}), "Set parameters");
        frames(2);
    }
    /// Types expressions into the fields at the pointer, with Tab between them.
    void enter(const std::vector<std::string> &texts) {
        for (const std::string &text : texts) {
            if (&text != &texts.front()) {
                key(key::kTab);
            }
            type(text);
        }
        key(key::kEnter);
        frames(2);
    }
    /// Types a text into a field of a dialog, which stays open.
    void fillDialog(std::string_view field, std::string_view text) {
        click(field);
        key('A', kControl);
        type(text);
        key(key::kTab);
        settle();
    }
    void set(const std::string &name, const std::string &expression) {
        context().document.apply(*overrideParameters(document(), {{name, expression}}), "Change parameter");
        frames(2);
    }
    const Shape &shape(std::size_t k = 0) { return *document().shapes[k]; }
    std::string formula(const NumberAddress &address) {
        const auto found = document().formulas.find(address);
        return found != document().formulas.end() ? found->second : std::string();
    }
};

} // namespace

TEST_CASE("Typed formulas: an expression without parameters becomes its value, and binds nothing") {
    Parametric driver;
    driver.rectangle({1, 1}, {4, 3});
    driver.key('V');
    driver.fill("inspector/corner/x", "687123+1");
    CHECK(driver.shape().nodes[0].x == 687124.0);
    CHECK(driver.document().formulas.empty());
    driver.fill("inspector/corner/x", "2*w");
    CHECK(driver.document().formulas.size() == 1);
    driver.fill("inspector/corner/x", "3+1"); // the value that it has
    CHECK(driver.shape().nodes[0].x == 4.0);
    CHECK(driver.document().formulas.empty());
    driver.fill("inspector/corner/x", "2*pi");
    CHECK(driver.document().formulas.empty());
}

TEST_CASE("Typed formulas: the nodes of a pen path follow distances and angles; undo and a project file keep them") {
    Parametric driver;
    driver.key('P');
    driver.clickPlace({2, 2});
    driver.moveToPlace({4, 4});
    driver.enter({"=L", "0"});
    driver.enter({"=w", "90"});
    driver.enter({"=L/2", "180 - 30*r"});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.formula("shape/1/x/1"_number) == "2 + L");
    CHECK(driver.formula("shape/1/y/1"_number).empty());
    CHECK(driver.formula("shape/1/x/2"_number) == "2 + L");
    CHECK(driver.formula("shape/1/y/2"_number) == "2 + w");
    CHECK(driver.formula("shape/1/x/3"_number) == "2 + L + L/2*cos((180 - 30*r)*pi/180)");
    driver.set("L", "6");
    driver.set("w", "3");
    CHECK(driver.shape().nodes[1] == Vec2{8, 2});
    CHECK(driver.shape().nodes[2] == Vec2{8, 5});
    CHECK(distance(driver.shape().nodes[2], driver.shape().nodes[3]) == doctest::Approx(3.0));
    const Result<Document> read = parseProject(projectText(driver.document()), "test");
    REQUIRE(read.ok());
    CHECK(read->formulas == driver.document().formulas);
    CHECK(overrideParameters(*read, {{"L", "1"}})->shapes[0]->nodes[1] == Vec2{3, 2});
    driver.key('Z', kControl);
    CHECK(driver.shape().nodes[2] == Vec2{8, 4});
    driver.key('Z', kControl);
    CHECK(driver.shape().nodes[1] == Vec2{6, 2});
    CHECK(driver.formula("shape/1/x/1"_number) == "2 + L");
}

TEST_CASE("Typed formulas: a place relative to the last node follows; a mixture with a coordinate says so") {
    Parametric driver;
    driver.key('L');
    driver.moveToPlace({5, 5});
    driver.enter({"1*r, 2"});
    driver.enter({"@L, w/2"});
    driver.moveToPlace({8, 8});
    driver.clickPlace({7, 7});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.formula("shape/1/x/0"_number) == "1*r");
    CHECK(driver.formula("shape/1/x/1"_number) == "1*r + L");
    CHECK(driver.formula("shape/1/y/1"_number) == "2 + w/2");
    CHECK(driver.formula("shape/1/x/2"_number).empty());
    driver.set("r", "2");
    CHECK(driver.shape().nodes[1] == Vec2{6, 3});
}

TEST_CASE("Typed formulas: corners of rectangles and ellipses, and the corner radius, follow") {
    Parametric driver;
    driver.key('R');
    driver.fill("options/cornerradius", "r/4");
    driver.moveToPlace({5, 5});
    driver.enter({"1*r, 2"});
    driver.moveToPlace({7, 7});
    driver.enter({"=L, w + 1"}); // width, height
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().formulas == std::map<NumberAddress, std::string>{{"shape/1/left"_number, "1*r"},
                                                                             {"shape/1/width"_number, "L"},
                                                                             {"shape/1/height"_number, "w + 1"},
                                                                             {"shape/1/radius"_number, "r/4"}});
    driver.key('K');
    driver.clickPlace({1, 6});
    driver.moveToPlace({3, 8});
    driver.key('X');
    driver.type("1 + L,8");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.formula("shape/2/rx"_number) == "(1 + L - 1)/2");
    driver.set("L", "6");
    CHECK(boundsOf(driver.shape(0)) == Box2{{1, 2}, {7, 5}});
    CHECK(boundsOf(driver.shape(1)).max.x == doctest::Approx(7.0));
    CHECK(boundsOf(driver.shape(1)).min.x == doctest::Approx(1.0));
    driver.set("r", "2");
    CHECK(driver.shape(0).as<RectangleForm>().radius == 0.5);
    CHECK(boundsOf(driver.shape(0)).min.x == 2.0);
}

TEST_CASE("Typed formulas: regular polygons and size sources follow") {
    Parametric driver;
    driver.key('H');
    driver.clickPlace({3, 3});
    driver.moveToPlace({4, 4});
    driver.enter({"=2*r", "30*r"});
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.formula("shape/1/x/0"_number) == "3 + 2*r*cos(30*r*pi/180)");
    driver.set("r", "1.5");
    for (const Vec2 corner : driver.shape(0).nodes) {
        CHECK(distance(corner, {3, 3}) == doctest::Approx(3.0));
    }
    driver.key('S');
    driver.click("options/source/shape/Circle"); // a disc
    driver.fill("options/source/size", "r/10");
    driver.clickPlace({7, 7});
    driver.moveToPlace({8, 8});
    driver.enter({"=r"});
    REQUIRE(driver.document().spacing.sources.size() == 1);
    CHECK(driver.formula("source/0/radius"_number) == "r");
    CHECK(driver.formula("source/0/size"_number) == "r/10");
}

TEST_CASE("Typed formulas: a slot keeps width and length, by numbers, formulas and handles") {
    Parametric driver;
    driver.key('U');
    driver.clickPlace({2, 5});
    driver.moveToPlace({5, 5});
    driver.enter({"=L", "0"});
    driver.key('D');
    driver.type("dw");
    driver.key(key::kEnter);
    driver.frames(2);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.shape().kind() == ShapeKind::Slot);
    CHECK(driver.document().formulas ==
          std::map<NumberAddress, std::string>{{"shape/1/length"_number, "L"}, {"shape/1/width"_number, "w"}});
    driver.set("w", "1");
    CHECK(driver.shape().as<SlotForm>().radius == 0.5);
    driver.key('V');
    driver.fill("inspector/slotwidth", "w/2 + 1");
    CHECK(driver.shape().as<SlotForm>().radius == 0.75);
    CHECK(driver.formula("shape/1/width"_number) == "w/2 + 1");
    driver.fill("inspector/slotlength", "3");
    CHECK(driver.shape().nodes[1] == Vec2{5, 5});
    driver.fill("inspector/centre2/x", "L + 3");
    CHECK(driver.shape().nodes[1] == Vec2{7, 5});
    driver.dragPlaces({4.5, 5.75}, {4.5, 7}); // the side
    CHECK(driver.shape().as<SlotForm>().radius == doctest::Approx(2.0));
    CHECK(driver.formula("shape/1/width"_number).empty());
    driver.key('Z', kControl);
    CHECK(driver.shape().as<SlotForm>().radius == 0.75);
    driver.dragPlaces({2, 5}, {2, 3});
    CHECK(driver.shape().nodes[0] == Vec2{2, 3});
    CHECK(driver.shape().as<SlotForm>().radius == 0.75);
}

TEST_CASE("Typed formulas: a parameter's name begins a number while a shape is drawn, not a shortcut") {
    Parametric driver;
    const auto tool = [&] { return std::string(driver.context().tools.current().id()); };
    SUBCASE("slot") {
        driver.key('U');
        driver.clickPlace({2, 5});
        driver.clickPlace({6, 5});
        CHECK(driver.context().tools.current().typingHint(driver.context()).find("= or a parameter") == 0);
        driver.keys("w/2");
        CHECK(tool() == "slot");
        driver.key(key::kEnter);
        driver.frames(2);
        REQUIRE(driver.document().shapes.size() == 1);
        CHECK(driver.shape().as<SlotForm>().radius == 1.0);
        CHECK(driver.formula("shape/1/width"_number) == "w");
    }
    SUBCASE("circle") {
        driver.key('C');
        driver.clickPlace({5, 5});
        driver.keys("r");
        driver.key(key::kEnter);
        driver.frames(2);
        REQUIRE(driver.document().shapes.size() == 1);
        CHECK(driver.formula("shape/1/radius"_number) == "r");
        driver.keys("r"); // nothing is drawn now: the tool for rectangles
        CHECK(tool() == "rectangle");
    }
    SUBCASE("pen") {
        driver.key('P');
        driver.clickPlace({2, 2});
        driver.clickPlace({6, 2});
        driver.clickPlace({6, 6});
        driver.keys("w");
        CHECK(driver.document().shapes.empty());
        CHECK(tool() == "polygon");
        driver.key(key::kEscape); // the number, not the path
        driver.keys("l");         // a line
        driver.key(key::kEnter);
        CHECK(driver.document().shapes.size() == 1);
    }
}

TEST_CASE("Typed formulas: the length of a segment moves its end, which follows; the inspector says so") {
    Parametric driver;
    driver.polygon({{1, 1}, {4, 1}, {4, 3}});
    driver.key('V');
    driver.key(key::kEscape);
    driver.clickPlace({2.5, 1});
    driver.context().selection.clear();
    driver.context().selection.segments.insert({1, 0});
    driver.frames(3);
    driver.fill("inspector/length", "L + 1");
    CHECK(driver.shape().nodes[1] == Vec2{6, 1});
    CHECK(driver.formula("shape/1/x/1"_number) == "1 + L + 1");
    CHECK(driver.has("inspector/follows"));
    driver.set("L", "2");
    CHECK(driver.shape().nodes[1] == Vec2{4, 1});
    driver.key('Z', kControl);
    driver.key('Z', kControl);
    CHECK(driver.document().formulas.empty());
    driver.rectangle({1, 5}, {4, 7});
    driver.key('V');
    driver.context().selection.clear();
    driver.context().selection.segments.insert({2, 1});
    driver.frames(3);
    driver.fill("inspector/length", "w/2");
    CHECK(driver.formula("shape/2/height"_number) == "w/2");
}

TEST_CASE("Typed formulas: fields that cannot follow say that parameters are used once") {
    Parametric driver;
    driver.key('S');
    driver.click("options/source/shape/Line"); // a line
    driver.fill("options/source/endsize", "r/5");
    CHECK(driver.has("options/source/endsize/note"));
    driver.key('R');
    driver.dragPlaces({1, 1}, {5, 5});
    driver.key('V');
    driver.fill("inspector/size/x", "L + 1");
    CHECK_FALSE(driver.has("inspector/size/x/note"));
    driver.context().actions.run("shape.offset", driver.context());
    driver.frames(2);
    driver.fillDialog("dialog/offset/size", "0.5");
    CHECK_FALSE(driver.has("dialog/offset/once"));
    driver.fillDialog("dialog/offset/size", "r/2");
    CHECK(driver.has("dialog/offset/once"));
    driver.click("dialog/offset/cancel");
}

TEST_CASE("Typed formulas: a rectangle rounded by the fillet dialog keeps its formulas and gets one for the radius") {
    Parametric driver;
    driver.rectangle({1, 1}, {5, 3});
    driver.key('V');
    driver.fill("inspector/size/x", "L + 1");
    driver.context().actions.run("shape.fillet", driver.context());
    driver.frames(2);
    driver.fillDialog("dialog/fillet/size", "r/4");
    CHECK_FALSE(driver.has("dialog/fillet/once"));
    driver.click("dialog/fillet/ok");
    driver.frames(2);
    CHECK(driver.shape().kind() == ShapeKind::Rectangle);
    CHECK(driver.formula("shape/1/width"_number) == "L + 1");
    CHECK(driver.formula("shape/1/radius"_number) == "r/4");
    driver.set("r", "2");
    CHECK(driver.shape().as<RectangleForm>().radius == 0.5);
}

TEST_CASE("Typed formulas: arcs by three points and by their centre follow their radius, not an angle") {
    Parametric driver;
    driver.key('A');
    driver.clickPlace({1, 7});
    driver.clickPlace({3, 7});
    driver.moveToPlace({2, 7.5});
    driver.enter({"=2*r"});
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.formula("shape/1/arcRadius/0"_number) == "2*r");
    driver.click("options/arc/Centre");
    driver.clickPlace({5, 3});
    driver.moveToPlace({6, 3});
    driver.enter({"=2*r", "0"});
    driver.moveToPlace({6, 4});
    driver.enter({"90"});
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.formula("shape/2/x/0"_number) == "5 + 2*r");
    CHECK(driver.formula("shape/2/y/1"_number) == "3 + 2*r");
    driver.set("r", "1.5");
    CHECK(radiusOf(driver.shape(0).path().curves[0]) == doctest::Approx(3.0));
    CHECK(driver.shape(1).nodes == std::vector<Vec2>{{8, 3}, {5, 6}});
    CHECK(radiusOf(driver.shape(1).path().curves[0]) == doctest::Approx(3.0));
    CHECK(lengthOf(driver.shape(1)) == doctest::Approx(1.5 * std::numbers::pi));
}

TEST_CASE("Typed formulas: a moved shape takes them along; a turn removes those that no longer fit, and says so") {
    Parametric driver;
    driver.key('R');
    driver.clickPlace({1, 1});
    driver.moveToPlace({7, 7});
    driver.enter({"=L, w"});
    REQUIRE(driver.document().shapes.size() == 1);
    driver.context().document.apply(setFormula(driver.document(), "shape/1/left"_number, "r"), "Change formula");
    driver.key('V');
    driver.clickPlace({3, 1});
    const std::size_t messages = driver.context().log.entries().size();
    driver.dragPlaces({3, 1}, {5, 2}); // by pixels: a place is exact up to the rounding of the camera
    CHECK(distance(boundsOf(driver.shape()).min, {3, 2}) < 1e-9);
    CHECK(distance(boundsOf(driver.shape()).max, {7, 4}) < 1e-9);
    CHECK(driver.formula("shape/1/left"_number) == "r + 2");
    CHECK(driver.formula("shape/1/width"_number) == "L");
    CHECK(driver.context().log.entries().size() == messages);
    driver.set("r", "2");
    CHECK(boundsOf(driver.shape()) == Box2{{4, 2}, {8, 4}});
    driver.key(key::kLeftBracket, {Modifiers::kControl}); // a quarter turn
    driver.frames(2);
    CHECK(driver.document().formulas.empty());
    CHECK(driver.context().log.entries().back().diagnostic.message ==
          "Removed 3 expressions that no longer match their values: height of rectangle 1, left of rectangle 1, width "
          "of rectangle 1");
    // An expression that is typed over is not reported.
    driver.key('Z', {Modifiers::kControl});
    REQUIRE(driver.formula("shape/1/width"_number) == "L");
    const std::size_t before = driver.context().log.entries().size();
    driver.fill("inspector/size/x", "5");
    CHECK(driver.formula("shape/1/width"_number).empty());
    CHECK(driver.formula("shape/1/height"_number) == "w");
    CHECK(driver.context().log.entries().size() == before);
}
