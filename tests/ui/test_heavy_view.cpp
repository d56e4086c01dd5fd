#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace forefront::test {

namespace {

/// A square with a mesh too large to redraw while the camera moves.
class HeavySquare : public Draughtsman {
  public:
    HeavySquare() {
        rectangle({1, 1}, {9, 8});
        Document sized = document();
        sized.spacing.size = 0.055;
        sized.options.improve = ImproveLevel::None;
        context().document.apply(std::move(sized), "Size");
        key('V');
        key(key::kEscape);
        key(key::kF5);
        settle();
        REQUIRE(run().quality.elements > 35'000);
        REQUIRE(run().quality.elements < 60'000);
        showLayer(context().layers, "lattice", false); // its spacing follows the zoom
        moveTo({5, 5});
        context().animate();
        settle();
    }
    /// Moves the camera before each frame and returns how often the still parts were redrawn.
    template <class Move>
    std::uint64_t redrawsWhile(Move move) {
        const std::uint64_t before = editor().stillDraws();
        for (int k = 0; k < 20; ++k) {
            move(context().view.camera);
            context().animate();
            frames(1);
        }
        return editor().stillDraws() - before;
    }
};

} // namespace

TEST_CASE("Canvas: a large mesh is not redrawn while the camera moves, and is sharp once it rests") {
    HeavySquare driver;
    CHECK(driver.redrawsWhile([](Camera &camera) { camera.pan({3.0, 2.0}); }) == 0);
    CHECK_FALSE(driver.editor().settled());
    driver.settle();
    CHECK(driver.redrawsWhile([](Camera &) {}) == 0);
    const auto rested = driver.picture();
    // The same view, reached in one step and drawn afresh.
    const Camera here = driver.context().view.camera;
    driver.context().view.camera.zoom *= 20.0;
    driver.settle();
    driver.context().view.camera = here;
    driver.settle();
    CHECK(driver.picture().differences(rested, driver.canvas()) == 0);
}

TEST_CASE("Canvas: a large mesh at rest is drawn over several frames, and a move of the camera discards them") {
    HeavySquare driver;
    const auto pan = [&] {
        driver.context().view.camera.pan({3.0, 2.0});
        driver.context().animate();
    };
    /// Counts the frames until a new picture is complete.
    const auto framesUntilDrawn = [&] {
        const std::uint64_t before = driver.editor().stillDraws();
        int count = 0;
        for (; driver.editor().stillDraws() == before && count < 200; ++count) {
            driver.context().animate();
            driver.frames(1);
        }
        return count;
    };
    pan();
    const int all = framesUntilDrawn();
    constexpr int kRestFrames = 8; // 0.12 s at 60 frames per second
    CHECK(all > kRestFrames + 1);  // more than one frame after that
    CHECK(all < 20);
    const std::uint64_t before = driver.editor().stillDraws();
    pan();
    driver.frames(all - 1); // all but the last part
    CHECK(driver.editor().stillDraws() == before);
    CHECK_FALSE(driver.editor().settled());
    pan();
    CHECK(framesUntilDrawn() == all); // from the start
    driver.settle();
    CHECK(framesUntilDrawn() == 200); // sharp
}

TEST_CASE("Canvas: the moved picture of a large mesh is where the mesh is") {
    HeavySquare driver;
    const PixelRect canvas = driver.canvas();
    const auto filled = [&](const Driver::Picture &picture, Vec2 place) {
        const Pixel p = driver.pixel(place);
        const auto at = 4 * (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(picture.size.width) +
                             static_cast<std::size_t>(p.x));
        return picture.rgba[at];
    };
    const auto before = driver.picture();
    const int inside = filled(before, {5, 4.5}), outside = filled(before, {5, 0.5});
    REQUIRE(std::abs(inside - outside) > 2);
    for (const double factor : {1.0, 1.15, 0.8}) {
        CAPTURE(factor);
        driver.context().view.camera.zoomAt(canvas.centre(), factor);
        driver.context().view.camera.pan({17.0, -11.0});
        driver.context().animate();
        const std::uint64_t draws = driver.editor().stillDraws();
        driver.frames(1);
        REQUIRE(driver.editor().stillDraws() == draws);
        const auto moved = driver.picture();
        driver.settle();
        const auto sharp = driver.picture();
        // The edges of the square, one pixel to either side, and its middle look the same in both.
        const double pixel = 3.0 / driver.context().view.camera.zoom;
        for (const Vec2 place : {Vec2{5, 1 - pixel}, Vec2{1 - pixel, 4}, Vec2{9 + pixel, 4}}) {
            CHECK(std::abs(filled(moved, place) - filled(sharp, place)) <= 2);
        }
        CHECK(std::abs(filled(moved, {5, 1 + pixel}) - outside) > 2);
        CHECK(std::abs(filled(moved, {1 + pixel, 4}) - outside) > 2);
    }
}

TEST_CASE("Canvas: a small mesh is redrawn whenever the camera moves") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key(key::kF5);
    driver.settle();
    const std::uint64_t before = driver.editor().stillDraws();
    driver.context().view.camera.pan({3.0, 2.0});
    driver.context().animate();
    driver.frames(1);
    CHECK(driver.editor().stillDraws() == before + 1);
}

} // namespace forefront::test
