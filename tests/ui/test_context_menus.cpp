#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace forefront::test {

namespace {

struct Clicker : Draughtsman {
    void rightClickAt(Pixel at) {
        moveTo(at);
        press(at, MouseButton::Right);
        release(at, MouseButton::Right);
        settle();
    }
    void rightClick(std::string_view widget) {
        const auto *found = context().widgets.find(widget);
        REQUIRE_MESSAGE(found != nullptr, std::string(widget));
        rightClickAt(found->rect.centre());
    }
    /// Returns the number of commands of the open menu, and closes it.
    std::size_t commands() {
        REQUIRE(has("contextmenu"));
        std::size_t count = 0;
        for (const auto &[name, widget] : context().widgets.all()) {
            count += name.starts_with("contextmenu/") ? 1 : 0;
        }
        key(key::kEscape);
        settle();
        return count;
    }
    /// Draws a square and meshes it.
    void mesh() {
        rectangle({1, 1}, {9, 8});
        key(key::kF5);
        settle();
    }
};

} // namespace

TEST_CASE("Context menu: the probe, trace and guess tools have menus of their own, on a mesh and without one") {
    Clicker clicker;
    for (const char tool : {'I', 'W', 'Q', 'M', 'Z', 'B'}) {
        CAPTURE(tool);
        clicker.key(tool);
        clicker.rightClickAt(clicker.pixel({5, 5}));
        CHECK(clicker.commands() > 0);
    }
    clicker.mesh();
    clicker.key('I');
    clicker.settle();
    clicker.rightClickAt(clicker.pixel({5.03, 4.02}));
    REQUIRE(clicker.has("contextmenu/copyValues"));
    clicker.click("contextmenu/copyValues");
    clicker.settle();
    CHECK(clicker.platform().clipboard().find('\t') != std::string::npos); // rows of names and values
    clicker.key('W');
    clicker.rightClickAt(clicker.pixel({5.03, 4.02}));
    REQUIRE(clicker.has("contextmenu/birth"));
    clicker.click("contextmenu/stopPlace");
    clicker.settle();
    CHECK(clicker.context().run.breakpoints().place);
    clicker.rightClickAt(clicker.pixel({5, 5}));
    clicker.click("contextmenu/noStops");
    clicker.settle();
    CHECK_FALSE(clicker.context().run.breakpoints().any());
    clicker.key('Q');
    clicker.settle();
    clicker.rightClickAt(clicker.canvas().centre()); // the camera has gone to the base
    CHECK(clicker.has("contextmenu/nextBase"));
}

TEST_CASE("Context menu: every panel has one, and none is empty") {
    Clicker clicker;
    clicker.mesh();
    for (const auto &panel : clicker.context().panels) {
        const std::string heading = std::string("panel/") + panel->id();
        CAPTURE(heading);
        clicker.showPanel(panel->id());
        clicker.rightClick(heading);
        CHECK(clicker.has("contextmenu/panel/pin") == (panel->place() == PanelPlace::Column));
        CHECK(clicker.commands() > 0);
    }
}

TEST_CASE("Context menu: rows of the history, parameters, layers and names") {
    Clicker clicker;
    clicker.mesh();
    clicker.rectangle({2, 2}, {3, 3});
    clicker.showPanel("history");
    clicker.settle();
    clicker.rightClick("history/1");
    clicker.click("contextmenu/goTo");
    clicker.settle();
    CHECK(clicker.document().shapes.size() == 1);
    clicker.showPanel("names");
    clicker.settle();
    clicker.rightClick("names/boundary/1");
    clicker.click("contextmenu/select");
    clicker.settle();
    CHECK(clicker.context().selection.shapes.size() == 1);
    clicker.showPanel("parameters");
    clicker.settle();
    clicker.click("parameters/add");
    clicker.settle();
    clicker.key(key::kEscape);
    clicker.settle();
    clicker.rightClick("parameters/0/remove");
    CHECK(clicker.has("contextmenu/copyValue"));
    clicker.click("contextmenu/copy");
    clicker.settle();
    CHECK(clicker.platform().clipboard() == "p1 = 1");
    clicker.rightClick("parameters/0/remove");
    clicker.click("contextmenu/remove");
    clicker.settle();
    CHECK(clicker.document().parameters.empty());
    clicker.unfoldLayers();
    clicker.rightClick("layer/labels");
    clicker.click("contextmenu/show");
    clicker.settle();
    CHECK_FALSE(clicker.context().layer("labels")->visible);
    clicker.rightClick("layer/labels");
    clicker.click("contextmenu/defaults");
    clicker.settle();
    CHECK(clicker.context().layer("labels")->visible);
}

TEST_CASE("Context menu: the legend chooses what colours the mesh, the timeline goes to an advance, rulers copy") {
    Clicker clicker;
    clicker.mesh();
    showLayer(clicker.context().layers, "quality", true);
    clicker.settle();
    clicker.rightClick("canvas/legend/quality");
    REQUIRE(clicker.has("contextmenu/measure/area"));
    clicker.click("contextmenu/measure/area");
    clicker.settle();
    CHECK(clicker.context().view.measure == Measure::Area);
    clicker.rightClick("canvas/legend/quality");
    CHECK(clicker.has("contextmenu/file.exportPicture"));
    clicker.click("contextmenu/colour/size");
    clicker.settle();
    CHECK(clicker.context().layer("size")->visible);
    clicker.workspace(WorkspaceKind::Step);
    const PixelRect bar = clicker.context().widgets.find("timeline/scrubber")->rect;
    clicker.rightClickAt({bar.x + bar.width / 2, bar.centre().y});
    REQUIRE(clicker.has("contextmenu/goTo"));
    clicker.click("contextmenu/goTo");
    clicker.settle();
    CHECK(clicker.run().advance > 0);
    CHECK(clicker.run().advance < clicker.run().known);
    clicker.key('R', kControl);
    clicker.settle();
    clicker.rightClick("canvas/ruler/x");
    clicker.click("contextmenu/copyCoordinate");
    clicker.settle();
    CHECK_FALSE(clicker.platform().clipboard().empty());
    clicker.rightClick("canvas/ruler/y");
    clicker.click("contextmenu/view.rulers");
    clicker.settle();
    CHECK_FALSE(clicker.has("canvas/ruler/x"));
}

TEST_CASE("Empty drawing: no figures of the mesh are shown after everything is deleted, until that is undone") {
    Clicker clicker;
    clicker.mesh();
    REQUIRE(clicker.has("status/counts"));
    const std::uint64_t elements = clicker.run().quality.elements;
    clicker.key('V');
    clicker.key('A', kControl);
    clicker.key(key::kDelete);
    clicker.settle();
    CHECK(clicker.document().shapes.empty());
    CHECK_FALSE(clicker.has("status/counts"));
    CHECK_FALSE(clicker.has("canvas/outofdate"));
    CHECK(clicker.run().known == 0);
    CHECK_FALSE(clicker.context().run.outOfDate());
    clicker.showPanel("histogram");
    clicker.settle();
    CHECK(clicker.has("histogram/empty"));
    clicker.key('Z', kControl);
    clicker.settle();
    CHECK(clicker.run().quality.elements == elements);
    CHECK_FALSE(clicker.context().run.outOfDate());
}

} // namespace forefront::test
