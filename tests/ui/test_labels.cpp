#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/canvas_painter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

using Labels = std::vector<CanvasPainter::Placed>;

/// Draws a plate with named sides, a hole, a line and dimensions, with everything selected, and returns the labels.
Labels labelsOf(Draughtsman &driver) {
    Document drawing = driver.document();
    const auto add = [&](ShapeKind kind, std::vector<Vec2> nodes, std::int32_t tag) {
        Shape shape;
        shape.id = drawing.nextId++;
        shape.form = formOf(kind);
        shape.nodes = std::move(nodes);
        shape.tag = tag;
        drawing.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
    };
    add(ShapeKind::Polygon, {{0.4, 0.4}, {9, 1}, {9.6, 7}, {5, 9.6}, {0.5, 8}}, 1);
    add(ShapeKind::Circle, {{3, 4}, {4, 4}}, 2);
    add(ShapeKind::Polygon, {{5, 3}, {8, 3}, {6.5, 6}}, 3);
    drawing.boundaryNames = {{1, "a rather long name of the plate"}, {2, "hole"}, {3, "triangle"}};
    drawing.regionMarkers.push_back({{2, 7}, 1, 0.0});
    drawing.regionNames = {{1, "steel"}};
    driver.context().document.apply(std::move(drawing), "Draw");
    showLayer(driver.context().layers, "labels", true);
    showLayer(driver.context().layers, "dimensions", true);
    driver.key('V');
    driver.key('A', {Modifiers::kControl});
    driver.settle();
    driver.frames(3);
    return driver.editor().canvas().labels();
}

bool inside(const PixelRect &rect, const PixelRect &room) {
    return rect.x >= room.x && rect.y >= room.y && rect.x + rect.width <= room.x + room.width &&
           rect.y + rect.height <= room.y + room.height;
}

/// Returns how many places on the outlines of the drawing a rectangle covers.
int coveredPlaces(Draughtsman &driver, const PixelRect &rect) {
    int covered = 0;
    for (const auto &shape : driver.document().shapes) {
        const Outline outline = outlineOf(*shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            for (int i = 0; i <= 400; ++i) {
                covered += rect.contains(driver.pixel(outline.curve(k).point(i / 400.0))) ? 1 : 0;
            }
        }
    }
    return covered;
}

void checkApart(Draughtsman &driver, const Labels &labels) {
    for (std::size_t i = 0; i < labels.size(); ++i) {
        CAPTURE(labels[i].text);
        CHECK(inside(labels[i].rect, driver.context().view.camera.viewport));
        for (const char *plate : {"options", "hints", "canvas/plate"}) {
            const auto &widgets = driver.context().widgets.all();
            const auto found = widgets.find(plate);
            CHECK_FALSE((found != widgets.end() && found->second.rect.overlaps(labels[i].rect)));
        }
        for (std::size_t k = i + 1; k < labels.size(); ++k) {
            CAPTURE(labels[k].text);
            CHECK_FALSE(labels[i].rect.overlaps(labels[k].rect));
        }
    }
}

} // namespace

TEST_CASE("Labels: names and dimensions cover neither each other, nor plates, edges and the selected outline") {
    for (const double scale : {1.0, 2.0}) {
        const auto side = [&](int pixels) { return static_cast<int>(pixels * scale); };
        Draughtsman driver({}, {side(1280), side(800)});
        if (scale > 1.0) {
            driver.context().settings.scale = scale;
            driver.settle();
        }
        for (const double zoom : {1.0, 0.6, 1.7}) {
            driver.context().view.camera.zoom *= zoom;
            const Labels labels = labelsOf(driver);
            CHECK(labels.size() > 6);
            checkApart(driver, labels);
            for (const CanvasPainter::Placed &label : labels) {
                CAPTURE(label.text);
                CHECK(coveredPlaces(driver, label.rect) == 0);
            }
            driver.key('Z', {Modifiers::kControl});
        }
    }
}

TEST_CASE("Labels: names cover no outline and no hole when nothing is selected") {
    for (const double zoom : {1.0, 0.6, 1.7}) {
        Draughtsman driver;
        driver.context().view.camera.zoom *= zoom;
        labelsOf(driver);
        driver.context().selection.clear();
        showLayer(driver.context().layers, "dimensions", false);
        driver.settle();
        const Labels labels = driver.editor().canvas().labels();
        CHECK(labels.size() >= 2);
        checkApart(driver, labels);
        for (const CanvasPainter::Placed &label : labels) {
            CAPTURE(label.text);
            CHECK(coveredPlaces(driver, label.rect) == 0);
        }
    }
}

TEST_CASE("Labels: words at the pointer move aside at the edge of the canvas, and names make way for them") {
    Draughtsman driver;
    labelsOf(driver);
    const PixelRect canvas = driver.context().view.camera.viewport;
    driver.key('L');
    for (const Pixel at : {Pixel(canvas.x + canvas.width - 3.0, canvas.y + 0.5 * canvas.height),
                           Pixel(canvas.x + 0.4 * canvas.width, canvas.y + 3.0), driver.pixel({9, 1}),
                           driver.pixel({6.5, 3}), driver.pixel({0.42, 0.41})}) {
        driver.clickAt({canvas.x + 0.5 * canvas.width, canvas.y + 0.4 * canvas.height});
        driver.moveTo(at);
        driver.frames(3);
        checkApart(driver, driver.editor().canvas().labels());
        driver.key(key::kEscape);
    }
}

TEST_CASE("Labels: those of sources and regions cover neither marks nor the lines of sources") {
    Draughtsman driver;
    Document drawing = driver.document();
    Shape plate;
    plate.form = RectangleForm{};
    plate.nodes = {{0, 0}, {10, 8}};
    drawing = *addShape(drawing, plate);
    drawing.spacing.sources = {
        {.shape = SourceShape::Line, .a = {2, 6}, .b = {8, 6.8}, .size = 0.1, .endSize = 0.4},
        {.shape = SourceShape::Point, .a = {2.2, 5.7}, .size = 0.1},
        {.shape = SourceShape::Point, .a = {2.9, 5.9}, .size = 0.2},
    };
    drawing.regionMarkers = {{{3.4, 5.6}, 2}};
    driver.context().document.apply(std::move(drawing), "Draw");
    driver.settle();
    const Labels labels = driver.editor().canvas().labels();
    CHECK(labels.size() >= 4);
    checkApart(driver, labels);
    for (const CanvasPainter::Placed &label : labels) {
        CAPTURE(label.text);
        for (const Vec2 mark : {Vec2{2, 6}, Vec2{8, 6.8}, Vec2{2.2, 5.7}, Vec2{2.9, 5.9}, Vec2{3.4, 5.6}}) {
            CHECK_FALSE(label.rect.contains(driver.pixel(mark)));
        }
        for (int k = 0; k <= 400; ++k) {
            CHECK_FALSE(label.rect.contains(driver.pixel(Vec2{2, 6} + k / 400.0 * Vec2{6, 0.8})));
        }
    }
}

TEST_CASE("Labels: those of an advance search the front once, and not again until it or the zoom changes") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 3});
    Document drawing = driver.document();
    drawing.spacing.size = 0.3;
    driver.context().document.apply(std::move(drawing), "Size");
    driver.workspace(WorkspaceKind::Step);
    driver.context().run.seek(12);
    driver.settle();
    REQUIRE(driver.run().explanation);
    REQUIRE_FALSE(driver.run().frontDone());
    driver.context().view.fit(boxAround(driver.run().explanation->a, 0.7)); // close enough for labels
    driver.settle();
    const Canvas &canvas = driver.editor().canvas();
    const auto labelled = [&canvas](const std::string &name) {
        return std::any_of(canvas.labels().begin(), canvas.labels().end(),
                           [&name](const CanvasPainter::Placed &label) { return label.text.starts_with(name); });
    };
    REQUIRE(labelled("A"));
    REQUIRE(labelled("B"));
    REQUIRE(labelled("C"));
    const std::size_t before = canvas.frontWalks();
    driver.frames(5);
    CHECK(canvas.frontWalks() == before);
    driver.context().run.seek(13);
    driver.until([&] { return driver.run().advance == 13; });
    driver.frames(1);
    CHECK(canvas.frontWalks() <= before + 2); // the labels of one frame share a search
    CHECK(canvas.frontWalks() > before);
}

TEST_CASE("Labels: the radius of a selected hole is written clear of its handles") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    Shape hole;
    hole.form = CircleForm{};
    hole.nodes = {{5, 4}, {5.6, 4}};
    driver.context().document.apply(*addShape(driver.document(), hole), "Hole");
    showLayer(driver.context().layers, "dimensions", true);
    driver.key('V');
    driver.context().selection.clear();
    driver.context().selection.shapes = {driver.document().shapes[1]->id};
    driver.settle();
    const Labels labels = driver.editor().canvas().labels();
    CHECK(std::any_of(labels.begin(), labels.end(), [](const auto &label) { return label.text == "R 0.6"; }));
}

TEST_CASE("Labels: the legend of the element size ends at the largest size in the domain") {
    Draughtsman driver;
    Shape disc;
    disc.form = CircleForm{};
    disc.nodes = {{5, 5}, {7, 5}};
    Document drawing = *addShape(driver.document(), disc);
    drawing.spacing.sources = {{.shape = SourceShape::Point, .a = {5, 5}, .size = 0.1, .growth = 0.1}};
    drawing.spacing.keepAutomatic = false;
    driver.context().document.apply(std::move(drawing), "Draw");
    driver.settle();
    const DocumentPreview &preview = *driver.context().preview;
    REQUIRE(preview.spacing);
    CHECK(preview.spacing->maximum() > 0.36); // in the corners of the box
    CHECK(preview.largestSpacing == doctest::Approx(0.3).epsilon(0.02));
}

} // namespace forefront::test
