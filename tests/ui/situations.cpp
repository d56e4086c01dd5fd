#include "core/drawing/shapes/shape_commands.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/shot.hpp"
#include "ui/dialogs/import_dialog.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/platform/assets.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Draws a plate with a hole, and begins a second hole.
void showDrawing(Driver &driver) {
    Shell &context = driver.context();
    Shape plate, hole;
    plate.form = formOf(ShapeKind::Rectangle);
    plate.nodes = {{0, 0}, {12, 8}};
    hole.form = formOf(ShapeKind::Circle);
    hole.nodes = {{8.5, 4}, {10, 4}};
    context.document.apply(*addShapes({}, {plate, hole}), "Draw");
    driver.settle();
    context.actions.run("view.fit", context);
    driver.key('P');
    driver.settle();
    for (const Vec2 corner : {Vec2{2, 2}, Vec2{5, 1.6}, Vec2{5.4, 4.2}}) {
        driver.clickAt(context.view.camera.toPixel(corner));
        driver.frames(30);
    }
    driver.moveTo(context.view.camera.toPixel({2.6, 6}));
}

/// Opens the first sample, meshed.
void showSample(Driver &driver) {
    Shell &context = driver.context();
    driver.key(key::kEscape);
    driver.key('V');
    context.document.markSaved({});
    context.actions.run(std::string("learn.") + sampleDrawings().front().path.stem().string(), context);
    driver.settle();
    context.run.mesh();
    driver.settle();
}

/// Meshes the sample with many small elements, and stops to look when part of them are made.
void showMeshing(Driver &driver) {
    Shell &context = driver.context();
    driver.workspace(WorkspaceKind::Mesh);
    context.settings.live = false;
    Document fine = *context.document.current();
    fine.options.method = Method::Classic;
    fine.spacing.size = 1.0;
    context.document.apply(std::move(fine), "Finer");
    driver.settle();
    context.run.mesh();
    driver.until([&] { return !driver.run().complete; }); // the last run is no longer shown
    driver.until([&] { return driver.run().complete || (driver.has("run/progress") && driver.run().progress > 0.3); });
}

/// Goes through ten situations of a day's work, one after the other; their names and what shows them.
std::vector<Shot> situations() {
    return {{"1-start", [](Driver &) {}},
            {"2-drawing", showDrawing, true},
            {"3-sizes",
             [](Driver &driver) {
                 showSample(driver);
                 driver.workspace(WorkspaceKind::Size);
             }},
            {"4-meshing", showMeshing, false, true},
            {"5-stepping",
             [](Driver &driver) {
                 driver.context().run.cancel();
                 driver.settle();
                 driver.context().settings.live = true;
                 showSample(driver);
                 driver.workspace(WorkspaceKind::Step);
                 driver.context().run.seek(driver.run().known / 2);
                 driver.settle();
                 driver.key('T');
             }},
            {"6-lesson",
             [](Driver &driver) {
                 driver.context().actions.run("learn.lessons", driver.context());
                 driver.settle();
                 driver.click("lessons/2-ten-steps");
                 driver.settle();
                 driver.key(key::kPageDown);
             }},
            {"7-judging",
             [](Driver &driver) {
                 driver.context().actions.run("lesson.close", driver.context());
                 driver.context().lessons.visible = false;
                 driver.settle();
                 showSample(driver);
                 driver.workspace(WorkspaceKind::Judge);
                 Document limited = *driver.context().document.current();
                 limited.limits[MeshLimit::MinAngle] = 36.0;
                 driver.context().document.apply(std::move(limited), "Limit");
                 driver.settle();
                 driver.click("worst/1");
             }},
            {"8-import",
             [](Driver &driver) {
                 driver.workspace(WorkspaceKind::Draw);
                 driver.context().actions.run("view.fit", driver.context());
                 importBracket(driver);
             }},
            {"9-export",
             [](Driver &driver) {
                 driver.context().settings.folders["export"] = std::filesystem::temp_directory_path().string();
                 driver.context().actions.run("file.export", driver.context());
             }},
            {"10-error", [](Driver &driver) {
                 driver.context().document.markSaved({});
                 offerCombination(driver);
                 driver.settle();
                 driver.context().dialogs.dismissPreviews(driver.context());
                 driver.workspace(WorkspaceKind::Size);
                 driver.click("spacing/size");
                 driver.type("abc+");
                 driver.key(key::kEnter);
             }}};
}

} // namespace

namespace {

/// Goes through the situations in a window and gives `take` the picture of each.
void takeSituations(PixelSize size, double scale, ThemeKind theme,
                    const std::function<void(const Shot &, const Driver::Picture &)> &take) {
    EditorSetup setup;
    setup.sample = false;
    setup.startPage = true;
    Driver driver(setup, size, scale);
    driver.context().settings.theme = theme;
    driver.context().settings.live = true;
    driver.settle();
    for (const Shot &scene : situations()) {
        scene.show(driver);
        if (!scene.moves) {
            driver.settle();
        }
        if (!scene.hovers && !scene.moves) {
            driver.moveTo({4.0, size.height - 10.0});
            driver.settle();
        }
        take(scene, driver.picture());
        driver.context().dialogs.dismissPreviews(driver.context());
        driver.context().dialogs.closeAll();
        driver.frames(1);
    }
}

/// Returns the folder for pictures.
std::filesystem::path pictureFolder() {
    const char *const folder = std::getenv("FOREFRONT_SCREENSHOTS");
    REQUIRE_MESSAGE(folder != nullptr, "set FOREFRONT_SCREENSHOTS to a folder");
    return folder;
}

const char *wordOf(ThemeKind theme) {
    return theme == ThemeKind::Dark ? "dark" : "light";
}

/// Returns the channel of a picture reduced to half, at a pixel: the mean of four.
std::uint8_t halved(const Driver::Picture &picture, int column, int row, int channel) {
    int sum = 2;
    for (const int down : {0, 1}) {
        for (const int right : {0, 1}) {
            const auto at = static_cast<std::size_t>((2 * row + down) * picture.size.width + 2 * column + right);
            sum += picture.rgba[4 * at + static_cast<std::size_t>(channel)];
        }
    }
    return static_cast<std::uint8_t>(sum / 4);
}

/// Draws a picture, reduced to half, into another one.
void drawHalved(const Driver::Picture &picture, PixelSize corner, Driver::Picture &page) {
    for (int row = 0; row < picture.size.height / 2; ++row) {
        for (int column = 0; column < picture.size.width / 2; ++column) {
            const auto to = static_cast<std::size_t>((corner.height + row) * page.size.width + corner.width + column);
            for (int channel = 0; channel < 3; ++channel) {
                page.rgba[4 * to + static_cast<std::size_t>(channel)] = halved(picture, column, row, channel);
            }
        }
    }
}

} // namespace

// Not a test; writes pictures of ten situations in windows of three sizes, at three scales, in both themes.
TEST_CASE("Screenshots: situations" * doctest::skip()) {
    const std::filesystem::path folder = pictureFolder();
    for (const PixelSize size : {PixelSize{1280, 800}, PixelSize{1440, 900}, PixelSize{2560, 1600}}) {
        for (const double scale : {1.0, 1.5, 2.0}) {
            for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
                const std::string prefix =
                    std::to_string(size.width) + "x" + ui::number(scale, 2) + "-" + wordOf(theme) + "-";
                takeSituations(size, scale, theme, [&](const Shot &scene, const Driver::Picture &picture) {
                    writePicture(picture, folder / (prefix + scene.name + ".ppm"));
                });
            }
        }
    }
}

// Not a test; writes the pages of the situations in ui/style, one for each theme: two in a row, reduced to half.
TEST_CASE("Screenshots: page of the situations" * doctest::skip()) {
    constexpr int kGap = 8;
    const std::filesystem::path folder = pictureFolder();
    const PixelSize window{1280, 800}, half{window.width / 2, window.height / 2};
    const auto rows = static_cast<int>((situations().size() + 1) / 2);
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        Driver::Picture page{{2 * half.width + kGap, rows * (half.height + kGap) - kGap}, {}};
        page.rgba.assign(4 * static_cast<std::size_t>(page.size.width) * static_cast<std::size_t>(page.size.height),
                         128);
        int count = 0;
        takeSituations(window, 1.0, theme, [&](const Shot &, const Driver::Picture &picture) {
            drawHalved(picture, {count % 2 * (half.width + kGap), count / 2 * (half.height + kGap)}, page);
            ++count;
        });
        writePicture(page, folder / (std::string("situations-") + wordOf(theme) + ".ppm"));
    }
}

// Not a test; writes the picture of the editor on the first page of the repository, assets/screenshot.png.
TEST_CASE("Screenshots: the picture of the readme" * doctest::skip()) {
    const std::filesystem::path folder = pictureFolder();
    Driver driver({}, {1440, 900});
    driver.context().settings.live = true;
    showSample(driver);
    driver.workspace(WorkspaceKind::Step);
    setFolded(driver.context(), "statistics", false);
    driver.context().run.seek(driver.run().known * 5 / 8);
    driver.settle();
    driver.context().view.following = false;
    driver.context().actions.run("view.fit", driver.context());
    driver.moveTo({4.0, 890.0});
    driver.settle();
    writePicture(driver.picture(), folder / "screenshot.ppm");
}

TEST_CASE("Ten situations at twice the scale, and in a window that becomes too small for them") {
    EditorSetup setup;
    setup.sample = false;
    setup.startPage = true;
    const PixelSize whole{1280, 800};
    Driver driver(setup, whole, 2.0);
    driver.settle();
    for (const Shot &scene : situations()) {
        CAPTURE(std::string(scene.name));
        scene.show(driver);
        driver.settle();
        for (const PixelSize size : {PixelSize{500, 300}, PixelSize{90, 60}, whole}) {
            driver.platform().resize(size, 2.0);
            driver.settle();
            CHECK(driver.has("status/pointer"));
        }
        CHECK(shell::layOut(driver.context()).open.width >= 0.3 * whole.width); // a canvas is left
        driver.context().dialogs.dismissPreviews(driver.context());
        driver.context().dialogs.closeAll();
        driver.settle();
    }
}

} // namespace forefront::test
