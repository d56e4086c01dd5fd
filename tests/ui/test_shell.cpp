#include "tests/ui/driver.hpp"
#include "ui/app/assets.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/style/colour_map.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace forefront::test {

namespace {

bool within(const PixelRect &inner, PixelSize size) {
    return inner.x >= -0.5 && inner.y >= -0.5 && inner.x + inner.width <= size.width + 0.5 &&
           inner.y + inner.height <= size.height + 0.5;
}

} // namespace

TEST_CASE("Editor: opens on the sample with a hint strip, its domain in view") {
    Driver driver;
    const Document &document = *driver.context().document().current();
    CHECK(document.shapes.size() >= 4);
    CHECK_FALSE(document.spacing.paint.tiles.empty());
    CHECK(driver.context().document().title() == "Harbour with a pier");
    CHECK_FALSE(driver.context().document().dirty());
    CHECK(driver.has("hints/close"));
    CHECK(driver.context().preview->faults.empty());
    const Box2 box = toDomain(document).bounds();
    const Camera &camera = driver.context().view.camera;
    CHECK(camera.visible().contains(box.min));
    CHECK(camera.visible().contains(box.max));
    CHECK(driver.platform().title().find("Harbour") != std::string::npos);
}

TEST_CASE("Editor: every sample of the gallery opens without a fault") {
    Driver driver;
    REQUIRE(samples().size() >= 6);
    for (const Sample &sample : samples()) {
        CAPTURE(sample.title);
        REQUIRE(driver.editor().open(sample.path));
        REQUIRE(driver.settle());
        CHECK(driver.context().preview->faults.empty());
        CHECK(driver.context().preview->spacing != nullptr);
        CHECK(driver.context().preview->estimatedElements > 100.0);
    }
}

TEST_CASE("Editor: the hint strip goes when closed and is not shown again") {
    const auto folder = std::filesystem::temp_directory_path() / "forefront_ui_settings";
    std::filesystem::remove_all(folder);
    {
        Driver driver({.settingsFolder = folder});
        driver.click("hints/close");
        CHECK_FALSE(driver.has("hints/close"));
        driver.click("menu/theme");
    }
    Driver again({.settingsFolder = folder});
    CHECK_FALSE(again.has("hints/close"));
    CHECK(again.context().theme.kind == ThemeKind::Light);
    std::filesystem::remove_all(folder);
}

TEST_CASE("Settings: a spoilt file gives the defaults and says so, numbers out of range are brought in") {
    const auto file = std::filesystem::temp_directory_path() / "forefront_settings_test.json";
    Diagnostics faults;
    std::ofstream(file) << "{\"scale\": 1e9, \"panelWidth\": \"wide\", \"theme\": 7";
    CHECK(loadSettings(file, &faults).scale == 1.0);
    CHECK_FALSE(faults.empty());
    std::ofstream(file) << "{\"scale\": 1e9, \"panelWidth\": \"wide\", \"theme\": 7, \"recentFiles\": [1, \"a\"]}";
    const Settings settings = loadSettings(file, &faults);
    CHECK(settings.scale == 3.0);
    CHECK(settings.panelWidth == Settings{}.panelWidth);
    CHECK(settings.recentFiles == std::vector<std::string>{"a"});
    std::filesystem::remove(file);
}

TEST_CASE("Editor: all of the interface is inside the window at 1280x800, 1920x1080 and twice the scale") {
    const std::pair<PixelSize, double> sizes[] = {
        {{1280, 800}, 1.0}, {{1920, 1080}, 1.0}, {{2560, 1600}, 2.0}, {{1024, 700}, 1.0}};
    Driver driver;
    for (const auto &each : sizes) {
        const PixelSize size = each.first; // not a structured binding: clang 14 lets no lambda of doctest capture one
        const double scale = each.second;
        CAPTURE(size.width);
        driver.platform().resize(size, scale);
        REQUIRE(driver.settle());
        CHECK(static_cast<double>(driver.context().scale) == scale);
        for (const char *name : {"canvas", "menu/File", "menu/Help", "tool/select", "layer/domain", "layer/mesh",
                                 "panel/steps", "panel/histogram", "panel/log", "timeline/play", "timeline/scrubber",
                                 "timeline/position", "status/pointer"}) {
            CAPTURE(name);
            const auto *widget = driver.context().widgets.find(name);
            REQUIRE(widget != nullptr);
            CHECK(within(widget->rect, size));
            CHECK(widget->rect.width >= 8.0 * scale);
            CHECK(widget->rect.height >= 8.0 * scale);
        }
        CHECK(driver.canvas().width > 0.5 * size.width);
    }
}

TEST_CASE("Editor: buttons grow with the scale") {
    Driver driver;
    const double before = driver.context().widgets.find("timeline/play")->rect.width;
    driver.context().settings.scale = 1.5;
    REQUIRE(driver.settle());
    const double after = driver.context().widgets.find("timeline/play")->rect.width;
    CHECK(std::abs(after / before - 1.5) < 0.05);
}

TEST_CASE("Editor: the theme changes nearly every pixel and back again none") {
    Driver driver;
    driver.moveTo({640, 400});
    REQUIRE(driver.settle());
    const auto dark = driver.picture();
    driver.context().settings.theme = ThemeKind::Light;
    REQUIRE(driver.settle());
    const auto light = driver.picture();
    const auto all = static_cast<std::size_t>(dark.size.width) * static_cast<std::size_t>(dark.size.height);
    CHECK(light.differences(dark) > all * 9 / 10);
    driver.context().settings.theme = ThemeKind::Dark;
    REQUIRE(driver.settle());
    CHECK(driver.picture().differences(dark) == 0);
}

TEST_CASE("Editor: Tab hides the panels and brings them back") {
    Driver driver;
    const double before = driver.canvas().width;
    driver.key(key::kTab);
    REQUIRE(driver.settle());
    CHECK(driver.canvas().width > before + 200.0);
    CHECK_FALSE(driver.has("layer/mesh"));
    driver.key(key::kTab);
    REQUIRE(driver.settle());
    CHECK(driver.canvas().width == before);
}

TEST_CASE("Editor: the view stays fitted while window and panels change their size, until the user moves it") {
    Driver driver;
    const Box2 box = toDomain(*driver.context().document().current()).bounds();
    const Camera &camera = driver.context().view.camera;
    const auto fits = [&] {
        REQUIRE(driver.settle());
        const Vec2 size = box.size();
        const double part =
            std::max(size.x * camera.zoom / camera.viewport.width, size.y * camera.zoom / camera.viewport.height);
        return part > 0.8 && part < 0.9 && distance(camera.centre, box.centre()) < 1e-9 * size.x;
    };
    CHECK(fits());
    const double before = camera.zoom;
    driver.platform().resize({1920, 1080}, 1.0);
    CHECK(fits());
    CHECK(camera.zoom > 1.2 * before);
    driver.key(key::kTab);
    CHECK(fits());
    driver.key(key::kTab);
    CHECK(fits());
    const PixelRect edge = driver.context().widgets.find("splitter/column")->rect;
    driver.drag(edge.centre(), edge.centre() - Vec2{120, 0});
    CHECK(fits());
    driver.scroll(driver.canvas().centre(), 2);
    const Vec2 centre = camera.centre;
    const double zoomed = camera.zoom;
    driver.platform().resize({1280, 800}, 1.0);
    REQUIRE(driver.settle());
    CHECK(camera.zoom == zoomed);
    CHECK(camera.centre == centre);
    driver.key('F');
    driver.platform().resize({1500, 900}, 1.0);
    CHECK(fits());
}

TEST_CASE("Editor: the splitter of the right column can be dragged, within bounds") {
    Driver driver;
    const PixelRect edge = driver.context().widgets.find("splitter/column")->rect;
    const double before = driver.canvas().width;
    driver.drag(edge.centre(), edge.centre() - Vec2{80, 0});
    CHECK(std::abs(driver.canvas().width - (before - 80.0)) < 3.0);
    const PixelRect moved = driver.context().widgets.find("splitter/column")->rect;
    driver.drag(moved.centre(), {1279, moved.centre().y});
    CHECK(driver.canvas().width <= 1280.0 - 240.0 - 40.0);
}

TEST_CASE("Editor: the shortcut sheet opens by ? and closes by Esc") {
    Driver driver;
    driver.key(key::kSlash, {Modifiers::kShift});
    driver.frames(3);
    REQUIRE(driver.context().dialogs.top() != nullptr);
    CHECK(std::string(driver.context().dialogs.top()->id()) == "shortcuts");
    CHECK(within(driver.context().widgets.find("dialog/shortcuts")->rect, {1280, 800}));
    driver.key(key::kEscape);
    driver.frames(3);
    CHECK(driver.context().dialogs.top() == nullptr);
}

TEST_CASE("Editor: the palette finds an action by a part of its name") {
    Driver driver;
    driver.key('P', {Modifiers::kControl});
    driver.frames(4);
    REQUIRE(driver.has("palette/query"));
    driver.type("light");
    driver.frames(2);
    CHECK(driver.has("palette/view.theme"));
    CHECK_FALSE(driver.has("palette/run.mesh"));
    driver.key(key::kEnter);
    REQUIRE(driver.settle());
    CHECK(driver.context().theme.kind == ThemeKind::Light);
    CHECK(driver.context().dialogs.top() == nullptr);
}

TEST_CASE("Editor: menus open by click and slide to their neighbours; Esc closes them") {
    Driver driver;
    driver.click("menu/View");
    driver.frames(2);
    REQUIRE(driver.has("menu/view.fit"));
    driver.hover("menu/Mesh");
    driver.frames(3);
    CHECK(driver.has("menu/run.mesh"));
    driver.key(key::kEscape);
    driver.frames(3);
    CHECK_FALSE(driver.has("menu/run.mesh"));
}

TEST_CASE("Editor: keys choose tools, each with a button in the strip") {
    Driver driver;
    for (const auto &tool : driver.context().tools.tools) {
        CAPTURE(tool->id());
        CHECK(driver.has(std::string("tool/") + tool->id()));
        if (tool->key() != 0) {
            driver.key(tool->key());
            CHECK(&driver.context().tools.current() == tool.get());
        }
    }
}

TEST_CASE("Editor: wheel zooms at the pointer, middle drag and Space with drag pan") {
    Driver driver;
    const Vec2 at{400, 300};
    const Vec2 place = driver.context().view.camera.toPlane(at);
    driver.scroll(at, 4);
    const Vec2 zoomed = driver.context().view.camera.toPixel(place);
    CHECK(std::abs(zoomed.x - at.x) < 0.01);
    CHECK(std::abs(zoomed.y - at.y) < 0.01);
    InputQueue &input = driver.editor().input();
    input.push({.kind = InputKind::Key, .code = key::kSpace, .pressed = true});
    driver.frames(2);
    driver.drag(at, at + Vec2{60, 25});
    input.push({.kind = InputKind::Key, .code = key::kSpace, .pressed = false});
    driver.frames(2);
    const Vec2 panned = driver.context().view.camera.toPixel(place);
    CHECK(std::abs(panned.x - (at.x + 60)) < 0.01);
    CHECK(std::abs(panned.y - (at.y + 25)) < 0.01);
    CHECK(driver.run().state == RunState::Empty); // the Space of a pan is no tap
}

TEST_CASE("Colour maps: ends as published, even between") {
    CHECK(viridis(0.0) == rgb(0x440154));
    CHECK(viridis(1.0) == rgb(0xfde725));
    CHECK(cividis(0.0) == rgb(0x00204d));
    CHECK(cividis(1.0) == rgb(0xffea46));
    CHECK(viridis(2.0) == viridis(1.0));
}

TEST_CASE("Legend: ticks of a logarithmic scale lie in order between the ends") {
    for (const auto &[least, greatest] : {std::pair{0.05, 0.5}, {1e-4, 3.0}, {2.0, 2.1}, {1e-9, 1e6}}) {
        const auto ticks = logarithmicTicks(least, greatest, 5);
        REQUIRE(ticks.size() >= 2);
        CHECK(ticks.size() <= 7);
        CHECK(ticks.front().at == 0.0);
        CHECK(ticks.back().at == 1.0);
        for (std::size_t i = 1; i < ticks.size(); ++i) {
            CHECK(ticks[i].at > ticks[i - 1].at);
        }
    }
}

} // namespace forefront::test
