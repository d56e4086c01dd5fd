#include "core/drawing/domain/document_domain.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/driver.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/platform/assets.hpp"
#include "ui/shell/tool_slots.hpp"
#include "ui/style/colour_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

namespace forefront::test {

namespace {

bool within(const PixelRect &inner, PixelSize size) {
    return inner.x >= -0.5 && inner.y >= -0.5 && inner.x + inner.width <= size.width + 0.5 &&
           inner.y + inner.height <= size.height + 0.5;
}

/// Returns the rectangle of a place in the tool strip.
PixelRect rectOfSlot(Driver &driver, const shell::ToolSlot &slot) {
    const ToolBox &box = driver.context().tools;
    const std::string name = std::string("tool/") + box.tools[shell::shownTool(box, slot)]->id();
    const WidgetRegistry::Widget *const widget = driver.context().widgets.find(name);
    REQUIRE_MESSAGE(widget != nullptr, name);
    return widget->rect;
}

} // namespace

TEST_CASE("Editor: opens with the sample in view and the hint strip shown") {
    Driver driver;
    const Document &document = *driver.context().document.current();
    CHECK(document.shapes.size() >= 4);
    CHECK_FALSE(document.spacing.paint.tiles.empty());
    CHECK(driver.context().document.title() == "Harbour with a pier");
    CHECK_FALSE(driver.context().document.dirty());
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
    REQUIRE(sampleDrawings().size() >= 6);
    for (const Sample &sample : sampleDrawings()) {
        CAPTURE(sample.title);
        REQUIRE(driver.editor().open(sample.path));
        driver.settle();
        CHECK(driver.context().preview->faults.empty());
        CHECK(driver.context().preview->spacing != nullptr);
        CHECK(driver.context().preview->estimatedElements > 100.0);
    }
}

TEST_CASE("Editor: a closed hint strip stays closed") {
    const testing::TemporaryFolder place;
    const std::filesystem::path &folder = place.path;
    {
        Driver driver({.settingsFolder = folder});
        driver.click("hints/close");
        CHECK_FALSE(driver.has("hints/close"));
        driver.click("menu/theme");
    }
    Driver again({.settingsFolder = folder});
    CHECK_FALSE(again.has("hints/close"));
    CHECK(again.context().theme.kind == ThemeKind::Light);
}

TEST_CASE("Settings: a damaged file gives the defaults and a warning, and numbers are clamped") {
    const testing::TemporaryFolder place;
    const std::filesystem::path file = place / "settings.json";
    Diagnostics faults;
    std::ofstream(file) << "{\"scale\": 1e9, \"panelWidth\": \"wide\", \"theme\": 7";
    CHECK(loadSettings(file, &faults).scale == 1.0);
    CHECK_FALSE(faults.empty());
    std::ofstream(file) << "{\"scale\": 1e9, \"panelWidth\": \"wide\", \"theme\": 7, \"recentFiles\": [1, \"a\"]}";
    const Settings settings = loadSettings(file, &faults);
    CHECK(settings.scale == 3.0);
    CHECK(settings.panelWidth == Settings{}.panelWidth);
    CHECK(settings.recentFiles == std::vector<std::string>{"a"});
}

TEST_CASE("Editor: the whole interface is inside the window at 1280x800, 1920x1080 and twice the scale") {
    const std::pair<PixelSize, double> sizes[] = {
        {{1280, 800}, 1.0}, {{1920, 1080}, 1.0}, {{2560, 1600}, 2.0}, {{1024, 700}, 1.0}};
    Driver driver;
    for (const auto &each : sizes) {
        const PixelSize size = each.first; // not a structured binding: clang 14 lets no lambda of doctest capture one
        const double scale = each.second;
        CAPTURE(size.width);
        driver.platform().resize(size, scale);
        driver.settle();
        CHECK(static_cast<double>(driver.context().scale) == scale);
        driver.workspace(WorkspaceKind::Step);
        driver.unfoldLayers();
        for (const char *name :
             {"canvas", "menu/File", "menu/Help", "workspace/Judge", "options", "tool/select", "layer/domain",
              "layer/mesh", "panel/steps", "panel/candidates", "panel/statistics", "timeline/play", "timeline/scrubber",
              "timeline/position", "status/pointer", "status/log"}) {
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
    driver.workspace(WorkspaceKind::Step);
    const double before = driver.context().widgets.find("timeline/play")->rect.width;
    driver.context().settings.scale = 1.5;
    driver.settle();
    const double after = driver.context().widgets.find("timeline/play")->rect.width;
    CHECK(std::abs(after / before - 1.5) < 0.05);
}

TEST_CASE("Editor: the theme changes nearly every pixel except value colours, and switching back restores all") {
    Driver driver;
    showLayer(driver.context().layers, "size", false); // the same in both themes
    driver.moveTo({640, 400});
    driver.settle();
    const auto dark = driver.picture();
    driver.context().settings.theme = ThemeKind::Light;
    driver.settle();
    const auto light = driver.picture();
    const auto all = static_cast<std::size_t>(dark.size.width) * static_cast<std::size_t>(dark.size.height);
    CHECK(light.differences(dark) > all * 9 / 10);
    driver.context().settings.theme = ThemeKind::Dark;
    driver.settle();
    CHECK(driver.picture().differences(dark) == 0);
}

TEST_CASE("Editor: Tab hides the panels and brings them back") {
    Driver driver;
    const double before = driver.canvas().width;
    REQUIRE(driver.has("panel/shapes"));
    driver.key('R');
    driver.key(key::kTab);
    driver.settle();
    CHECK(driver.canvas().width > before + 200.0);
    CHECK_FALSE(driver.has("panel/shapes"));
    // The tools, their options and the status stay where they were.
    CHECK(driver.has("status/pointer"));
    const PixelRect options = driver.context().widgets.find("options")->rect;
    CHECK(options.y + options.height <= driver.canvas().y);
    for (const shell::ToolSlot &slot : shell::toolSlots(driver.context())) {
        const PixelRect button = rectOfSlot(driver, slot);
        CHECK(button.x + button.width <= driver.canvas().x);
        CHECK(button.y >= options.y + options.height);
    }
    driver.click("menu/panels"); // the visible way to bring them back
    driver.settle();
    CHECK(driver.has("panel/shapes"));
    CHECK(driver.canvas().width == before);
}

TEST_CASE("Editor: the view stays fitted when window and panels are resized, until the user moves it") {
    Driver driver;
    const Box2 box = toDomain(*driver.context().document.current()).bounds();
    const Camera &camera = driver.context().view.camera;
    const auto fits = [&] {
        driver.settle();
        const Vec2 size = camera.zoom * box.size();
        const Pixel middle = camera.toPixel(box.centre());
        const PixelRect &room = driver.context().view.room;
        const double part = std::max(size.x / room.width, size.y / room.height);
        return std::abs(part - 0.9) < 1e-9 && distance(middle, room.centre()) < 1e-6;
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
    driver.drag(edge.centre(), edge.centre() - Pixel(120, 0));
    CHECK(fits());
    driver.scroll(driver.canvas().centre(), 2);
    const Vec2 centre = camera.centre;
    const double zoomed = camera.zoom;
    driver.platform().resize({1280, 800}, 1.0);
    driver.settle();
    CHECK(camera.zoom == zoomed);
    CHECK(camera.centre == centre);
    driver.key('F');
    driver.platform().resize({1500, 900}, 1.0);
    CHECK(fits());
}

TEST_CASE("Editor: legends, hints and tool options do not cover a fitted drawing") {
    const std::pair<PixelSize, double> sizes[] = {
        {{1280, 800}, 1.0}, {{1920, 1080}, 1.0}, {{2560, 1600}, 2.0}, {{1024, 700}, 1.0}};
    Driver driver;
    driver.platform().show(true); // legends belong to what is drawn
    driver.key(key::k2);          // the legend of the shapes needs a mesh
    driver.settle();
    for (const auto &each : sizes) {
        driver.platform().resize(each.first, each.second);
        driver.settle();
        std::map<bool, double> zooms;
        for (const bool quality : {false, true}) {
            for (const bool panels : {true, false}) {
                showLayer(driver.context().layers, quality ? "quality" : "size", true);
                driver.context().view.panels = panels;
                driver.context().animate();
                driver.settle();
                const Camera &camera = driver.context().view.camera;
                CHECK(zooms.try_emplace(panels, camera.zoom).first->second == camera.zoom); // no jump for a layer
                const Box2 box = toDomain(*driver.context().document.current()).bounds();
                const Pixel corner = camera.toPixel({box.min.x, box.max.y});
                const Vec2 extent = camera.zoom * box.size();
                const PixelRect drawing{corner.x, corner.y, extent.x, extent.y};
                CHECK(within(drawing, each.first));
                std::size_t legends = 0;
                for (const auto &[name, widget] : driver.context().widgets.all()) {
                    const bool legend = name.starts_with("canvas/legend/");
                    legends += legend ? 1 : 0;
                    if (legend || name == "hints" || name == "canvas/tools") {
                        const std::string message = name;
                        CHECK_MESSAGE(!widget.rect.overlaps(drawing), message);
                    }
                }
                CHECK(legends == 1);
            }
        }
    }
}

TEST_CASE("Editor: nothing overlaps in a small window") {
    const std::pair<PixelSize, double> sizes[] = {{{800, 500}, 1.0}, {{1280, 800}, 2.0}, {{1100, 700}, 1.5}};
    Driver driver;
    driver.platform().show(true); // legends belong to what is drawn
    driver.workspace(WorkspaceKind::Step);
    showLayer(driver.context().layers, "size", true);
    driver.key(key::k2);
    driver.settle();
    Document changed = *driver.context().document.current();
    changed.spacing.size = 14.0;
    driver.context().document.apply(std::move(changed), "Size"); // "mesh out of date"
    for (const auto &each : sizes) {
        driver.platform().resize(each.first, each.second);
        for (const auto &tool : driver.context().tools.tools) {
            CAPTURE(std::string(tool->id()));
            driver.context().tools.choose(tool->id(), driver.context());
            driver.context().log.announce(std::string(120, 'x') + " and " + std::string(60, 'y'));
            driver.settle();
            const WidgetRegistry::Map &all = driver.context().widgets.all();
            const PixelRect canvas = driver.canvas();
            std::vector<std::pair<std::string, PixelRect>> plates;
            for (const char *name : {"canvas/tools", "canvas/plate", "hints", "canvas/news", "canvas/legend/size"}) {
                if (const auto found = all.find(name); found != all.end()) {
                    plates.emplace_back(name, found->second.rect);
                }
            }
            CHECK(plates.size() >= 3);
            for (std::size_t i = 0; i < plates.size(); ++i) {
                const PixelRect &rect = plates[i].second;
                const std::string name = plates[i].first;
                CHECK_MESSAGE(rect.x >= canvas.x, name);
                CHECK_MESSAGE(rect.x + rect.width <= canvas.x + canvas.width + 0.5, name);
                for (std::size_t j = 0; j < i; ++j) {
                    const std::string other = plates[j].first;
                    const bool transient = name == "canvas/news"; // covers other plates for a few seconds
                    CHECK_MESSAGE((transient || !rect.overlaps(plates[j].second)), name << " over " << other);
                }
            }
            CHECK_FALSE(all.find("options")->second.rect.overlaps(canvas));
            for (const shell::ToolSlot &slot : shell::toolSlots(driver.context())) {
                const PixelRect button = rectOfSlot(driver, slot);
                CHECK(button.x + button.width <= canvas.x);
                CHECK(button.y + button.height <= canvas.y + canvas.height);
            }
        }
        const WidgetRegistry::Map &all = driver.context().widgets.all();
        const auto rectOf = [&](const char *name) { return all.find(name)->second.rect; };
        CHECK_FALSE(rectOf("timeline/scrubber").overlaps(rectOf("timeline/position")));
        CHECK_FALSE(rectOf("timeline/scrubber").overlaps(rectOf("timeline/granularity/Layer")));
        CHECK(rectOf("menu/Help").x + rectOf("menu/Help").width <= rectOf("workspace").x);
        CHECK(rectOf("workspace").x + rectOf("workspace").width <= rectOf("menu/panels").x);
        driver.showPanel("steps");
        for (const char *heading : {"panel/steps", "panel/candidates", "panel/statistics"}) {
            CHECK(within(rectOf(heading), each.first));
        }
    }
}

TEST_CASE("Editor: windows of any size are drawn and settle") {
    Driver driver;
    const PixelSize sizes[] = {{1, 1}, {640, 60}, {800, 102}, {800, 112}, {90, 600}, {3000, 90}, {1280, 800}};
    for (const PixelSize &size : sizes) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        driver.platform().resize(size, 1.0);
        driver.settle();
        // Only if there is room between the bars, and beside the canvas.
        CHECK(driver.has("splitter/column") == (size.height > 102 && size.width >= 800));
    }
}

TEST_CASE("Editor: the splitter of the right column can be dragged, within bounds") {
    Driver driver;
    const PixelRect edge = driver.context().widgets.find("splitter/column")->rect;
    const double before = driver.canvas().width;
    driver.drag(edge.centre(), edge.centre() - Pixel(80, 0));
    CHECK(std::abs(driver.canvas().width - (before - 80.0)) < 3.0);
    const PixelRect moved = driver.context().widgets.find("splitter/column")->rect;
    driver.drag(moved.centre(), {1279, moved.centre().y});
    CHECK(driver.canvas().width <= 1280.0 - 240.0 - 39.0); // beside the column and the tools
}

TEST_CASE("Editor: the shortcut sheet opens with ? and closes with Esc") {
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
    for (const int enter : {key::kEnter, key::kKeypadEnter}) {
        Driver driver;
        driver.key('P', {Modifiers::kControl});
        driver.frames(4);
        REQUIRE(driver.has("palette/query"));
        driver.type("light");
        driver.frames(2);
        CHECK(driver.has("palette/view.theme"));
        CHECK_FALSE(driver.has("palette/run.mesh"));
        driver.key(enter);
        driver.settle();
        CHECK(driver.context().theme.kind == ThemeKind::Light);
        CHECK(driver.context().dialogs.top() == nullptr);
    }
}

TEST_CASE("Editor: the palette says when nothing matches") {
    Driver driver;
    driver.key('P', {Modifiers::kControl});
    driver.frames(4);
    CHECK_FALSE(driver.has("palette/none"));
    driver.type("qqq");
    driver.frames(2);
    CHECK(driver.has("palette/none"));
    driver.key(key::kEnter);
    driver.frames(2);
    CHECK(driver.has("palette/none"));
}

TEST_CASE("Editor: menus open on click, their neighbours on hover; Esc closes them") {
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

TEST_CASE("Editor: shapes of one kind share a place in the strip, with the others in a flyout") {
    Driver driver;
    const ToolBox &box = driver.context().tools;
    std::vector<std::string> placed;
    for (const shell::ToolSlot &slot : shell::toolSlots(driver.context())) {
        for (const std::size_t tool : slot.tools) {
            placed.emplace_back(box.tools[tool]->id());
        }
    }
    std::sort(placed.begin(), placed.end());
    const auto &preset = presetOf(WorkspaceKind::Draw).tools;
    std::vector<std::string> wanted(preset.begin(), preset.end());
    std::sort(wanted.begin(), wanted.end());
    CHECK(placed == wanted); // each once
    CHECK(driver.has("tool/rectangle"));
    CHECK_FALSE(driver.context().widgets.find("tool/slot")->enabled); // behind it
    const PixelRect place = driver.context().widgets.find("tool/rectangle")->rect;
    driver.click("tool/rectangle");
    CHECK(box.current().id() == std::string("rectangle"));
    CHECK_FALSE(driver.has("flyout"));
    driver.click("tool/rectangle"); // it is active, so there is nothing else to choose
    driver.frames(2);
    REQUIRE(driver.has("flyout/slot"));
    driver.click("flyout/slot");
    driver.frames(2);
    CHECK(box.current().id() == std::string("slot"));
    CHECK_FALSE(driver.has("flyout"));
    driver.key('V');
    driver.frames(2);
    REQUIRE(driver.context().widgets.find("tool/slot")->enabled); // the one used last stays in view
    CHECK(driver.context().widgets.find("tool/slot")->rect == place);
    driver.clickAt({place.x + place.width - 3.0, place.y + place.height - 3.0}); // the corner opens it at once
    driver.frames(2);
    REQUIRE(driver.has("flyout/circle"));
    driver.click("flyout/circle");
    CHECK(box.current().id() == std::string("circle"));
}

TEST_CASE("Editor: keys choose tools, each with a button in the strip") {
    Driver driver;
    for (const auto &tool : driver.context().tools.tools) {
        CAPTURE(tool->id());
        if (tool->key() != 0) {
            driver.key(tool->key());
            CHECK(&driver.context().tools.current() == tool.get());
            driver.frames(1);
            CHECK(driver.context().widgets.find(std::string("tool/") + tool->id())->enabled);
        }
    }
}

TEST_CASE("Editor: wheel zooms at the pointer, middle drag and Space with drag pan") {
    Driver driver;
    const Pixel at{400, 300};
    const Vec2 place = driver.context().view.camera.toPlane(at);
    driver.scroll(at, 4);
    const Pixel zoomed = driver.context().view.camera.toPixel(place);
    CHECK(std::abs(zoomed.x - at.x) < 0.01);
    CHECK(std::abs(zoomed.y - at.y) < 0.01);
    InputQueue &input = driver.editor().input();
    input.push({.kind = InputKind::Key, .code = key::kSpace, .pressed = true});
    driver.frames(2);
    driver.drag(at, at + Pixel(60, 25));
    input.push({.kind = InputKind::Key, .code = key::kSpace, .pressed = false});
    driver.frames(2);
    const Pixel panned = driver.context().view.camera.toPixel(place);
    CHECK(std::abs(panned.x - (at.x + 60)) < 0.01);
    CHECK(std::abs(panned.y - (at.y + 25)) < 0.01);
    CHECK(driver.run().state == RunState::Empty); // holding Space to pan is not a tap
}

} // namespace forefront::test
