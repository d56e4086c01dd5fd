#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/spacing/spec/source_box.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/canvas_painter.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace forefront::test {

TEST_CASE("Brush: a stroke is one command that refines the spacing there, and the eraser removes it") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.settle();
    const double before = driver.context().preview->spacing->at({4, 4});
    driver.key('B');
    driver.dragPlaces({3, 4}, {5, 4});
    driver.settle();
    CHECK(driver.undoLabel() == "Paint spacing");
    CHECK_FALSE(driver.document().spacing.paint.tiles.empty());
    CHECK(driver.context().preview->spacing->at({4, 4}) < 0.6 * before);
    CHECK(driver.context().preview->spacing->sample({4, 4}).origin == SpacingOrigin::Paint);
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().spacing.paint.tiles.empty());
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    CHECK_FALSE(driver.document().spacing.paint.tiles.empty());
    driver.key('E');
    for (double y = 2.5; y <= 5.5; y += 0.5) {
        driver.dragPlaces({1.5, y}, {7, y});
    }
    driver.settle();
    CHECK(driver.context().preview->spacing->at({4, 4}) > 0.9 * before);
}

TEST_CASE("Brush: brackets change the radius, with Shift the spacing, and the options strip shows both") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('B');
    driver.click("options/brush/radius");
    driver.key('A', {Modifiers::kControl});
    driver.type("1");
    driver.key(key::kEnter);
    driver.click("options/brush/spacing");
    driver.key('A', {Modifiers::kControl});
    driver.type("0.05");
    driver.key(key::kEnter);
    driver.moveToPlace({5, 5});
    driver.key(key::kRightBracket);
    driver.key(key::kRightBracket, {Modifiers::kShift});
    driver.dragPlaces({5, 5}, {5, 5});
    driver.settle();
    // Steps are factors of 1.2: the stroke has a radius of 1.2 and paints 0.06.
    CHECK(driver.context().preview->spacing->at({5, 5}) == doctest::Approx(0.06).epsilon(0.02));
    CHECK(driver.context().preview->spacing->at({5, 5.7}) == doctest::Approx(0.06).epsilon(0.05));
    CHECK(driver.context().preview->spacing->at({5, 7.5}) > 0.1);
}

TEST_CASE("Brush: Ctrl+click picks the size under the pointer, Shift+click paints straight from the last stroke") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('B');
    driver.fill("options/brush/radius", "0.5");
    driver.fill("options/brush/spacing", "0.05");
    driver.dragPlaces({2, 2}, {2, 2});
    driver.settle();
    driver.fill("options/brush/spacing", "0.2");
    const auto spacingAt = [&](Vec2 place) { return driver.context().preview->spacing->at(place); };
    const std::string strokes = driver.undoLabel();
    driver.drag(driver.pixel({2, 2}), driver.pixel({2, 2}), 1, {Modifiers::kControl});
    CHECK(driver.undoLabel() == strokes); // nothing was painted
    driver.drag(driver.pixel({8, 2}), driver.pixel({8, 2}), 1, {Modifiers::kShift});
    driver.settle();
    for (const double x : {2.0, 3.5, 5.0, 6.5, 8.0}) {
        CAPTURE(x);
        CHECK(spacingAt({x, 2}) == doctest::Approx(0.05).epsilon(0.1)); // as picked
    }
    CHECK(spacingAt({5, 6}) > 0.2);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(spacingAt({5, 2}) > 0.1);
    CHECK(spacingAt({2, 2}) == doctest::Approx(0.05).epsilon(0.1));
}

TEST_CASE("Brush: until the first stroke its label says that the size is taken from under the pointer") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('B');
    driver.settle();
    driver.moveToPlace({5, 5});
    driver.frames(3);
    const auto saysSo = [&] {
        const auto &labels = driver.editor().canvas().labels();
        return std::any_of(labels.begin(), labels.end(),
                           [](const auto &label) { return label.text.ends_with(", 0.4 of the size here"); });
    };
    CHECK(saysSo());
    driver.dragPlaces({5, 5}, {6, 5});
    driver.settle();
    driver.moveToPlace({3, 3});
    driver.frames(3);
    CHECK_FALSE(saysSo());
}

TEST_CASE("Sources: placed by click and by drag, named, and the inspector says which one sets the spacing") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S');
    driver.clickPlace({3, 3});
    driver.click("options/source/shape/Circle");
    driver.dragPlaces({6, 5}, {7, 5});
    REQUIRE(driver.document().spacing.sources.size() == 2);
    CHECK(driver.document().spacing.sources[0].a == Vec2{3, 3});
    CHECK(driver.document().spacing.sources[1].radius == doctest::Approx(1));
    driver.settle();
    const SpacingSample sample = driver.context().preview->spacing->sample({6, 5});
    CHECK(sample.origin == SpacingOrigin::Source);
    CHECK(sample.describe.find("disc 2") != std::string::npos);
    // Drag the rim of the disc with the select tool.
    driver.key('V');
    driver.dragPlaces({6, 6}, {6, 6.6});
    CHECK(driver.document().spacing.sources[1].radius == doctest::Approx(1.6));
    CHECK(driver.undoLabel() == "Resize source");
}

TEST_CASE(
    "Sources and brush: what was proposed before the drawing got its size is proposed anew; what was typed stays") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S');
    driver.settle();
    driver.clickPlace({3, 3});
    driver.key('B');
    driver.dragPlaces({6, 6}, {7, 6});
    const double source = driver.document().spacing.sources[0].size;
    Document large = *scaleDocument(driver.document(), {0, 0}, 600.0); // as the calibration of a picture does
    large.spacing.paint = {};
    large.spacing.sources.clear();
    driver.context().document.apply(std::move(large), "Scale");
    driver.key('F');
    driver.settle();
    driver.key('S');
    driver.settle();
    const double rho = driver.context().preview->spacing->at({1800, 1800});
    driver.clickPlace({1800, 1800});
    const double now = driver.document().spacing.sources.back().size;
    CHECK(now > 100.0 * source);
    CHECK(now == doctest::Approx(0.25 * rho).epsilon(0.1));
    driver.clickPlace({3600, 3600}); // stays for the next one
    CHECK(driver.document().spacing.sources.back().size == now);
    driver.key('B');
    driver.settle();
    const double before = driver.context().preview->spacing->at({4500, 1500});
    driver.dragPlaces({4500, 1500}, {4500, 1500});
    driver.settle();
    const double painted = driver.context().preview->spacing->at({4500, 1500});
    CHECK(painted < 0.7 * before);
    CHECK(painted > 0.2 * before);

    driver.key('S');
    driver.settle();
    driver.fill("options/source/size", "77");
    driver.context().document.apply(*scaleDocument(driver.document(), {0, 0}, 10.0), "Scale");
    driver.key('F');
    driver.settle();
    driver.clickPlace({30000, 30000});
    CHECK(driver.document().spacing.sources.back().size == 77.0);
}

TEST_CASE("Sources: the size proposed for the first one stays for the next") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S');
    driver.clickPlace({3, 3});
    driver.settle();
    driver.clickPlace({3.2, 3});
    REQUIRE(driver.document().spacing.sources.size() == 2);
    CHECK(driver.document().spacing.sources[1].size == driver.document().spacing.sources[0].size);
}

TEST_CASE(
    "Sources: a line gets a size at its second end, when it is drawn or in the inspector; both ends are dragged") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S');
    CHECK_FALSE(driver.has("options/source/endsize")); // a point has no second end
    driver.click("options/source/shape/Line");
    driver.fill("options/source/size", "0.1");
    driver.fill("options/source/endsize", "0.3");
    driver.dragPlaces({2, 3}, {6, 3});
    REQUIRE(driver.document().spacing.sources.size() == 1);
    CHECK(driver.document().spacing.sources[0].size == 0.1);
    CHECK(driver.document().spacing.sources[0].endSize == 0.3);
    driver.settle();
    CHECK(driver.context().preview->spacing->at({4, 3}) == doctest::Approx(0.2));
    driver.key('V');
    driver.dragPlaces({6, 3}, {6, 7});
    CHECK(driver.document().spacing.sources[0].b == Vec2{6, 7});
    CHECK(driver.undoLabel() == "Move source");
    driver.dragPlaces({2, 3}, {2, 7});
    CHECK(driver.document().spacing.sources[0].a == Vec2{2, 7});
    driver.fill("inspector/endsize", "2*0.1");
    CHECK(driver.document().spacing.sources[0].endSize == doctest::Approx(0.2));
    CHECK(driver.undoLabel() == "Change source");
    driver.settle();
    CHECK(driver.context().preview->spacing->at({4, 7}) == doctest::Approx(0.15));
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().spacing.sources[0].endSize == 0.3);
    driver.fill("inspector/endsize", "-1");
    CHECK(driver.document().spacing.sources[0].endSize == 0.3);
    CHECK(driver.logHas("bad-source"));
    driver.click("inspector/endsize");
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.document().spacing.sources[0].endSize.has_value());
    CHECK(driver.context().preview->spacing->at({4, 7}) == doctest::Approx(0.1));
}

TEST_CASE("Sources: a box is drawn by a drag or with typed sizes, resized by its corners and moved by its sides") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S');
    driver.click("options/source/shape/Box");
    driver.fill("options/source/size", "0.1");
    driver.dragPlaces({2, 3}, {6, 5});
    REQUIRE(driver.document().spacing.sources.size() == 1);
    const auto source = [&]() -> const SizeSource & { return driver.document().spacing.sources[0]; };
    CHECK(source().shape == SourceShape::Box);
    CHECK(source().name == "box 1");
    CHECK(boxOf(source().a, source().b) == Box2{{2, 3}, {6, 5}});
    driver.settle();
    CHECK(driver.context().preview->spacing->at({4, 4}) == doctest::Approx(0.1));
    CHECK(driver.context().preview->spacing->sample({4, 4}).describe == "source 'box 1'");
    driver.key('V');
    driver.dragPlaces({6, 3}, {7, 2}); // a corner that is neither end of the drag
    CHECK(boxOf(source().a, source().b) == Box2{{2, 2}, {7, 5}});
    CHECK(driver.undoLabel() == "Resize source");
    driver.dragPlaces({4, 2}, {4, 3}); // a side
    CHECK(distance(SourceBox(source()).centre(), {4.5, 4.5}) < 1e-9);
    CHECK(driver.undoLabel() == "Move source");
    driver.fill("inspector/angle", "30");
    CHECK(source().angle == 30.0);
    driver.fill("inspector/b/x", "2*4");
    CHECK(source().b.x == 8.0);
    const Vec2 corner = source().a;
    driver.fill("inspector/extent/x", "3");
    CHECK(boxExtent(source()).x == doctest::Approx(3.0)); // along its angle
    CHECK(source().a == corner);
    // Width and height can be typed.
    driver.key('S');
    driver.clickPlace({3, 7});
    driver.type("2");
    driver.key(key::kTab);
    driver.type("0.5");
    driver.key(key::kEnter);
    REQUIRE(driver.document().spacing.sources.size() == 2);
    CHECK(driver.document().spacing.sources[1].b == Vec2{5, 7.5});
}

TEST_CASE("Sources: a first source refines automatic spacing near it, and the panel can let it replace the spacing") {
    Draughtsman driver;
    driver.context().snapping.toGrid = false;
    driver.polygon({{1, 1}, {9, 1}, {9, 8}, {5.05, 8}, {5.05, 2}, {5, 2}, {5, 8}, {1, 8}}); // with a narrow slit
    driver.settle();
    const Vec2 besideSlit{5.2, 5}, far{8, 7}, near{2, 3};
    const auto at = [&](Vec2 p) { return driver.context().preview->spacing->at(p); };
    const double slit = at(besideSlit), away = at(far), before = at(near);
    driver.key('S');
    driver.clickPlace(near);
    driver.settle();
    REQUIRE(driver.document().spacing.sources.size() == 1);
    CHECK(at(near) < 0.5 * before);
    CHECK(at(besideSlit) == slit);
    CHECK(at(far) == away);
    driver.showPanel("spacing");
    driver.click("spacing/keepautomatic");
    driver.settle();
    CHECK(driver.document().spacing.keepAutomatic == false);
    CHECK(at(far) > 1.5 * away);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(at(far) == away);
    driver.fill("spacing/size", "0.5");
    CHECK_FALSE(driver.has("spacing/keepautomatic")); // a size replaces automatic spacing in any case
    CHECK(at(far) == 0.5);
}

TEST_CASE("Sources: the end size follows a parameter") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Document named = *setParameters(driver.document(), {{"h", "0.4"}});
    driver.context().document.apply(std::move(named), "Add parameter");
    driver.key('S');
    driver.click("options/source/shape/Line");
    driver.dragPlaces({2, 3}, {6, 3});
    driver.key('V');
    driver.fill("inspector/endsize", "h/2");
    CHECK(driver.document().spacing.sources[0].endSize == doctest::Approx(0.2));
    CHECK(driver.document().formulas.at("source/0/endSize"_number) == "h/2");
    driver.context().document.apply(*setParameters(driver.document(), {{"h", "1"}}), "Change parameter");
    CHECK(driver.document().spacing.sources[0].endSize == doctest::Approx(0.5));
}

TEST_CASE("Spacing panel: size, limits and expression; an invalid expression is explained with its position") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.showPanel("spacing");
    driver.click("spacing/size");
    driver.type("0.5");
    driver.key(key::kEnter);
    CHECK(driver.document().spacing.size == 0.5);
    driver.click("spacing/minimum");
    driver.type("0.125");
    driver.key(key::kEnter);
    CHECK(driver.document().spacing.minimum == 0.125);
    driver.click("spacing/expression");
    driver.type("0.1+*x");
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.document().spacing.expression.has_value());
    CHECK(driver.has("spacing/expression/fault"));
    CHECK(driver.context().fieldFault.text.starts_with("column 5: "));
    driver.click("spacing/expression");
    driver.key('A', {Modifiers::kControl});
    driver.type("0.1+0.1*abs(x)");
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("spacing/expression/fault"));
    CHECK(driver.context().preview->faults.empty());
    driver.click("spacing/size");
    driver.key('A', {Modifiers::kControl});
    driver.type("zero");
    driver.key(key::kEnter);
    CHECK(driver.document().spacing.size == 0.5);
    CHECK(driver.logHas("bad-number"));
}

TEST_CASE("Inspector: fields do not move as the pointer approaches them") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.polygon({{3, 3}, {3.5, 3}, {3.5, 3.5}, {3, 3.5}});
    driver.key('V');
    driver.key(key::kEscape);
    driver.workspace(WorkspaceKind::Size);
    driver.moveToPlace({3.25, 2.95}); // "automatic: length of a segment of 'boundary_1' at ..." takes two lines
    driver.frames(3);
    const double over = driver.context().widgets.find("spacing/size")->rect.y;
    driver.moveTo({1150, 100});
    driver.frames(3);
    CHECK(driver.context().widgets.find("spacing/size")->rect.y == over);
}

TEST_CASE("Inspector: the runner-up of the node spacing stands below the winner, and nothing moves") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key(key::kEscape);
    Document sized = driver.document();
    sized.spacing = {};
    sized.spacing.size = 1.0;
    driver.context().document.apply(std::move(sized), "Size");
    driver.workspace(WorkspaceKind::Size);
    driver.moveToPlace({3, 3});
    driver.frames(3);
    CHECK_FALSE(driver.has("inspector/runnerup")); // there is one rule
    const double spacing = driver.context().widgets.find("spacing/size")->rect.y;
    Document source = driver.document();
    source.spacing.sources.push_back({SourceShape::Point, {3, 3}, {}, 0.0, 0.25, 0.25, "pier head"});
    driver.context().document.apply(std::move(source), "Source");
    driver.settle();
    driver.moveToPlace({3.5, 3});
    driver.frames(3);
    REQUIRE(driver.has("inspector/runnerup"));
    const PixelRect winner = driver.context().widgets.find("inspector/here")->rect,
                    next = driver.context().widgets.find("inspector/runnerup")->rect;
    CHECK(next.y >= winner.y + winner.height - 1.0);
    CHECK(next.width > 20.0);
    CHECK(driver.context().widgets.find("spacing/size")->rect.y == spacing); // what is worked with stays in place
}

TEST_CASE("Inspector: reports an error in the spacing, but none for an empty drawing") {
    Draughtsman driver;
    REQUIRE(driver.has("inspector/here"));
    CHECK_FALSE(driver.has("inspector/fault"));
    driver.rectangle({1, 1}, {9, 8});
    driver.settle();
    CHECK_FALSE(driver.has("inspector/fault"));
    Document faulty = driver.document();
    faulty.spacing.expression = "0.1+*x";
    driver.context().document.apply(std::move(faulty), "Change spacing");
    driver.settle();
    CHECK(driver.context().preview->spacing == nullptr);
    CHECK(driver.has("inspector/fault"));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.has("inspector/fault"));
}

TEST_CASE("Checks: a self-crossing polygon is a fault with a location; Repair fixes it as one command") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 8}, {9, 1}, {1, 8}});
    driver.settle();
    REQUIRE(driver.context().preview->faults.size() >= 1);
    REQUIRE(driver.context().preview->faults.front().at.has_value());
    driver.showPanel("checks");
    driver.click("checks/goto/0");
    CHECK(distance(driver.context().view.camera.centre, *driver.context().preview->faults.front().at) < 2.0);
    driver.click("checks/repair");
    driver.settle();
    CHECK(driver.context().preview->faults.empty());
    CHECK(driver.undoLabel() == "Repair drawing");
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Source tool: a new source does not get the name of another one") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {8, 8});
    driver.key('S');
    driver.clickPlace({2, 2});
    driver.clickPlace({4, 4});
    driver.key('V');
    driver.clickPlace({2, 2});
    driver.key(key::kDelete);
    REQUIRE(driver.document().spacing.sources.size() == 1);
    driver.key('S');
    driver.clickPlace({6, 6});
    REQUIRE(driver.document().spacing.sources.size() == 2);
    CHECK(driver.document().spacing.sources[0].name == "point 2");
    CHECK(driver.document().spacing.sources[1].name == "point 3");
}

} // namespace forefront::test
