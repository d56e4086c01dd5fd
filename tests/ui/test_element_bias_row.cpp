#include "core/drawing/shapes/segment_sizes.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

namespace {

ElementBias biasOf(Draughtsman &driver, std::uint32_t segment) {
    const SegmentSize *const size = segmentSize(driver.document(), {1, segment});
    REQUIRE(size != nullptr);
    return size->bias;
}

} // namespace

TEST_CASE("Bias: set, flipped, at both ends and removed in the inspector, for a segment with a number of elements") {
    Draughtsman driver;
    driver.rectangle({2.0, 2.0}, {8.0, 8.0});
    driver.key('V');
    driver.clickPlace({5.0, 2.0});
    driver.clickPlace({5.0, 2.0}); // the lower side of the rectangle
    driver.settle();
    REQUIRE(driver.context().selection.segments.size() == 1);
    const std::uint32_t side = driver.context().selection.segments.begin()->segment;
    CHECK_FALSE(driver.has("inspector/bias"));
    driver.fill("inspector/elements", "10");
    REQUIRE(driver.has("inspector/bias"));
    const Driver::Picture plain = driver.picture();
    driver.fill("inspector/bias", "8");
    CHECK(biasOf(driver, side) == ElementBias{8.0, false});
    CHECK(driver.undoLabel() == "Set bias of elements");
    CHECK(driver.picture().differences(plain, driver.canvas()) > 0); // marks along the segment
    driver.click("inspector/biasflip");
    CHECK(biasOf(driver, side) == ElementBias{0.125, false});
    driver.click("inspector/biasends");
    CHECK(biasOf(driver, side) == ElementBias{0.125, true});
    driver.fill("inspector/bias", "-3");
    CHECK(biasOf(driver, side) == ElementBias{0.125, true});
    driver.key(key::kEscape);
    driver.click("inspector/bias");
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kBackspace);
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(biasOf(driver, side).any());
}

} // namespace forefront::test
