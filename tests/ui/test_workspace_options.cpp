#include "tests/ui/meshed_square.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/number_field.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

namespace forefront::test {

namespace {

bool allShown(Driver &driver, std::initializer_list<const char *> widgets) {
    for (const char *widget : widgets) {
        const WidgetRegistry::Widget *const found = driver.context().widgets.find(widget);
        if (found == nullptr || !found->visible) {
            MESSAGE(widget);
            return false;
        }
    }
    return true;
}

} // namespace

TEST_CASE("Options bar: Mesh has the method, the improvement, the element size and the run") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Mesh);
    REQUIRE(allShown(
        driver, {"options/mesh/method/Fast", "options/mesh/improve/Best", "options/mesh/size", "options/mesh/run"}));
    CHECK_FALSE(driver.has("options/delete")); // the options of the selection
    driver.click("options/mesh/method/Classic");
    driver.click("options/mesh/improve/None");
    driver.fill("options/mesh/size", "2");
    CHECK(driver.document().options.method == Method::Classic);
    CHECK(driver.document().options.improve == ImproveLevel::None);
    CHECK(driver.document().spacing.size == 2.0);
    CHECK(driver.context().run.outOfDate());
    const std::size_t before = driver.mesh().elements.size();
    driver.click("options/mesh/run");
    driver.settle();
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK(driver.mesh().elements.size() < before);
}

TEST_CASE("Options bar: Step has the unit of a step, the speed, and whether the camera follows") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Step);
    REQUIRE(allShown(driver,
                     {"timeline/granularity/Event", "timeline/speed", "options/step/follow", "options/step/compare"}));
    driver.click("timeline/granularity/Layer");
    CHECK(driver.context().run.granularity == Granularity::Layer);
    driver.click("options/step/follow");
    CHECK(driver.context().view.following);
    const PixelRect slider = driver.context().widgets.find("timeline/speed")->rect;
    driver.clickAt({slider.x + slider.width - 8.0, slider.centre().y});
    CHECK(driver.context().run.speed() > 100.0);
    driver.click("options/step/compare");
    driver.settle();
    CHECK(driver.context().sides.visible);
    driver.click("options/step/compare");
    driver.settle();
    CHECK_FALSE(driver.context().sides.visible);
}

TEST_CASE("Options bar: Judge has the measure, its limit, the range of the colours and the worst places") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Judge);
    REQUIRE(allShown(driver, {"options/judge/measure", "options/judge/limit", "options/judge/from", "options/judge/to",
                              "options/judge/fit", "options/judge/next"}));
    driver.fill("options/judge/limit", "0.9");
    CHECK(driver.document().limits[MeshLimit::MinAlpha] == 0.9);
    driver.fill("options/judge/from", "0.4");
    CHECK(measureRange(driver.context()).from == doctest::Approx(0.4));
    driver.click("options/judge/next");
    driver.settle();
    CHECK(driver.context().probe.rank == 0);
    driver.click("options/judge/next");
    driver.settle();
    CHECK(driver.context().probe.rank == 1);
    driver.click("options/judge/previous");
    driver.settle();
    CHECK(driver.context().probe.rank == 0);
    driver.click("options/judge/measure");
    driver.settle();
    driver.click(std::string("options/judge/measure/") + infoOf(Measure::MinAngle).name);
    driver.settle();
    CHECK(driver.context().view.measure == Measure::MinAngle);
    chooseMeasure(driver.context(), Measure::Region);
    driver.settle();
    CHECK_FALSE(driver.has("options/judge/limit"));
    CHECK_FALSE(driver.has("options/judge/from"));
}

TEST_CASE("Options bar: in a narrow window labels go before fields do") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Mesh);
    const auto left = [&] { return driver.context().widgets.find("options/mesh/size")->rect.x; };
    const double labelled = left();
    for (int width = 1280; width >= 560; width -= 20) {
        CAPTURE(width);
        driver.platform().resize({width, 700}, 1.0);
        driver.settle();
        if (driver.has("options/more")) {
            CHECK(left() != labelled);
            break;
        }
        REQUIRE(allShown(driver, {"options/mesh/size", "options/mesh/run"}));
        REQUIRE(width > 560);
    }
    driver.platform().resize({1280, 800}, 1.0);
    driver.settle();
    CHECK(left() == labelled);
}

TEST_CASE("Judge: what was probed is forgotten with the workspace and the tool, and hidden under a dialog") {
    MeshedSquare driver;
    const auto worst = [&] {
        driver.workspace(WorkspaceKind::Judge);
        driver.context().actions.run("run.worst", driver.context());
        driver.settle();
        CHECK(driver.has("probe/plate/place"));
    };
    worst();
    driver.workspace(WorkspaceKind::Draw);
    driver.settle();
    CHECK_FALSE(driver.context().probe.chosen);
    CHECK_FALSE(driver.has("probe/plate/place"));
    worst();
    driver.key('M');
    driver.settle();
    CHECK_FALSE(driver.context().probe.chosen);
    worst();
    driver.context().actions.run("view.scale", driver.context());
    driver.settle();
    CHECK_FALSE(driver.has("probe/plate/place")); // an import would show another drawing there
    driver.key(key::kEscape);
    driver.settle();
    CHECK(driver.has("probe/plate/place"));
}

TEST_CASE("Worst places: a click zooms to the element, arrow keys walk the table, and it follows the measure") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Judge);
    REQUIRE(allShown(driver, {"panel/worst", "worst/0", "worst/2"}));
    CHECK_FALSE(driver.context().widgets.find("below")->rect.overlaps(driver.canvas()));
    const double before = driver.context().view.camera.zoom;
    const auto chosen = [&] { return driver.context().probe.chosen; };
    driver.click("worst/2");
    driver.settle();
    const std::vector<std::uint32_t> &worst = driver.context().judgement->worst;
    REQUIRE(chosen());
    CHECK(*chosen() == MeshPick{MeshPart::Elements, worst[2]});
    CHECK(driver.context().view.camera.zoom > before);
    CHECK(driver.has("probe/plate/value")); // at the element
    CHECK(driver.canvas().contains(driver.context().widgets.find("probe/plate/value")->rect.centre()));
    driver.key(key::kDown);
    driver.settle();
    CHECK(driver.context().probe.rank == 3);
    CHECK(*chosen() == MeshPick{MeshPart::Elements, worst[3]});
    for (int k = 0; k < 5; ++k) {
        driver.key(key::kUp);
    }
    driver.settle();
    CHECK(driver.context().probe.rank == 0);
    for (int k = 0; k < 30; ++k) { // the list scrolls along
        driver.key(key::kDown);
    }
    driver.settle();
    CHECK(allShown(driver, {"worst/30"}));
    // On the canvas the arrow keys move the selection again.
    driver.clickAt(driver.canvas().centre());
    driver.key(key::kDown);
    driver.settle();
    CHECK(driver.context().probe.rank.value_or(30) == 30);
    chooseMeasure(driver.context(), Measure::SizeRatio);
    driver.settle();
    CHECK_FALSE(driver.context().probe.rank);
    driver.click("worst/0");
    driver.settle();
    REQUIRE(chosen());
    CHECK(chosen()->part == MeshPart::Edges);
    chooseMeasure(driver.context(), Measure::Region);
    driver.settle();
    CHECK(driver.has("worst/empty"));
    driver.click("panel/worst");
    driver.settle();
    CHECK_FALSE(driver.has("worst/empty"));
}

TEST_CASE("Menu bar: a field for the search of commands opens the palette, with its focus") {
    Draughtsman driver;
    const WidgetRegistry::Widget *const field = driver.context().widgets.find("menu/palette");
    REQUIRE(field != nullptr);
    CHECK(field->rect.width > 120.0);
    driver.click("menu/palette");
    driver.type("zoom to fit");
    driver.settle();
    CHECK(driver.has("palette/view.fit"));
    driver.key(key::kEscape);
    driver.settle();
    driver.platform().resize({900, 700}, 1.0); // no room for a field
    driver.settle();
    CHECK(driver.context().widgets.find("menu/palette")->rect.width < 40.0);
    driver.click("menu/palette");
    driver.settle();
    CHECK(driver.has("palette/query"));
}

TEST_CASE("Numbers: a layer of its own, which no workspace shows, numbers nodes and elements close up") {
    MeshedSquare driver;
    for (const WorkspaceKind kind : kWorkspaceKinds) {
        driver.workspace(kind);
        CHECK_FALSE(driver.context().layer("numbers")->visible);
    }
    const auto numbered = [&](const std::string &text, Vec2 place) {
        for (const CanvasPainter::Placed &label : driver.editor().canvas().labels()) {
            const double away = glm::distance(label.rect.centre(), driver.pixel(place));
            if (label.text == text && away < 40.0) {
                return true;
            }
        }
        return false;
    };
    const Vec2 node = driver.nodeAt(40, 0), middle = driver.middleOf(40);
    const std::string number = std::to_string(index(driver.mesh().elements[40][0]));
    driver.context().view.fit(boxAround(middle, 1.5));
    driver.settle();
    CHECK_FALSE(numbered(number, node));
    showLayer(driver.context().layers, "numbers", true);
    driver.context().animate();
    driver.settle();
    CHECK(numbered(number, node));
    CHECK(numbered("40", middle));
}

} // namespace forefront::test
