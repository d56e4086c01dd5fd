#include "core/engine/base/vec2.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/measure_colours.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace forefront::test {

namespace {

/// A meshed square with only mesh and colours on the canvas.
struct ColouredSquare : MeshedSquare {
    ColouredSquare() {
        hideLayers({"front", "candidates", "tests", "labels", "grid"});
        moveTo({5, 5});
        context().animate();
        settle();
    }
    bool visible(const char *layer) { return context().layer(layer)->visible; }
    /// Redraws and returns the picture.
    Picture redrawn() {
        context().animate();
        settle();
        return picture();
    }
    /// Returns the number of unhatched elements whose middle does not have the colour of their α.
    std::size_t wronglyColoured(const ColourRange &range) {
        const Picture shown = redrawn();
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < run().mesh->alpha.size(); ++i) {
            const double alpha = static_cast<double>(run().mesh->alpha[i]);
            wrong += alpha > 0.5 && difference(colourAt(shown, pixel(middleOf(i))), cividis(range.position(alpha))) > 4;
        }
        return wrong;
    }
};

} // namespace

TEST_CASE("Colours: quality and spacing exclude each other") {
    ColouredSquare driver;
    driver.platform().show(true); // this legend belongs to what is drawn
    driver.workspace(WorkspaceKind::Size);
    REQUIRE(driver.visible("size"));
    driver.unfoldLayers();
    driver.settle();
    CHECK(driver.has("canvas/legend/size"));
    driver.click("layer/quality");
    CHECK(driver.visible("quality"));
    CHECK_FALSE(driver.visible("size"));
    CHECK(driver.has("canvas/legend/quality"));
    CHECK_FALSE(driver.has("canvas/legend/size"));
    driver.click("layer/size");
    CHECK(driver.visible("size"));
    CHECK_FALSE(driver.visible("quality"));
    driver.click("layer/size"); // neither
    CHECK_FALSE(driver.visible("size"));
    CHECK_FALSE(driver.visible("quality"));
}

TEST_CASE("Colours: every element has the colour of its quality in the legend, in both themes") {
    ColouredSquare driver;
    showLayer(driver.context().layers, "quality", true);
    const ColourRange fitted = driver.context().judgement->fitted;
    REQUIRE(fitted.from > 0.6); // a good mesh
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        driver.context().settings.theme = theme;
        driver.context().view.measureRange.reset();
        CHECK(driver.wronglyColoured(fitted) == 0);
        driver.context().view.measureRange = ColourRange{0.2, 0.99};
        CHECK(driver.wronglyColoured({0.2, 0.99}) == 0);
    }
}

TEST_CASE("Colours: the range fits the mesh and ignores a few bad elements") {
    const auto fitted = [](Measure measure, const std::vector<double> &values) {
        return fittedRange(measure, summarise(values));
    };
    std::vector<double> good(980, 0.99);
    good.insert(good.end(), 20, 0.91);
    CHECK(fitted(Measure::ShapeFactor, good) == ColourRange{0.9, 1.0});
    std::vector<double> withOneBad = good;
    withOneBad.push_back(0.08);
    CHECK(fitted(Measure::ShapeFactor, withOneBad) == ColourRange{0.9, 1.0});
    std::vector<double> poor = good;
    poor.insert(poor.end(), 500, 0.26);
    CHECK(fitted(Measure::ShapeFactor, poor) == ColourRange{0.25, 1.0});
    const ColourRange perfect = fitted(Measure::ShapeFactor, std::vector<double>(10, 1.0));
    CHECK(perfect.to - perfect.from >= 0.049);
    std::vector<double> growth(999, 1.2);
    growth.push_back(5000.0);
    CHECK(fitted(Measure::AreaRatio, growth).to < 2.0);
    CHECK(fitted(Measure::SizeRatio, {0.5, 1.0, 1.2}).from == doctest::Approx(0.5));
    CHECK(fitted(Measure::SizeRatio, {0.5, 1.0, 1.2}).to == doctest::Approx(2.0));
}

TEST_CASE("Colours: good values are bright and bad ones dark, and the middle of a diverging map is neutral") {
    const auto brightness = [](Colour colour) { return colour.r + colour.g + colour.b; };
    for (const Measure measure : valuesOf<Measure>()) {
        CAPTURE(wordOf(measure));
        const ColourMap map = mapOf(measure);
        if (infoOf(measure).bad == BadEnd::Low) {
            CHECK(brightness(map(1.0)) > 2 * brightness(map(0.0)));
        } else if (infoOf(measure).bad == BadEnd::High && measure != Measure::Valence) {
            CHECK(brightness(map(0.0)) > 2 * brightness(map(1.0)));
        } else if (infoOf(measure).bad == BadEnd::FarFromOne) {
            CHECK(map(0.5) == rgb(0xf7f7f7));
        }
    }
    CHECK(mapPosition(Measure::SizeRatio, {0.5, 2.0}, 1.0) == doctest::Approx(0.5));
    CHECK(mapPosition(Measure::Region, {}, 3.0) == mapPosition(Measure::Region, {}, 11.0));
}

TEST_CASE("Colours: the user can set the quality range in the histogram, and fit it again") {
    ColouredSquare driver;
    driver.unfoldLayers();
    driver.click("layer/quality");
    driver.showPanel("histogram");
    driver.settle();
    driver.click("histogram/from");
    driver.key('A', {Modifiers::kControl});
    driver.type("0.3");
    driver.key(key::kTab);
    driver.settle();
    REQUIRE(driver.context().view.measureRange);
    CHECK(*driver.context().view.measureRange == ColourRange{0.3, 1.0});
    driver.click("histogram/to");
    driver.key('A', {Modifiers::kControl});
    driver.type("0.2"); // below the other end
    driver.key(key::kTab);
    driver.settle();
    CHECK(*driver.context().view.measureRange == ColourRange{0.3, 1.0});
    CHECK(driver.logHas("bad-range"));
    driver.click("histogram/fit");
    CHECK_FALSE(driver.context().view.measureRange);
}

TEST_CASE("Colours: fine spacing is bright and coarse spacing blue, the same in both themes") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document graded = driver.document();
    graded.spacing.expression = "0.1 + 0.4*abs(x - 2)";
    driver.context().document.apply(std::move(graded), "Spacing");
    driver.key('V');
    driver.key(key::kEscape);
    showLayer(driver.context().layers, "lattice", false);
    showLayer(driver.context().layers, "size", true);
    driver.moveTo({5, 5});
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        driver.context().settings.theme = theme;
        driver.context().animate();
        driver.settle();
        const SpacingField &spacing = *driver.context().preview->spacing;
        const Driver::Picture picture = driver.picture();
        const double minimum = std::log(spacing.minimum()), span = std::log(spacing.maximum()) - minimum;
        for (const Vec2 place : {Vec2{2.6, 4.3}, {3.3, 4.3}, {5.2, 4.3}, {8.7, 4.3}}) {
            CAPTURE(place.x);
            const Colour expected = spacingColour((std::log(spacing.at(place)) - minimum) / span);
            CHECK(difference(colourAt(picture, driver.pixel(place)), expected) <= 6);
        }
    }
    CHECK(spacingColour(0.0) == viridis(1.0));
}

TEST_CASE("Colours: the edges of a dense mesh fade and leave the quality colours unchanged") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document fine = driver.document();
    fine.spacing.size = 0.06; // about 35,000 elements
    driver.context().document.apply(std::move(fine), "Size");
    driver.key('V');
    driver.key(key::kEscape);
    driver.key(key::kF5);
    driver.settle();
    for (const char *layer : {"front", "candidates", "tests", "labels", "grid", "boundary"}) {
        showLayer(driver.context().layers, layer, false);
    }
    showLayer(driver.context().layers, "quality", true);
    View &view = driver.context().view;
    view.zoomAt(driver.canvas().centre(), 0.35); // an element is about 1.5 pixels high
    driver.moveTo({5, 5});
    driver.context().animate();
    driver.settle();
    const Driver::Picture withEdges = driver.picture();
    showLayer(driver.context().layers, "mesh", false);
    driver.context().animate();
    driver.settle();
    const Driver::Picture without = driver.picture();
    const Pixel from = driver.pixel({1.5, 7.5}), to = driver.pixel({8.5, 1.5});
    CHECK(withEdges.differences(without, {from.x, from.y, to.x - from.x, to.y - from.y}) == 0);
}

TEST_CASE("Legend: numbers are plain") {
    CHECK(logarithmicTicks(0.05, 140.0, 5).back().text == "140");
    CHECK(logarithmicTicks(0.05, 140.0, 5).front().text == "0.05");
    CHECK(logarithmicTicks(20.0, 123456.0, 5).back().text == "123456");
    const auto ticks = linearTicks({0.85, 1.0});
    CHECK(ticks.front().text == "\xe2\x89\xa4"
                                "0.85");
    CHECK(ticks.back().text == "1");
    REQUIRE(ticks.size() > 2);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        CHECK(ticks[i].at > ticks[i - 1].at);
    }
}

} // namespace forefront::test
