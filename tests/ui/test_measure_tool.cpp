#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/tools/look/measure_tool.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

namespace {

struct Measurer : Draughtsman {
    Measurer() {
        Shape square;
        square.form = RectangleForm{};
        square.nodes = {{1, 1}, {9, 8}};
        Shape hole;
        hole.form = CircleForm{};
        hole.nodes = {{3, 4}, {4, 4}};
        Shape slope;
        slope.form = PathForm{.closed = false};
        slope.nodes = {{5, 3}, {8, 6}};
        slope.use = ShapeUse::Constraint;
        context().document.apply(*addShapes(Document(), {square, hole, slope}), "Draw");
        key('M');
        settle();
    }
    void choose(const char *mode) {
        click(std::string("options/measure/mode/") + mode);
        settle();
    }
    std::string reading() { return dynamic_cast<const MeasureTool &>(context().tools.current()).reading(context()); }
};

} // namespace

TEST_CASE("Measure: the angle between two segments, and at the second of three points") {
    Measurer measurer;
    measurer.choose("Angle");
    measurer.clickPlace({6.5, 4.5}); // the slope
    measurer.clickPlace({6, 1});     // the bottom side
    CHECK(measurer.reading() == "\xe2\x88\xa0 45\xc2\xb0   supplement 135\xc2\xb0");
    measurer.clickPlace({9, 1});
    measurer.clickPlace({1, 1});
    measurer.clickPlace({1, 8});
    CHECK(measurer.reading() == "\xe2\x88\xa0 90\xc2\xb0");
    CHECK(measurer.context().tools.current().statusText(measurer.context()).find("Ctrl+C") != std::string::npos);
}

TEST_CASE("Measure: radius, diameter and circumference of a circle; area and perimeter of the face around it") {
    Measurer measurer;
    measurer.choose("Object");
    measurer.clickPlace({2, 4});
    CHECK(measurer.reading().starts_with("radius 1   diameter 2   circumference 6.283"));
    measurer.clickPlace({3, 4}); // inside the hole
    CHECK(measurer.reading().starts_with("area 3.14159   perimeter 6.28319"));
    Document inMetres = measurer.document();
    inMetres.unit = LengthUnit::Metre;
    measurer.context().document.apply(inMetres, "Set unit");
    measurer.settle();
    measurer.clickPlace({3, 4});
    CHECK(measurer.reading().starts_with("area 3.14159 m\xc2\xb2   perimeter 6.28319 m"));
    measurer.key('Z', {Modifiers::kControl});
    measurer.settle();
    measurer.clickPlace({8, 2});
    CHECK(measurer.reading().starts_with("area 52.8584   perimeter 36.2832"));
    measurer.clickPlace({0.2, 0.2});
    CHECK(measurer.reading().empty());
    CHECK(measurer.context().tools.current().statusText(measurer.context()).starts_with("No face"));
}

TEST_CASE("Measure: Ctrl+C and the menu copy the values") {
    Measurer measurer;
    measurer.clickPlace({1, 1});
    measurer.clickPlace({9, 1});
    measurer.key('C', kControl);
    measurer.settle();
    CHECK(measurer.platform().clipboard().starts_with("8 "));
    const Pixel at = measurer.pixel({5, 5});
    measurer.press(at, MouseButton::Right);
    measurer.release(at, MouseButton::Right);
    measurer.settle();
    REQUIRE(measurer.has("contextmenu/edit.copy"));
    measurer.click("contextmenu/copy/\xce\x94x");
    measurer.settle();
    CHECK(measurer.platform().clipboard() == "8");
}

TEST_CASE("Measure tool: Backspace, Esc and undo take back a segment that was picked for an angle") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {8, 8});
    driver.key('M');
    driver.settle();
    driver.click("options/measure/mode/Angle");
    const auto picked = [&] {
        return driver.context().tools.current().statusText(driver.context()) == "Click the second segment";
    };
    for (const int code : {static_cast<int>(key::kBackspace), static_cast<int>(key::kEscape), static_cast<int>('Z')}) {
        CAPTURE(code);
        driver.clickPlace({3, 1});
        CHECK(picked());
        driver.key(code, code == 'Z' ? kControl : Modifiers{});
        driver.settle();
        CHECK_FALSE(picked());
        CHECK(driver.document().shapes.size() == 1);
    }
}

} // namespace forefront::test
