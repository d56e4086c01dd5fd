#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/constraint_glyphs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::test {
namespace sketch_canvas {

/// A quadrilateral whose lower side is horizontal and 5 long, and whose right side is vertical.
class CanvasSketcher : public Draughtsman {
  public:
    CanvasSketcher() {
        polygon({{1, 1}, {6, 1.4}, {5.7, 5}, {1.2, 4.6}});
        key('V');
        key(key::kEscape);
        add(ConstraintKind::Horizontal, {{1, SketchPartKind::Segment, 0}});
        add(ConstraintKind::Vertical, {{1, SketchPartKind::Segment, 1}});
        add(ConstraintKind::Length, {{1, SketchPartKind::Segment, 0}});
        context().selection.clear();
        moveToPlace({9.5, 9.5});
        settle();
    }
    void add(ConstraintKind kind, std::vector<SketchPart> parts) {
        CHECK(context().applyCommand(addConstraint(document(), kind, std::move(parts)), "Add"));
    }
    std::uint32_t idOf(ConstraintKind kind) {
        for (const auto &constraint : document().constraints) {
            if (constraint->kind == kind) {
                return constraint->id;
            }
        }
        return 0;
    }
    std::string glyph(ConstraintKind kind) { return "sketch/" + std::to_string(idOf(kind)) + "/0"; }
    Pixel middle(const std::string &widget) {
        const PixelRect rect = context().widgets.find(widget)->rect;
        return {rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height};
    }
    bool labelHas(std::string_view text) {
        const auto &labels = editor().canvas().labels();
        return std::any_of(labels.begin(), labels.end(), [&](const CanvasPainter::Placed &label) {
            return label.text.find(text) != std::string::npos;
        });
    }
    Vec2 at(std::size_t node) { return document().shapes[0]->nodes[node]; }
};

} // namespace sketch_canvas

using sketch_canvas::CanvasSketcher;

TEST_CASE("Sketch on the canvas: each constraint has a glyph or a value, none on another") {
    CanvasSketcher driver;
    std::vector<PixelRect> rects;
    for (const ConstraintKind kind : {ConstraintKind::Horizontal, ConstraintKind::Vertical, ConstraintKind::Length}) {
        REQUIRE(driver.has(driver.glyph(kind)));
        rects.push_back(driver.context().widgets.find(driver.glyph(kind))->rect);
    }
    for (std::size_t i = 0; i < rects.size(); ++i) {
        for (std::size_t k = i + 1; k < rects.size(); ++k) {
            CHECK_FALSE(rects[i].overlaps(rects[k]));
        }
    }
    // Two more on the same side stand beside the first one.
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 0}});
    driver.settle();
    CHECK(driver.has(driver.glyph(ConstraintKind::Fixed)));
    showLayer(driver.context().layers, "sketch", false);
    driver.settle();
    CHECK_FALSE(driver.has(driver.glyph(ConstraintKind::Length)));
}

TEST_CASE("Sketch on the canvas: a click selects a constraint, Delete removes it in one step") {
    CanvasSketcher driver;
    driver.clickAt(driver.middle(driver.glyph(ConstraintKind::Vertical)));
    driver.settle();
    CHECK(driver.context().selection.constraints == std::set<std::uint32_t>{driver.idOf(ConstraintKind::Vertical)});
    CHECK(driver.context().selection.size() == 1);
    CHECK(driver.has("inspector/sketch"));
    driver.key(key::kDelete);
    driver.settle();
    CHECK(driver.document().constraints.size() == 2);
    CHECK(driver.idOf(ConstraintKind::Vertical) == 0);
    CHECK(driver.document().shapes.size() == 1);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.document().constraints.size() == 3);
}

TEST_CASE("Sketch on the canvas: a double-click edits a value in place; an invalid text stays with its reason") {
    CanvasSketcher driver;
    const std::string value = driver.glyph(ConstraintKind::Length);
    const auto edit = [&](const std::string &text) {
        driver.clickAt(driver.middle(value));
        driver.clickAt(driver.middle(value));
        driver.settle();
        REQUIRE(driver.has("dimension/value"));
        driver.key('A', {Modifiers::kControl});
        driver.type(text);
        driver.key(key::kEnter);
        driver.frames(30);
        driver.settle();
    };
    edit("4");
    CHECK_FALSE(driver.has("dimension"));
    CHECK(distance(driver.at(0), driver.at(1)) == doctest::Approx(4.0));
    CHECK(driver.undoLabel() == "Change Length 1");
    Result<Document> named = setParameters(driver.document(), {{"w", "9"}});
    REQUIRE(named.ok());
    driver.context().document.apply(*std::move(named), "Parameters");
    driver.settle();
    edit("w/2");
    CHECK(distance(driver.at(0), driver.at(1)) == doctest::Approx(4.5));
    CHECK(driver.document().formulas.size() == 1);
    CHECK(dimensionText(driver.document(), *driver.document().constraints.back()) == "w/2 = 4.5");
    edit("-3");
    CHECK(driver.has("dimension/fault"));
    CHECK(driver.context().dimensionEntry.text == "-3");
    CHECK(distance(driver.at(0), driver.at(1)) == doctest::Approx(4.5));
    driver.key('A', {Modifiers::kControl}); // the field still has the focus
    driver.type("3");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(distance(driver.at(0), driver.at(1)) == doctest::Approx(3.0));
    CHECK(driver.document().formulas.empty());
}

TEST_CASE("Sketch on the canvas: a dragged value stays where it was put, in one step") {
    CanvasSketcher driver;
    const std::shared_ptr<const Document> before = driver.context().document.current();
    const Pixel from = driver.middle(driver.glyph(ConstraintKind::Length));
    const Pixel to = from + Pixel(30, 40);
    driver.drag(from, to);
    driver.settle();
    CHECK(driver.document().shapes == before->shapes);
    REQUIRE(driver.document().constraints.back()->label);
    CHECK(glm::distance(driver.middle(driver.glyph(ConstraintKind::Length)), to) < 4.0);
    CHECK(driver.undoLabel() == "Place Length 1");
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.context().document.current()->constraints == before->constraints);
}

TEST_CASE("Sketch on the canvas: a free node that is dragged snaps exactly to a node") {
    CanvasSketcher driver;
    Shape line;
    line.form = formOf(ShapeKind::Polyline);
    line.use = ShapeUse::Constraint;
    line.nodes = {{8, 8}, {9, 8.5}};
    driver.context().applyCommand(addShapes(driver.document(), {line}), "Add");
    driver.context().selection.nodes = {{1, 2}};
    driver.settle();
    driver.press(driver.pixel(driver.at(2)));
    driver.moveToPlace({7, 7});
    driver.moveToPlace({8, 8});
    driver.frames(2);
    driver.release(driver.pixel({8, 8}));
    driver.settle();
    CHECK(driver.at(2) == Vec2{8, 8});
    CHECK(driver.at(1).x == doctest::Approx(8.0));
}

TEST_CASE("Sketch on the canvas: a determined node stays, and its typed place is refused, with what holds it") {
    CanvasSketcher driver;
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 0}});
    driver.context().selection.nodes = {{1, 1}};
    driver.settle();
    const Vec2 from = driver.at(1);
    driver.press(driver.pixel(from));
    driver.moveToPlace(from + Vec2{0.5, 0.5});
    driver.moveToPlace(from + Vec2{1.0, 1.5});
    driver.frames(2);
    CHECK(driver.labelHas("held by Length 1 and Fixed 1"));
    driver.release(driver.pixel(from + Vec2{1.0, 1.5}));
    driver.settle();
    CHECK(distance(driver.at(1), from) < 1e-9);
    driver.fill("inspector/at/x", "9");
    CHECK(distance(driver.at(1), from) < 1e-9);
    CHECK(driver.logHas("constraint-conflict"));
    driver.key(key::kEscape);
    driver.press(driver.pixel(from)); // the same for a distance and an angle that are typed while it is dragged
    driver.moveToPlace(from + Vec2{0.5, 0.5});
    driver.moveToPlace(from + Vec2{1.0, 1.5});
    driver.frames(2);
    driver.type("2");
    driver.key(key::kTab);
    driver.type("90");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(distance(driver.at(1), from) < 1e-9);
    CHECK(driver.logHas("refused"));
    CHECK(driver.context().log.entries().back().diagnostic.message.find("Fixed 1") != std::string::npos);
    driver.release(driver.pixel(from));
}

TEST_CASE("Sketch on the canvas: the status bar and the legend say what is free") {
    CanvasSketcher driver;
    REQUIRE(driver.has("status/sketch"));
    CHECK(driver.has("canvas/legend/sketch"));
    CHECK(driver.context().preview->sketch->degrees == 5);
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 0}});
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 2}});
    driver.add(ConstraintKind::Fixed, {{1, SketchPartKind::Node, 3}});
    driver.settle();
    CHECK(driver.context().preview->sketch->degrees == 0);
    for (const auto &constraint : std::vector(driver.document().constraints)) {
        driver.context().applyCommand(removeConstraints(driver.document(), {constraint->id}), "Remove");
    }
    driver.settle();
    CHECK_FALSE(driver.has("status/sketch"));
    CHECK_FALSE(driver.has("canvas/legend/sketch"));
}

TEST_CASE("Inference on the canvas: a nearly horizontal side becomes horizontal, and a constraint if that is on") {
    Draughtsman driver;
    driver.context().snapping.infers = true;
    driver.context().snapping.toGrid = false;
    const Pixel lift{0, -4}; // in pixels
    const auto draw = [&] {
        driver.key('L');
        driver.clickPlace({2, 2});
        driver.clickAt(driver.pixel({6, 2}) + lift);
        driver.frames(30);
        driver.key(key::kEnter);
        driver.settle();
    };
    draw();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes[1].y == driver.document().shapes[0]->nodes[0].y);
    CHECK(driver.document().constraints.empty());
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    driver.context().snapping.addsConstraints = true;
    draw();
    REQUIRE(driver.document().constraints.size() == 1);
    CHECK(driver.document().constraints[0]->kind == ConstraintKind::Horizontal);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.document().shapes.empty()); // shape and constraint are one step
    CHECK(driver.document().constraints.empty());
    driver.context().snapping.infers = false;
    draw();
    CHECK(driver.document().shapes[0]->nodes[1].y != driver.document().shapes[0]->nodes[0].y);
}

TEST_CASE("Guides: dragged out of a ruler, snapped to, moved and removed by a drag back") {
    Draughtsman driver;
    driver.context().settings.rulers = true;
    driver.context().snapping.toGrid = false;
    driver.settle();
    const PixelRect ruler = driver.context().widgets.find("canvas/ruler/y")->rect;
    const Pixel start{ruler.x + 0.5 * ruler.width, ruler.y + 0.5 * ruler.height};
    driver.drag(start, driver.pixel({3.3, 5}));
    driver.settle();
    REQUIRE(driver.document().guides.size() == 1);
    CHECK(driver.document().guides[0].upright);
    CHECK(driver.document().guides[0].at == doctest::Approx(3.3).epsilon(0.02));
    CHECK(driver.undoLabel() == "Add guide");
    const double at = driver.document().guides[0].at;
    driver.key('L');
    driver.clickAt(driver.pixel({at, 2}) + Pixel(4, 0));
    driver.frames(30);
    driver.clickPlace({6, 6});
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().shapes[0]->nodes[0].x == at);
    driver.key('V');
    driver.key(key::kEscape);
    driver.drag(driver.pixel({at, 8}), driver.pixel({at + 1, 8}));
    driver.settle();
    CHECK(driver.document().guides[0].at == doctest::Approx(at + 1).epsilon(0.02));
    driver.drag(driver.pixel({driver.document().guides[0].at, 8}), start);
    driver.settle();
    CHECK(driver.document().guides.empty());
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.document().guides.size() == 1);
}

} // namespace forefront::test
