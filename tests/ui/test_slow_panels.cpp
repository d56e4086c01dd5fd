#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/slow_entry.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

/// Makes `document` the drawing, and selects something.
void showDrawn(Typist &typist, Document document, Selection selection) {
    typist.write("v");
    typist.finish();
    typist.context().document.apply(std::move(document), "Draw");
    typist.settle();
    selectParts(typist, std::move(selection));
}

/// Draws a polygon, and selects something of it.
void drawPolygon(Typist &typist, Selection selection) {
    Shape shape;
    shape.nodes = {{1, 1}, {6, 1}, {6, 5}, {1, 5}};
    Document document = *addShape(typist.document(), shape);
    showDrawn(typist, std::move(document), std::move(selection));
}

/// Selects a side of the typed rectangle.
void typedSide(Typist &typist) {
    selectedRectangle(typist);
    selectParts(typist, {.segments = {{1, 0}}});
}

void addSource(Typist &typist, SizeSource source) {
    typedRectangle(typist);
    typist.finish();
    Document document = typist.document();
    document.spacing.sources = {std::move(source)};
    showDrawn(typist, std::move(document), {.sources = {0}});
}

/// The panel of the limits that meshes must meet, of a meshed rectangle.
void judgeRectangle(Typist &typist) {
    meshedRectangle(typist);
    typist.workspace(WorkspaceKind::Judge);
    typist.settle();
}

} // namespace

TEST_CASE("Slow frames: the numbers of round shapes, slots and points in their panel") {
    expectSame("rectangle in its panel", [](Typist &typist) {
        selectedRectangle(typist);
        typist.touch("inspector/corner/x");
        tabbed(typist, "2");
        tabbed(typist, "3");
        tabbed(typist, "4");
        tabbed(typist, "4.5");
        enter(typist, "0.5");
        typist.write("v");
    });
    expectSame("diameter", [](Typist &typist) {
        typist.write("c");
        enter(typist, "5,5");
        enter(typist, "2");
        typist.write("v");
        typist.touch("inspector/radius");
        tabbed(typist, "3");
        enter(typist, "5");
        typist.write("v");
    });
    expectSame("ellipse in its panel", [](Typist &typist) {
        typist.write("k");
        tabbed(typist, "1");
        enter(typist, "2");
        tabbed(typist, "6");
        enter(typist, "3");
        typist.write("v");
        typist.touch("inspector/centre/x");
        tabbed(typist, "5");
        tabbed(typist, "4");
        tabbed(typist, "2.5");
        enter(typist, "1.25");
        typist.write("v");
    });
    expectSame("slot in its panel", [](Typist &typist) {
        typist.write("u");
        enter(typist, "1,1");
        tabbed(typist, "4");
        enter(typist, "0");
        enter(typist, "1");
        typist.write("v");
        typist.touch("inspector/centre/x");
        tabbed(typist, "2");
        tabbed(typist, "2.5");
        tabbed(typist, "6");
        tabbed(typist, "2.5");
        tabbed(typist, "5");
        enter(typist, "1.5");
        typist.write("v");
    });
    expectSame("point", [](Typist &typist) {
        Shape point;
        point.form = formOf(ShapeKind::Point);
        point.use = ShapeUse::Constraint;
        point.nodes = {{3, 3}};
        showDrawn(typist, *addShape(typist.document(), point), {.shapes = {1}});
        typist.touch("inspector/at/x");
        tabbed(typist, "4");
        enter(typist, "4.5");
        typeOver(typist, {{"inspector/nodesize", "0.2"}, {"inspector/nodegrowth", "0.3"}});
        typist.write("v");
    });
}

TEST_CASE("Slow frames: the numbers of sides and nodes in their panel") {
    expectSame("side of a rectangle", [](Typist &typist) {
        typedSide(typist);
        typist.touch("inspector/length");
        enter(typist, "7");
        typist.write("v");
    });
    expectSame("side of a rounded rectangle", [](Typist &typist) {
        selectedRectangle(typist);
        typist.touch("inspector/cornerradius");
        enter(typist, "0.5");
        typist.finish();
        selectParts(typist, {.segments = {{1, 0}}});
        typist.touch("inspector/length");
        enter(typist, "7");
        typist.write("v");
    });
    expectSame("side of a polygon", [](Typist &typist) {
        drawPolygon(typist, {.segments = {{1, 0}}});
        typist.touch("inspector/length");
        enter(typist, "4");
        typist.write("v");
    });
    expectSame("arc of a path", [](Typist &typist) {
        Shape bow;
        bow.form = formOf(ShapeKind::Circle);
        bow.nodes = {{4, 4}, {6, 4}};
        Document document = *convertToPath(*addShape(typist.document(), bow), 1);
        showDrawn(typist, std::move(document), {.segments = {{1, 0}}});
        typist.touch("inspector/arcradius");
        enter(typist, "3");
        typist.write("v");
    });
    expectSame("node", [](Typist &typist) {
        drawPolygon(typist, {.nodes = {{1, 2}}});
        typist.touch("inspector/at/x");
        tabbed(typist, "7");
        enter(typist, "6");
        typist.write("v");
    });
    expectSame("size of a side", [](Typist &typist) {
        typedSide(typist);
        typist.touch("inspector/segmentsize");
        tabbed(typist, "0.25");
        typist.finish();
        typeOver(typist, "inspector/segmentgrowth", "0.4");
        typist.write("v");
    });
}

TEST_CASE("Slow frames: tags and names of boundaries and regions, and their sizes") {
    expectSame("boundary", [](Typist &typist) {
        typedSide(typist);
        typeOver(typist, "inspector/tag", "3");
        typist.touch("inspector/tag/name");
        tabbed(typist, "inlet");
        typist.finish();
        typeOver(typist, {{"inspector/partsize", "0.5"}, {"inspector/partgrowth", "0.4"}});
        typist.write("v");
    });
    expectSame("several boundaries", [](Typist &typist) {
        typedSide(typist);
        typeOver(typist, "inspector/tag", "3");
        typist.finish();
        selectParts(typist, {.segments = {{1, 0}, {1, 1}}});
        typist.touch("inspector/tag");
        enter(typist, "5");
        typist.write("v");
    });
    expectSame("region", [](Typist &typist) {
        typedRectangle(typist);
        typist.finish();
        Document document = typist.document();
        document.regionMarkers = {{{4, 4}, 2}};
        document.regionNames = {{2, "steel"}};
        showDrawn(typist, std::move(document), {.markers = {0}});
        typist.touch("inspector/at/x");
        tabbed(typist, "3");
        enter(typist, "3.5");
        typeOver(typist, {{"inspector/tag", "4"},
                          {"inspector/tag/name", "resin"},
                          {"inspector/maxarea", "0.2"},
                          {"inspector/regionsize", "0.3"},
                          {"inspector/regiongrowth", "0.35"}});
        typist.write("v");
    });
    expectSame("names", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("v");
        typist.showPanel("names");
        typist.touch("names/boundary/1");
        tabbed(typist, "wall");
        typist.write("v");
    });
}

TEST_CASE("Slow frames: sources, boundary layers and strips in their panel") {
    expectSame("box source", [](Typist &typist) {
        addSource(typist, {.shape = SourceShape::Box, .a = {2, 3}, .b = {4, 5}, .size = 0.5});
        typist.touch("inspector/name");
        tabbed(typist, "pier");
        for (const char *number : {"1.5", "2.5", "5", "6", "3", "2", "30"}) {
            tabbed(typist, number);
        }
        tabbed(typist, "0.25");
        enter(typist, "0.4");
        typist.write("v");
    });
    expectSame("line source", [](Typist &typist) {
        addSource(typist, {.shape = SourceShape::Line, .a = {2, 3}, .b = {4, 5}, .size = 0.5});
        typist.touch("inspector/a/x");
        for (const char *number : {"1.5", "2.5", "5", "6", "0.1", "0.25", "0.5"}) {
            tabbed(typist, number);
        }
        enter(typist, "0.4");
        typist.write("v");
    });
    expectSame("point source", [](Typist &typist) {
        addSource(typist, {.shape = SourceShape::Point, .a = {2, 3}, .size = 0.5});
        typist.touch("inspector/a/x");
        tabbed(typist, "3");
        enter(typist, "4");
        typist.write("v");
    });
    expectSame("growth and height of layers", [](Typist &typist) {
        typist.touch("workspace/Size");
        typedSide(typist);
        typeOver(typist, {{"inspector/layers/first", "0.02"},
                          {"inspector/layers/growth", "1.3"},
                          {"inspector/layers/thickness", "0.2"}});
        typist.write("v");
    });
}

TEST_CASE("Slow frames: limits, curvature and number of elements of the spacing") {
    expectSame("curves and limits", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("v");
        typist.showPanel("spacing");
        typeOver(typist, {{"spacing/across", "3"},
                          {"spacing/curvetolerance", "0.01"},
                          {"spacing/minimum", "0.1"},
                          {"spacing/maximum", "0.8"}});
        typist.write("v");
    });
    expectSame("target", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("v");
        typist.showPanel("spacing");
        replaceText(typist, "spacing/target", "900");
        typist.write("c");
        typist.finish();
        CHECK(typist.document().spacing.size.has_value());
    });
    expectSame("least angle", [](Typist &typist) {
        typedRectangle(typist);
        typist.finish();
        typist.workspace(WorkspaceKind::Mesh);
        typist.showPanel("meshing");
        typist.touch("meshing/leastangle");
        enter(typist, "20");
        typist.write("v");
    });
}

TEST_CASE("Slow frames: rules of the method, limits of checks and ranges of colours") {
    expectSame("rules", [](Typist &typist) {
        selectedRectangle(typist);
        Document document = typist.document();
        document.options.method = Method::Classic;
        document.options.rules.base = BaseRule::Random;
        showDrawn(typist, std::move(document), {});
        typist.workspace(WorkspaceKind::Step);
        typist.showPanel("rules");
        typeOver(typist, {{"rules/seed", "7"}, {"rules/minRho", "0.6"}, {"rules/maxRho", "2.5"}});
        typist.write("v");
        typist.finish();
        CHECK(typist.document().options.rules.seed == 7);
    });
    expectSame("checks", [](Typist &typist) {
        judgeRectangle(typist);
        typist.showPanel("checks");
        typist.touch("checks/min-angle");
        tabbed(typist, "30");
        tabbed(typist, "110");
        enter(typist, "0.7");
        typist.write("v");
        typist.finish();
        CHECK(typist.document().limits[MeshLimit::MinAngle] == 30.0);
    });
    expectSame("limit in the options bar", [](Typist &typist) {
        judgeRectangle(typist);
        typist.touch("options/judge/limit");
        enter(typist, "0.8");
        typist.write("v");
    });
    expectSame("limit of the legend", [](Typist &typist) {
        judgeRectangle(typist);
        REQUIRE(typist.has("canvas/limit"));
        const Pixel at = typist.context().widgets.find("canvas/limit")->rect.centre();
        typist.grab(typist.context().view.camera.toPlane(at), {60, 0});
        typist.drop();
        typist.write("c");
        typist.finish();
        CHECK(typist.document().limits[MeshLimit::MinAlpha].has_value());
    });
    expectSame(
        "range of colours",
        [](Typist &typist) {
            judgeRectangle(typist);
            typist.touch("options/judge/from");
            typist.tap('A', kControl);
            tabbed(typist, "0.5");
            enter(typist, "0.9");
            typist.write("v");
        },
        [](Typist &typist) {
            const auto &range = typist.context().view.measureRange;
            return range ? std::to_string(range->from) + " " + std::to_string(range->to) : std::string();
        });
}

TEST_CASE("Slow frames: values of constraints, in the panel and on the canvas") {
    const auto constrained = [](Typist &typist) {
        drawPolygon(typist, {});
        Result<Document> next =
            addConstraint(typist.document(), ConstraintKind::Length, {{1, SketchPartKind::Segment, 0}});
        REQUIRE(next);
        showDrawn(typist, *std::move(next), {});
    };
    expectSame("value of a constraint", [&](Typist &typist) {
        constrained(typist);
        const std::uint32_t id = typist.document().constraints.front()->id;
        selectParts(typist, {.constraints = {id}});
        replaceText(typist, "inspector/constraint/" + std::to_string(id), "6");
        typist.write("v");
    });
    expectSame("dimension on the canvas", [&](Typist &typist) {
        constrained(typist);
        const std::uint32_t id = typist.document().constraints.front()->id;
        const std::string glyph = "sketch/" + std::to_string(id) + "/0";
        typist.touch(glyph, 2);
        enter(typist, "4.5");
        typist.write("c");
        typist.finish();
        CHECK(typist.document().constraints.front()->value == 4.5);
    });
    expectSame("value of a new dimension", [](Typist &typist) {
        drawPolygon(typist, {});
        selectParts(typist, {.segments = {{1, 0}}});
        typist.tap('P', kControl);
        enter(typist, "dimension: length");
        enter(typist, "4.5");
        typist.write("c");
        typist.finish();
        CHECK(typist.document().constraints.front()->value == 4.5);
    });
    expectSame("lengths in other units", [](Typist &typist) {
        selectedRectangle(typist);
        typist.context().actions.run("edit.unit", typist.context());
        typist.settle();
        typist.touch("dialog/unit/unit/mm");
        typist.tap(key::kEnter);
        typist.finish();
        typist.touch("inspector/size/x");
        typist.tap('A', kControl);
        tabbed(typist, "1 in");
        enter(typist, "2 cm");
        typist.write("v");
        typist.finish();
        CHECK(typist.document().unit == LengthUnit::Millimetre);
        CHECK(boundsOf(*typist.document().shapes[0]).size() == Vec2{25.4, 20.0});
    });
}

TEST_CASE("Slow frames: factors and angles typed while a handle is dragged") {
    const auto outside = [](Typist &typist, Vec2 place, Pixel by) {
        return typist.context().view.camera.toPlane(typist.pixel(place) + by);
    };
    expectSame("factor of a handle", [&](Typist &typist) {
        selectedRectangle(typist);
        typist.grab(outside(typist, {7, 4.5}, {12, 0}), {30, 0});
        enter(typist, "1.5");
        typist.drop();
        typist.write("c");
        typist.finish();
        CHECK(boundsOf(*typist.document().shapes[0]).size().x == doctest::Approx(9.0));
    });
    expectSame("angle of a handle", [&](Typist &typist) {
        selectedRectangle(typist);
        typist.grab(outside(typist, {7, 7}, {26, -26}), {20, 20});
        enter(typist, "90");
        typist.drop();
        typist.write("c");
        typist.finish();
        CHECK(boundsOf(*typist.document().shapes[0]).size().x == doctest::Approx(5.0));
    });
    expectSame("distance of a drag", [&](Typist &typist) {
        drawPolygon(typist, {});
        selectParts(typist, {.shapes = {1}});
        typist.grab({6, 3}, {40, 10}); // the side, not a node
        tabbed(typist, "2");
        enter(typist, "0");
        typist.drop();
        typist.write("c");
    });
}

} // namespace forefront::test
