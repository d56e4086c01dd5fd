#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

std::uint32_t draw(Draughtsman &driver, Shape shape) {
    const auto next = addShapes(driver.document(), {std::move(shape)});
    REQUIRE(next.ok());
    driver.context().document.apply(*next, "Draw");
    driver.key('V');
    driver.settle();
    return driver.document().shapes.back()->id;
}

Shape triangle() {
    Shape shape;
    shape.nodes = {{2, 2}, {6, 2}, {2, 4}};
    return shape;
}

} // namespace

TEST_CASE("Inspector: the radii of an ellipse are fields") {
    Draughtsman driver;
    Shape ellipse;
    ellipse.form = EllipseForm{};
    ellipse.nodes = {{5, 5}, {7, 5}, {5, 6}};
    driver.context().selection.shapes = {draw(driver, ellipse)};
    driver.settle();
    driver.fill("inspector/radii/x", "3");
    driver.fill("inspector/radii/y", "0.5");
    const Shape &now = *driver.document().shapes[0];
    CHECK(distance(now.nodes[0], now.nodes[1]) == doctest::Approx(3));
    CHECK(distance(now.nodes[0], now.nodes[2]) == doctest::Approx(0.5));
    driver.fill("inspector/radii/x", "-1");
    CHECK(distance(driver.document().shapes[0]->nodes[0], driver.document().shapes[0]->nodes[1]) == doctest::Approx(3));
}

TEST_CASE("Inspector: the role of a shape and the kind of a node are switches") {
    Draughtsman driver;
    const std::uint32_t id = draw(driver, triangle());
    driver.context().selection.shapes = {id};
    driver.settle();
    driver.click("inspector/use/Inner line");
    driver.settle();
    CHECK(driver.document().shapes[0]->use == ShapeUse::Constraint);
    CHECK(driver.undoLabel() == "Change role");
    driver.context().selection.clear();
    driver.context().selection.nodes = {{id, 0}};
    driver.settle();
    driver.click("inspector/nodekind/Symmetric");
    driver.settle();
    CHECK(nodeKind(*driver.document().shapes[0], 0) == NodeKind::Symmetric);
    driver.click("inspector/nodekind/Corner");
    driver.settle();
    CHECK(nodeKind(*driver.document().shapes[0], 0) == NodeKind::Corner);
}

TEST_CASE("Inspector: the maximum area of a region gives the mesh smaller elements there") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document drawing = driver.document();
    drawing.regionMarkers = {{{5, 5}, 1}};
    driver.context().document.apply(drawing, "Mark");
    driver.key('V');
    driver.settle();
    const double before = driver.context().preview->estimatedElements;
    driver.context().selection.clear();
    driver.context().selection.markers = {0};
    driver.settle();
    driver.fill("inspector/maxarea", "0.002");
    CHECK(driver.document().regionMarkers[0].maxArea == doctest::Approx(0.002));
    CHECK(driver.context().preview->estimatedElements > 2.0 * before);
    driver.click("inspector/maxarea");
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().regionMarkers[0].maxArea == 0.0);
}

TEST_CASE("Import: a drawing is multiplied by the number in the dialog") {
    const TemporaryFolder place;
    Draughtsman driver;
    draw(driver, triangle());
    REQUIRE(writeProject(place.path / "part.forefront", driver.document()).empty());
    driver.key('I', {Modifiers::kControl});
    driver.frames(5);
    driver.fill("dialog/import/name", (place.path / "part.forefront").string());
    driver.until([&] { return driver.has("dialog/importoptions/scale"); });
    driver.fill("dialog/importoptions/scale", "2.5");
    driver.click("dialog/importoptions/ok");
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(boundsOf(*driver.document().shapes[1]).size().x == doctest::Approx(10));
}

TEST_CASE("Preferences: the step of angles with Shift is set by a slider") {
    Draughtsman driver;
    driver.context().actions.run("edit.preferences", driver.context());
    driver.settle();
    driver.click("dialog/preferences/page/Snapping");
    driver.settle();
    driver.click("dialog/preferences/snap/angle");
    driver.settle();
    const double half = driver.context().snapping.angleStep;
    CHECK(half != 15.0);
    const auto *const slider = driver.context().widgets.find("dialog/preferences/snap/angle");
    REQUIRE(slider != nullptr);
    driver.drag(slider->rect.centre(), slider->rect.centre() - Pixel(0.2 * slider->rect.width, 0.0));
    driver.settle();
    CHECK(driver.context().snapping.angleStep < half);
}

TEST_CASE("Brush: paint is cleared from the options strip and from the spacing panel") {
    for (const bool inPanel : {false, true}) {
        CAPTURE(inPanel);
        Draughtsman driver;
        driver.rectangle({1, 1}, {9, 8});
        driver.key('B');
        driver.dragPlaces({3, 3}, {5, 5});
        driver.settle();
        REQUIRE_FALSE(driver.document().spacing.paint.tiles.empty());
        if (inPanel) {
            driver.showPanel("spacing");
        }
        driver.click(inPanel ? "spacing/clearpaint" : "options/brush/clear");
        driver.settle();
        CHECK(driver.document().spacing.paint.tiles.empty());
        CHECK(driver.undoLabel() == "Clear paint");
    }
}

TEST_CASE("Timeline: the slider of the speed makes the run faster towards the right") {
    Draughtsman driver;
    draw(driver, triangle());
    driver.key(key::kF5);
    driver.settle();
    driver.workspace(WorkspaceKind::Step);
    const auto *const slider = driver.context().widgets.find("timeline/speed");
    REQUIRE(slider != nullptr);
    const PixelRect at = slider->rect;
    driver.clickAt({at.x + 0.2 * at.width, at.centre().y});
    driver.settle();
    const double slow = driver.context().run.speed();
    driver.clickAt({at.x + 0.8 * at.width, at.centre().y});
    driver.settle();
    CHECK(driver.context().run.speed() > 10.0 * slow);
}

TEST_CASE("Background picture: a slider sets its opacity") {
    const TemporaryFolder place;
    Draughtsman driver;
    Document drawing = driver.document();
    drawing.picture = BackgroundPicture{place.path / "missing.png", {1, 1}, {6, 4}, 0.5, false};
    driver.context().document.apply(drawing, "Add picture");
    driver.click("tool/picture");
    driver.settle();
    const auto *const slider = driver.context().widgets.find("options/picture/opacity");
    REQUIRE(slider != nullptr);
    const PixelRect at = slider->rect;
    driver.drag(at.centre(), {at.x + 0.9 * at.width, at.centre().y});
    driver.settle();
    REQUIRE(driver.document().picture.has_value());
    CHECK(driver.document().picture->opacity > 0.7);
}

} // namespace forefront::test
