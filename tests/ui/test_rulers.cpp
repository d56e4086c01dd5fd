#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/ruler_scale.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace forefront::test {

TEST_CASE("rulerScale: labels and marks at steps of 1, 2 or 5, far enough apart; texts have the digits needed") {
    for (double unit = 1e-9; unit < 1e9; unit *= 1.37) {
        CAPTURE(unit);
        const RulerScale scale = rulerScale(unit, 50.0, 5.0);
        CHECK(scale.major >= 50.0 * unit);
        CHECK(scale.major <= 126.0 * unit);
        CHECK(scale.minor() >= 5.0 * unit);
        for (const double step : {scale.major, scale.minor()}) {
            const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
            CHECK((std::abs(digit - 1.0) < 1e-9 || std::abs(digit - 2.0) < 1e-9 || std::abs(digit - 5.0) < 1e-9));
        }
    }
    CHECK(rulerText(0.0, 0.5) == "0");
    CHECK(rulerText(-1.5, 0.5) == "-1.5");
    CHECK(rulerText(2.0, 0.05) == "2.00");
    CHECK(rulerText(1200.0, 200.0) == "1200");
    CHECK(rulerText(3e-12, 1e-12) == "3e-12");
    CHECK(rulerText(2.5e9, 5e8) == "2.5e+09");
}

TEST_CASE("multiplesWithin: finds the multiples of a step, and ends where the step is lost in rounding") {
    const Multiples few = multiplesWithin(-1.0, 1.3, 0.5);
    CHECK(few.first == -2.0);
    CHECK(few.count == 5);
    CHECK(multiplesWithin(0.1, 0.4, 0.5).count == 0);
    CHECK(multiplesWithin(4e16, 4e16 + 64.0, 1e-3).count == 10'000);
}

TEST_CASE("Canvas: the grid is drawn where its step is lost in rounding") {
    Draughtsman driver;
    Shell &context = driver.context();
    context.view.camera.centre = {4e16, -4e16};
    context.view.camera.zoom = 1e4;
    context.animate();
    driver.frames(2); // would not end
    CHECK(context.view.camera.visible().min.x > 3.9e16);
}

TEST_CASE("Rulers: Ctrl+R shows them along two edges, with a mark at the pointer; the setting is kept") {
    const TemporaryFolder folder;
    const EditorSetup setup{.settingsFolder = folder.path};
    {
        Draughtsman driver(setup);
        const PixelRect before = driver.canvas();
        CHECK_FALSE(driver.has("canvas/ruler/x"));
        driver.key('R', kControl);
        driver.settle();
        CHECK(driver.context().tools.current().id() == std::string("select")); // not the tool with this letter
        const PixelRect canvas = driver.canvas();
        CHECK(canvas == PixelRect{before.x + 20, before.y + 20, before.width - 20, before.height - 20});
        const PixelRect x = driver.context().widgets.find("canvas/ruler/x")->rect,
                        y = driver.context().widgets.find("canvas/ruler/y")->rect;
        CHECK(x == PixelRect{canvas.x, before.y, canvas.width, 20});
        CHECK(y == PixelRect{before.x, canvas.y, 20, canvas.height});
        driver.moveToPlace({2, 2});
        const Driver::Picture left = driver.picture();
        driver.moveToPlace({8, 7});
        const Driver::Picture right = driver.picture();
        const auto near = [&](Vec2 place, bool upright) {
            const Pixel at = driver.pixel(place);
            return upright ? PixelRect{y.x, at.y - 8, y.width, 16} : PixelRect{at.x - 8, x.y, 16, x.height};
        };
        for (const Vec2 place : {Vec2{2, 2}, Vec2{8, 7}}) {
            CHECK(right.differences(left, near(place, false)) > 10); // the mark came or went
            CHECK(right.differences(left, near(place, true)) > 10);
        }
        CHECK(right.differences(left, near({5, 5}, false)) == 0);
    }
    Draughtsman again(setup);
    CHECK(again.has("canvas/ruler/y"));
    again.key('R', kControl);
    again.settle();
    CHECK_FALSE(again.has("canvas/ruler/y"));
}

} // namespace forefront::test
