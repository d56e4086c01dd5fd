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

#include <cstdlib>
#include <filesystem>
#include <fstream>
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
    context.actions.run(std::string("learn.") + samples().front().path.stem().string(), context);
    driver.settle();
    context.run.mesh();
    driver.settle();
}

/// Goes through ten situations of a day's work, one after the other; their names and what shows them.
std::vector<Shot> situations() {
    const auto workspace = [](WorkspaceKind kind) { return [kind](Driver &driver) { driver.workspace(kind); }; };
    const auto action = [](const char *id) {
        return [id](Driver &driver) { driver.context().actions.run(id, driver.context()); };
    };
    return {{"1-start", [](Driver &) {}},
            {"2-drawing", showDrawing, true},
            {"3-sizes",
             [](Driver &driver) {
                 showSample(driver);
                 driver.workspace(WorkspaceKind::Size);
             }},
            {"4-meshing", workspace(WorkspaceKind::Mesh)},
            {"5-stepping",
             [](Driver &driver) {
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
            {"9-export", action("file.export")},
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

// Not a test; writes pictures of ten situations in windows of three sizes, at three scales, in both themes.
TEST_CASE("Screenshots: situations" * doctest::skip()) {
    const char *const folder = std::getenv("FOREFRONT_SCREENSHOTS");
    REQUIRE_MESSAGE(folder != nullptr, "set FOREFRONT_SCREENSHOTS to a folder");
    for (const PixelSize size : {PixelSize{1280, 800}, PixelSize{1440, 900}, PixelSize{2560, 1600}}) {
        for (const double scale : {1.0, 1.5, 2.0}) {
            for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
                EditorSetup setup;
                setup.sample = false;
                setup.startPage = true;
                Driver driver(setup, size, scale);
                driver.context().settings.theme = theme;
                driver.context().settings.live = true;
                driver.settle();
                for (const Shot &scene : situations()) {
                    scene.show(driver);
                    driver.settle();
                    if (!scene.hovers) {
                        driver.moveTo({4.0, size.height - 10.0});
                        driver.settle();
                    }
                    writePicture(driver.picture(),
                                 std::filesystem::path(folder) /
                                     (std::to_string(size.width) + "x" + ui::number(scale, 2) + "-" +
                                      (theme == ThemeKind::Dark ? "dark" : "light") + "-" + scene.name + ".ppm"));
                    driver.context().dialogs.dismissPreviews(driver.context());
                    driver.context().dialogs.closeAll();
                    driver.settle();
                }
            }
        }
    }
}

// Not a test; writes the picture of the editor on the first page of the repository, assets/screenshot.png.
TEST_CASE("Screenshots: the picture of the readme" * doctest::skip()) {
    const char *const folder = std::getenv("FOREFRONT_SCREENSHOTS");
    REQUIRE_MESSAGE(folder != nullptr, "set FOREFRONT_SCREENSHOTS to a folder");
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
    writePicture(driver.picture(), std::filesystem::path(folder) / "screenshot.ppm");
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
