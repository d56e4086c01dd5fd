#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

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
        context().drawSeconds = 0.0; // one piece a frame, however quick the machine
    }
    /// Moves the camera before each frame and returns how often the still parts were redrawn.
    template <class Move>
    std::uint64_t redrawsWhile(Move move) {
        const std::uint64_t before = editor().canvas().stillDraws();
        for (int k = 0; k < 20; ++k) {
            move(context().view.camera);
            context().animate();
            frames(1);
        }
        return editor().canvas().stillDraws() - before;
    }
    /// Counts the frames until a new picture is complete, 200 at most.
    int framesUntilDrawn() {
        const std::uint64_t before = editor().canvas().stillDraws();
        int count = 0;
        for (; editor().canvas().stillDraws() == before && count < 200; ++count) {
            context().animate();
            frames(1);
        }
        return count;
    }
    /// Shows a part of the mesh, moved to the right, as if it had been read from a file.
    void showPart(std::size_t elements, double moved = 0.0) {
        TriMesh part = run().mesh->mesh;
        part.elements.resize(elements);
        part.regions.resize(elements);
        for (Vec2 &node : part.nodes) {
            node.x += moved;
        }
        context().run.showFile(fileMeshOf({std::move(part), {}, {}}));
    }
    int redAt(const Picture &picture, Vec2 place) {
        const Pixel p = pixel(place);
        return picture.rgba[4 * (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(picture.size.width) +
                                 static_cast<std::size_t>(p.x))];
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
    pan();
    const int all = driver.framesUntilDrawn();
    constexpr int kRestFrames = 8; // 0.12 s at 60 frames per second
    CHECK(all > kRestFrames + 1);  // more than one frame after that
    CHECK(all < 20);
    const std::uint64_t before = driver.editor().canvas().stillDraws();
    pan();
    driver.frames(all - 1); // all but the last part
    CHECK(driver.editor().canvas().stillDraws() == before);
    CHECK_FALSE(driver.editor().settled());
    pan();
    CHECK(driver.framesUntilDrawn() == all); // from the start
    driver.settle();
    CHECK(driver.framesUntilDrawn() == 200); // sharp
}

TEST_CASE("Canvas: the first picture of a large mesh is drawn over several frames, behind the last one") {
    HeavySquare driver;
    const auto before = driver.picture();
    driver.showPart(34'000);
    driver.frames(1);
    CHECK(driver.picture().differences(before, driver.canvas()) < 1000); // what is drawn over the mesh
    CHECK(driver.framesUntilDrawn() >= 3);                               // 8192 elements each
    CHECK(driver.picture().differences(before, driver.canvas()) > 10'000);
    driver.settle();
    const auto sliced = driver.picture();
    driver.context().drawSeconds = 1e9;
    driver.context().view.camera.zoom *= 20.0;
    driver.settle();
    driver.context().view.camera.zoom /= 20.0;
    driver.settle();
    CHECK(driver.picture().differences(sliced, driver.canvas()) == 0);
}

TEST_CASE("Canvas: while the mesh of another document is drawn, the one before is not shown") {
    HeavySquare driver;
    const int outside = driver.redAt(driver.picture(), {0.5, 4}), inside = driver.redAt(driver.picture(), {2, 4});
    REQUIRE(std::abs(inside - outside) > 2);
    const Camera here = driver.context().view.camera;
    driver.context().document.load(Document(driver.document()), {});
    driver.context().view.camera = here;
    driver.showPart(34'000, 2.0);
    driver.frames(2);
    REQUIRE_FALSE(driver.editor().settled());
    CHECK(std::abs(driver.redAt(driver.picture(), {2, 4}) - inside) > 2);
    CHECK(driver.framesUntilDrawn() >= 2);
}

TEST_CASE("Canvas: the next snapshot of a run waits until the picture of a large mesh is complete") {
    HeavySquare driver;
    const std::uint64_t end = driver.run().known;
    const auto seek = [&](std::uint64_t advance) {
        driver.context().run.seek(advance);
        while (driver.context().run.busy()) {
        }
    };
    seek(end - 1);
    driver.until([&] { return driver.run().advance == end - 1; });
    seek(end - 100);
    const int all = driver.framesUntilDrawn();
    CHECK(all >= 4);
    CHECK(driver.run().advance == end - 1);
    driver.until([&] { return driver.run().advance == end - 100; });
    driver.settle();
    CHECK(driver.run().advance == end - 100);
}

TEST_CASE("Canvas: the picture of a large mesh is completed while something light changes in every frame") {
    HeavySquare driver;
    const std::uint64_t before = driver.editor().canvas().stillDraws();
    for (int k = 0; k < 60; ++k) {
        Document moved = driver.document();
        auto shape = std::make_shared<Shape>(*moved.shapes.front());
        shape->nodes.front().x += 0.01;
        moved.shapes.front() = shape;
        driver.context().document.apply(std::move(moved), "Move");
        driver.frames(1);
    }
    CHECK(driver.editor().canvas().stillDraws() >= before + 3);
}

TEST_CASE("Canvas: the picture of a large mesh is completed while the range of its colours is dragged") {
    HeavySquare driver;
    showLayer(driver.context().layers, "quality", true);
    driver.settle();
    const std::uint64_t before = driver.editor().canvas().stillDraws();
    for (int k = 0; k < 60; ++k) {
        driver.context().view.measureRange = ColourRange{0.5 + 0.001 * k, 1.0};
        driver.context().animate();
        driver.frames(1);
    }
    CHECK(driver.editor().canvas().stillDraws() >= before + 3);
}

TEST_CASE("Canvas: a mesh takes less than 60 bytes an element, whichever of its layers are visible") {
    HeavySquare driver;
    const auto bytes = [&] {
        driver.context().animate();
        driver.settle();
        return driver.editor().canvas().meshBytes() / driver.run().quality.elements;
    };
    CHECK(bytes() > 30);
    CHECK(bytes() < 60);
    showLayer(driver.context().layers, "quality", true);
    CHECK(bytes() < 60);
    showLayer(driver.context().layers, "mesh", false);
    CHECK(bytes() < 60);
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
        const std::uint64_t draws = driver.editor().canvas().stillDraws();
        driver.frames(1);
        REQUIRE(driver.editor().canvas().stillDraws() == draws);
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

TEST_CASE("Canvas: at the deepest zoom, a circle is drawn where it is") {
    Draughtsman driver;
    driver.key('C');
    driver.dragPlaces({5, 4}, {8, 4});
    driver.key('V');
    driver.key(key::kEscape);
    driver.settle();
    const Shape circle = *driver.document().shapes.at(0);
    Camera &camera = driver.context().view.camera;
    const PixelRect canvas = driver.canvas();
    const Colour boundary = driver.context().theme.boundary;
    const auto hits = [&](const Driver::Picture &picture) { // on a small cross, which the circle passes
        int count = 0;
        for (int k = -6; k <= 6; ++k) {
            const auto x = static_cast<std::size_t>(canvas.centre().x), y = static_cast<std::size_t>(canvas.centre().y);
            const std::size_t at =
                4 * ((y + static_cast<std::size_t>(k)) * static_cast<std::size_t>(picture.size.width) + x);
            count += std::abs(picture.rgba[at] - boundary.r) < 40 && std::abs(picture.rgba[at + 1] - boundary.g) < 40
                         ? 1
                         : 0;
        }
        return count;
    };
    camera.zoom = camera.maxZoom;
    for (const double t : {0.1234567, 0.3456789, 0.6543219}) {
        camera.centre = Curve::circle(circle.nodes[0], circle.nodes[1]).point(t);
        driver.context().animate();
        driver.settle();
        CHECK(hits(driver.picture()) > 0);
    }
}

TEST_CASE("Canvas: a half-drawn picture is given up when the mesh is hidden, whether frames are shown or not") {
    for (const bool shown : {true, false}) {
        HeavySquare driver;
        driver.showPart(34'000);
        driver.frames(1);
        REQUIRE(driver.editor().canvas().pictureIncomplete());
        driver.platform().show(shown);
        driver.showPart(100);
        driver.frames(1);
        CHECK_FALSE(driver.editor().canvas().pictureIncomplete());
        driver.settle();
    }
}

TEST_CASE("Canvas: a small mesh is redrawn whenever the camera moves") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key(key::kF5);
    driver.platform().show(true);
    driver.settle();
    const std::uint64_t before = driver.editor().canvas().stillDraws();
    driver.context().view.camera.pan({3.0, 2.0});
    driver.context().animate();
    driver.frames(1);
    CHECK(driver.editor().canvas().stillDraws() == before + 1);
}

} // namespace forefront::test
