#include "tests/ui/meshed_square.hpp"
#include "ui/canvas/mesh_glide.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/workspace/checks_summary.hpp"
#include "ui/workspace/view/follow_camera.hpp"

#include <doctest/doctest.h>

#include <array>
#include <utility>

using namespace forefront;
using namespace forefront::test;

namespace improvement_steps {

/// Goes to the finished front of a meshed square, before its improvement.
void toFrontDone(Driver &driver) {
    driver.workspace(WorkspaceKind::Step);
    driver.context().run.seek(driver.run().known);
    driver.settle();
}

std::string caption(Driver &driver) {
    return shell::stateText(driver.context());
}

/// Steps forward to a step that fulfils a condition. Returns false if there is none.
template <class Condition>
bool stepTo(Driver &driver, const Condition &condition) {
    while (!driver.run().atEnd()) {
        driver.key(key::kPeriod);
        driver.settle();
        if (driver.run().improvement && condition(*driver.run().improvement)) {
            return true;
        }
    }
    return false;
}

} // namespace improvement_steps

TEST_CASE("Improvement: . and , step through it after the last advance, and the caption has the figures") {
    MeshedSquare driver;
    const SessionSnapshot end = driver.run();
    REQUIRE(end.state == RunState::Finished);
    REQUIRE(end.improveSteps > 4);
    CHECK(improvement_steps::caption(driver).find("and the mesh improved") != std::string::npos);
    improvement_steps::toFrontDone(driver);
    CHECK(driver.run().advance == end.known);
    CHECK(driver.run().state == RunState::Paused);
    CHECK(driver.run().mesh->version != end.mesh->version);
    CHECK(improvement_steps::caption(driver).find("as the front leaves it") != std::string::npos);
    CHECK(unfinishedText(driver.context()).find("improvement") != std::string::npos);
    driver.key(key::kPeriod);
    driver.settle();
    CHECK(driver.run().improveStep == 1);
    CHECK(improvement_steps::caption(driver).starts_with("Improvement 1 of " + std::to_string(end.improveSteps)));
    CHECK(improvement_steps::caption(driver).find("minimum angle") != std::string::npos);
    const std::uint64_t first = driver.run().stateHash;
    driver.key(key::kPeriod);
    driver.key(key::kComma);
    driver.settle();
    CHECK(driver.run().improveStep == 1);
    CHECK(driver.run().stateHash == first);
    driver.key(key::kComma);
    driver.key(key::kComma);
    driver.settle();
    CHECK(driver.run().advance == end.known - 1);
    driver.key(key::kEnd);
    driver.settle();
    CHECK(driver.run().meshHash == end.meshHash);
    CHECK(driver.run().atEnd());
}

TEST_CASE("Improvement: the timeline leads into it, and its layer shows what a step changes") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Step);
    const SessionSnapshot end = driver.run();
    const PixelRect bar = driver.context().widgets.find("timeline/scrubber")->rect;
    const double y = bar.centre().y;
    const double part = (static_cast<double>(end.known) + 0.5 * static_cast<double>(end.improveSteps)) /
                        static_cast<double>(end.length());
    driver.drag({bar.x + bar.width - 8, y}, {bar.x + 7 + part * (bar.width - 14), y});
    driver.settle();
    CHECK(driver.run().improveStep > 0);
    CHECK(driver.run().improveStep < end.improveSteps);
    improvement_steps::toFrontDone(driver);
    REQUIRE(improvement_steps::stepTo(driver, [](const ImproveStep &step) { return !step.moves.empty(); }));
    const auto shown = driver.picture();
    driver.hideLayers({"improvement"});
    driver.settle();
    CHECK(driver.picture().differences(shown, driver.canvas()) > 20);
}

TEST_CASE("Improvement: nodes glide along a step forward and back, and are at their places in the end") {
    MeshedSquare driver;
    improvement_steps::toFrontDone(driver);
    MeshGlide glide;
    CHECK_FALSE(glide.follow(driver.run())); // the front is done, nothing has moved
    std::size_t glided = 0;
    const auto takeStep = [&](int by) {
        driver.context().run.step(Granularity::Advance, by);
        driver.settle();
        const SessionSnapshot &run = driver.run();
        glide.follow(run);
        CHECK(glide.at(0.0) == nullptr);
        const auto begin = glide.at(1.0), middle = glide.at(0.5);
        if (begin == nullptr) {
            return;
        }
        CHECK(begin->version != middle->version);
        CHECK(begin->version != run.mesh->version);
        for (std::size_t n = 0; n < run.mesh->mesh.nodes.size(); ++n) {
            const Vec2 target = run.mesh->mesh.nodes[n], from = begin->mesh.nodes[n];
            const Vec2 on = middle->mesh.nodes[n];
            glided += from == target ? 0 : 1;
            REQUIRE(distance(on, target) <= distance(from, target));
        }
    };
    for (int k = 0; k < 30 && !driver.run().atEnd(); ++k) {
        takeStep(1);
    }
    const std::size_t forward = glided;
    CHECK(forward > 10);
    while (driver.run().improveStep > 0) {
        takeStep(-1);
    }
    CHECK(glided == 2 * forward);
}

TEST_CASE("Improvement: the picture moves for a moment after a step, unless motion is reduced") {
    for (const bool reduced : {false, true}) {
        CAPTURE(reduced);
        MeshedSquare driver;
        improvement_steps::toFrontDone(driver);
        REQUIRE(improvement_steps::stepTo(driver,
                                          [](const ImproveStep &step) { return step.change == ImproveChange::Sweep; }));
        driver.key(key::kComma);
        driver.settle();
        driver.context().settings.reduceMotion = reduced;
        const std::size_t before = driver.run().improveStep;
        driver.key(key::kPeriod);
        driver.until([&] { return driver.run().improveStep == before + 1; });
        const auto first = driver.picture();
        driver.settle();
        CHECK((driver.picture().differences(first, driver.canvas()) > 50) == !reduced);
    }
}

TEST_CASE("Improvement: T follows the place that a step changes, and stays there while all nodes move") {
    MeshedSquare driver;
    Document classic = driver.document(); // its mesh has edges to swap
    classic.options.method = Method::Classic;
    driver.context().document.apply(std::move(classic), "Method");
    driver.key(key::kF5);
    driver.settle();
    improvement_steps::toFrontDone(driver);
    driver.key('T');
    driver.settle();
    REQUIRE(
        improvement_steps::stepTo(driver, [](const ImproveStep &step) { return step.change == ImproveChange::Swap; }));
    const std::array<Vec2, 2> edge = driver.run().improvement->addedEdges.front();
    const Box2 visible = driver.context().view.camera.visible();
    for (const Vec2 end : edge) {
        CHECK(visible.contains(end));
    }
    const double pixels = driver.context().view.camera.zoom * distance(edge[0], edge[1]);
    CHECK(pixels > 30.0);
    CHECK(pixels < 200.0);
    const Camera there = driver.context().view.camera;
    REQUIRE(
        improvement_steps::stepTo(driver, [](const ImproveStep &step) { return step.change == ImproveChange::Sweep; }));
    CHECK_FALSE(subjectOf(driver.run()).has_value());
    CHECK(driver.context().view.following);
    CHECK(driver.context().view.camera.zoom <= 1.5 * there.zoom);
}
