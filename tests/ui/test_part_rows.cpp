#include "core/drawing/names/part_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/domain.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <utility>

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

} // namespace forefront::test
