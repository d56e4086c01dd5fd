#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/action_cases.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace forefront::test {

void drawShapes(Draughtsman &driver, std::vector<Shape> shapes) {
    const auto next = addShapes(driver.document(), std::move(shapes));
    REQUIRE(next.ok());
    driver.context().document.apply(*next, "Draw");
    driver.settle();
}

void drawThree(Draughtsman &driver) {
    const auto box = [](Vec2 a, Vec2 b) {
        Shape shape;
        shape.form = RectangleForm{};
        shape.nodes = {a, b};
        return shape;
    };
    drawShapes(driver, {box({1, 1}, {3, 2}), box({4, 3}, {8, 7}), box({8.5, 6}, {9.5, 9})});
    driver.key('A', {Modifiers::kControl});
    driver.settle();
}

void drawTriangle(Draughtsman &driver) {
    Shape triangle;
    triangle.nodes = {{2, 2}, {6, 2}, {2, 4}};
    drawShapes(driver, {triangle});
    driver.key('A', {Modifiers::kControl});
    driver.settle();
}

void drawMesh(Draughtsman &driver) {
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key(key::kF5);
    driver.until([&] { return driver.run().complete && !driver.context().run.busy(); });
    driver.settle();
}

bool dialogIs(Draughtsman &driver, const std::string &id) {
    const Dialog *const top = driver.context().dialogs.top();
    return top != nullptr && top->id() == id;
}

namespace {

std::vector<ActionCase> allCases() {
    std::vector<ActionCase> cases = documentActionCases();
    for (auto &&list : {shapeActionCases(), viewActionCases()}) {
        cases.insert(cases.end(), list.begin(), list.end());
    }
    return cases;
}

/// Waits until the window comes to rest or a run plays, which the worker reports at its own time.
void rest(Draughtsman &driver) {
    driver.frames(4);
    const Editor &editor = driver.editor();
    driver.until([&] { return driver.context().run.playing() || (editor.settled() && !editor.needsFrame()); });
}

/// Runs an action as a user does: by its key, from its menu, or from the palette.
void perform(Draughtsman &driver, const Action &action) {
    if (!action.shortcuts.empty() && action.shortcuts.front().key != 0) {
        driver.key(action.shortcuts.front().key, action.shortcuts.front().modifiers);
    } else if (!action.menu.empty()) {
        CHECK(driver.click("menu/" + action.menu));
        CHECK(driver.click("menu/" + action.id));
    } else {
        driver.key('P', {Modifiers::kControl});
        driver.settle();
        driver.type(action.title);
        driver.settle();
        driver.key(key::kEnter);
    }
    rest(driver);
}

/// Runs each action where it can run, and checks its effect.
void runAll(const std::vector<ActionCase> &cases) {
    for (const ActionCase &each : cases) {
        CAPTURE(each.id);
        Draughtsman driver;
        each.prepare(driver);
        rest(driver);
        const Action *const action = driver.context().actions.find(each.id);
        REQUIRE(action != nullptr);
        CHECK((!action->enabled || action->enabled(driver.context())));
        const StateBefore before(driver);
        CHECK_FALSE(each.done(driver, before));
        perform(driver, *action);
        CHECK(each.done(driver, before));
    }
}

/// Returns true for the actions made from a list of samples, terms, tools or modes; a case below runs all of each.
bool ofList(std::string_view id) {
    const std::string_view prefixes[] = {"tool.",      "glossary.",     "brush.mode.", "panel.",
                                         "workspace.", "lesson.choice", "constraint."};
    return std::any_of(std::begin(prefixes), std::end(prefixes),
                       [&](std::string_view prefix) { return id.starts_with(prefix); });
}

bool opensSample(std::string_view id) {
    const auto gallery = sampleDrawings();
    return std::any_of(gallery.begin(), gallery.end(),
                       [&](const Sample &sample) { return id == "learn." + sample.path.stem().string(); });
}

} // namespace

TEST_CASE("Actions: each has a case that runs it, and no case is without an action") {
    Driver driver;
    std::set<std::string> expected, tested;
    for (const Action &action : driver.context().actions.all()) {
        if (!ofList(action.id) && !opensSample(action.id)) {
            expected.insert(action.id);
        }
    }
    for (const ActionCase &each : allCases()) {
        CAPTURE(each.id);
        CHECK(tested.insert(each.id).second);
    }
    for (const std::string &id : expected) {
        CAPTURE(id);
        CHECK(tested.contains(id));
    }
    for (const std::string &id : tested) {
        CAPTURE(id);
        CHECK(expected.contains(id));
    }
}

TEST_CASE("Actions: those of files and of the menu Edit do what they say" * doctest::test_suite("slow")) {
    runAll(documentActionCases());
}

TEST_CASE("Actions: those of shapes and paths do what they say" * doctest::test_suite("slow")) {
    runAll(shapeActionCases());
}

TEST_CASE("Actions: those of the view, the run and the lessons do what they say" * doctest::test_suite("slow")) {
    runAll(viewActionCases());
}

TEST_CASE("Actions: those of every tool, glossary term, brush mode and sample") {
    Draughtsman driver;
    Driver::Picture modeBefore;
    for (const Action &action : driver.context().actions.all()) {
        CAPTURE(action.id);
        const std::string word = action.id.substr(action.id.rfind('.') + 1);
        if (action.id.starts_with("tool.")) {
            perform(driver, action);
            CHECK(driver.context().tools.current().id() == word);
        } else if (action.id.starts_with("glossary.")) {
            driver.context().actions.run(action.id, driver.context());
            driver.settle();
            CHECK(dialogIs(driver, "glossary"));
            driver.context().dialogs.closeAll();
        } else if (action.id.starts_with("brush.mode.")) {
            perform(driver, action);
            REQUIRE(driver.has("options/brush/mode"));
            Driver::Picture now = driver.picture();
            const PixelRect shown = driver.context().widgets.find("options/brush/mode")->rect;
            CHECK((modeBefore.rgba.empty() || now.differences(modeBefore, shown) > 0));
            modeBefore = std::move(now);
        } else if (opensSample(action.id)) {
            driver.context().document.markSaved({});
            driver.context().actions.run(action.id, driver.context());
            driver.settle();
            CHECK(driver.context().document.title() == action.title);
        }
    }
}

TEST_CASE("Actions: the choices of the list of lessons open the lesson with that number, up to the ninth") {
    Draughtsman driver;
    driver.key(key::kF1 + 3);
    driver.settle();
    REQUIRE(driver.context().lessons.list.size() > 9);
    CHECK(driver.context().actions.find("lesson.choice10") == nullptr); // Alt and a digit
    for (std::size_t k = 0; k < 9; ++k) {
        const std::string id = "lesson.choice" + std::to_string(k + 1);
        CAPTURE(id);
        const Action *const action = driver.context().actions.find(id);
        REQUIRE(action != nullptr);
        perform(driver, *action);
        REQUIRE(driver.context().lessons.open.has_value());
        CHECK(driver.context().lessons.open->entry.id == driver.context().lessons.list[k].id);
        driver.context().actions.run("lesson.close", driver.context());
        driver.settle();
        CHECK_FALSE(driver.context().lessons.open.has_value());
        driver.context().lessons.visible = true;
        driver.settle();
    }
}

} // namespace forefront::test
