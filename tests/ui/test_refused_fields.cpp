#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

namespace {

/// Types a text into a field and expects it to be refused there, until the field is edited again.
void expectRefused(Draughtsman &driver, const std::string &field, const std::string &text) {
    CAPTURE(field);
    CAPTURE(text);
    const std::uint64_t revision = driver.context().document.revision();
    driver.fill(field, text);
    CHECK(driver.has(field + "/fault"));
    CHECK(driver.context().document.revision() == revision);
    driver.click(field);
    driver.key(key::kEscape);
    driver.frames(2);
    CHECK_FALSE(driver.has(field + "/fault"));
}

} // namespace

TEST_CASE("Refused fields: what a command refuses is told at the field of a panel") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    expectRefused(driver, "inspector/cornerradius", "-1");
    expectRefused(driver, "inspector/size/y", "0");
    expectRefused(driver, "inspector/segmentsize", "-1");
    driver.showPanel("spacing");
    expectRefused(driver, "spacing/size", "-1");
    CHECK(driver.logHas("bad-size"));
    expectRefused(driver, "spacing/maximum", "0");
    driver.showPanel("checks");
    driver.settle();
    expectRefused(driver, "checks/min-angle", "91");
    CHECK(driver.logHas("bad-limit"));
}

TEST_CASE("Refused fields: a command that fails after a field was committed is not told at the field") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.showPanel("spacing");
    driver.click("spacing/size");
    driver.type("0.5");
    driver.key('D', {Modifiers::kControl}); // commits the field, then runs
    driver.settle();
    CHECK(driver.document().spacing.size == 0.5);
    CHECK_FALSE(driver.has("spacing/size/fault"));
}

TEST_CASE("Refused fields: the text, the caret and the focus stay, and the next keys edit it") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.showPanel("spacing");
    driver.fill("spacing/size", "0.5");
    driver.fill("spacing/size", "abc+");
    REQUIRE(driver.has("spacing/size/fault"));
    CHECK(driver.context().fieldFault.text.ends_with("; still 0.5"));
    CHECK(driver.document().spacing.size == 0.5);
    CHECK_FALSE(driver.has("canvas/error")); // told once, at the field
    CHECK_FALSE(driver.has("tooltip"));
    REQUIRE(driver.context().widgets.fields.entry.has_value());
    CHECK(driver.context().widgets.fields.entry->name == "spacing/size");
    CHECK(driver.context().widgets.fields.entry->text == "abc+");
    driver.key(key::kBackspace); // at the caret, after the +
    CHECK(driver.context().widgets.fields.entry->text == "abc");
    CHECK_FALSE(driver.has("spacing/size/fault"));
    driver.key('A', kControl);
    driver.key(key::kBackspace);
    driver.key(key::kDelete);
    driver.type("0.75");
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.document().spacing.size == 0.75);
    CHECK(driver.context().selection.size() == 1); // Ctrl+A did not select anything
}

TEST_CASE("Refused fields: Tab stays, a shortcut and a click on the canvas wait; one more click gives the text up") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.showPanel("spacing");
    driver.click("spacing/size");
    driver.type("-1");
    driver.key(key::kTab);
    const auto stays = [&] {
        REQUIRE(driver.context().widgets.fields.entry.has_value());
        CHECK(driver.context().widgets.fields.entry->name == "spacing/size");
        CHECK(driver.context().widgets.fields.entry->text == "-1");
        CHECK(driver.has("spacing/size/fault"));
    };
    stays();
    driver.key('D', kControl); // would duplicate the rectangle
    stays();
    CHECK(driver.document().shapes.size() == 1);
    driver.key(key::kEscape);
    driver.click("spacing/size");
    driver.type("-1");
    driver.clickPlace({-1, -1}); // would select nothing
    stays();
    CHECK(driver.context().selection.size() == 1);
    driver.clickPlace({-1, -1}); // the fault has been seen
    CHECK_FALSE(driver.context().widgets.fields.entry.has_value());
    CHECK_FALSE(driver.has("spacing/size/fault"));
    CHECK_FALSE(driver.document().spacing.size.has_value());
    CHECK(driver.context().selection.size() == 0);
}

TEST_CASE("Refused fields: after a click on another widget the field still shows the text; Esc restores the value") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.showPanel("spacing");
    driver.fill("spacing/size", "0.5");
    driver.click("spacing/size");
    driver.key('A', kControl);
    driver.type("1x");
    driver.click("menu/theme");
    CHECK(driver.has("spacing/size/fault"));
    CHECK_FALSE(driver.context().widgets.fields.entry.has_value());
    driver.click("spacing/size");
    REQUIRE(driver.context().widgets.fields.entry.has_value());
    CHECK(driver.context().widgets.fields.entry->text == "1x");
    driver.key(key::kEscape);
    CHECK_FALSE(driver.has("spacing/size/fault"));
    CHECK(driver.document().spacing.size == 0.5);
    driver.click("spacing/size");
    CHECK(driver.context().widgets.fields.entry->text == "0.5");
}

TEST_CASE("Refused fields: expressions and parameters keep the focus too") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.showPanel("spacing");
    driver.fill("spacing/expression", "0.2+*");
    CHECK(driver.has("spacing/expression/fault"));
    driver.key('A', kControl);
    driver.key(key::kBackspace);
    driver.type("0.2+0.1*x");
    driver.key(key::kEnter);
    CHECK(driver.document().spacing.expression == "0.2+0.1*x");
    CHECK(driver.document().shapes.size() == 1);
    driver.showPanel("parameters");
    driver.click("parameters/add");
    driver.settle();
    driver.fill("parameters/0/expression", "2*(");
    CHECK(driver.has("parameters/0/expression/fault"));
    driver.key('A', kControl);
    driver.key(key::kDelete);
    driver.type("2*3");
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.document().parameters[0].expression == "2*3");
}

TEST_CASE("Fields: a number is shown in full while it is edited, and rounded at rest") {
    Draughtsman driver;
    Shape point;
    point.form = PointForm{};
    point.nodes = {{687123.25, 5312945.5}};
    driver.context().document.apply(*addShape(Document(), point), "Draw");
    driver.context().selection.shapes.insert(1);
    driver.key('V');
    driver.settle();
    driver.context().selection.shapes.insert(1);
    driver.settle();
    const auto edited = [&] {
        REQUIRE(driver.context().widgets.fields.entry.has_value());
        return driver.context().widgets.fields.entry->text;
    };
    driver.click("inspector/at/x");
    CHECK(edited() == "687123.25");
    driver.key(key::kEnd);
    driver.type("+1");
    driver.key(key::kTab);
    CHECK(edited() == "5312945.5");
    driver.key(key::kEnter); // unchanged
    CHECK(driver.document().shapes[0]->nodes[0] == Vec2{687124.25, 5312945.5});
    driver.fill("inspector/at/y", "5312945.0123456");
    driver.click("inspector/at/y");
    CHECK(edited() == "5312945.0123456");
    driver.key(key::kEnter);
    CHECK(driver.document().shapes[0]->nodes[0].y == 5312945.0123456);
    CHECK(ui::editedNumber(1e6) == "1000000");
    CHECK(ui::editedNumber(0.1) == "0.1");
    CHECK(ui::editedNumber(-2.5e-7) == "-2.5e-07");
    CHECK(ui::editedNumber(-0.0) == "0");
    CHECK(ui::number(-0.0) == "0");
    CHECK(ui::listedNumber(1.0 - 0.28) == "0.72"); // 0.72 and two units in its last place
    CHECK(ui::listedNumber(5312945.01234) == "5312945.01234");
    CHECK(ui::listedNumber(-0.0) == "0");
}

TEST_CASE("Refused fields: radii of ellipses and boundary tags") {
    Draughtsman driver;
    driver.key('K');
    driver.dragPlaces({1, 1}, {9, 8});
    driver.key('V');
    expectRefused(driver, "inspector/radii/x", "-1");
    expectRefused(driver, "inspector/radii/y", "0");
    for (const char *tag : {"0", "2.7", "2e9"}) {
        expectRefused(driver, "inspector/tag", tag);
    }
    driver.fill("inspector/tag", "3");
    CHECK(driver.document().shapes[0]->tag == 3);
}

TEST_CASE("Refused fields: the tag of the region tool") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.click("tool/region");
    driver.settle();
    expectRefused(driver, "options/region/tag", "0");
    expectRefused(driver, "options/region/tag", "2.7");
}

TEST_CASE("Refused fields: the scale of an import") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({2, 2}, {4, 4});
    REQUIRE(writeProject(place.path / "part.forefront", driver.document()).empty());
    driver.key('I', {Modifiers::kControl});
    driver.frames(5);
    driver.fill("dialog/import/name", (place.path / "part.forefront").string());
    if (driver.has("dialog/import/ok")) {
        driver.click("dialog/import/ok");
        driver.settle();
    }
    REQUIRE(driver.has("dialog/importoptions/scale"));
    for (const char *scale : {"0", "-1"}) {
        driver.click("dialog/importoptions/scale");
        driver.key('A', {Modifiers::kControl});
        driver.type(scale);
        driver.key(key::kTab);
        driver.settle();
        CHECK(driver.has("dialog/importoptions/scale/fault"));
    }
}

} // namespace forefront::test
