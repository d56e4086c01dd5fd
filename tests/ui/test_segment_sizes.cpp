#include "core/drawing/document/equality.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing_files/documents.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <set>

namespace forefront::test {

TEST_CASE("Segment sizes: a size and a number on an edge change no tag or name, are drawn, saved, opened and undone") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.context().document.apply(*setBoundaryName(driver.document(), 1, "wall"), "Name");
    driver.key('V');
    driver.key(key::kEscape);
    const auto select = [&](Vec2 at) {
        driver.key(key::kEscape);
        driver.clickPlace(at);
        driver.clickPlace(at);
        REQUIRE(driver.context().selection.segments.size() == 1);
    };
    const Document plain = driver.document();
    select({3, 1});
    driver.fill("inspector/segmentsize", "0.25");
    select({9, 3});
    driver.fill("inspector/elements", "12");
    const Document sized = driver.document();
    CHECK(*segmentSize(sized, {1, 0}) == SegmentSize{.size = 0.25, .elements = 0, .growth = 0.2});
    CHECK(*segmentSize(sized, {1, 1}) == SegmentSize{.size = 0.0, .elements = 12, .growth = 0.2});
    CHECK(sized.shapes[0]->segmentTags.empty());
    CHECK(boundaryTags(sized) == std::vector<std::int32_t>{1});
    CHECK(sized.boundaryNames == plain.boundaryNames);
    CHECK(sized.spacing.partSizes.empty());
    CHECK(sized.elementCounts.empty());

    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    driver.chooseFile("save", place.path / "plate");
    CHECK(sameContent(*readDocument(place.path / "plate.forefront"), sized));

    select({3, 1});
    driver.click("inspector/split"); // both halves keep the size
    CHECK(driver.document().shapes[0]->segmentSizes.size() == 3);
    driver.key('Z', {Modifiers::kControl});
    CHECK(sameContent(driver.document(), sized));
    driver.key('Z', {Modifiers::kControl});
    driver.key('Z', {Modifiers::kControl});
    CHECK(sameContent(driver.document(), plain));
}

TEST_CASE("Segment sizes: several edges get one size, and a field whose sizes differ says so") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document next = *setSegmentSize(driver.document(), {{1, 0}}, SegmentSize{.size = 0.5});
    driver.context().document.apply(*setSegmentSize(next, {{1, 1}}, SegmentSize{.size = 0.25}), "Sizes");
    driver.key('V');
    driver.context().selection = {};
    driver.context().selection.segments = {{1, 0}, {1, 1}};
    driver.settle();
    driver.fill("inspector/segmentgrowth", "0.4");
    CHECK(segmentSize(driver.document(), {1, 0})->size == 0.5); // keeps its own
    CHECK(segmentSize(driver.document(), {1, 1})->growth == 0.4);
    driver.fill("inspector/segmentsize", "0.125");
    CHECK(segmentSize(driver.document(), {1, 0})->size == 0.125);
    CHECK(segmentSize(driver.document(), {1, 1})->size == 0.125);
    CHECK_FALSE(segmentSize(driver.document(), {1, 2}));
}

} // namespace forefront::test
