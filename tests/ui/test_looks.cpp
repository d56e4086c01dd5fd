#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/colour_vision.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/shot.hpp"
#include "tests/ui/widget_rects.hpp"
#include "ui/platform/assets.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/style/theme.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace forefront::test {

namespace {

/// The relative luminance of a colour of a picture, from 0 to 1.
double luminanceAt(const Driver::Picture &picture, int x, int y) {
    const auto at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) + static_cast<std::size_t>(x));
    constexpr double kShares[] = {0.2126, 0.7152, 0.0722};
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double value = picture.rgba[at + k] / 255.0;
        sum += kShares[k] * (value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
    }
    return sum;
}

/// The mean luminance of a square of the drawing.
double meanLuminance(Driver &driver, const Driver::Picture &picture, Vec2 middle, double half) {
    const Camera &camera = driver.context().view.camera;
    const Pixel from = camera.toPixel(middle + Vec2{-half, half}), to = camera.toPixel(middle + Vec2{half, -half});
    double sum = 0.0;
    int count = 0;
    for (int y = static_cast<int>(from.y); y < static_cast<int>(to.y); ++y) {
        for (int x = static_cast<int>(from.x); x < static_cast<int>(to.x); ++x, ++count) {
            sum += luminanceAt(picture, x, y);
        }
    }
    REQUIRE(count > 500);
    return sum / count;
}

/// An editor at twice the scale in a window of 1280 x 800 pixels, with a meshed plate in Judge.
class LargeText : public Draughtsman {
  public:
    LargeText() : Draughtsman({}, {1280, 800}) {
        platform().resize({1280, 800}, 2.0);
        settle();
        Shape plate, hole;
        plate.form = formOf(ShapeKind::Rectangle);
        plate.nodes = {{0, 0}, {12, 8}};
        hole.form = formOf(ShapeKind::Circle);
        hole.nodes = {{8.5, 4}, {10, 4}};
        context().document.apply(*addShapes({}, {plate, hole}), "Draw");
        settle();
        context().run.mesh();
        settle();
        context().actions.run("view.fit", context());
    }
};

const PixelRect kWindow{0, 0, 1280, 800};

} // namespace

TEST_CASE("Looks: at twice the scale, Judge shows whole rows of the worst places, beside an open column, too") {
    LargeText driver;
    driver.workspace(WorkspaceKind::Judge);
    for (const bool column : {false, true}) {
        CAPTURE(column);
        driver.context().plates.column = column;
        driver.context().animate();
        driver.settle();
        const PixelRect below = rectOf(driver, "below");
        for (const char *row : {"worst/0", "worst/1"}) {
            const PixelRect rect = rectOf(driver, row);
            CHECK(within(rect, below));
            CHECK(rect.width > 0.9 * below.width - 40.0);
        }
        driver.click("worst/1");
        driver.settle();
        const shell::Layout layout = shell::layOut(driver.context());
        CHECK_FALSE(layout.column.overlaps(layout.below));
        REQUIRE(driver.context().view.flag);
        const Pixel worst = driver.context().view.camera.toPixel(*driver.context().view.flag);
        CHECK(layout.open.contains(worst));
        CHECK(within(rectOf(driver, "probe/plate/value"), layout.open));
        CHECK((std::fmod(layout.below.height - 2.0 * (32.0 + 4.0), 48.0)) == doctest::Approx(0.0)); // whole rows
    }
    REQUIRE(driver.has("panel/checks"));
    CHECK(driver.has("checks/min-angle"));
}

TEST_CASE("Looks: at twice the scale, an import shows all it asks, and its buttons stay in sight in a lower window") {
    LargeText driver;
    importBracket(driver);
    driver.settle();
    for (const PixelSize size : {PixelSize{1280, 800}, PixelSize{1280, 560}}) {
        driver.platform().resize(size, 2.0);
        driver.settle();
        const PixelRect window{0, 0, static_cast<double>(size.width), static_cast<double>(size.height)};
        CHECK(within(rectOf(driver, "dialog/importoptions"), window));
        for (const char *button : {"dialog/importoptions/cancel", "dialog/importoptions/ok"}) {
            CHECK(within(rectOf(driver, button), rectOf(driver, "dialog/importoptions")));
        }
        const bool whole = size.height == 800;
        CHECK(driver.context().widgets.find("dialog/importoptions/weld")->visible == whole);
    }
}

TEST_CASE("Looks: a drawing that is imported is fitted beside the dialog") {
    Draughtsman driver({}, {1440, 900});
    importBracket(driver);
    driver.settle();
    const PixelRect dialog = rectOf(driver, "dialog/importoptions");
    const Camera &camera = driver.context().view.camera;
    for (const auto &shape : driver.document().shapes) {
        const Box2 box = boundsOf(*shape);
        CHECK(camera.toPixel(box.max).x <= dialog.x);
        CHECK(driver.canvas().contains(camera.toPixel(box.min)));
    }
}

TEST_CASE("Looks: the chosen format of an export is filled, and the others have only an edge") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.context().actions.run("file.export", driver.context());
    driver.until([&] { return driver.has("dialog/export/ok") && driver.run().complete; });
    driver.settle();
    const Theme &theme = driver.context().theme;
    const auto filled = [&](const std::string &preset) {
        driver.moveTo({4, 4});
        driver.settle();
        const PixelRect rect = rectOf(driver, "dialog/export/preset/" + preset);
        const Driver::Picture picture = driver.picture();
        const double inside =
            luminanceAt(picture, static_cast<int>(rect.x + 5), static_cast<int>(rect.y + 0.5 * rect.height));
        return std::abs(inside - luminance(theme.accent)) < std::abs(inside - luminance(theme.popup));
    };
    CHECK(filled("gmsh")); // MSH 2.2, of the same program as MSH 4.1
    CHECK_FALSE(filled("su2"));
    driver.click("dialog/export/preset/calculix"); // has the format of Abaqus
    CHECK(filled("calculix"));
    CHECK_FALSE(filled("abaqus"));
    CHECK_FALSE(filled("gmsh"));
}

TEST_CASE("Looks: what is wrong with a field is said below it, within its panel") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.showPanel("spacing");
    for (const double scale : {1.0, 1.5}) {
        driver.platform().resize({1280, 800}, scale);
        driver.settle();
        driver.fill("spacing/size", "abc+");
        const PixelRect note = rectOf(driver, "fieldnote"), field = rectOf(driver, "spacing/size");
        CHECK(note.y >= field.y + field.height);
        CHECK(note.y <= field.y + field.height + 8.0 * scale);
        CHECK(within(note, shell::layOut(driver.context()).column));
        driver.key(key::kEscape);
        driver.key(key::kEscape);
        driver.settle();
    }
}

TEST_CASE("Looks: the finest part of the harbour is not the emptiest one") {
    Driver driver({}, {1440, 900});
    driver.context().run.mesh();
    driver.settle();
    driver.workspace(WorkspaceKind::Mesh);
    driver.context().actions.run("view.fit", driver.context());
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        driver.context().settings.theme = theme;
        driver.context().animate();
        driver.settle();
        const Driver::Picture picture = driver.picture();
        const double fine = meanLuminance(driver, picture, {100, 130}, 10),
                     coarse = meanLuminance(driver, picture, {340, 60}, 10);
        INFO("mean luminance of the fine patch " << fine << ", of the coarse one " << coarse);
        CHECK((theme == ThemeKind::Dark ? fine >= coarse : fine <= coarse));
    }
}

} // namespace forefront::test
