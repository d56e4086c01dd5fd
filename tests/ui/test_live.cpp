#include "core/boundary/discretise.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>

namespace forefront::test {

namespace {

/// A live-meshed square of 8 x 8 units, with its upper right node being dragged.
struct LiveDrag : Draughtsman {
    LiveDrag() {
        polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
        Document sized = document();
        sized.spacing.size = 0.5;
        context().document.apply(std::move(sized), "Size");
        key('V');
        context().run.live = true;
        settle();
        context().log.clear();
        press(pixel({8, 8}));
    }

    /// Moves the node a little further and draws one frame, like a drag without a pause.
    void moveOn() {
        const double angle = 0.3 * ++moves_;
        const Pixel at = pixel({7.5 + 0.4 * std::cos(angle), 7.5 + 0.4 * std::sin(angle)});
        editor().input().push({.kind = InputKind::MouseMove, .x = at.x, .y = at.y});
        frames(1);
    }
    std::size_t logged(std::string_view what) {
        std::size_t count = 0;
        for (const MessageLog::Entry &entry : context().log.entries()) {
            count += entry.diagnostic.message.find(what) != std::string::npos ? 1 : 0;
        }
        return count;
    }

  private:
    int moves_ = 0;
};

} // namespace

TEST_CASE("Live: the mesh and the preview follow a node that is dragged without a pause") {
    LiveDrag driver;
    std::set<std::uint64_t> meshes, previews;
    while (meshes.size() < 5 || previews.size() < 5) {
        driver.moveOn();
        CHECK(driver.run().state == RunState::Finished); // never half a mesh
        CHECK_FALSE(driver.context().run.outOfDate());
        meshes.insert(driver.run().meshHash);
        previews.insert(driver.context().preview->revision);
    }
    driver.release(driver.pixel({7, 7}));
    driver.settle();
    CHECK(driver.run().boundary->nodes[2] == Vec2{7, 7});
    CHECK_FALSE(driver.context().run.hasToFollow());
}

TEST_CASE("Live: each gesture leaves one line in the log") {
    LiveDrag driver;
    for (std::set<std::uint64_t> meshes; meshes.size() < 4; meshes.insert(driver.run().meshHash)) {
        driver.moveOn();
    }
    CHECK(driver.logged("triangles") == 0);
    driver.release(driver.pixel({7, 7}));
    driver.settle();
    CHECK(driver.logged("triangles") == 1);
    driver.dragPlaces({7, 7}, {8, 8});
    driver.settle();
    CHECK(driver.logged("triangles") == 2);
    // Nudges with the arrow keys are one undo step, so they leave one line.
    for (int i = 0; i < 4; ++i) {
        driver.editor().input().push({.kind = InputKind::Key, .code = key::kRight, .pressed = true, .repeated = i > 0});
        driver.settle();
    }
    CHECK(driver.undoLabel() == "Nudge");
    CHECK(driver.logged("triangles") == 3);
}

TEST_CASE("Live: a drawing with faults keeps the last mesh, out of date, until the faults are fixed") {
    LiveDrag driver;
    const std::uint64_t hash = driver.run().meshHash;
    driver.release(driver.pixel({4, -2})); // the outline crosses itself
    driver.settle();
    CHECK(driver.run().meshHash == hash);
    CHECK(driver.context().run.outOfDate());
    CHECK(driver.has("status/faults"));
    CHECK(driver.logged("triangles") == 0);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.run().meshHash == hash);
    CHECK_FALSE(driver.context().run.outOfDate());
}

TEST_CASE("Live: a mesh too large to follow a drag shows its progress and restarts after the drag") {
    LiveDrag driver;
    driver.release(driver.pixel({8, 8}));
    Document fine = driver.document();
    fine.spacing.size = 0.012; // beyond kQuietElements
    driver.context().document.apply(std::move(fine), "Fine");
    driver.until([&] { return driver.run().state == RunState::Running && driver.has("canvas/progress"); });
    Document coarse = driver.document();
    coarse.spacing.size = 0.5;
    driver.context().document.apply(std::move(coarse), "Coarse");
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    CHECK(driver.run().quality.elements < 2000);
}

} // namespace forefront::test
