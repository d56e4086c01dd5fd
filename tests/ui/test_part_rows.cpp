#include "core/drawing/names/part_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/domain.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/shot.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

/// Selects a segment of the only shape.
void chooseSegment(Draughtsman &driver, Vec2 at) {
    driver.click("workspace/Size");
    driver.key('V');
    driver.clickPlace(at);
    driver.clickPlace(at);
    driver.settle();
    REQUIRE(driver.context().selection.segments.size() == 1);
}

} // namespace

TEST_CASE("Parts: boundary layers are set in the inspector, and drawn with the mesh") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    chooseSegment(driver, {5.0, 2.0});
    const SegmentRef side = *driver.context().selection.segments.begin();
    CHECK_FALSE(driver.has("inspector/layers/count"));
    driver.fill("inspector/layers/first", "-1");
    CHECK(driver.document().layers.empty());
    driver.key(key::kEscape);
    driver.fill("inspector/layers/first", "0.02");
    REQUIRE(driver.document().layers.size() == 1);
    CHECK(driver.undoLabel() == "Change boundary layers");
    const std::int32_t tag = segmentTag(*driver.document().shapes.front(), side.segment);
    REQUIRE(layersOf(driver.document(), tag) != nullptr);
    driver.fill("inspector/layers/count", "5");
    CHECK(layersOf(driver.document(), tag)->count == 5);
    driver.fill("inspector/layers/growth", "1.5");
    CHECK(layersOf(driver.document(), tag)->growth == 1.5);
    driver.fill("inspector/layers/thickness", "0.5");
    CHECK(layersOf(driver.document(), tag)->thickness == 0.5);
    CHECK_FALSE(layersOf(driver.document(), tag)->count);

    driver.click("workspace/Mesh");
    driver.key(key::kF5);
    driver.settle();
    REQUIRE(driver.run().layers);
    CHECK(driver.run().layers->rays > 10);
    CHECK(driver.run().layers->lines.size() == driver.run().layers->rays);
    const Driver::Picture with = driver.picture();
    showLayer(driver.context().layers, "rays", false);
    driver.settle();
    CHECK(driver.picture().differences(with, driver.canvas()) > 100);
}

TEST_CASE("Parts: rows of layers are drawn before there is a run, and follow each value") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    chooseSegment(driver, {5.0, 2.0});
    const auto plan = [&]() -> const LayerRows & { return driver.context().examiner.layers().plan()->rows; };
    CHECK(plan().pieces.empty());
    const Driver::Picture without = driver.picture();
    driver.fill("inspector/layers/first", "0.1");
    driver.fill("inspector/layers/count", "4");
    driver.settle();
    CHECK_FALSE(driver.context().run.hasRun());
    CHECK(plan().report.most == 4);
    CHECK(plan().report.lines.size() > 5);
    CHECK(plan().pieces.size() >= 4 * (plan().report.lines.size() - 1));
    const Driver::Picture four = driver.picture();
    CHECK(four.differences(without, driver.canvas()) > 500);
    driver.fill("inspector/layers/count", "7");
    driver.fill("inspector/layers/growth", "1.1");
    driver.settle();
    CHECK(plan().report.most == 7);
    const Driver::Picture seven = driver.picture();
    CHECK(seven.differences(four, driver.canvas()) > 200);
    driver.key('Z', {Modifiers::kControl});
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(plan().report.most == 4);
    CHECK(driver.picture().differences(seven, driver.canvas()) > 200);
    showLayer(driver.context().layers, "rays", false);
    driver.settle();
    CHECK(plan().pieces.empty()); // nothing is planned that is not shown
    showLayer(driver.context().layers, "rays", true);
    driver.settle();
    CHECK(plan().report.most == 4);
}

TEST_CASE("Parts: planned rows give way to those of a run, and come back when the drawing changes") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    chooseSegment(driver, {5.0, 2.0});
    driver.fill("inspector/layers/first", "0.1");
    driver.fill("inspector/layers/count", "3");
    driver.settle();
    const std::size_t rays = driver.context().examiner.layers().plan()->rows.report.rays;
    CHECK(rays > 5);
    driver.key(key::kF5);
    driver.settle();
    REQUIRE(driver.run().layers);
    CHECK(driver.run().layers->rays == rays);
    CHECK(driver.context().examiner.layers().plan()->rows.pieces.empty());
    driver.fill("inspector/layers/count", "5");
    driver.settle();
    CHECK(driver.context().examiner.layers().plan()->rows.report.most == 5);
}

TEST_CASE("Parts: layers are removed by an empty field") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    chooseSegment(driver, {5.0, 2.0});
    driver.fill("inspector/layers/first", "0.02");
    REQUIRE(driver.document().layers.size() == 1);
    driver.click("inspector/layers/first");
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kBackspace);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().layers.empty());
    CHECK_FALSE(driver.has("inspector/layers/count"));
}

TEST_CASE("Parts: two sides become periodic, and are drawn as a pair") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    chooseSegment(driver, {2.0, 5.0});
    CHECK_FALSE(driver.has("inspector/crack"));
    CHECK_FALSE(driver.has("inspector/periodic")); // there is no other part
    driver.clickPlace({5.0, 2.0});
    driver.settle();
    driver.fill("inspector/layers/first", "0.02"); // makes the lower side a part of its own
    driver.clickPlace({5.0, 8.0});
    driver.settle();
    const Driver::Picture before = driver.picture();
    REQUIRE(driver.has("inspector/periodic"));
    driver.click("inspector/periodic");
    driver.settle();
    const std::int32_t lower = driver.document().layers.front().tag;
    driver.click("inspector/periodic/" + boundaryName(driver.document().boundaryNames, lower));
    driver.settle();
    REQUIRE(driver.document().periodic.size() == 1);
    CHECK(driver.document().periodic.front().to == lower);
    CHECK(driver.undoLabel() == "Change periodic part");
    CHECK(driver.picture().differences(before, driver.canvas()) > 50);
}

TEST_CASE("Parts: an inner line becomes a crack, and a region is filled by rows") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    driver.key('L');
    driver.clickPlace({4.0, 5.0});
    driver.clickPlace({6.0, 5.0});
    driver.key(key::kEnter);
    driver.settle();
    driver.key('V');
    driver.clickPlace({5.0, 5.0});
    driver.settle();
    REQUIRE(driver.has("inspector/crack"));
    CHECK_FALSE(driver.has("inspector/layers/first"));
    driver.click("inspector/crack");
    driver.settle();
    REQUIRE(driver.document().cracks.size() == 1);
    CHECK(driver.document().cracks.front() != driver.document().shapes.front()->tag);
    CHECK(driver.undoLabel() == "Make crack");
    driver.click("inspector/crack");
    driver.settle();
    CHECK(driver.document().cracks.empty());

    driver.fill("inspector/strip/width", "0.2");
    REQUIRE(driver.document().strips.size() == 1);
    CHECK(driver.document().strips.front().width == 0.2);
    CHECK(driver.undoLabel() == "Change strip");
    driver.fill("inspector/strip/rows", "2");
    CHECK(driver.document().strips.front().rows == 2);
    driver.fill("inspector/strip/rows", "1.5");
    CHECK(driver.document().strips.front().rows == 2);
    driver.key(key::kEscape);

    Document next = driver.document();
    next.regionMarkers.push_back({{3.0, 3.0}, 2});
    driver.context().document.apply(std::move(next), "Region");
    driver.context().selection = {};
    driver.context().selection.markers.insert(0);
    driver.settle();
    driver.click("inspector/mapped");
    driver.settle();
    CHECK(isMapped(driver.document(), 2));
    driver.click("inspector/elements");
    driver.settle();
    driver.click("inspector/elements/Quads");
    driver.settle();
    CHECK(elementsOf(driver.document(), 2) == Elements::Quads);
    CHECK(driver.undoLabel() == "Change elements of region");
    driver.click("inspector/elements");
    driver.settle();
    driver.click("inspector/elements/As the rest");
    driver.settle();
    CHECK(driver.document().regionElements.empty());
}

namespace {

/// Draws an outline with straight segments and selects a region in it.
void drawRegion(Draughtsman &driver, const std::vector<Vec2> &corners, Vec2 marker) {
    driver.key('P');
    for (const Vec2 corner : corners) {
        driver.clickPlace(corner);
    }
    driver.clickPlace(corners.front());
    driver.settle();
    driver.key('V');
    Document next = driver.document();
    next.regionMarkers.push_back({marker, 2});
    driver.context().document.apply(std::move(next), "Region");
    driver.context().selection = {};
    driver.context().selection.markers.insert(0);
    driver.settle();
}

} // namespace

TEST_CASE("Parts: the corners of a mapped region are chosen in the inspector, and drawn") {
    Draughtsman driver({}, {1280, 1600});                                         // the inspector has room for all rows
    drawRegion(driver, {{2, 2}, {8, 2}, {8, 5}, {5, 5}, {5, 8}, {2, 8}}, {3, 3}); // five corners below 150 degrees
    driver.click("inspector/mapped");
    driver.settle();
    CHECK(driver.has("inspector/corners/unclear"));
    CHECK_FALSE(driver.has("inspector/corners/1"));
    const Driver::Picture before = driver.picture();
    driver.click("inspector/corners/choice/Chosen");
    driver.settle();
    REQUIRE(mappedOf(driver.document(), 2)->corners.size() == 4);
    CHECK(driver.undoLabel() == "Choose corners");
    CHECK(driver.picture().differences(before, driver.canvas()) > 50);
    const auto choose = [&](const std::string &corner, const std::string &node) {
        driver.click("inspector/corners/" + corner);
        driver.settle();
        driver.click("inspector/corners/" + corner + '/' + node);
        driver.settle();
    };
    const std::vector<std::string> wanted{"(8, 2)", "(8, 5)", "(5, 8)", "(2, 8)"};
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        choose(std::to_string(k + 1), wanted[k]);
    }
    CHECK(mappedOf(driver.document(), 2)->corners == std::vector<Vec2>{{8, 2}, {8, 5}, {5, 8}, {2, 8}});
    choose("1", "(8, 5)"); // two corners change places
    CHECK(mappedOf(driver.document(), 2)->corners == std::vector<Vec2>{{8, 5}, {8, 2}, {5, 8}, {2, 8}});
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    choose("4", "none");
    CHECK(mappedOf(driver.document(), 2)->corners.size() == 3);
    driver.click("inspector/corners/choice/Automatic");
    driver.settle();
    CHECK(mappedOf(driver.document(), 2)->corners.empty());
    CHECK(driver.has("inspector/corners/unclear"));
}

TEST_CASE("Parts: a corner of a mapped region goes with its node") {
    Draughtsman driver;
    drawRegion(driver, {{2, 2}, {8, 2}, {8, 8}, {2, 8}}, {5, 5});
    driver.click("inspector/mapped");
    driver.settle();
    driver.click("inspector/corners/choice/Chosen");
    driver.settle();
    REQUIRE(mappedOf(driver.document(), 2)->corners.size() == 4);
    driver.context().selection = {};
    driver.settle();
    driver.clickPlace({5.0, 2.0}); // shows the nodes of the outline
    driver.dragPlaces({8.0, 8.0}, {9.0, 7.0});
    driver.settle();
    const std::vector<Vec2> &corners = mappedOf(driver.document(), 2)->corners;
    CHECK(std::ranges::find(corners, Vec2{9.0, 7.0}) != corners.end());
    CHECK(std::ranges::find(corners, Vec2{8.0, 8.0}) == corners.end());
}

// Not a test; writes pictures of planned layers and of corners, in both themes, into the folder that
// FOREFRONT_SCREENSHOTS names.
TEST_CASE("Screenshots: parts" * doctest::skip()) {
    const char *const folder = std::getenv("FOREFRONT_SCREENSHOTS");
    REQUIRE_MESSAGE(folder != nullptr, "set FOREFRONT_SCREENSHOTS to a folder");
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        const std::string ending = theme == ThemeKind::Dark ? "-dark.ppm" : "-light.ppm";
        {
            Draughtsman driver;
            driver.context().settings.theme = theme;
            driver.rectangle({2.0, 2.0}, {8.0, 8.0});
            chooseSegment(driver, {5.0, 2.0});
            driver.fill("inspector/layers/first", "0.1");
            driver.fill("inspector/layers/count", "6");
            driver.settle();
            writePicture(driver.picture(), std::filesystem::path(folder) / ("parts-layers" + ending));
        }
        Draughtsman driver;
        driver.context().settings.theme = theme;
        drawRegion(driver, {{2, 2}, {8, 2}, {8, 5}, {5, 5}, {5, 8}, {2, 8}}, {3, 3});
        driver.click("inspector/mapped");
        driver.settle();
        driver.click("inspector/corners/choice/Chosen");
        driver.settle();
        writePicture(driver.picture(), std::filesystem::path(folder) / ("parts-corners" + ending));
    }
}

} // namespace forefront::test
