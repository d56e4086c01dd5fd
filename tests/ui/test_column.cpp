#include "tests/ui/edit_driver.hpp"
#include "ui/shell/section_heights.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <string>

namespace forefront::test {

namespace {

constexpr shell::SectionMeasures kMeasures{.heading = 28.0F, .gap = 10.0F, .lowest = 84.0F};

} // namespace

TEST_CASE("Column: low sections get their height, the others share what is left") {
    std::vector<shell::Section> sections{{.content = 50.0F}, {.content = 900.0F}, {.content = 900.0F}};
    const std::vector<float> heights = shell::sectionHeights(sections, kMeasures, 700.0F);
    CHECK(heights[0] == 50.0F);
    CHECK(heights[1] == heights[2]);
    CHECK(std::accumulate(heights.begin(), heights.end(), 3.0F * 38.0F) == doctest::Approx(700.0));
    CHECK(shell::sectionHeights(sections, kMeasures, 5000.0F) == std::vector<float>{50.0F, 900.0F, 900.0F});
}

TEST_CASE("Column: a section that a command has opened is whole before others grow") {
    std::vector<shell::Section> sections{{.content = 900.0F}, {.first = true, .content = 400.0F}};
    const std::vector<float> heights = shell::sectionHeights(sections, kMeasures, 700.0F);
    CHECK(heights[1] == 400.0F);
    CHECK(heights[0] == doctest::Approx(700.0 - 400.0 - 2.0 * 38.0));
}

TEST_CASE("Column: where those that come first are to be whole, others fold for them, but not what the user opened") {
    shell::SectionMeasures measures = kMeasures;
    measures.wholeFirst = true;
    std::vector<shell::Section> sections{{.first = true, .content = 520.0F},
                                         {.keepsOpen = false, .content = 300.0F},
                                         {.keepsOpen = true, .content = 50.0F},
                                         {.keepsOpen = false, .content = 300.0F}};
    const std::vector<float> heights = shell::sectionHeights(sections, measures, 760.0F);
    CHECK(heights[0] == 520.0F);
    CHECK_FALSE(sections[3].open);
    CHECK_FALSE(sections[1].open);
    CHECK(heights[2] == 50.0F);
    std::vector<shell::Section> roomy{{.first = true, .content = 520.0F}, {.keepsOpen = false, .content = 300.0F}};
    CHECK(shell::sectionHeights(roomy, measures, 760.0F)[1] > 100.0F); // there is room for both
}

TEST_CASE("Column: without room, the lower sections fold, except those that were opened") {
    std::vector<shell::Section> sections(4, {.keepsOpen = false, .content = 300.0F});
    sections[3].keepsOpen = true;
    const std::vector<float> heights = shell::sectionHeights(sections, kMeasures, 330.0F);
    CHECK(sections[0].open);
    CHECK_FALSE(sections[1].open);
    CHECK_FALSE(sections[2].open);
    CHECK(sections[3].open);
    CHECK(heights[1] == 0.0F);
    CHECK(heights[3] >= 84.0F);
}

TEST_CASE("Column: one section stays open, however low the column is") {
    std::vector<shell::Section> sections(4, {.keepsOpen = false, .content = 300.0F});
    const std::vector<float> heights = shell::sectionHeights(sections, kMeasures, 190.0F);
    CHECK(heights[0] >= 42.0F);
    CHECK(heights[0] <= 84.0F);
    CHECK(sections[0].open);
    CHECK_FALSE(sections[1].open);
    CHECK_FALSE(sections[3].open);
}

TEST_CASE("Column: a selected shape can be renamed without scrolling, in a low window too") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key(key::kEscape);
    driver.context().selection.shapes = {1};
    for (const double height : {800.0, 600.0}) {
        driver.platform().resize({1280, static_cast<int>(height)}, 1.0);
        driver.settle();
        for (const char *row : {"inspector/what", "inspector/name"}) {
            CAPTURE(row);
            const auto *widget = driver.context().widgets.find(row);
            REQUIRE(widget != nullptr);
            CHECK(widget->visible);
        }
    }
}

TEST_CASE("Column: in a narrow window it opens over the canvas on demand") {
    Draughtsman driver({}, {1280, 800});
    const double docked = driver.canvas().width;
    CHECK(driver.has("column"));
    driver.platform().resize({1280, 800}, 2.0);
    driver.settle();
    CHECK_FALSE(driver.has("column"));
    const PixelRect canvas = driver.canvas();
    CHECK(canvas.width > docked); // more of the window than beside the column
    driver.key(key::kTab);
    driver.settle();
    REQUIRE(driver.has("column"));
    CHECK(driver.canvas() == canvas); // the drawing stays where it is
    const PixelRect column = driver.context().widgets.find("column")->rect;
    CHECK(column.overlaps(canvas));
    CHECK_FALSE(driver.context().widgets.find("canvas/tools")->rect.overlaps(column));
    driver.key(key::kTab);
    driver.settle();
    CHECK_FALSE(driver.has("column"));
    driver.showPanel("spacing");
    CHECK(driver.has("column"));
    driver.platform().resize({1280, 800}, 1.0);
    driver.settle();
    CHECK(driver.canvas().width == docked);
}

TEST_CASE("Column: panels stay in place when something else is selected, or a part of the mesh is probed") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.settle();
    const auto top = [&](const char *widget) {
        driver.settle();
        REQUIRE(driver.has(widget));
        return driver.context().widgets.find(widget)->rect.y;
    };
    driver.context().selection.clear();
    const double shapes = top("panel/shapes"), parameters = top("panel/parameters"), add = top("parameters/add");
    for (const Selection &selection :
         {Selection{.shapes = {1}}, Selection{.segments = {{1, 0}}}, Selection{.nodes = {{1, 0}}}}) {
        driver.context().selection = selection;
        CHECK(top("panel/shapes") == shapes);
        CHECK(top("panel/parameters") == parameters);
        CHECK(top("parameters/add") == add);
    }
    driver.context().selection.clear();
    driver.key(key::k2);
    driver.settle();
    driver.workspace(WorkspaceKind::Judge);
    driver.showPanel("probe");
    const double next = top("probe/next"), heading = top("panel/probe");
    for (int k = 0; k < 3; ++k) {
        driver.click("probe/next");
        CHECK(driver.context().probe.chosen.has_value());
        CHECK(top("probe/next") == next);
        CHECK(top("panel/probe") == heading);
    }
}

TEST_CASE("Column: the names of layers do not reach into the next column") {
    for (const double scale : {1.0, 2.0}) {
        Driver driver({}, {1280, 800}, scale);
        driver.unfoldLayers();
        for (const LayerSlot &slot : driver.context().layers) {
            CAPTURE(slot.layer->name());
            const auto *eye = driver.context().widgets.find(std::string("layer/") + slot.layer->id());
            REQUIRE(eye != nullptr);
            // The eye is 24 pixels wide; letters of the small font are at most 9 pixels wide, on average below 7.
            CHECK(eye->rect.width >=
                  (24.0 + 5.5 * static_cast<double>(std::string_view(slot.layer->name()).size())) * scale);
        }
    }
}

} // namespace forefront::test
