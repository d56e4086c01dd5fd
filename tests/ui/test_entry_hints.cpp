#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/tools/common/drawing_tool.hpp"
#include "ui/tools/common/numeric_entry.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <string_view>

namespace forefront::test {

namespace {

/// Draws with one tool by numbers, and reads its hints.
struct Drawer : Draughtsman {
    explicit Drawer(std::string_view tool, PixelSize size = {1280, 800}) : Draughtsman({}, size) { use(tool); }
    void use(std::string_view tool) {
        context().tools.choose(tool, context());
        moveToPlace({5, 5});
        frames(3);
    }
    std::string hint() { return context().tools.current().statusText(context()); }
    std::string prompt() {
        frames(1);
        const auto *const tool = dynamic_cast<const DrawingTool *>(&context().tools.current());
        REQUIRE(tool != nullptr);
        return tool->typingPrompt();
    }
    bool says(std::string_view words) { return hint().find(words) != std::string::npos; }
    void pair(std::string_view first, std::string_view second) {
        keys(first);
        key(key::kTab);
        keys(second);
    }
    void enter() {
        key(key::kEnter);
        settle();
    }
};

} // namespace

TEST_CASE("Typed numbers: below them stands what Tab and Enter do next") {
    Drawer drawer("circle");
    CHECK(drawer.prompt().empty());
    drawer.keys("3");
    CHECK(drawer.prompt() == "Tab: y   Enter: keep x");
    drawer.key(key::kTab);
    drawer.keys("4");
    CHECK(drawer.prompt() == "Tab: x   Enter: place the centre");
    drawer.enter();
    CHECK(drawer.prompt().empty());
    CHECK(drawer.says("type the radius, Enter, or D, the diameter, Enter"));
    drawer.keys("2");
    CHECK(drawer.prompt() == "Enter: draw the circle");
    drawer.enter();
    REQUIRE(drawer.document().shapes.size() == 1);
    CHECK(drawer.document().shapes[0]->nodes[0] == Vec2{3, 4});
    CHECK(circleRadius(*drawer.document().shapes[0]) == 2.0);
}

TEST_CASE("Typed numbers: a pair says what Enter does, invalid text says nothing but its fault") {
    constexpr std::array kPlace{EntryField::X, EntryField::Y};
    NumericEntry entry;
    const auto type = [&](std::string_view text) {
        for (const char c : text) {
            entry.handle({.kind = CanvasEvent::Kind::Text, .character = static_cast<char32_t>(c)}, kPlace);
        }
    };
    type("3,4");
    CHECK(entry.prompt("place the node") == "Enter: place the node");
    entry.clear();
    type("3*");
    entry.handle({.kind = CanvasEvent::Kind::Key, .key = key::kEnter}, kPlace);
    REQUIRE(entry.isWrong());
    CHECK(entry.prompt("place the node").empty());
}

TEST_CASE("Hints: every tool that takes coordinates says so, with the key that enters them") {
    Drawer drawer("polygon");
    for (const char *tool : {"polygon", "polyline", "rectangle", "circle", "ellipse", "regular", "slot", "arc", "point",
                             "source", "gradient"}) {
        CAPTURE(tool);
        drawer.use(tool);
        CHECK(drawer.says("type x, Tab, y, Enter"));
        drawer.keys("2");
        CHECK(drawer.prompt().starts_with("Tab: y"));
        drawer.key(key::kEscape);
        drawer.key(key::kEscape);
    }
}

TEST_CASE("Hints: what they say of the next numbers is what these numbers do") {
    Drawer drawer("slot");
    drawer.pair("2", "3");
    drawer.enter();
    CHECK(drawer.says("length between the centres, Tab, angle, Enter"));
    drawer.pair("4", "0");
    CHECK(drawer.prompt() == "Tab: distance   Enter: place the second centre");
    drawer.enter();
    drawer.keys("1");
    CHECK(drawer.prompt() == "Enter: draw the slot");
    drawer.enter();
    REQUIRE(drawer.document().shapes.size() == 1);
    CHECK(boundsOf(*drawer.document().shapes[0]).size().x == doctest::Approx(6.0));

    drawer.use("ellipse");
    drawer.pair("1", "6");
    CHECK(drawer.prompt() == "Tab: x   Enter: place the first corner");
    drawer.enter();
    CHECK(drawer.says("opposite corner of its box, or type width, Tab, height, Enter"));
    drawer.pair("4", "2");
    CHECK(drawer.prompt() == "Tab: width   Enter: draw the ellipse");
    drawer.enter();
    REQUIRE(drawer.document().shapes.size() == 2);
    CHECK(boundsOf(*drawer.document().shapes[1]).size().x == doctest::Approx(4.0));

    drawer.use("regular");
    drawer.pair("8", "8");
    drawer.enter();
    CHECK(drawer.says("radius, Tab, angle, Enter"));
    drawer.keys("1");
    CHECK(drawer.prompt() == "Tab: angle   Enter: draw the polygon");
    drawer.enter();
    CHECK(drawer.document().shapes.size() == 3);

    drawer.use("source");
    drawer.pair("5", "5");
    CHECK(drawer.prompt() == "Tab: x   Enter: add the source");
    drawer.enter();
    CHECK(drawer.document().spacing.sources.size() == 1);
}

TEST_CASE("Hints: what does not fit into the options bar is left out by sentences") {
    Drawer drawer("ellipse", {1600, 900});
    const std::string whole = drawer.hint();
    REQUIRE(whole.find(". ") != std::string::npos);
    drawer.settle();
    REQUIRE(drawer.has("options/hint"));
    const PixelRect shown = drawer.context().widgets.find("options/hint")->rect;
    const PixelRect bar = drawer.context().widgets.find("options")->rect;
    CHECK(shown.x + shown.width <= bar.x + bar.width);
}

} // namespace forefront::test
