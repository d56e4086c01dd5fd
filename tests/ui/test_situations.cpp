#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/ui/colour_vision.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/shot.hpp"
#include "tests/ui/widget_rects.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/platform/assets.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/workspace/judging.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// What the pictures of the situations have shown to be cut, covered or said twice.

namespace forefront::test {

namespace {

/// Returns the rectangle of the first label whose text begins so.
PixelRect labelOf(Driver &driver, const std::string &begin) {
    const auto &labels = driver.editor().canvas().labels();
    const auto found = std::find_if(labels.begin(), labels.end(),
                                    [&](const CanvasPainter::Placed &label) { return label.text.starts_with(begin); });
    REQUIRE_MESSAGE(found != labels.end(), begin);
    return found->rect;
}

/// Returns how many of many places on the outlines of the drawing a rectangle covers.
int coveredPlaces(Driver &driver, const PixelRect &rect) {
    int covered = 0;
    for (const auto &shape : driver.context().document.current()->shapes) {
        const Outline outline = outlineOf(*shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            for (int i = 0; i <= 400; ++i) {
                const Vec2 place = outline.curve(k).point(i / 400.0);
                covered += rect.contains(driver.context().view.camera.toPixel(place)) ? 1 : 0;
            }
        }
    }
    return covered;
}

/// An editor with the first sample, meshed, in a workspace, in a window of 1280 x 800 pixels.
class SampleDriver : public Driver {
  public:
    explicit SampleDriver(WorkspaceKind kind, double scale = 1.0) : Driver({}, {1280, 800}, scale) {
        settle();
        context().run.mesh();
        settle();
        workspace(kind);
        settle();
    }
};

EditorSetup startPageSetup() {
    EditorSetup setup;
    setup.sample = false;
    setup.startPage = true;
    return setup;
}

} // namespace

TEST_CASE("Situations: an import leaves the drawing in sight, whatever the scale and whether the column is open") {
    for (const double scale : {1.0, 1.5, 2.0}) {
        for (const bool column : {true, false}) {
            CAPTURE(scale);
            CAPTURE(column);
            Driver driver({}, {1280, 800}, scale);
            driver.context().view.panels = driver.context().plates.column = column;
            driver.settle();
            importBracket(driver);
            driver.settle();
            const PixelRect dialog = rectOf(driver, "dialog/importoptions");
            CHECK(within(dialog, {0, 0, 1280, 800}));
            for (const char *part : {"weld", "point", "cancel", "ok"}) {
                CHECK(within(rectOf(driver, std::string("dialog/importoptions/") + part), dialog));
            }
            const PixelRect open = driver.context().view.open;
            CHECK_FALSE(open.overlaps(dialog));
            CHECK(open.width > 0.4 * 1280.0);
            for (const auto &shape : driver.context().document.current()->shapes) {
                const Box2 box = boundsOf(*shape);
                CHECK(open.contains(driver.context().view.camera.toPixel(box.min)));
                CHECK(open.contains(driver.context().view.camera.toPixel(box.max)));
            }
        }
    }
}

TEST_CASE("Situations: the name of a changed drawing is in the title at one and a half times the scale") {
    SampleDriver driver(WorkspaceKind::Judge, 1.5);
    Document limited = *driver.context().document.current();
    limited.limits[MeshLimit::MinAngle] = 36.0;
    driver.context().document.apply(std::move(limited), "Limit");
    driver.settle();
    CHECK(rectOf(driver, "menu/title").width > rectOf(driver, "menu/unsaved").width + 60.0 * 1.5);
}

TEST_CASE("Situations: the start page has the canvas for itself, in its middle, with the whole names of samples") {
    Driver driver(startPageSetup(), {1280, 800}, 1.5);
    driver.settle();
    CHECK_FALSE(driver.has("hints")); // the status bar has the same keys
    CHECK_FALSE(driver.has("canvas/tools"));
    ImFont *const font = driver.context().fonts.strong;
    for (const Sample &sample : sampleDrawings()) {
        const WidgetRegistry::Widget *const card =
            driver.context().widgets.find("start/sample/" + sample.path.stem().string());
        if (card != nullptr) {
            CAPTURE(sample.title);
            const double room = card->rect.width - 16.0 * 1.5;
            CHECK(static_cast<double>(font->CalcTextSizeA(imgui::lineOf(*font), 1e9F, 0.0F, sample.title.c_str()).x) <=
                  room);
        }
    }
    driver.platform().resize({2560, 1600}, 1.0);
    driver.settle();
    const Pixel middle = rectOf(driver, "start").centre(), canvas = driver.canvas().centre();
    CHECK(std::abs(middle.x - canvas.x) <= 1.0);
    CHECK(std::abs(middle.y - canvas.y) <= 1.0);
}

TEST_CASE("Situations: a lesson on the ideal point labels A, B and C at every scale") {
    for (const double scale : {1.0, 1.5, 2.0}) {
        CAPTURE(scale);
        SampleDriver driver(WorkspaceKind::Draw, scale);
        driver.context().actions.run("learn.lessons", driver.context());
        driver.settle();
        driver.click("lessons/2-ten-steps");
        driver.settle();
        driver.key(key::kPageDown);
        driver.settle();
        for (const char *point : {"A ", "B ", "C"}) {
            CHECK(labelOf(driver, point).width > 0.0);
        }
    }
}

TEST_CASE("Situations: what is told about an element lies beside it, and covers no outline") {
    SampleDriver driver(WorkspaceKind::Judge);
    driver.click("worst/1");
    driver.settle();
    const Judgement &judgement = *driver.context().judgement;
    const Element &element = judgement.of.mesh->mesh.elements[judgement.worst[1]];
    for (const char *plate : {"probe/plate/value", "probe/plate/place"}) {
        const PixelRect rect = rectOf(driver, plate);
        CHECK(coveredPlaces(driver, rect) == 0);
        for (int i = 0; i < 100; ++i) { // along the sides
            const Vec2 a = judgement.of.mesh->mesh.nodes[index(element[i % 3])];
            const Vec2 b = judgement.of.mesh->mesh.nodes[index(element[(i + 1) % 3])];
            CHECK_FALSE(rect.contains(driver.context().view.camera.toPixel(lerp(a, b, i / 99.0))));
        }
    }
}

TEST_CASE("Situations: an error is told once; what says that the mesh is out of date does not repeat it") {
    Driver driver({}, {1280, 800});
    driver.context().settings.live = true;
    driver.settle();
    offerCombination(driver);
    driver.settle();
    driver.context().dialogs.dismissPreviews(driver.context());
    driver.settle();
    REQUIRE(driver.context().run.outOfDate());
    REQUIRE(driver.has("canvas/outofdate"));
    REQUIRE_FALSE(driver.context().preview->faults.empty());
    const std::string text = shell::stateText(driver.context());
    CHECK(text.starts_with(driver.context().preview->faults.front().message));
}

TEST_CASE("Situations: the options bar is filled as far as there is room") {
    SampleDriver driver(WorkspaceKind::Size, 1.5);
    CHECK(within(rectOf(driver, "options/snap/relations"), rectOf(driver, "options")));
}

TEST_CASE("Situations: a histogram shows its axis, and its bars stand out on the light theme") {
    SampleDriver driver(WorkspaceKind::Judge);
    driver.context().settings.theme = ThemeKind::Light;
    driver.settle();
    const PixelRect axis = rectOf(driver, "histogram/axis");
    CHECK(axis.height >= static_cast<double>(imgui::lineOf(*driver.context().fonts.small)));
    CHECK(axis.y + axis.height <= rectOf(driver, "panel/probe").y);
    const auto &bins = driver.context().judgement->histogram.bins;
    const auto tallest = std::max_element(bins.begin(), bins.end()) - bins.begin();
    const PixelRect bar = rectOf(driver, "histogram/" + std::to_string(tallest));
    const Driver::Picture picture = driver.picture();
    double best = 0.0;
    for (int y = static_cast<int>(bar.y) - 1; y <= static_cast<int>(bar.y) + 2; ++y) {
        const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
                             static_cast<std::size_t>(bar.centre().x));
        const Colour colour = rgb(static_cast<std::uint32_t>(picture.rgba[at]) << 16U |
                                  static_cast<std::uint32_t>(picture.rgba[at + 1]) << 8U | picture.rgba[at + 2]);
        best = std::max(best, contrast(colour, driver.context().theme.panel));
    }
    CHECK(best >= 3.0);
}

TEST_CASE("Situations: the link to the places that break a limit is level with its icon") {
    SampleDriver driver(WorkspaceKind::Judge, 1.5);
    Document limited = *driver.context().document.current();
    limited.limits[MeshLimit::MinAngle] = 36.0;
    driver.context().document.apply(std::move(limited), "Limit");
    driver.settle();
    const PixelRect broken = rectOf(driver, "checks/min-angle/broken");
    CHECK(std::abs(rectOf(driver, "checks/min-angle/next").centre().y - broken.centre().y) <= 1.5);
}

TEST_CASE("Situations: names of size sources cover no outline where there is room beside it") {
    for (const double scale : {1.0, 1.5}) {
        CAPTURE(scale);
        SampleDriver driver(WorkspaceKind::Size, scale);
        for (const char *source : {"breakwater head", "dolphin"}) {
            CAPTURE(source);
            CHECK(coveredPlaces(driver, labelOf(driver, source)) == 0);
        }
    }
}

TEST_CASE("Situations: the label of an accepted candidate covers no line of the front") {
    SampleDriver driver(WorkspaceKind::Step);
    driver.context().run.seek(driver.run().known / 2);
    driver.settle();
    driver.key('T');
    driver.settle();
    const PixelRect label = labelOf(driver, "1  score");
    REQUIRE(driver.run().front != nullptr);
    for (const FrontSegmentView &segment : *driver.run().front) {
        const Camera &camera = driver.context().view.camera;
        CHECK_FALSE(meets(label, camera.toPixel(segment.a), camera.toPixel(segment.b)));
    }
}

} // namespace forefront::test
