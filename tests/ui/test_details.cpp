#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_list.hpp"
#include "ui/parts/settings.hpp"
#include "ui/platform/assets.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

void nameAndConfirm(Driver &driver, const std::string &dialog, const std::filesystem::path &file) {
    driver.click("dialog/" + dialog + "/name");
    driver.key('A', {Modifiers::kControl});
    driver.type(file.string());
    driver.click("dialog/" + dialog + "/ok");
    driver.settle();
}

/// Sets the working folder, and restores the previous one when destroyed.
class WorkingFolder {
  public:
    explicit WorkingFolder(const std::filesystem::path &folder) : before_(std::filesystem::current_path()) {
        std::filesystem::current_path(folder);
    }
    ~WorkingFolder() { std::filesystem::current_path(before_); }
    WorkingFolder(const WorkingFolder &) = delete;
    WorkingFolder &operator=(const WorkingFolder &) = delete;

  private:
    std::filesystem::path before_;
};

} // namespace

TEST_CASE("Export: an unknown extension is refused with a list of known ones, and nothing is written") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    nameAndConfirm(driver, "export", place.path / "pic.png");
    CHECK(driver.has("dialog/export/ok")); // the dialog stays
    CHECK(driver.logHas("unknown-extension"));
    const std::string message = driver.context().log.entries().back().diagnostic.message;
    CHECK(message.find("'.png'") != std::string::npos);
    CHECK(message.find(".msh") != std::string::npos);
    CHECK(message.find(".vtu") != std::string::npos);
    CHECK(place.fileCount() == 0);
    nameAndConfirm(driver, "export", place.path / "pic.vtu");
    CHECK_FALSE(driver.has("dialog/export/ok"));
    CHECK(std::filesystem::exists(place.path / "pic.vtu"));
}

TEST_CASE("Export: the suggested name is the name of the document, saved or not") {
    const TemporaryFolder place;
    const WorkingFolder here(place.path);
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    const Document drawn = driver.document();
    driver.context().document.load(drawn, {}, false, "Old harbour");
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    driver.click("dialog/export/ok");
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "Old harbour.msh"));
    driver.context().document.load(drawn, place.path / "bay.forefront");
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    driver.click("dialog/export/ok");
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "bay.msh"));
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    driver.click("dialog/export/preset/su2");
    driver.click("dialog/export/ok");
    driver.settle();
    REQUIRE(std::filesystem::remove(place.path / "bay.su2"));
    driver.key('E', {Modifiers::kControl}); // offers the format of the last export
    driver.settle();
    driver.click("dialog/export/ok");
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "bay.su2"));
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.has("dialog/export/names"));
    driver.fill("dialog/export/name", "fine.su2"); // Enter exports
    driver.settle();
    REQUIRE(std::filesystem::remove(place.path / "fine.su2"));
    driver.key('E', {Modifiers::kControl}); // and its name
    driver.settle();
    driver.click("dialog/export/ok");
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "fine.su2"));
}

TEST_CASE("Faults: a fault is marked on the canvas as soon as it is drawn, without meshing") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 8}, {9, 1}, {1, 8}}); // crosses itself in the middle
    driver.key('V');
    driver.key(key::kEscape);
    driver.moveTo({5, 5});
    driver.settle();
    REQUIRE(driver.run().state == RunState::Empty);
    const auto around = [&](Vec2 place) {
        const Pixel p = driver.pixel(place);
        return PixelRect{p.x - 14, p.y - 14, 28, 28};
    };
    const Vec2 crossing{5, 4.5};
    const auto marked = driver.picture();
    showLayer(driver.context().layers, "faults", false);
    driver.context().animate();
    driver.settle();
    const auto plain = driver.picture();
    CHECK(marked.differences(plain, around(crossing)) > 100);
    CHECK(marked.differences(plain, around({3, 6})) == 0);
    showLayer(driver.context().layers, "faults", true);
    driver.moveToPlace(crossing);
    driver.settle();
    const Pixel p = driver.pixel(crossing); // its explanation is to its right
    CHECK(driver.picture().differences(plain, {p.x + 16, p.y - 30, 120, 26}) > 500);
}

TEST_CASE("Checks: repair is offered only if there is something to repair") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 8}, {9, 1}, {1, 8}});
    driver.key(key::kEscape);
    driver.showPanel("checks");
    driver.settle();
    CHECK(driver.has("checks/repair"));
    CHECK(driver.context().actions.find("edit.repair")->enabled(driver.context()));
    driver.click("checks/repair");
    driver.settle();
    CHECK_FALSE(hasErrors(driver.context().preview->faults));
    CHECK_FALSE(driver.has("checks/repair"));
    Document faulty = driver.document();
    faulty.spacing.expression = "0.1*nonsense(x)"; // an error, but not a geometric one
    driver.context().document.apply(std::move(faulty), "Expression");
    driver.settle();
    REQUIRE(hasErrors(driver.context().preview->faults));
    CHECK_FALSE(driver.has("checks/repair"));
    CHECK_FALSE(driver.context().actions.find("edit.repair")->enabled(driver.context()));
}

TEST_CASE("Import: the imported drawing is in view") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document far = driver.document();
    REQUIRE(far.shapes.size() == 1);
    auto moved = std::make_shared<Shape>(*far.shapes.front());
    moved->nodes = {{500, 500}, {580, 570}};
    far.shapes = {moved};
    REQUIRE(writeProject(place.path / "far.forefront", far).empty());
    driver.key('I', {Modifiers::kControl});
    driver.settle();
    nameAndConfirm(driver, "import", place.path / "far.forefront");
    REQUIRE(driver.has("dialog/importoptions/ok"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    const Box2 all = boundsOf(driver.document()), seen = driver.context().view.camera.visible();
    CHECK(all.contains({550, 550}));
    CHECK(seen.contains(all.min));
    CHECK(seen.contains(all.max));
}

TEST_CASE("Recent files: a file given on the command line becomes one of them") {
    const TemporaryFolder place;
    const std::filesystem::path file = place.path / "bay.forefront";
    {
        Draughtsman driver;
        driver.rectangle({1, 1}, {9, 8});
        REQUIRE(writeProject(file, driver.document()).empty());
    }
    Driver driver({.file = file});
    REQUIRE_FALSE(driver.context().settings.recentFiles.empty());
    CHECK(driver.context().settings.recentFiles.front() == file.string());
    Driver missing({.file = place.path / "no-such.forefront"});
    CHECK(missing.context().settings.recentFiles.empty());
}

TEST_CASE("Files: samples are not among the recent files, so dialogs do not begin in their folder") {
    Draughtsman driver;
    const std::vector<Sample> gallery = sampleDrawings();
    REQUIRE_FALSE(gallery.empty());
    openDocument(driver.context(), gallery.front().path);
    driver.settle();
    CHECK(driver.context().settings.recentFiles.empty());
    CHECK(startFolder(driver.context()).empty());
    driver.context().settings.recentFiles.emplace_back("/bay/lake.forefront");
    CHECK(startFolder(driver.context()) == "/bay");
}

TEST_CASE("Settings: the window position is saved, and invalid positions are ignored") {
    const TemporaryFolder place;
    const std::filesystem::path file = place.path / "settings.json";
    Settings settings;
    settings.window = WindowPlace{.x = -30, .y = 40, .width = 1100, .height = 700, .maximised = true};
    saveSettings(file, settings);
    CHECK(loadSettings(file) == settings);
    for (const char *text : {R"({"window": {"x": 1, "y": 2}})", R"({"window": {"width": -5, "height": 1e300}})",
                             R"({"window": [1, 2, 3, 4]})", R"({"window": {"width": "wide", "height": 20}})"}) {
        CAPTURE(text);
        REQUIRE(writeFileAtomically(file, text).empty());
        CHECK_FALSE(loadSettings(file).window.has_value());
    }
}

TEST_CASE("Numbers: plain notation, and about three digits for means of counts") {
    CHECK(ui::number(140.0, 2) == "140");
    CHECK(ui::number(1234567.0, 4) == "1234567");
    CHECK(ui::number(0.05, 4) == "0.05");
    CHECK(ui::number(12.3456, 4) == "12.35");
    CHECK(ui::number(-0.00123456, 3) == "-0.00123");
    CHECK(ui::number(0.0, 4) == "0");
    CHECK(ui::number(1e-9, 3) == "1e-09");
    CHECK(ui::number(2e12, 3) == "2e+12");
    CHECK(ui::mean(0.0) == "0.00");
    CHECK(ui::mean(3.2741) == "3.27");
    CHECK(ui::mean(41.52) == "41.5");
    CHECK(ui::mean(1402.7) == "1403");
}

TEST_CASE("Statistics: hovering the label or the value of a row shows its tooltip") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key(key::kF5);
    driver.showPanel("statistics");
    driver.settle();
    REQUIRE(driver.has("statistics/Nb"));
    const PixelRect row = driver.context().widgets.find("statistics/Nb")->rect;
    for (const double part : {0.05, 0.4, 0.95}) {
        CAPTURE(part);
        driver.moveTo({row.x + part * row.width, row.y + 0.5 * row.height});
        driver.frames(40);
        CHECK(driver.has("tooltip"));
    }
}

TEST_CASE("Forms: hovering the label of a field shows its tooltip") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {8, 8});
    driver.key(key::kEscape);
    driver.showPanel("spacing");
    for (const char *field :
         {"spacing/size", "spacing/expression", "spacing/gradation", "meshing/elements/Triangles"}) {
        CAPTURE(field);
        if (std::string_view(field).starts_with("meshing")) {
            driver.showPanel("meshing");
        }
        const PixelRect rect = driver.context().widgets.find(field)->rect;
        driver.moveTo({rect.x - 60.0, rect.centre().y});
        driver.frames(40);
        CHECK(driver.has("tooltip"));
    }
}

TEST_CASE("Inspector: fields stay in place for any pointer position and text length") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {8, 8});
    Document wordy = driver.document();
    wordy.spacing.expression = "max(0.1, 0.2*dist(3, 2)) + 0.001*sin(x)*cos(y) + 0.002*sin(2*x)*cos(3*y) + "
                               "0.003*sin(5*x)*cos(7*y) + 0.004*sin(11*x)*cos(13*y)";
    driver.context().document.apply(std::move(wordy), "Expression");
    driver.key('V');
    driver.settle();
    driver.clickPlace({0, 4}); // selects the rectangle
    driver.settle();
    REQUIRE(driver.has("inspector/name"));
    const PixelRect name = driver.context().widgets.find("inspector/name")->rect;
    const PixelRect size = driver.context().widgets.find("panel/parameters")->rect;
    for (const Vec2 place : {Vec2{1, 1}, {3, 2}, {7, 7}, {9, 9}}) {
        driver.moveToPlace(place);
        driver.settle();
        CHECK(driver.context().widgets.find("inspector/name")->rect == name);
        CHECK(driver.context().widgets.find("panel/parameters")->rect == size);
    }
    driver.hover("inspector/name");
    driver.settle();
    CHECK(driver.context().widgets.find("inspector/name")->rect == name);
}

TEST_CASE("Text: at most two lines, and truncated text ends with an ellipsis") {
    Driver driver;
    const std::string text =
        "max(0.1, 0.2*dist(3, 2)) limited by the gradation 0.3 of the boundary between here and there";
    for (const float width : {90.0F, 160.0F, 240.0F}) {
        const std::string lines = ui::twoLines(text, width);
        CHECK(std::count(lines.begin(), lines.end(), '\n') == 1);
        CHECK(lines.ends_with("\xe2\x80\xa6"));
        CHECK(ImGui::CalcTextSize(lines.c_str()).x <= width);
    }
    CHECK(ui::twoLines("short", 200.0F) == "short");
    CHECK(ui::twoLines("short\n", 200.0F) == "short\n");
    CHECK(ui::twoLines("one\ntwo\n", 200.0F) == "one\ntwo");
    CHECK(ui::twoLines("one\ntwo\n\n", 200.0F) == "one\ntwo");
    CHECK(ui::twoLines("one\ntwo\n\nthree", 200.0F) == "one\ntwo\xe2\x80\xa6");
}

TEST_CASE("Fonts: all digits have the same width") {
    for (const double scale : {1.0, 1.5, 2.0}) {
        Driver driver({}, {1280, 800}, scale);
        const Fonts &fonts = driver.context().fonts;
        for (ImFont *font :
             {fonts.body, fonts.strong, fonts.small, fonts.heading, fonts.title, fonts.page, fonts.mono}) {
            const auto width = [&](const char *text) {
                return font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, text).x;
            };
            CHECK(width("0000") == width("1111"));
            CHECK(width("0123456789") == width("4444444444"));
        }
    }
}

TEST_CASE("Text: labels and captions contrast with their background in both themes") {
    const auto luminance = [](Colour colour) {
        const auto linear = [&](std::uint8_t channel) {
            const double c = channel / 255.0;
            return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
    };
    const auto contrast = [&](Colour a, Colour b) { // as WCAG defines it
        const double u = luminance(a), v = luminance(b);
        return (std::max(u, v) + 0.05) / (std::min(u, v) + 0.05);
    };
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const Theme theme = makeTheme(kind);
        for (const Colour surface : {theme.panel, theme.popup}) {
            CHECK(contrast(theme.text, surface) >= 10.0);
            CHECK(contrast(theme.muted, surface) >= 7.0);
            CHECK(contrast(theme.faint, surface) >= 3.5);
            CHECK(contrast(theme.bad, surface) >= 4.5);
            CHECK(contrast(theme.warn, surface) >= 4.5);
        }
    }
    Driver driver;
    CHECK(driver.context().fonts.small->FontSize >= 13.0F);
    CHECK(driver.context().fonts.heading->FontSize >= 12.0F);
}

TEST_CASE("Labels: a label is placed clear of the others, or left out") {
    Driver driver;
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    const Camera camera{.centre = {0, 0}, .zoom = 10.0, .viewport = {0, 0, 800, 600}};
    CanvasPainter painter(list, camera, 1.0);
    ImFont *font = driver.context().fonts.small;
    const PixelRect first = painter.label({0, 0}, {6, 3}, "first", rgb(0xffffff), rgb(0), font);
    CHECK(painter.freeLabel({0, 0}, {6, 3}, "second", rgb(0xffffff), rgb(0), font));
    CHECK(painter.freeLabel({20, 20}, {6, 3}, "far away", rgb(0xffffff), rgb(0), font));
    painter.reserve({first.x - 300, first.y - 300, 600, 600});
    CHECK_FALSE(painter.freeLabel({0, 0}, {6, 3}, "no room", rgb(0xffffff), rgb(0), font));
}

TEST_CASE("Labels: stay clear of the handles of the selected shape") {
    Draughtsman driver;
    driver.rectangle({2, 2}, {8, 7});
    driver.key('V');
    driver.settle();
    Shell &context = driver.context();
    REQUIRE(context.selection.shapes.size() == 1);
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    CanvasPainter painter(list, context.view.camera, 1.0);
    context.tools.current().reserveOverlay(painter, context);
    const double gap = context.view.camera.length(12.0); // of the handles that scale
    for (const Vec2 handle : {Vec2{2, 2}, Vec2{8, 7}, Vec2{5, 7 + gap}}) {
        const int before = list.VtxBuffer.Size;
        REQUIRE(painter.freeLabel(handle, {-6, -6}, "shore", rgb(0xffffff), rgb(0), context.fonts.small));
        Box2 drawn;
        for (int k = before; k < list.VtxBuffer.Size; ++k) {
            drawn.add(Vec2{static_cast<double>(list.VtxBuffer[k].pos.x), static_cast<double>(list.VtxBuffer[k].pos.y)});
        }
        const Pixel at = driver.pixel(handle);
        CHECK_FALSE(drawn.overlaps(boxAround({at.x, at.y}, 3.5)));
    }
}

TEST_CASE("Sliders: the number stands beside the slider, not under its knob") {
    Driver driver;
    driver.context().actions.run("edit.preferences", driver.context());
    driver.settle();
    const std::string name = "dialog/preferences/scale";
    REQUIRE(driver.has(name + "/number"));
    const PixelRect slider = driver.context().widgets.find(name)->rect;
    const PixelRect number = driver.context().widgets.find(name + "/number")->rect;
    CHECK(number.x >= slider.x + slider.width);
    CHECK(number.width > 20.0);
}

} // namespace forefront::test
