#include "core/teaching/moment/moment.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/canvas/glide.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace forefront::test {

TEST_CASE("Motion: a jump of the camera takes 120 ms, slows down, and ends at the target") {
    const Camera from{.centre = {0, 0}, .zoom = 10.0, .viewport = {0, 0, 800, 600}};
    const Camera to{.centre = {30, 10}, .zoom = 40.0, .viewport = {0, 0, 800, 600}};
    Glide glide;
    CHECK(glide.next(from, 0, 5.0, true) == from);
    CHECK_FALSE(glide.moving());
    CHECK(glide.next(to, 1, 6.0, true).zoom == doctest::Approx(10.0));
    double before = 10.0, step = 1e9;
    for (int k = 1; k < 8; ++k) {
        const Camera shown = glide.next(to, 1, 6.0 + 0.015 * k, true);
        CHECK(glide.moving());
        CHECK(shown.zoom > before);
        CHECK(std::log(shown.zoom / before) < step); // ever slower
        step = std::log(shown.zoom / before);
        before = shown.zoom;
    }
    CHECK(glide.next(to, 1, 6.1201, true) == to);
    CHECK_FALSE(glide.moving());
    // A move by hand is shown at once, and so is a jump with reduced motion or after a change of the window.
    CHECK(glide.next(from, 1, 7.0, true) == from);
    CHECK(glide.next(to, 2, 8.0, false) == to);
    Camera wide = from;
    wide.viewport.width = 900;
    CHECK(glide.next(wide, 3, 9.0, true) == wide);
}

TEST_CASE("Motion: what both cameras show at the same pixel stays there during a zoom") {
    const Camera from{.centre = {0, 0}, .zoom = 10.0, .viewport = {0, 0, 800, 600}};
    Camera to = from;
    to.zoomAt({200, 100}, 6.0);
    const Vec2 fixed = from.toPlane({200, 100});
    Glide glide;
    glide.next(from, 0, 0.0, true);
    for (int k = 0; k < 8; ++k) {
        const Pixel at = glide.next(to, 1, 1.0 + 0.015 * k, true).toPixel(fixed);
        CHECK(at.x == doctest::Approx(200.0));
        CHECK(at.y == doctest::Approx(100.0));
    }
}

TEST_CASE("Motion: a command moves the picture smoothly, unless motion is reduced") {
    for (const bool reduced : {false, true}) {
        Draughtsman driver;
        driver.platform().show(true);
        driver.rectangle({4, 4}, {6, 6});
        driver.key('V');
        driver.moveTo({5, 5});
        driver.settle();
        driver.context().settings.reduceMotion = reduced;
        const std::uint64_t before = driver.editor().canvas().stillDraws();
        driver.context().actions.run("view.fit", driver.context());
        const Camera target = driver.context().view.camera; // at once, for the next command
        driver.settle();
        CHECK(driver.context().view.camera == target);
        const std::uint64_t draws = driver.editor().canvas().stillDraws() - before;
        CHECK((reduced ? draws <= 2 : draws >= 5));
    }
}

namespace {

/// A square meshed by advances, ready to be stepped.
void stepTo(MeshedSquare &driver, std::uint64_t advance) {
    driver.workspace(WorkspaceKind::Step);
    driver.context().run.seek(advance);
    driver.settle();
}

} // namespace

TEST_CASE("Motion: the elements of a step fade in while stepping, unless motion is reduced") {
    for (const bool reduced : {false, true}) {
        CAPTURE(reduced);
        MeshedSquare driver;
        stepTo(driver, 20);
        driver.context().settings.reduceMotion = reduced;
        driver.key(key::kPeriod);
        driver.until([&] { return driver.run().advance == 21; });
        const Moment moment = momentOf(driver.run());
        REQUIRE(moment);
        REQUIRE_FALSE(moment.advance->made.empty());
        const auto &corners = moment.advance->made.front();
        const Pixel middle = driver.pixel((1.0 / 3.0) * (corners[0] + corners[1] + corners[2]));
        const Colour first = colourAt(driver.picture(), middle);
        driver.frames(4);
        const Colour then = colourAt(driver.picture(), middle);
        driver.settle();
        const Colour last = colourAt(driver.picture(), middle);
        CHECK((difference(first, last) > 8) == !reduced);
        CHECK((difference(then, last) < difference(first, last)) == !reduced);
    }
}

TEST_CASE("Motion: the camera that follows the front glides to it, and jumps if motion is reduced") {
    for (const bool reduced : {false, true}) {
        CAPTURE(reduced);
        MeshedSquare driver;
        stepTo(driver, 20);
        driver.context().settings.reduceMotion = reduced;
        driver.key('T');
        driver.frames(1);
        const Camera soon = driver.context().view.camera;
        driver.settle();
        const Camera last = driver.context().view.camera;
        CHECK((std::abs(soon.zoom / last.zoom - 1.0) < 1e-6) == reduced);
        const Moment moment = momentOf(driver.run());
        REQUIRE(moment);
        const double base = last.zoom * distance(moment.advance->a, moment.advance->b);
        CHECK(base >= 59.0);
        CHECK(base <= 121.0);
    }
}

} // namespace forefront::test
