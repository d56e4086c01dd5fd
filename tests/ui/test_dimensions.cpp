#include "tests/ui/edit_driver.hpp"
#include "ui/layers/layers.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace forefront::test {

namespace {

bool dimensionsShown(Draughtsman &driver) {
    return driver.context().layer("dimensions")->visible;
}

/// Returns the pixels within `half` of a place.
PixelRect pixelsAround(Draughtsman &driver, Vec2 place, double half) {
    const Pixel at = driver.pixel(place);
    return {at.x - half, at.y - half, 2.0 * half, 2.0 * half};
}

/// Shows or hides the layer and returns the picture.
Driver::Picture dimensionPicture(Draughtsman &driver, bool visible) {
    showLayer(driver.context().layers, "dimensions", visible);
    driver.context().animate();
    driver.settle();
    return driver.picture();
}

} // namespace

TEST_CASE("Dimensions: off at first; the eye in the Layers panel shows lengths beside segments, and is remembered") {
    const TemporaryFolder folder;
    const EditorSetup setup{.settingsFolder = folder.path};
    {
        Draughtsman driver(setup);
        driver.rectangle({2, 2}, {8, 7});
        driver.key('V');
        driver.key(key::kEscape);
        driver.unfoldLayers();
        CHECK_FALSE(dimensionsShown(driver));
        driver.moveTo({4, 790});
        driver.settle();
        const Driver::Picture plain = driver.picture();
        CHECK(driver.click("layer/dimensions"));
        driver.moveTo({4, 790});
        driver.settle();
        CHECK(dimensionsShown(driver));
        const Driver::Picture shown = driver.picture();
        for (const Vec2 middle : {Vec2{5, 2}, Vec2{5, 7}, Vec2{2, 4.5}, Vec2{8, 4.5}}) {
            CHECK(shown.differences(plain, pixelsAround(driver, middle, 30)) > 20);
        }
        CHECK(shown.differences(plain, pixelsAround(driver, {5, 4.5}, 60)) == 0);
        CHECK(shown.differences(plain, pixelsAround(driver, {2, 2}, 15)) == 0);
    }
    Draughtsman again(setup);
    CHECK(dimensionsShown(again));
}

TEST_CASE("Dimensions: those of the selection alone, with the angles; none of hidden shapes") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.polygon({{3, 3}, {7, 3}, {5, 5.5}});
    driver.key('V');
    driver.key(key::kEscape);
    driver.moveTo({4, 790});
    driver.settle();
    const auto changed = [&](const Driver::Picture &a, const Driver::Picture &b, Vec2 place, double half) {
        return a.differences(b, pixelsAround(driver, place, half)) > 0;
    };
    const Driver::Picture none = dimensionPicture(driver, false), all = dimensionPicture(driver, true);
    CHECK(changed(all, none, {5, 1}, 30));            // length of the rectangle
    CHECK(changed(all, none, {5, 3}, 30));            // and of the triangle
    CHECK_FALSE(changed(all, none, {3.6, 3.25}, 20)); // angles are those of selected shapes
    driver.context().selection.shapes = {2};
    const Driver::Picture chosen = dimensionPicture(driver, true), without = dimensionPicture(driver, false);
    CHECK_FALSE(changed(chosen, without, {5, 1}, 30));
    CHECK(changed(chosen, without, {3.6, 3.25}, 20));
    driver.context().selection.clear();
    driver.context().selection.shapes = {1};
    driver.key('H', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.document().shapes[0]->hidden);
    driver.moveTo({4, 790});
    driver.settle();
    const Driver::Picture hidden = dimensionPicture(driver, true), bare = dimensionPicture(driver, false);
    CHECK_FALSE(changed(hidden, bare, {5, 1}, 30));
    CHECK(changed(hidden, bare, {5, 3}, 30));
}

TEST_CASE("Dimensions: none for segments shorter than their text; a drawing of many segments stays quick") {
    Draughtsman driver;
    Shape ring;
    ring.id = 1;
    constexpr int kCorners = 100'000;
    for (int k = 0; k < kCorners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kCorners;
        ring.nodes.push_back(Vec2{5, 4} + 3.0 * Vec2{std::cos(angle), std::sin(angle)});
    }
    Document document = driver.document();
    document.shapes = {std::make_shared<const Shape>(std::move(ring))};
    document.nextId = 2;
    driver.context().document.apply(std::move(document), "Draw");
    driver.settle();
    const Driver::Picture plain = dimensionPicture(driver, false), shown = dimensionPicture(driver, true);
    CHECK(shown.differences(plain, driver.canvas()) == 0);
    driver.context().view.camera.centre = {8, 4};
    driver.context().view.camera.zoom = 1.5e6; // a segment has about 280 pixels
    const Driver::Picture close = dimensionPicture(driver, true), bare = dimensionPicture(driver, false);
    CHECK(close.differences(bare, driver.canvas()) > 100);
}

} // namespace forefront::test
