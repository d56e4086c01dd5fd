#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

namespace forefront::test {

TEST_CASE(
    "Column: in a low window the layers are folded, so that the inspector is seen whole; a choice is remembered") {
    const TemporaryFolder place;
    EditorSetup setup;
    setup.settingsFolder = place.path;
    {
        Draughtsman driver(setup);
        driver.rectangle({1, 1}, {9, 8});
        driver.settle();
        CHECK_FALSE(driver.has("layer/domain"));
        const auto *button = driver.context().widgets.find("inspector/delete"); // the last row
        REQUIRE(button != nullptr);
        CHECK(button->visible);
        CHECK((!button->clip || button->rect.y + button->rect.height <= button->clip->y + button->clip->height));
        driver.platform().resize({1280, 1000}, 1.0);
        driver.settle();
        CHECK(driver.has("layer/domain"));
        driver.platform().resize({1280, 1000}, 2.0);
        driver.settle();
        CHECK_FALSE(driver.has("layer/domain"));
        driver.click("panel/layers");
        driver.settle();
        CHECK(driver.has("layer/domain"));
    }
    Draughtsman again(setup);
    CHECK(again.has("layer/domain"));
}

TEST_CASE("Column: at twice the scale, a selection scrolls the inspector into view") {
    Draughtsman driver({}, {1280, 800});
    driver.rectangle({1, 1}, {9, 8});
    driver.platform().resize({1280, 800}, 2.0);
    driver.key('V');
    driver.key(key::kEscape);
    driver.unfoldLayers();
    driver.context().selection.shapes = {1};
    driver.settle();
    for (const char *row : {"inspector/what", "inspector/name"}) {
        CAPTURE(row);
        const auto *widget = driver.context().widgets.find(row);
        REQUIRE(widget != nullptr);
        CHECK(widget->visible);
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

TEST_CASE("Column: the tabs stay under the pointer, whichever is chosen, and no row holds a single one") {
    for (const double scale : {1.0, 2.0}) {
        Driver driver({}, {1280, 800}, scale);
        std::map<std::string, Pixel> places;
        std::map<double, int> rows;
        for (const auto &panel : driver.context().panels) {
            if (panel->place() == PanelPlace::Tabbed) {
                const std::string tab = std::string("panel/") + panel->id();
                const auto *widget = driver.context().widgets.find(tab);
                REQUIRE(widget != nullptr);
                places[tab] = widget->rect.centre();
                ++rows[widget->rect.y];
            }
        }
        for (const auto &[y, count] : rows) {
            CHECK(count >= 3);
        }
        for (const auto &chosen : places) {
            driver.clickAt(chosen.second);
            driver.settle();
            CAPTURE(chosen.first);
            CHECK("panel/" + driver.context().settings.tab == chosen.first);
            for (const auto &[tab, place] : places) {
                CAPTURE(tab);
                CHECK(driver.context().widgets.find(tab)->rect.centre() == place);
            }
        }
    }
}

} // namespace forefront::test
