#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront::test {

namespace {

void openPage(Driver &driver, const char *page) {
    driver.context().actions.run("edit.preferences", driver.context());
    driver.settle();
    driver.click(std::string("dialog/preferences/page/") + page);
    driver.settle();
}

} // namespace

TEST_CASE(
    "Preferences: new drawings take their element size, gradation and numbers of elements, after a restart, too") {
    const TemporaryFolder place;
    const EditorSetup setup{.settingsFolder = place.path};
    {
        Draughtsman driver(setup);
        openPage(driver, "New drawings");
        driver.fill("dialog/preferences/new/size", "0.25");
        driver.fill("dialog/preferences/new/gradation", "0.1");
        driver.fill("dialog/preferences/new/perturn", "0");
        driver.fill("dialog/preferences/new/across", "3");
        driver.fill("dialog/preferences/new/size", "-1"); // refused
        driver.key(key::kEscape);
        CHECK_FALSE(driver.document().spacing.size.has_value()); // the open drawing keeps its own
    }
    Draughtsman driver(setup); // begins with a new drawing
    const SpacingSpec &spacing = driver.document().spacing;
    CHECK(spacing.size == 0.25);
    CHECK(spacing.gradation == 0.1);
    CHECK(spacing.segmentsPerTurn == 0.0);
    CHECK(spacing.elementsAcross == 3.0);
}

TEST_CASE("Preferences: the steps of the grid and of angles") {
    const TemporaryFolder place;
    const EditorSetup setup{.settingsFolder = place.path};
    {
        Draughtsman driver(setup);
        openPage(driver, "Snapping");
        driver.fill("dialog/preferences/snap/step", "0.4");
        driver.key(key::kEscape);
        driver.context().snapping.angleStep = 10.0;
        driver.rectangle({1.17, 1.23}, {4.83, 3.63});
        REQUIRE(driver.document().shapes.size() == 1);
        CHECK(distance(driver.document().shapes[0]->nodes[0], {1.2, 1.2}) < 1e-12);
        CHECK(distance(driver.document().shapes[0]->nodes[1], {4.8, 3.6}) < 1e-12);
        driver.key('L');
        driver.clickPlace({6, 6});
        driver.editor().input().push(
            {.kind = InputKind::Key, .code = key::kLeftShift, .pressed = true, .modifiers = {Modifiers::kShift}});
        driver.clickPlace({7.93, 6.4});
        driver.editor().input().push({.kind = InputKind::Key, .code = key::kLeftShift, .pressed = false});
        driver.key(key::kEnter);
        const std::vector<Vec2> &nodes = driver.document().shapes[1]->nodes;
        const Vec2 arm = nodes[1] - nodes[0];
        CHECK(std::atan2(arm.y, arm.x) * 180.0 / std::acos(-1.0) == doctest::Approx(10.0));
    }
    Driver again(setup);
    CHECK(again.context().snapping.gridStep == 0.4);
    CHECK(again.context().snapping.angleStep == 10.0);
}

TEST_CASE("Keys: every command of the palette is in the list, and so are the keys of the brush and every tool") {
    Draughtsman driver({}, {1280, 8000}); // tall enough for all rows
    openPage(driver, "Keys");
    for (const auto &tool : driver.context().tools.tools) {
        CHECK(driver.context().actions.find(std::string("tool.") + tool->id()) != nullptr);
    }
    for (const Action &action : driver.context().actions.all()) { // as the palette lists them
        CAPTURE(action.id);
        CHECK(driver.has("dialog/preferences/key/" + action.id));
    }
    driver.key(key::kEscape);
    driver.settle();
    for (const char *id : {"brush.larger", "brush.smaller", "brush.sizeUp", "brush.mode.coarser", "snap.grid"}) {
        CHECK(driver.context().actions.find(id) != nullptr);
    }
}

TEST_CASE("Keys: the brush takes another key for its radius; a conflict is shown with a button that resets the key") {
    const TemporaryFolder place;
    Draughtsman driver({.settingsFolder = place.path});
    driver.rectangle({1, 1}, {9, 9});
    driver.settle();
    driver.key('B');
    driver.fill("options/brush/radius", "1");
    driver.moveToPlace({5, 5});
    driver.key(key::kRightBracket);
    driver.settle();
    openPage(driver, "Keys");
    driver.click("dialog/preferences/keys/find");
    driver.type("larger radius");
    driver.settle();
    driver.click("dialog/preferences/key/brush.larger");
    driver.key('V'); // the select tool's
    driver.frames(2);
    CHECK(driver.has("dialog/preferences/conflict/brush.larger/loses")); // the tool comes first
    CHECK(driver.has("dialog/preferences/reset/brush.larger"));
    driver.click("dialog/preferences/reset/brush.larger");
    driver.frames(2);
    CHECK_FALSE(driver.has("dialog/preferences/conflict/brush.larger"));
    driver.click("dialog/preferences/key/brush.larger");
    driver.key('X');
    driver.key(key::kEscape);
    driver.moveToPlace({5, 5});
    driver.key('X');
    driver.frames(3);
    const auto &labels = driver.editor().canvas().labels();
    CHECK(std::any_of(labels.begin(), labels.end(),
                      [](const auto &label) { return label.text.starts_with("r=1.4"); })); // 1.2 twice
}

} // namespace forefront::test
