#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {
namespace sketch_values {

/// A quadrilateral with a horizontal lower side.
class ValueSketcher : public Draughtsman {
  public:
    ValueSketcher() {
        polygon({{1, 1}, {6, 1.4}, {5.7, 5}, {1.2, 4.6}});
        key('V');
        key(key::kEscape);
        add(ConstraintKind::Horizontal, {{1, SketchPartKind::Segment, 0}});
        context().selection.clear();
        moveToPlace({9.5, 9.5});
        settle();
    }
    /// Adds a constraint, and returns the name of its glyph or value.
    std::string add(ConstraintKind kind, std::vector<SketchPart> parts) {
        CHECK(context().applyCommand(addConstraint(document(), kind, std::move(parts)), "Add"));
        return "sketch/" + std::to_string(document().constraints.back()->id) + "/0";
    }
    PixelRect rect(const std::string &widget) {
        REQUIRE(has(widget));
        return context().widgets.find(widget)->rect;
    }
    void doubleClick(const std::string &widget) {
        const Pixel at = rect(widget).centre();
        clickAt(at);
        frames(1);
        clickAt(at);
        settle();
    }
    double lowerSide() { return distance(document().shapes[0]->nodes[0], document().shapes[0]->nodes[1]); }
};

bool samePlace(const PixelRect &a, const PixelRect &b) {
    return a.x == b.x && a.y == b.y;
}

} // namespace sketch_values

using sketch_values::samePlace;
using sketch_values::ValueSketcher;

TEST_CASE("Values of the sketch: they stay while the selection changes, and a double-click opens the field") {
    ValueSketcher driver;
    for (const std::uint32_t segment : {0U, 1U, 2U, 3U}) {
        CAPTURE(segment);
        driver.context().selection.clear();
        driver.context().selection.segments.insert({1, segment});
        driver.settle();
        CHECK(driver.context().actions.run("constraint.length", driver.context()));
        driver.settle();
        driver.key(key::kEscape); // the field of the new dimension
        driver.settle();
        const std::string value = "sketch/" + std::to_string(driver.document().constraints.back()->id) + "/0";
        const PixelRect added = driver.rect(value);
        driver.doubleClick(value);
        REQUIRE(driver.has("dimension/value"));
        driver.key(key::kEscape);
        driver.settle();
        CHECK(samePlace(driver.rect(value), added));
        driver.key(key::kEscape); // the selection
        driver.context().selection.shapes.insert(1);
        driver.settle();
        CHECK(samePlace(driver.rect(value), added));
        driver.context().log.refuse("a message at the lower edge of the canvas");
        driver.frames(3);
        CHECK(samePlace(driver.rect(value), added));
    }
}

TEST_CASE("Values of the sketch: undo in an open field gives the text back, and never undoes the drawing") {
    ValueSketcher driver;
    const std::string value = driver.add(ConstraintKind::Length, {{1, SketchPartKind::Segment, 0}});
    driver.settle();
    const std::uint64_t revision = driver.context().document.revision();
    driver.doubleClick(value);
    const std::string before = driver.context().dimensionEntry.text;
    driver.key('A', {Modifiers::kControl});
    driver.type("-4");
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.has("dimension/fault")); // the field has been left and entered again
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.context().document.revision() == revision);
    REQUIRE(driver.has("dimension/value"));
    CHECK(driver.context().dimensionEntry.text == before);
    CHECK_FALSE(driver.has("dimension/fault"));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.context().document.revision() == revision);
    driver.key('A', {Modifiers::kControl}); // the focus is still there
    driver.type("4");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.lowerSide() == doctest::Approx(4.0));
}

TEST_CASE("Values of the sketch: a number typed for a parameter sets the parameter") {
    ValueSketcher driver;
    Result<Document> named = setParameters(driver.document(), {{"w", "5"}, {"half", "w/2"}});
    REQUIRE(named.ok());
    driver.context().document.apply(*std::move(named), "Parameters");
    const std::string value = driver.add(ConstraintKind::Length, {{1, SketchPartKind::Segment, 0}});
    driver.settle();
    const auto edit = [&](const std::string &text) {
        driver.doubleClick(value);
        REQUIRE(driver.has("dimension/value"));
        driver.key('A', {Modifiers::kControl});
        driver.type(text);
        driver.key(key::kEnter);
        driver.settle();
        CHECK_FALSE(driver.has("dimension"));
    };
    edit("w");
    CHECK(driver.lowerSide() == doctest::Approx(5.0));
    edit("4");
    CHECK(driver.lowerSide() == doctest::Approx(4.0));
    CHECK(driver.document().parameters[0].expression == "4");
    CHECK(driver.document().formulas.size() == 1);
    CHECK(driver.context().log.entries().back().diagnostic.message == "Set the parameter w to 4");
    edit("half"); // which follows another one, and so is not set
    CHECK(driver.lowerSide() == doctest::Approx(2.0));
    edit("3");
    CHECK(driver.lowerSide() == doctest::Approx(3.0));
    CHECK(driver.document().parameters[1].expression == "w/2");
    CHECK(driver.document().formulas.empty());
}

TEST_CASE("Typed sizes: a length that a dimension holds says so at the field, and offers to change the dimension") {
    ValueSketcher driver;
    driver.add(ConstraintKind::Length, {{1, SketchPartKind::Segment, 0}});
    const double before = driver.lowerSide();
    driver.context().selection.clear();
    driver.context().selection.segments.insert({1, 0});
    driver.settle();
    const std::uint64_t revision = driver.context().document.revision();
    driver.fill("inspector/length", "4");
    CHECK(driver.context().document.revision() == revision);
    REQUIRE(driver.has("inspector/length/fault"));
    CHECK(driver.context().fieldFault.text.starts_with("length = 4 cannot hold together with Length 1; still "));
    REQUIRE(driver.has("fieldoffer/change"));
    driver.key(key::kEscape); // gives up the text, and nothing has changed
    driver.settle();
    CHECK_FALSE(driver.has("fieldoffer/change"));
    CHECK(driver.lowerSide() == before);

    driver.fill("inspector/length", "4");
    driver.click("fieldoffer/change");
    driver.settle();
    CHECK(driver.lowerSide() == doctest::Approx(4.0));
    CHECK(driver.undoLabel() == "Change Length 1");
    CHECK_FALSE(driver.has("inspector/length/fault"));
    CHECK_FALSE(driver.has("fieldoffer/change"));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.lowerSide() == before);
}

TEST_CASE("Typed sizes: where no dimension holds the length, its field names what does and offers nothing") {
    ValueSketcher driver;
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 0}});
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 1}});
    driver.context().selection.clear();
    driver.context().selection.segments.insert({1, 0});
    driver.settle();
    driver.fill("inspector/length", "4");
    REQUIRE(driver.has("inspector/length/fault"));
    CHECK(driver.context().fieldFault.text.starts_with("length = 4 cannot hold together with Fixed 1 and Fixed 2"));
    CHECK_FALSE(driver.has("fieldoffer/change"));
}

TEST_CASE("Typed sizes: a radius and the width of a rectangle offer what holds them, also a parameter") {
    ValueSketcher driver;
    driver.rectangle({1, 7}, {4, 9});
    driver.key('C');
    driver.dragPlaces({7, 8}, {8, 8});
    driver.key('V');
    REQUIRE(driver.document().shapes.size() == 3);
    const std::uint32_t box = driver.document().shapes[1]->id, circle = driver.document().shapes[2]->id;
    driver.add(ConstraintKind::HorizontalDistance, {{box, SketchPartKind::Node, 0}, {box, SketchPartKind::Node, 1}});
    driver.add(ConstraintKind::Diameter, {{circle, SketchPartKind::Segment, 0}});
    const NumberAddress diameter{NumberOwner::ofConstraint(driver.document().constraints.back()->id), Quantity::Value};
    Result<Document> named = setParameters(driver.document(), {{"d", "2"}});
    REQUIRE(named.ok());
    driver.context().document.apply(setFormula(*std::move(named), diameter, "d"), "Parameters");
    REQUIRE(driver.document().formulas.contains(diameter));
    const auto typeAndTake = [&](std::uint32_t shape, const char *field, const char *text) {
        driver.context().selection.clear();
        driver.context().selection.shapes.insert(shape);
        driver.settle();
        driver.fill(field, text);
        CHECK(driver.has(std::string(field) + "/fault"));
        driver.click("fieldoffer/change");
        driver.settle();
        CHECK_FALSE(driver.has("fieldoffer/change"));
    };
    typeAndTake(box, "inspector/size/x", "5");
    CHECK(boundsOf(*driver.document().shapes[1]).size().x == doctest::Approx(5.0));
    typeAndTake(circle, "inspector/radius", "1.5");
    CHECK(circleRadius(*driver.document().shapes[2]) == doctest::Approx(1.5));
    CHECK(driver.document().parameters[0].expression == "3");
    CHECK(driver.document().formulas.at(diameter) == "d");
}

TEST_CASE("Values of the sketch: a new dimension opens its field with the measured value") {
    ValueSketcher driver;
    const auto add = [&] {
        driver.context().selection.clear();
        driver.context().selection.segments.insert({1, 0});
        driver.settle();
        CHECK(driver.context().actions.run("constraint.length", driver.context()));
        driver.settle();
    };
    const double measured = driver.lowerSide();
    const std::uint64_t before = driver.context().document.revision();
    add();
    REQUIRE(driver.has("dimension/value"));
    CHECK(driver.context().dimensionEntry.text == ui::editedNumber(measured));
    driver.type("4"); // over the selected value
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("dimension"));
    CHECK(driver.lowerSide() == doctest::Approx(4.0));
    CHECK(driver.undoLabel() == "Add Length 1");
    driver.key('Z', {Modifiers::kControl}); // one step with its value
    driver.settle();
    CHECK(driver.context().document.revision() == before);

    for (const int leave : {key::kEscape, key::kEnter}) {
        add();
        REQUIRE(driver.has("dimension/value"));
        driver.key(leave);
        driver.settle();
        CHECK_FALSE(driver.has("dimension"));
        CHECK(driver.lowerSide() == measured);
        REQUIRE(driver.document().constraints.size() == 2);
        CHECK(driver.document().constraints.back()->value == measured);
        driver.key('Z', {Modifiers::kControl});
        driver.settle();
        CHECK(driver.context().document.revision() == before);
    }

    add();
    driver.type("-4"); // refused
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.has("dimension/fault"));
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.has("dimension"));
    CHECK(driver.document().constraints.back()->value == measured);
}

TEST_CASE("Glyphs of the sketch: the pointer shows the name; a refusal lights those that it names until the next act") {
    ValueSketcher driver;
    const std::string vertical = driver.add(ConstraintKind::Vertical, {{1, SketchPartKind::Segment, 1}});
    driver.settle();
    CHECK_FALSE(driver.has("canvas/constraint"));
    driver.moveTo(driver.rect(vertical).centre());
    driver.settle();
    REQUIRE(driver.has("canvas/constraint"));
    const auto &labels = driver.editor().canvas().labels();
    CHECK(std::any_of(labels.begin(), labels.end(), [](const auto &label) {
        return label.name == "canvas/constraint" && label.text == "Vertical 1";
    }));
    driver.moveToPlace({9.5, 9.5});
    driver.settle();
    const Driver::Picture plain = driver.picture();
    CHECK_FALSE(
        driver.context().applyCommand(addConstraint(driver.document(), ConstraintKind::Parallel,
                                                    {{1, SketchPartKind::Segment, 0}, {1, SketchPartKind::Segment, 1}}),
                                      "Add"));
    driver.settle();
    const Driver::Picture lit = driver.picture();
    CHECK(lit.differences(plain, driver.rect(vertical)) > 10);
    driver.rectangle({7, 7}, {8, 8});
    driver.key('V');
    driver.key(key::kEscape);
    driver.moveToPlace({9.5, 9.5});
    driver.settle();
    CHECK(driver.picture().differences(plain, driver.rect(vertical)) == 0);
}

TEST_CASE("Shortcuts and menus: a command that waits for a selection says for which") {
    ValueSketcher driver;
    driver.context().selection.clear();
    driver.context().selection.nodes.insert({1, 0});
    driver.settle();
    const auto said = [&] { return driver.context().log.entries().back().diagnostic.message; };
    driver.key('D', {Modifiers::kControl});
    driver.settle();
    CHECK(said() == "Duplicate: select whole shapes, not their nodes or segments");
    driver.key('P', {Modifiers::kControl | Modifiers::kShift});
    driver.settle();
    CHECK(said() == "Polar array: select whole shapes, not their nodes or segments");
    driver.rectangle({7, 7}, {8, 8});
    driver.key('V');
    driver.context().selection.clear();
    driver.context().selection.nodes.insert({driver.document().shapes.back()->id, 0});
    driver.settle();
    driver.key('S', {Modifiers::kShift});
    driver.settle();
    CHECK(said().starts_with("Smooth node: select nodes of a path"));

    driver.context().selection.clear();
    driver.context().selection.shapes = {1};
    driver.settle();
    driver.click("menu/Shape");
    driver.settle();
    driver.moveTo(driver.rect("menu/shape.dimension").centre());
    driver.until([&] { return driver.has("tooltip"); });
}

} // namespace forefront::test
