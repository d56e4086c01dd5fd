#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace forefront::test {

namespace {

/// A rectangle with named sides and a region.
struct Namer : Draughtsman {
    Namer() {
        Shape square;
        square.form = RectangleForm{};
        square.nodes = {{1, 1}, {9, 8}};
        Document document = *addShape(Document(), square);
        document = *setSegmentTag(document, {{1, 0}}, 3);
        document = *setBoundaryName(*setBoundaryName(document, 3, "inlet"), 1, "wall");
        document = *setRegionName(*addRegionMarker(document, {{5, 4}, 2, 0.0}), 2, "steel");
        context().document.apply(std::move(document), "Draw");
        key('V');
        settle();
    }
    void rightClick(Vec2 place) {
        press(pixel(place), MouseButton::Right);
        release(pixel(place), MouseButton::Right);
        settle();
    }
    void doubleClick(std::string_view widget) {
        const Pixel at = context().widgets.find(widget)->rect.centre();
        frames(30); // so that clicks before do not count
        clickAt(at);
        clickAt(at);
        settle();
    }
    void retype(std::string_view text) {
        key('A', kControl);
        type(text);
        key(key::kEnter);
        settle();
    }
    const std::vector<std::int32_t> &tags() { return document().shapes[0]->segmentTags; }
};

} // namespace

TEST_CASE("Naming: a double-click on a label renames that boundary part, or all parts with its tag") {
    Namer namer;
    REQUIRE(namer.has("label/boundary/1/0"));
    namer.doubleClick("label/boundary/1/0");
    REQUIRE(namer.has("naming"));
    CHECK(namer.has("naming/choice/wall"));
    namer.retype("inflow");
    CHECK_FALSE(namer.has("naming"));
    CHECK(namer.document().boundaryNames.at(3) == "inflow");
    CHECK(namer.context().document.history().position() == 2); // one step after the drawing
    namer.doubleClick("label/region/0");
    REQUIRE(namer.has("naming"));
    namer.retype("water");
    CHECK(namer.document().regionNames.at(2) == "water");
}

TEST_CASE("Naming: Esc leaves the field and changes nothing; a click elsewhere applies what was typed") {
    Namer namer;
    const std::uint64_t before = namer.context().document.revision();
    namer.doubleClick("label/boundary/1/0");
    namer.type("other");
    namer.key(key::kEscape);
    namer.settle();
    CHECK_FALSE(namer.has("naming"));
    CHECK(namer.context().document.revision() == before);
    namer.doubleClick("label/boundary/1/0");
    namer.key('A', kControl);
    namer.type("other");
    namer.clickPlace({0.2, 9.7});
    namer.settle();
    CHECK_FALSE(namer.has("naming"));
    CHECK(namer.document().boundaryNames.at(3) == "other");
}

TEST_CASE("Naming: several selected segments get a tag at once, from the list of names or as a number") {
    Namer namer;
    namer.context().selection.segments = {{1, 1}, {1, 2}};
    namer.key('T', kShift);
    namer.settle();
    REQUIRE(namer.has("naming/name"));
    namer.click("naming/choice/inlet");
    namer.settle();
    CHECK(namer.tags() == std::vector<std::int32_t>{3, 3, 3, 1});
    CHECK(namer.undoLabel() == "Name boundary");
    namer.key('Z', kControl);
    CHECK(namer.tags() == std::vector<std::int32_t>{3, 1, 1, 1});
    namer.key('T', kShift);
    namer.settle();
    namer.retype("7");
    CHECK(namer.tags() == std::vector<std::int32_t>{3, 7, 7, 1});
    namer.key('T', kShift);
    namer.settle();
    namer.key(key::kDown); // the first name of the list
    namer.key(key::kEnter);
    namer.settle();
    CHECK(namer.tags() == std::vector<std::int32_t>{3, 1, 1, 1});
}

TEST_CASE("Naming: the menu of a segment sets its tag, F2 names a shape on the canvas") {
    Namer namer;
    namer.rightClick({5, 8});
    REQUIRE(namer.has("contextmenu/segmentTag"));
    namer.click("contextmenu/segmentTag");
    namer.settle();
    REQUIRE(namer.has("naming/name"));
    namer.retype("roof");
    CHECK(namer.tags() == std::vector<std::int32_t>{3, 1, 4, 1});
    CHECK(namer.document().boundaryNames.at(4) == "roof");
    namer.context().selection = {.shapes = {1}};
    namer.key(key::kF1 + 1);
    namer.settle();
    REQUIRE(namer.has("naming/name"));
    namer.retype("plate");
    CHECK(namer.document().shapes[0]->name == "plate");
}

TEST_CASE("Naming: F2 on a shape whose boundary is one part names that part, and a switch offers the shape") {
    Draughtsman driver;
    driver.key('C');
    driver.dragPlaces({5, 5}, {7, 5});
    driver.key('V');
    const auto name = [&](std::string_view text) {
        driver.type(text);
        driver.key(key::kEnter);
        driver.settle();
    };
    driver.context().selection = {.shapes = {1}};
    driver.key(key::kF1 + 1);
    driver.settle();
    REQUIRE(driver.has("naming/thing/Boundary tag"));
    name("cylinder");
    const Shape &circle = *driver.document().shapes[0];
    CHECK(driver.document().boundaryNames.at(circle.tag) == "cylinder");
    CHECK(circle.name.empty());
    driver.key(key::kF1 + 1);
    driver.settle();
    driver.click("naming/thing/Shape name");
    driver.settle();
    REQUIRE(driver.has("naming/name"));
    name("rod");
    CHECK(driver.document().shapes[0]->name == "rod");
    CHECK(driver.document().boundaryNames.at(driver.document().shapes[0]->tag) == "cylinder");
    // A segment has no other name.
    driver.context().selection = {.segments = {{1, 0}}};
    driver.key(key::kF1 + 1);
    driver.settle();
    CHECK_FALSE(driver.has("naming/thing/Boundary tag"));
    name("hull");
    CHECK(driver.document().boundaryNames.at(driver.document().shapes[0]->tag) == "hull");
}

TEST_CASE("Naming: what was typed before the switch stays") {
    Namer namer; // whose sides have several tags: the shape comes first
    namer.context().selection = {.shapes = {1}};
    namer.key(key::kF1 + 1);
    namer.settle();
    REQUIRE(namer.has("naming/thing/Boundary tag"));
    namer.type("plate");
    namer.click("naming/thing/Boundary tag");
    namer.settle();
    CHECK(namer.context().naming.text == "plate");
    namer.key(key::kEnter);
    namer.settle();
    CHECK(namer.document().shapes[0]->name.empty());
    CHECK(namer.document().shapes[0]->segmentTags.empty());
    CHECK(namer.document().boundaryNames.at(namer.document().shapes[0]->tag) == "plate");
}

TEST_CASE("Naming: the field on the canvas closes when undo removes what it names, or another drawing is opened") {
    Namer namer;
    namer.rectangle({2, 2}, {3, 3});
    namer.key('V');
    namer.key('T', kShift);
    namer.settle();
    REQUIRE(namer.has("naming"));
    namer.key('Z', kControl); // the field has nothing to undo
    namer.settle();
    CHECK(namer.document().shapes.size() == 1);
    CHECK_FALSE(namer.has("naming"));
    namer.context().selection = {.shapes = {1}};
    namer.key('T', kShift);
    namer.settle();
    REQUIRE(namer.has("naming"));
    namer.context().document.load(Document(), "plate.forefront"); // as when a file is dropped on the window
    namer.settle();
    CHECK_FALSE(namer.has("naming"));
}

} // namespace forefront::test
