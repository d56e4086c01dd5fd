#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace forefront::test {

namespace {

Pixel knobAt(Draughtsman &driver, double t, const char *slider = "spacing/gradation/slider") {
    const PixelRect rect = driver.context().widgets.find(slider)->rect;
    return {rect.x + 6.0 + t * (rect.width - 12.0), rect.y + 0.5 * rect.height};
}

} // namespace

TEST_CASE(
    "Gradation: spacing, prediction and mesh follow the slider; a drag is one undo step and one line in the log") {
    Draughtsman driver;
    Shape channel; // between two rooms
    channel.nodes = {{1, 1}, {4, 1}, {4, 4.9}, {6, 4.9}, {6, 1}, {9, 1},
                     {9, 9}, {6, 9}, {6, 5.1}, {4, 5.1}, {4, 9}, {1, 9}};
    driver.context().document.apply(*addShape(driver.document(), channel), "Draw polygon");
    driver.showPanel("spacing");
    driver.context().settings.live = true;
    driver.settle();
    const auto rho = [&] { return driver.context().preview->spacing->at({3.5, 5}); };
    const double before = rho();
    const std::size_t lines = driver.context().log.entries().size();
    driver.press(knobAt(driver, 0.6));
    driver.moveTo(knobAt(driver, 0.3));
    driver.settle();
    const double gentle = rho();
    const double predicted = driver.context().preview->estimatedElements;
    CHECK(gentle < before);
    REQUIRE(driver.run().mesh != nullptr);
    const std::size_t elements = driver.run().mesh->mesh.elements.size();
    driver.moveTo(knobAt(driver, 0.9));
    driver.settle();
    CHECK(rho() > gentle);
    CHECK(driver.context().preview->estimatedElements < predicted);
    CHECK(driver.run().mesh->mesh.elements.size() < elements);
    driver.release(knobAt(driver, 0.9));
    driver.settle();
    CHECK(driver.context().log.entries().size() <= lines + 1);
    CHECK(driver.undoLabel() == "Change gradation");
    driver.press(knobAt(driver, 0.9)); // another gesture
    driver.moveTo(knobAt(driver, 0.5));
    driver.release(knobAt(driver, 0.5));
    driver.settle();
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(*driver.document().spacing.gradation > 0.4);
    driver.key('Z', {Modifiers::kControl});
    CHECK_FALSE(driver.document().spacing.gradation.has_value());
    CHECK(driver.undoLabel() == "Draw polygon");
}

TEST_CASE("Gradation: Esc takes back a drag of the slider") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    driver.key('V');
    driver.key(key::kEscape);
    driver.showPanel("spacing");
    driver.settle();
    driver.press(knobAt(driver, 0.6));
    driver.moveTo(knobAt(driver, 0.2));
    driver.frames(3);
    CHECK(driver.document().spacing.gradation.has_value());
    driver.context().selection = {.shapes = {1}};
    driver.key(key::kEscape);
    CHECK(driver.context().selection.size() == 1); // Esc means the slider alone
    driver.moveTo(knobAt(driver, 0.4));
    driver.frames(3);
    driver.release(knobAt(driver, 0.4));
    driver.frames(3);
    CHECK_FALSE(driver.document().spacing.gradation.has_value());
    CHECK(driver.undoLabel() == "Draw rectangle");
}

namespace {

/// Draws a square, and shows the Spacing panel with a live mesh.
void drawMeshedSquare(Draughtsman &driver) {
    driver.rectangle({1, 1}, {9, 9});
    driver.key('V');
    driver.key(key::kEscape);
    driver.showPanel("spacing");
    driver.context().settings.live = true;
    driver.settle();
}

std::size_t liveElements(Draughtsman &driver) {
    driver.settle();
    REQUIRE(driver.run().mesh != nullptr);
    return driver.run().mesh->mesh.elements.size();
}

} // namespace

TEST_CASE("Target: a typed number of elements scales the sizes in one undo step, finer and coarser") {
    Draughtsman driver;
    drawMeshedSquare(driver);
    const std::string before = driver.undoLabel();
    for (const double target : {900.0, 300.0, 2500.0}) {
        driver.fill("spacing/target", std::to_string(static_cast<int>(target)));
        CHECK(static_cast<double>(liveElements(driver)) == doctest::Approx(target).epsilon(0.05));
        CHECK(driver.undoLabel() == "Set number of elements");
        CHECK(driver.has("spacing/target/asked"));
    }
    driver.fill("spacing/size", "0.7"); // other sizes than those that were asked for
    CHECK_FALSE(driver.has("spacing/target/asked"));
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.has("spacing/target/asked"));
    for (int step = 0; step < 3; ++step) {
        driver.key('Z', {Modifiers::kControl});
    }
    CHECK(driver.undoLabel() == before);
}

TEST_CASE("Target: a minimum size is kept, and what holds the sizes is said") {
    Draughtsman driver;
    drawMeshedSquare(driver);
    driver.fill("spacing/minimum", "0.5");
    driver.fill("spacing/target", "5000");
    driver.settle();
    CHECK(driver.document().spacing.minimum == 0.5);
    CHECK(driver.logHas("missed-target"));
    driver.fill("spacing/target", "0.2");
    CHECK(driver.context().fieldFault.field == "spacing/target");
}

TEST_CASE("Target: a drag scales the sizes by the estimate, then by meshing, in one undo step; Esc takes it back") {
    Draughtsman driver;
    drawMeshedSquare(driver);
    constexpr const char *kSlider = "spacing/target/slider";
    const std::string before = driver.undoLabel();
    driver.press(knobAt(driver, 0.4, kSlider));
    driver.moveTo(knobAt(driver, 0.3, kSlider));
    const std::size_t fewer = liveElements(driver);
    driver.moveTo(knobAt(driver, 0.2, kSlider));
    CHECK(liveElements(driver) < fewer);
    driver.release(knobAt(driver, 0.2, kSlider));
    const double target = 100.0 * std::pow(1.0e4, 0.2);
    CHECK(static_cast<double>(liveElements(driver)) == doctest::Approx(target).epsilon(0.2)); // a pixel is 10 %
    CHECK_FALSE(driver.logHas("missed-target"));
    CHECK(driver.undoLabel() == "Set number of elements");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.undoLabel() == before);
    driver.press(knobAt(driver, 0.5, kSlider));
    driver.moveTo(knobAt(driver, 0.2, kSlider));
    driver.frames(3);
    CHECK(driver.undoLabel() == "Set number of elements");
    driver.key(key::kEscape);
    driver.release(knobAt(driver, 0.2, kSlider));
    driver.settle();
    CHECK(driver.undoLabel() == before);
}

} // namespace forefront::test
