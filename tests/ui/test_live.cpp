#include "core/engine/boundary/discretise.hpp"
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
        context().settings.live = true;
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
        if (driver.context().preview->revision == driver.context().run.shownRevision()) {
            CHECK(driver.context().preview->spacing == driver.run().spacing); // built once for both
        }
    }
    driver.release(driver.pixel({7, 7}));
    driver.settle();
    CHECK(driver.run().boundary->nodes[2] == Vec2{7, 7});
    CHECK_FALSE(driver.context().run.liveMeshPending());
}

TEST_CASE("Live: the still parts are drawn once for a mesh and its preview, not for each move of the pointer") {
    LiveDrag driver;
    driver.platform().show(true);
    driver.settle();
    const std::uint64_t before = driver.editor().canvas().stillDraws();
    std::size_t meshes = 0, previewsAlone = 0;
    while (meshes < 12) {
        const std::uint64_t mesh = driver.run().meshHash;
        const auto preview = driver.context().preview;
        driver.moveOn();
        const bool newMesh = driver.run().meshHash != mesh;
        meshes += newMesh ? 1 : 0;
        previewsAlone += !newMesh && driver.context().preview != preview ? 1 : 0;
    }
    // Only where meshing takes long does a preview come before its mesh, and perhaps before its raster.
    const std::uint64_t draws = driver.editor().canvas().stillDraws() - before;
    CHECK(draws >= meshes);
    CHECK(draws <= meshes + 2 * previewsAlone + 3);
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
    CHECK(driver.has("status/checks"));
    CHECK(driver.logged("triangles") == 0);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.run().meshHash == hash);
    CHECK_FALSE(driver.context().run.outOfDate());
}

TEST_CASE("Live: on by default, and switched off in the menu") {
    const Settings defaults;
    CHECK(defaults.live);
    CHECK(defaults.liveBudget >= 20'000.0);
    Draughtsman driver;
    driver.context().settings.live = true;
    driver.rectangle({0, 0}, {4, 4});
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    const std::uint64_t run = driver.run().run;
    driver.context().actions.run("run.live", driver.context());
    driver.dragPlaces({4, 4}, {5, 5});
    driver.settle();
    CHECK(driver.run().run == run);
}

TEST_CASE("Live: above the budget a coarser preview follows the drag, and the full mesh is made when it ends") {
    LiveDrag driver;
    driver.release(driver.pixel({8, 8}));
    driver.context().settings.liveBudget = 1000.0;
    Document fine = driver.document();
    fine.spacing.size = 0.12; // about 10,000 elements
    driver.context().document.apply(std::move(fine), "Fine");
    driver.settle();
    driver.context().log.clear();
    driver.press(driver.pixel({8, 8}));
    for (std::set<std::uint64_t> meshes; meshes.size() < 4;) {
        driver.moveOn();
        CHECK_FALSE(driver.context().run.outOfDate());
        if (driver.context().run.preview()) {
            meshes.insert(driver.run().meshHash);
            CHECK(driver.run().quality.elements < 2000);
        }
    }
    CHECK(driver.logged("triangles") == 0);
    driver.release(driver.pixel({7, 7}));
    driver.settle();
    CHECK_FALSE(driver.context().run.preview());
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK(driver.run().quality.elements > 7000);
    CHECK(driver.logged("triangles") == 1);
}

TEST_CASE("Live: a mesh too large to make unasked is shown as a preview, with the predicted number of triangles") {
    LiveDrag driver;
    driver.release(driver.pixel({8, 8}));
    driver.context().settings.liveBudget = 1000.0;
    Document fine = driver.document();
    fine.spacing.size = 0.008;
    driver.context().document.apply(std::move(fine), "Fine");
    driver.settle();
    REQUIRE(driver.context().preview->estimatedElements > RunControl::kLargestLive);
    CHECK(driver.run().state == RunState::Finished);
    CHECK(driver.context().run.preview());
    CHECK(driver.run().quality.elements < 2000);
    CHECK(driver.has("canvas/remesh"));
    CHECK(driver.has("status/estimate"));
    CHECK(driver.logged("Preview") == 1);
}

TEST_CASE("Live: a mesh too large to follow a drag shows its progress and restarts after the drag") {
    LiveDrag driver;
    driver.release(driver.pixel({8, 8}));
    Document fine = driver.document();
    fine.spacing.size = 0.012; // beyond kQuietElements
    driver.context().document.apply(std::move(fine), "Fine");
    driver.until([&] { return driver.run().state == RunState::Running && driver.has("status/progress"); });
    Document coarse = driver.document();
    coarse.spacing.size = 0.5;
    driver.context().document.apply(std::move(coarse), "Coarse");
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    CHECK(driver.run().quality.elements < 2000);
}

} // namespace forefront::test
