#include "tests/support/temporary_folder.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/parts/settings.hpp"
#include "ui/shell/pointer_hints.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Hints at the pointer: a tool has one until it was used twice, and so in later sessions") {
    Draughtsman driver;
    driver.context().settings.toolUses.clear(); // as for a new user
    driver.key('R');
    driver.moveToPlace({2, 2});
    driver.frames(2);
    CHECK(driver.has("canvas/hint"));
    const std::string first = pointerHint(driver.context().settings, "rectangle", false);
    driver.clickPlace({2, 2});
    driver.moveToPlace({4, 4});
    driver.frames(2);
    CHECK(driver.has("canvas/hint"));
    CHECK(pointerHint(driver.context().settings, "rectangle", true) != first);
    driver.clickPlace({4, 4});
    CHECK(driver.context().settings.toolUses.at("rectangle") == 1);
    driver.dragPlaces({5, 5}, {6, 6});
    driver.frames(2);
    CHECK(driver.context().settings.toolUses.at("rectangle") == 2);
    CHECK_FALSE(driver.has("canvas/hint"));
    driver.dragPlaces({7, 7}, {8, 8});
    CHECK(driver.context().settings.toolUses.at("rectangle") == 2); // no longer counted
    driver.key('C');                                                // another tool has its own
    driver.moveToPlace({3, 3});
    driver.frames(2);
    CHECK(driver.has("canvas/hint"));
    driver.context().settings.hints = false;
    driver.frames(2);
    CHECK_FALSE(driver.has("canvas/hint"));

    const TemporaryFolder place;
    saveSettings(place.path / "settings.json", driver.context().settings);
    CHECK(loadSettings(place.path / "settings.json").toolUses == driver.context().settings.toolUses);
}

TEST_CASE("Hints on the canvas: the strip of keys goes once two were used or a mesh was made, and is not in the way") {
    Draughtsman driver;
    CHECK(driver.has("hints"));
    driver.key('P');
    driver.clickPlace({1, 1});
    CHECK_FALSE(driver.has("hints")); // a tool is at work
    driver.clickPlace({8, 1});
    driver.clickPlace({8, 7});
    driver.key(key::kEnter);
    driver.key('V');
    driver.settle();
    CHECK(driver.has("hints")); // the keys of a drawing that is not empty
    for (const WorkspaceKind kind : {WorkspaceKind::Step, WorkspaceKind::Judge}) {
        driver.workspace(kind);
        CHECK_FALSE(driver.has("hints"));
    }
    driver.workspace(WorkspaceKind::Draw);
    CHECK(driver.has("hints"));
    driver.key(key::kF1 + 3);
    driver.settle();
    CHECK_FALSE(driver.has("hints")); // lessons
    driver.key(key::kF1 + 3);
    driver.settle();
    driver.key('B');
    driver.settle();
    CHECK(driver.has("hints"));
    driver.key('B');
    driver.settle();
    CHECK_FALSE(driver.has("hints"));

    const TemporaryFolder place;
    saveSettings(place.path / "settings.json", driver.context().settings);
    CHECK(loadSettings(place.path / "settings.json").toolUses == driver.context().settings.toolUses);

    driver.key('V');
    driver.context().actions.run("view.hints", driver.context());
    driver.context().actions.run("view.hints", driver.context()); // on again: as for a new user
    driver.settle();
    CHECK(driver.has("hints"));
    driver.context().actions.run("run.mesh", driver.context());
    driver.until([&] { return driver.run().complete && !driver.context().run.busy(); });
    driver.settle();
    CHECK_FALSE(driver.has("hints"));
}

} // namespace forefront::test
