#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

namespace {

/// A rectangle, with the spacing panel visible and the focus in its first field.
struct SpacingForm : Draughtsman {
    SpacingForm() {
        rectangle({1, 1}, {9, 8});
        showPanel("spacing");
        click("spacing/size");
    }
    const SpacingSpec &spacing() { return document().spacing; }
};

} // namespace

TEST_CASE("Fields: Tab commits the value and goes to the next field, Shift+Tab back, wrapping around the column") {
    SpacingForm form;
    form.type("0.5");
    form.key(key::kTab);
    CHECK(form.spacing().size == 0.5);
    CHECK(form.context().view.panels); // no shortcut while a field has the focus
    form.type("0.2+0.1*x");
    form.key(key::kTab);
    CHECK(form.spacing().expression == "0.2+0.1*x");
    form.type("0.125");
    form.key(key::kTab);
    CHECK(form.spacing().minimum == 0.125);
    form.type("2");
    form.key(key::kTab, kShift);
    CHECK(form.spacing().maximum == 2.0);
    form.type("0.25"); // replaces the old text, which was selected
    form.key(key::kTab, kShift);
    CHECK(form.spacing().minimum == 0.25);
    form.key(key::kTab, kShift);
    form.type("0.75");
    form.key(key::kEnter);
    CHECK(form.spacing().size == 0.75);
    CHECK(form.spacing().expression == "0.2+0.1*x"); // passed, not touched
    form.key(key::kTab);
    CHECK_FALSE(form.context().view.panels); // no field has the focus
}

TEST_CASE("Fields: typing right after Tab goes to the next field, and no key to the canvas") {
    SpacingForm form;
    InputQueue &input = form.editor().input();
    const auto keyAndText = [&](int code) {
        input.push({.kind = InputKind::Key, .code = code, .pressed = true});
        if (code < 128) {
            input.push({.kind = InputKind::Text, .code = code});
        }
        input.push({.kind = InputKind::Key, .code = code, .pressed = false});
    };
    for (const int code : {int{key::k2}, int{key::kTab}, int{key::kTab}, int{key::k2}, int{key::kEnter}}) {
        keyAndText(code);
    }
    form.settle();
    CHECK(form.spacing().size == 2.0);
    CHECK(form.spacing().minimum == 2.0);
    CHECK(form.run().state == RunState::Empty); // 2 alone would mesh
}

TEST_CASE("Fields: Ctrl+Z undoes typing first, then changes of the document") {
    SpacingForm form;
    form.type("0.5");
    form.key(key::kTab);
    form.type("0.3");
    form.key('Z', kControl);
    form.key('Z', kControl);
    form.key('Z', kControl);
    CHECK(form.spacing().size == 0.5); // three characters were typed, and three undone
    form.key('Z', kControl);
    CHECK_FALSE(form.spacing().size.has_value());
    CHECK_FALSE(form.spacing().expression.has_value());
    form.key('Z', kControl);
    CHECK(form.document().shapes.empty());
    form.key('Z', kControlShift);
    form.key('Z', kControlShift);
    CHECK(form.spacing().size == 0.5);
}

TEST_CASE("Fields: Ctrl+Shift+Z and Ctrl+Y redo typing that Ctrl+Z undid") {
    SpacingForm form;
    for (const Shortcut redo : {Shortcut{'Z', kControlShift}, Shortcut{'Y', kControl}}) {
        form.click("spacing/size");
        form.key('A', kControl);
        form.type("0.5");
        form.key('Z', kControl);
        form.key('Z', kControl);
        form.key(redo.key, redo.modifiers);
        form.key(redo.key, redo.modifiers);
        form.key(key::kEnter);
        CHECK(form.spacing().size == 0.5);
        form.key('Z', kControl);
        CHECK_FALSE(form.spacing().size.has_value());
    }
}

TEST_CASE("Fields: back in a field, Ctrl+Z does not undo typing from an earlier visit") {
    SpacingForm form;
    form.type("0.5");
    form.key(key::kEnter);
    form.click("spacing/size");
    form.key('Z', kControl);
    CHECK_FALSE(form.spacing().size.has_value());
}

TEST_CASE("Fields: Ctrl+S commits the typed text and saves it with the document") {
    const TemporaryFolder place;
    SpacingForm form;
    const auto file = place.path / "square.json";
    form.context().document.markSaved(file);
    form.click("spacing/size");
    form.key('A', kControl);
    form.type("0.5");
    form.key('S', kControl);
    form.settle();
    CHECK(form.spacing().size == 0.5);
    CHECK_FALSE(form.context().document.dirty());
    REQUIRE(form.editor().open(file));
    CHECK(form.spacing().size == 0.5);
}

TEST_CASE("Fields: Esc keeps the old value; a number typed and undone is no change") {
    SpacingForm form;
    form.type("0.5");
    form.key(key::kEscape);
    CHECK_FALSE(form.spacing().size.has_value());
    form.key('B');
    form.click("options/brush/radius");
    form.key('A', kControl);
    form.type("1");
    form.key(key::kEnter);
    form.click("options/brush/radius");
    form.key(key::kEnd);
    form.type("5");
    form.key(key::kBackspace);
    form.key(key::kEnter);
    form.dragPlaces({5, 5}, {5, 5});
    form.settle();
    CHECK(form.context().preview->spacing->sample({5, 5.4}).origin == SpacingOrigin::Paint);
    CHECK(form.context().preview->spacing->sample({5, 7.5}).origin != SpacingOrigin::Paint); // 15 would reach it
}

TEST_CASE("Fields: typed text is committed when a button above takes the focus") {
    SpacingForm form;
    form.click("spacing/maximum");
    form.type("2");
    form.click("panel/spacing"); // folds the panel: its heading is drawn before the field
    form.click("panel/spacing");
    form.click("spacing/maximum");
    form.type("3");
    form.click("spacing/sources/add");
    CHECK(form.spacing().maximum == 3.0);
}

TEST_CASE("Fields: a brush stroke straight from a field paints with the number just typed") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('B');
    driver.click("options/brush/spacing");
    driver.key('A', kControl);
    driver.type("0.05");
    driver.dragPlaces({4, 4}, {6, 4});
    driver.settle();
    CHECK(driver.context().preview->spacing->at({5, 4}) == doctest::Approx(0.05).epsilon(0.02));
    CHECK(driver.undoLabel() == "Paint spacing");
}

TEST_CASE("Fields: Tab moves through the fields of a dialog") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S', {Modifiers::kControl | Modifiers::kShift});
    driver.settle();
    REQUIRE(driver.context().dialogs.any());
    const std::string id = driver.context().dialogs.top()->id();
    REQUIRE(driver.has("dialog/" + id + "/path"));
    driver.click("dialog/" + id + "/path");
    driver.key(key::kTab);
    driver.key('A', kControl);
    driver.type("other");
    driver.key(key::kTab, kShift);
    driver.frames(3);
    CHECK(driver.context().view.panels);
    driver.key('A', kControl);
    const TemporaryFolder place;
    driver.type(place.path.string());
    driver.key(key::kTab); // goes to that folder
    driver.settle();
    driver.click("dialog/" + id + "/ok");
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "other.forefront"));
}

} // namespace forefront::test
