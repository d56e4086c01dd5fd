#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::test;

namespace {

void chooseMode(Draughtsman &driver, const std::string &mode) {
    driver.click("options/brush/mode");
    driver.settle();
    driver.click("options/brush/mode/" + mode);
    driver.settle();
}

} // namespace

TEST_CASE("Hide, isolate, lock: hidden shapes stay in the domain but are neither drawn nor picked") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.rectangle({3, 3}, {5, 5});
    driver.key('V');
    driver.key('H', kControl);
    CHECK(driver.document().shapes[1]->hidden);
    CHECK(driver.context().selection.empty());
    CHECK(toDomain(driver.document()).segments.size() == 8);
    driver.clickPlace({3, 4});
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1}); // inside the outer one
    driver.key('H', kControlShift);
    CHECK_FALSE(driver.document().shapes[1]->hidden);
    driver.clickPlace({3, 4});
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{2});
    driver.key('I', kAlt);
    CHECK(driver.document().shapes[0]->hidden);
    CHECK_FALSE(driver.document().shapes[1]->hidden);
    driver.key('Z', kControl);
    CHECK_FALSE(driver.document().shapes[0]->hidden);
    driver.key('L', kControl);
    CHECK(driver.document().shapes[1]->locked);
    driver.key('A', kControl);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1});
    driver.dragPlaces({3, 4}, {4, 6});
    CHECK(boundsOf(*driver.document().shapes[1]) == Box2{{3, 3}, {5, 5}});
    driver.key('L', kAlt);
    CHECK_FALSE(driver.document().shapes[1]->locked);
}

TEST_CASE("Lock: undoing an unlock deselects the shape; the Names panel skips hidden and locked shapes") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.rectangle({3, 3}, {5, 5});
    driver.key('V');
    driver.key('L', kControl);
    driver.key('L', kAlt);
    driver.clickPlace({3, 4});
    REQUIRE(driver.context().selection.shapes == std::set<std::uint32_t>{2});
    driver.key('Z', kControl);
    driver.settle();
    CHECK(driver.document().shapes[1]->locked);
    CHECK(driver.context().selection.empty());
    driver.key(key::kDelete);
    CHECK(driver.document().shapes.size() == 2);
    driver.showPanel("names");
    driver.settle();
    driver.click("names/boundary/1/select");
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1});
}

TEST_CASE("Selection: no command, undo or step through the history leaves a locked shape selected, panels or not") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.rectangle({3, 3}, {5, 5});
    driver.key('V');
    driver.key('L', kControl); // both are unlocked again in one step
    driver.key('L', kAlt);
    driver.key(key::kTab); // hides the panels
    driver.settle();
    REQUIRE_FALSE(driver.context().view.panels);
    Shell &context = driver.context();
    context.selection.shapes = {1, 2};
    context.selection.nodes = {{2, 1}};
    context.selection.segments = {{2, 1}};
    SUBCASE("undo") {
        driver.key('Z', kControl);
    }
    SUBCASE("history") {
        context.document.goTo(context.document.history().position() - 1);
    }
    SUBCASE("command") {
        context.document.apply(*setLocked(driver.document(), {2}, true), "Lock shape");
    }
    CHECK(driver.document().shapes[1]->locked);
    CHECK(context.selection.shapes == std::set<std::uint32_t>{1});
    CHECK(context.selection.size() == 1);
}

TEST_CASE("Context menu: a right click selects the item under the pointer and offers its actions") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    driver.key('V');
    driver.key(key::kEscape);
    const Pixel side = driver.pixel({3, 1});
    driver.moveTo(side);
    driver.press(side, MouseButton::Right);
    driver.release(side, MouseButton::Right);
    driver.settle();
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1});
    REQUIRE(driver.has("contextmenu"));
    CHECK_FALSE(driver.has("contextmenu/edit.union"));
    driver.click("contextmenu/shape.mirrorX");
    driver.settle();
    CHECK_FALSE(driver.has("contextmenu"));
    CHECK(driver.undoLabel() == "Mirror left-right");
}

TEST_CASE("Context menu: opens with an empty selection and while a drawing tool is active; Esc closes it") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    const Pixel empty = driver.pixel({8, 8});
    driver.moveTo(empty);
    driver.press(empty, MouseButton::Right);
    driver.release(empty, MouseButton::Right);
    driver.settle();
    REQUIRE(driver.has("contextmenu"));
    CHECK(driver.has("contextmenu/edit.selectAll"));
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.has("contextmenu"));
    driver.key('P');
    driver.clickPlace({6, 6});
    driver.clickPlace({9, 6});
    driver.clickPlace({9, 9});
    driver.press(driver.pixel({7, 8}), MouseButton::Right); // finishes the polygon
    driver.release(driver.pixel({7, 8}), MouseButton::Right);
    driver.settle();
    CHECK_FALSE(driver.has("contextmenu"));
    CHECK(driver.document().shapes.size() == 2);
}

TEST_CASE("Context menu: in a tool that does not show the selection, it does not act on one") {
    Draughtsman driver;
    for (const char tool : {'P', 'M', 'R'}) {
        CAPTURE(tool);
        driver.rectangle({1, 1}, {5, 5});
        driver.key(tool);
        const Pixel empty = driver.pixel({8, 8});
        driver.moveTo(empty);
        driver.press(empty, MouseButton::Right);
        driver.release(empty, MouseButton::Right);
        driver.settle();
        REQUIRE(driver.has("contextmenu"));
        for (const char *action : {"edit.cut", "edit.delete", "shape.hide"}) {
            CHECK_FALSE(driver.has(std::string("contextmenu/") + action));
        }
        CHECK(driver.has("contextmenu/edit.paste"));
        driver.key(key::kEscape);
        driver.settle();
    }
}

TEST_CASE("Select: the buttons of its options stay in place when something is selected") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    driver.key('V');
    const auto places = [&] {
        driver.settle();
        const auto &widgets = driver.context().widgets;
        return std::pair(widgets.find("options/delete")->rect.x, widgets.find("options/picks")->rect.x);
    };
    const auto selected = places();
    driver.key(key::kEscape);
    CHECK(places() == selected);
}

TEST_CASE("Select: picks only the chosen kinds of items") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 5});
    driver.key('V');
    driver.clickPlace({5, 5});
    REQUIRE(driver.context().selection.nodes.size() == 1);
    driver.click("options/picks");
    driver.settle();
    driver.click("picks/nodes");
    CHECK(driver.context().selection.empty());
    driver.key(key::kEscape);
    driver.settle();
    driver.clickPlace({5, 5});
    CHECK(driver.context().selection.nodes.empty());
    CHECK(driver.context().selection.shapes.size() == 1);
    driver.click("options/picks");
    driver.settle();
    driver.click("picks/shapes");
    driver.key(key::kEscape);
    driver.settle();
    driver.clickPlace({5, 3});
    driver.dragPlaces({0, 0}, {9, 9});
    CHECK(driver.context().selection.empty());
}

TEST_CASE("Brush: finer and coarser scale the current spacing; a stroke is one undo step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.settle();
    driver.key('B');
    chooseMode(driver, "Finer");
    CHECK_FALSE(driver.has("options/brush/spacing"));
    const double before = driver.context().preview->spacing->at({5, 5});
    driver.dragPlaces({4, 5}, {6, 5});
    driver.settle();
    CHECK(driver.undoLabel() == "Make spacing finer");
    CHECK(driver.context().preview->spacing->at({5, 5}) < before);
    driver.key('Z', kControl);
    CHECK(driver.document().spacing.paint.tiles.empty());
}

TEST_CASE("Brush: smooth and erase are modes of the brush; strength and falloff are options") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.settle();
    driver.key('B');
    driver.fill("options/brush/falloff", "0");
    driver.dragPlaces({4, 5}, {6, 5});
    driver.fill("options/brush/spacing", "0.02");
    driver.dragPlaces({4, 5.5}, {6, 5.5}); // gives the next stroke something to smooth
    chooseMode(driver, "Smooth");
    driver.fill("options/brush/strength", "0.5");
    driver.dragPlaces({4, 5}, {6, 5});
    CHECK(driver.undoLabel() == "Smooth spacing");
    chooseMode(driver, "Erase");
    CHECK_FALSE(driver.has("options/brush/strength"));
    driver.fill("options/brush/radius", "3");
    driver.dragPlaces({4, 5}, {6, 5});
    driver.settle();
    CHECK(driver.undoLabel() == "Erase spacing");
    CHECK(driver.context().preview->spacing->sample({5, 5}).origin != SpacingOrigin::Paint);
}

TEST_CASE("Brush: coarser enlarges automatic sizes, smooth evens them out, and one undo takes each back") {
    Draughtsman driver;
    Shape channel; // between two rooms
    channel.nodes = {{1, 1}, {4, 1}, {4, 4.9}, {6, 4.9}, {6, 1}, {9, 1},
                     {9, 9}, {6, 9}, {6, 5.1}, {4, 5.1}, {4, 9}, {1, 9}};
    driver.context().document.apply(*addShape(driver.document(), channel), "Draw");
    driver.settle();
    const auto rho = [&](Vec2 at) { return driver.context().preview->spacing->at(at); };
    const Vec2 coarse{7.5, 7.5}, narrow{5, 5};
    const double before = rho(coarse), tight = rho(narrow);
    driver.key('B');
    driver.fill("options/brush/radius", "1.2");
    chooseMode(driver, "Coarser");
    for (int k = 0; k < 3; ++k) {
        driver.dragPlaces({7, 7.5}, {8, 7.5});
        driver.settle();
    }
    CHECK(driver.undoLabel() == "Make spacing coarser");
    CHECK(rho(coarse) > 1.2 * before);
    CHECK(driver.context().preview->spacing->sample(coarse).origin != SpacingOrigin::Automatic);
    chooseMode(driver, "Smooth");
    driver.dragPlaces({4.8, 5}, {5.2, 5});
    driver.settle();
    CHECK(driver.undoLabel() == "Smooth spacing");
    CHECK(rho(narrow) > 1.1 * tight);
    driver.key('Z', kControl);
    driver.settle();
    CHECK(rho(narrow) == doctest::Approx(tight));
    driver.key('2');
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
}

TEST_CASE("Polygon: as a spline through clicked points, or freehand with its corners") {
    Draughtsman driver;
    driver.key('P');
    driver.click("options/pen/Spline");
    for (const Vec2 point : {Vec2{2, 2}, Vec2{8, 2}, Vec2{8, 7}, Vec2{2, 7}}) {
        driver.clickPlace(point);
    }
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    const Shape &smooth = *driver.document().shapes[0];
    CHECK(smooth.nodes.size() == 4);
    REQUIRE(smooth.path().curves.size() == 4);
    CHECK(smooth.path().curves[3].kind() == CurveKind::Cubic);
    CHECK(areaOf(smooth) > 30.0);
    driver.key('Z', kControl);
    driver.key('P');
    driver.click("options/pen/Freehand");
    driver.moveToPlace({2, 2});
    driver.press(driver.pixel({2, 2}));
    for (const Vec2 corner : {Vec2{8, 2}, Vec2{8, 7}, Vec2{2, 7}}) {
        for (int k = 1; k <= 10; ++k) {
            const Vec2 from = corner == Vec2{8, 2} ? Vec2{2, 2} : corner == Vec2{8, 7} ? Vec2{8, 2} : Vec2{8, 7};
            driver.moveToPlace(lerp(from, corner, 0.1 * k));
        }
    }
    driver.release(driver.pixel({2, 7}));
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(driver.document().shapes[0]->nodes.size() == 4);
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(30.0).epsilon(0.02));
}

TEST_CASE("Polygon: a freehand loop becomes smooth curves, or corners as chosen") {
    Draughtsman driver;
    REQUIRE(driver.context().snapping.toGrid); // which gives the loop no corner
    const auto draw = [&] {
        driver.key('P');
        const auto at = [&](int k) {
            return driver.canvas().centre() + 150.0 * Pixel(std::cos(0.06 * k), std::sin(0.06 * k));
        };
        driver.moveTo(at(0));
        driver.press(at(0));
        for (int k = 1; k < 104; ++k) {
            driver.moveTo(at(k));
        }
        driver.release(at(104));
        driver.settle();
        return *driver.document().shapes.back();
    };
    driver.key('P');
    driver.click("options/pen/Freehand");
    const double radius = driver.context().view.camera.length(150.0), disc = std::numbers::pi * radius * radius;
    const Shape smooth = draw();
    CHECK(smooth.kind() == ShapeKind::Polygon);
    CHECK(smooth.nodes.size() >= 2);
    CHECK(smooth.nodes.size() <= 8);
    REQUIRE(smooth.path().curves.size() == smooth.nodes.size());
    for (std::size_t k = 0; k < smooth.nodes.size(); ++k) {
        CHECK(smooth.path().curves[k].kind() == CurveKind::Cubic);
        CHECK(nodeKind(smooth, static_cast<std::uint32_t>(k)) != NodeKind::Corner);
    }
    CHECK(areaOf(smooth) == doctest::Approx(disc).epsilon(0.03));
    CHECK(driver.undoLabel() == "Draw polygon");
    driver.key('Z', kControl);
    driver.key('P');
    driver.click("options/freehand/Corners");
    const Shape straight = draw();
    CHECK(straight.path().curves.empty());
    CHECK(straight.nodes.size() > 10);
    driver.key('L');                      // a line with a corner in its middle
    driver.click("options/pen/Freehand"); // each tool has a mode of its own
    driver.click("options/freehand/Smooth");
    const Pixel middle = driver.canvas().centre();
    driver.moveTo(middle + Pixel(-100, 0));
    driver.press(middle + Pixel(-100, 0));
    for (int k = -99; k <= 100; k += 3) {
        driver.moveTo(middle + Pixel(k, std::abs(k) - 100));
    }
    driver.release(middle + Pixel(100, 0));
    driver.settle();
    const Shape &line = *driver.document().shapes.back();
    CHECK(line.kind() == ShapeKind::Polyline);
    CHECK(line.use == ShapeUse::Constraint);
    CHECK(line.nodes.size() == 3);
    CHECK(line.path().curves.empty());
}

TEST_CASE("Polygon: a freehand loop closes where it began; undo while drawing cancels it") {
    Draughtsman driver;
    driver.key('P');
    driver.click("options/pen/Freehand");
    const std::vector<Vec2> corners{{2, 2}, {8, 2}, {8, 7}, {2, 7}, {2, 2}};
    const auto draw = [&](std::size_t sides) {
        driver.moveToPlace(corners[0]);
        driver.press(driver.pixel(corners[0]));
        for (std::size_t side = 0; side < sides; ++side) {
            for (int k = 1; k <= 10; ++k) {
                driver.moveToPlace(lerp(corners[side], corners[side + 1], 0.1 * k));
            }
        }
    };
    draw(4);
    driver.release(driver.pixel(corners[0]));
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes.size() == 4);
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(30.0).epsilon(0.02));
    driver.key('Z', kControl);
    driver.key('P');
    draw(2);
    driver.key('Z', kControl);
    driver.release(driver.pixel(corners[2]));
    driver.settle();
    CHECK(driver.document().shapes.empty());
    driver.clickPlace({5, 5});
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Inspector: size and growth of a shape are those of its segments; they leave its tag alone") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.click("inspector/segmentgrowth");
    CHECK_FALSE(ImGui::GetIO().WantTextInput); // without a size there is nothing to grow
    driver.fill("inspector/segmentsize", "0.1");
    const auto sizes = [&] { return driver.document().shapes[0]->segmentSizes; };
    REQUIRE(sizes().size() == 4);
    CHECK(sizes().at(3) == SegmentSize{.size = 0.1, .elements = 0, .growth = 0.2});
    CHECK(driver.undoLabel() == "Change size of segment");
    CHECK(driver.document().shapes[0]->segmentTags.empty());
    CHECK(driver.document().spacing.partSizes.empty());
    driver.settle();
    CHECK(driver.context().preview->spacing->at({5, 1}) == doctest::Approx(0.1));
    CHECK(driver.context().preview->spacing->sample({5, 1}).describe.find("size of a segment") != std::string::npos);
    driver.fill("inspector/segmentgrowth", "0.5");
    CHECK(sizes().at(0).growth == 0.5);
    driver.click("inspector/segmentsize");
    driver.key('A', kControl);
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(sizes().empty());
}

TEST_CASE("Inspector: size and growth of a named boundary are added to the spacing and removed again") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.settle();
    CHECK_FALSE(driver.has("inspector/partsize")); // nobody has named it
    driver.context().document.apply(*setBoundaryName(driver.document(), 1, "wall"), "Name");
    driver.settle();
    driver.fill("inspector/partsize", "0.1");
    REQUIRE(driver.document().spacing.partSizes.contains(1));
    CHECK(driver.document().spacing.partSizes.at(1) == PartSize{0.1, 0.2});
    CHECK(driver.undoLabel() == "Change size of boundary part");
    driver.settle();
    CHECK(driver.context().preview->spacing->sample({5, 1}).describe.find("size of 'wall'") != std::string::npos);
    driver.fill("inspector/partgrowth", "0.5");
    CHECK(driver.document().spacing.partSizes.at(1).growth == 0.5);
    driver.click("inspector/partsize");
    driver.key('A', kControl);
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().spacing.partSizes.empty());
}

TEST_CASE("Inspector: a tag that is no whole number above 0 is reported beside its field") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {8, 8});
    driver.key('V');
    driver.settle();
    for (const char *bad : {"0", "2.5", "-3"}) {
        driver.fill("inspector/tag", bad);
        CHECK(driver.document().shapes[0]->tag == 1);
        CHECK(driver.has("inspector/tag/fault"));
    }
    CHECK(driver.logHas("bad-tag"));
    driver.fill("inspector/tag", "3");
    CHECK(driver.document().shapes[0]->tag == 3);
    driver.key('G');
    driver.settle();
    driver.fill("options/region/tag", "0");
    CHECK(driver.has("options/region/tag/fault"));
}
