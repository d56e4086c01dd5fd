#include "core/engine/base/vec2.hpp"
#include "tests/ui/colour_vision.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/edge_colour.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/style/spacing_tint.hpp"
#include "ui/workspace/judging.hpp"

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
        const ColourMap map = measureMap(context());
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < run().mesh->alpha.size(); ++i) {
            const double alpha = static_cast<double>(run().mesh->alpha[i]);
            wrong += alpha > 0.5 && difference(colourAt(shown, pixel(middleOf(i))), map(range.position(alpha))) > 4;
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
    View &view = driver.context().view;
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        driver.context().settings.theme = theme;
        for (const QualityScale scale : {QualityScale::Alarm, QualityScale::Cividis}) {
            view.scale = scale;
            view.measureRange.reset();
            view.fitRange = false;
            CHECK(driver.wronglyColoured({0.5, 1.0}) == 0); // the same for all meshes
            fitMeasureRange(driver.context());
            CHECK(driver.wronglyColoured(fitted) == 0);
            view.measureRange = ColourRange{0.2, 0.99};
            CHECK(driver.wronglyColoured({0.2, 0.99}) == 0);
        }
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

TEST_CASE("Colours: good values are quiet and bad ones loud on both grounds, also without seeing red and green") {
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        const Colour ground = makeTheme(theme).domain;
        for (const Measure measure : valuesOf<Measure>()) {
            CAPTURE(wordOf(measure));
            const ColourMap map = mapOf(measure, QualityScale::Alarm, theme);
            const BadEnd bad = infoOf(measure).bad;
            if (measure == Measure::SizeRatio || measure == Measure::Valence) {
                CHECK(apart(map(0.5), ground) < 15.0);
                CHECK(std::min(apart(map(0.0), ground), apart(map(1.0), ground)) > 45.0);
            } else if (bad == BadEnd::Low || bad == BadEnd::High) {
                const double good = bad == BadEnd::Low ? 1.0 : 0.0;
                CHECK(apart(map(good), ground) < 15.0);
                CHECK(apart(map(1.0 - good), ground) > 40.0);
                CHECK(apart(map(good), map(1.0 - good)) > 40.0);
            }
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

TEST_CASE("Colours: the limit in the legend is dragged, hatches what is beyond it, and is off at the end") {
    ColouredSquare driver;
    driver.platform().show(true);
    showLayer(driver.context().layers, "quality", true);
    chooseMeasure(driver.context(), Measure::MinAngle);
    driver.redrawn();
    REQUIRE(driver.has("canvas/limit"));
    const auto handle = [&] { return driver.context().widgets.find("canvas/limit")->rect.centre(); };
    const PixelRect legend = driver.context().widgets.find("canvas/legend/quality")->rect;
    const PixelRect bar = colourBarRect({legend.x + legend.width, legend.y + legend.height}, 1.0);
    CHECK(std::abs(handle().x - bar.x) < 1.5); // not set
    const Camera camera = driver.context().view.camera;
    const Driver::Picture before = driver.redrawn();
    driver.drag(handle(), {bar.x + bar.width * 40.0 / 45.0, bar.y});
    driver.settle();
    REQUIRE(driver.document().limits[MeshLimit::MinAngle]);
    CHECK(*driver.document().limits[MeshLimit::MinAngle] == doctest::Approx(55.0).epsilon(0.02));
    CHECK(driver.undoLabel() == "Set minimum angle");
    CHECK(driver.context().view.camera == camera);                      // the canvas below was not dragged
    CHECK(driver.redrawn().differences(before, driver.canvas()) > 500); // hatched
    driver.drag(handle(), {bar.x - 20.0, bar.y});
    driver.settle();
    CHECK_FALSE(driver.document().limits[MeshLimit::MinAngle]);
    CHECK_FALSE(driver.context().view.draggedLimit);
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
            const Colour expected =
                mix(driver.context().theme.domain, spacingColour((std::log(spacing.at(place)) - minimum) / span),
                    spacingTint(theme));
            CHECK(difference(colourAt(picture, driver.pixel(place)), expected) <= 6);
        }
    }
    CHECK(spacingColour(0.0) == viridis(1.0));
}

TEST_CASE("Colours: the finest part of a mesh never looks emptier than the coarsest") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document graded = driver.document();
    graded.spacing.expression = "0.015 + 0.06*max(0, x - 3)";
    driver.context().document.apply(std::move(graded), "Spacing");
    driver.key('V');
    driver.key(key::kEscape);
    driver.key(key::kF5);
    driver.settle();
    for (const char *layer : {"front", "candidates", "tests", "labels", "grid", "boundary", "size"}) {
        showLayer(driver.context().layers, layer, false);
    }
    driver.moveTo({5, 5});
    for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
        driver.context().settings.theme = theme;
        driver.context().animate();
        driver.settle();
        const Driver::Picture picture = driver.picture();
        const Theme &t = driver.context().theme;
        // How much the edges change the light of the faces, on the mean.
        const auto ink = [&](Vec2 low, Vec2 high) {
            const Pixel from = driver.pixel({low.x, high.y}), to = driver.pixel({high.x, low.y});
            double sum = 0.0, count = 0.0;
            for (double y = from.y; y < to.y; y += 1.0) {
                for (double x = from.x; x < to.x; x += 1.0) {
                    sum += luminance(colourAt(picture, {x, y}));
                    count += 1.0;
                }
            }
            return std::abs(sum / count - luminance(t.element));
        };
        const double coarse = ink({7.5, 3}, {8.8, 7});
        double before = coarse;
        CHECK(coarse > 0.0);
        for (const double x : {5.5, 4.5, 3.6, 1.2}) { // ever finer, down to a pixel
            CAPTURE(x);
            const double here = ink({x, 3}, {x + 0.8, 7});
            CHECK(here >= coarse);
            before = here;
        }
        CHECK(before >= 1.5 * coarse);
    }
}

TEST_CASE("Colours: the edges of a dense mesh cover the colours of its quality evenly") {
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
    std::size_t checked = 0, wrong = 0;
    for (double y = from.y; y < to.y; y += 7.0) {
        for (double x = from.x; x < to.x; x += 7.0) {
            const Colour face = colourAt(without, {x, y});
            wrong += difference(colourAt(withEdges, {x, y}), mix(face, edgeOn(face), 0.25)) > 8 ? 1U : 0U;
            ++checked;
        }
    }
    REQUIRE(checked > 200);
    CHECK(wrong < checked / 20); // where two elements meet in a pixel
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
