#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

namespace forefront::test {

TEST_CASE("Workspaces: the menu bar, keys and commands choose panels, tools and layers") {
    Draughtsman driver;
    CHECK(driver.has("panel/shapes"));
    CHECK(driver.has("tool/polygon"));
    driver.click("workspace/Judge");
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
    CHECK_FALSE(driver.has("panel/shapes"));
    CHECK(driver.has("panel/checks"));
    CHECK_FALSE(driver.has("tool/polygon"));
    CHECK(driver.context().layer("quality")->visible);
    CHECK_FALSE(driver.context().layer("lattice")->visible);
    driver.key(key::k2, {Modifiers::kControl});
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Size);
    CHECK(driver.has("panel/spacing"));
    CHECK(driver.context().layer("size")->visible);
    CHECK(driver.context().actions.run("workspace.draw", driver.context()));
    driver.settle();
    CHECK(driver.has("panel/shapes"));
    CHECK_FALSE(driver.context().layer("quality")->visible);
}

TEST_CASE("Workspaces: every preset names panels, tools and layers that there are") {
    Driver driver;
    std::set<std::string_view> panels, tools, layers;
    for (const auto &panel : driver.context().panels) {
        panels.insert(panel->place() == PanelPlace::Column ? panel->id() : "");
    }
    for (const auto &tool : driver.context().tools.tools) {
        tools.insert(tool->id());
    }
    for (const LayerSlot &slot : driver.context().layers) {
        layers.insert(slot.layer->id());
    }
    std::set<std::string_view> listed{""}, offered;
    for (const WorkspaceKind kind : kWorkspaceKinds) {
        const WorkspacePreset &preset = presetOf(kind);
        CAPTURE(preset.name);
        CHECK(workspaceOf(preset.word) == kind);
        CHECK(std::all_of(preset.panels.begin(), preset.panels.end(), [&](auto id) { return panels.contains(id); }));
        CHECK(std::all_of(preset.tools.begin(), preset.tools.end(), [&](auto id) { return tools.contains(id); }));
        CHECK(std::all_of(preset.layers.begin(), preset.layers.end(), [&](auto id) { return layers.contains(id); }));
        listed.insert(preset.panels.begin(), preset.panels.end());
        offered.insert(preset.tools.begin(), preset.tools.end());
    }
    CHECK(listed == panels); // each panel of the column has a workspace
    CHECK(offered == tools); // and so has each tool
}

TEST_CASE("Workspaces: layers and folded sections are kept in each, also by the settings") {
    const TemporaryFolder place;
    EditorSetup setup;
    setup.settingsFolder = place.path;
    {
        Draughtsman driver(setup);
        driver.unfoldLayers();
        driver.click("layer/labels");
        driver.click("panel/parameters");
        driver.workspace(WorkspaceKind::Size);
        CHECK(driver.context().layer("labels")->visible);
        CHECK(driver.has("panel/spacing"));
        driver.click("panel/spacing");
        driver.settle();
        CHECK_FALSE(driver.has("spacing/size"));
    }
    Draughtsman again(setup);
    CHECK(again.context().settings.workspace == WorkspaceKind::Size);
    CHECK_FALSE(again.has("spacing/size"));
    again.workspace(WorkspaceKind::Draw);
    CHECK_FALSE(again.context().layer("labels")->visible);
    CHECK_FALSE(again.has("parameters/add"));
    CHECK(again.has("panel/parameters"));
}

TEST_CASE("Workspaces: every tool key works in all of them, and the active tool is in the strip") {
    Draughtsman driver;
    for (const WorkspaceKind kind : kWorkspaceKinds) {
        driver.workspace(kind);
        for (const auto &tool : driver.context().tools.tools) {
            CAPTURE(presetOf(kind).name);
            CAPTURE(tool->id());
            driver.key(tool->key());
            driver.frames(2);
            CHECK(&driver.context().tools.current() == tool.get());
            CHECK(driver.has(std::string("tool/") + tool->id()));
        }
        CHECK(driver.context().settings.workspace == kind);
    }
}

TEST_CASE("Workspaces: a tool that another workspace does not show gives way to Select, as in a new drawing") {
    Draughtsman driver;
    driver.key('S');
    REQUIRE(driver.context().tools.current().id() == std::string("source"));
    driver.workspace(WorkspaceKind::Size);
    CHECK(driver.context().tools.current().id() == std::string("source"));
    driver.workspace(WorkspaceKind::Judge);
    CHECK(driver.context().tools.current().id() == std::string("select"));
    driver.workspace(WorkspaceKind::Draw);
    driver.key('C');
    driver.context().document.load(Document(), {});
    driver.settle();
    CHECK(driver.context().tools.current().id() == std::string("select"));
}

TEST_CASE("Workspaces: commands on the run switch to Step, which has the timeline") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {8, 8});
    driver.key('V');
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Draw);
    CHECK_FALSE(driver.has("timeline/scrubber"));
    driver.key(key::kHome);
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Step);
    CHECK(driver.has("timeline/scrubber"));
    CHECK(driver.context().layer("front")->visible);
}

TEST_CASE("Workspaces: the command of a panel shows it in any of them, until another is chosen") {
    Draughtsman driver;
    for (const auto &panel : driver.context().panels) {
        for (const WorkspaceKind kind : kWorkspaceKinds) {
            driver.workspace(kind);
            driver.showPanel(panel->id());
            const auto *heading = driver.context().widgets.find(std::string("panel/") + panel->id());
            CAPTURE(panel->id());
            CAPTURE(presetOf(kind).name);
            REQUIRE(heading != nullptr);
            CHECK(heading->visible);
        }
    }
    driver.workspace(WorkspaceKind::Draw);
    driver.showPanel("histogram");
    driver.workspace(WorkspaceKind::Size);
    driver.workspace(WorkspaceKind::Draw);
    CHECK_FALSE(driver.has("panel/histogram"));
}

TEST_CASE("Options bar: it keeps its height, and what does not fit opens beside it") {
    Draughtsman driver;
    const PixelRect canvas = driver.canvas();
    for (const auto &tool : driver.context().tools.tools) {
        CAPTURE(tool->id());
        driver.context().tools.choose(tool->id(), driver.context());
        driver.settle();
        CHECK(driver.canvas() == canvas);
        CHECK(driver.context().widgets.find("options")->rect.height == 36.0);
        CHECK_FALSE(driver.context().widgets.find("options")->rect.overlaps(canvas));
    }
    driver.platform().resize({560, 600}, 1.0);
    driver.key('S');
    driver.settle();
    REQUIRE(driver.has("options/more"));
    CHECK_FALSE(driver.has("options/rest"));
    std::string hidden;
    for (const auto &[name, widget] : driver.context().widgets.all()) {
        hidden = name.starts_with("options/") && !widget.visible ? name : hidden;
    }
    REQUIRE_FALSE(hidden.empty());
    driver.click("options/more");
    driver.settle();
    CHECK(driver.context().widgets.find(hidden)->visible);
    driver.clickAt(driver.canvas().centre());
    driver.settle();
    CHECK_FALSE(driver.has("options/rest"));
}

TEST_CASE("Layers: a button on the canvas opens them, a press beside them closes them") {
    Draughtsman driver;
    CHECK_FALSE(driver.has("layer/mesh"));
    driver.click("canvas/layers");
    driver.settle();
    REQUIRE(driver.has("layer/mesh"));
    driver.click("layer/mesh");
    driver.settle();
    CHECK_FALSE(driver.context().layer("mesh")->visible);
    CHECK(driver.has("layer/mesh"));
    driver.clickAt(driver.canvas().centre());
    driver.settle();
    CHECK_FALSE(driver.has("layer/mesh"));
}

TEST_CASE("History and log: commands open and close them") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {8, 8});
    CHECK(driver.context().actions.run("edit.history", driver.context()));
    driver.settle();
    CHECK(driver.has("history/1"));
    driver.click("plate/history/close");
    driver.settle();
    CHECK_FALSE(driver.has("history/1"));
    CHECK(driver.context().actions.run("view.log", driver.context()));
    driver.settle();
    CHECK(driver.has("panel/log"));
    CHECK(driver.context().actions.run("view.log", driver.context()));
    driver.settle();
    CHECK_FALSE(driver.has("panel/log"));
}

} // namespace forefront::test
