#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/dialogs/question_dialog.hpp"
#include "ui/tools/look/measure_tool.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Types a number into a field and goes on with Tab.
void fill(Draughtsman &driver, const char *field, const char *number) {
    driver.click(field);
    driver.key('A', kControl);
    driver.type(number);
    driver.key(key::kTab);
    driver.settle();
}

/// Draws a rectangle and opens the dialog that rounds its corners.
void openFillet(Draughtsman &driver) {
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key('F', kControlShift);
    driver.settle();
}

/// Returns true if a part of the picture has pixels of a colour. Thin letters may cover no pixel fully.
bool shows(Driver &driver, PixelRect area, Colour colour) { // a copy: frames change the widgets
    constexpr int kSimilar = 40;
    const Driver::Picture picture = driver.picture();
    for (double y = area.y; y < area.y + area.height; ++y) {
        for (double x = area.x; x < area.x + area.width; ++x) {
            if (difference(colourAt(picture, {x, y}), colour) < kSimilar) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

TEST_CASE("Shape menu: mirror and quarter turns about the middle of the selection, by key, menu and palette") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {5, 1}, {1, 3}});
    driver.key('V');
    driver.key('H', kShift);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{5, 1}, {1, 1}, {5, 3}});
    CHECK(driver.undoLabel() == "Mirror left-right");
    driver.click("menu/Shape");
    driver.click("menu/shape.mirrorY");
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{5, 3}, {1, 3}, {5, 1}});
    driver.key('Z', kControl);
    driver.key('Z', kControl);
    driver.key('P', kControl);
    driver.type("rotate left");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{4, 0}, {4, 4}, {2, 0}});
    driver.key(key::kRightBracket, kControl);
    CHECK(driver.document().shapes[0]->nodes == std::vector<Vec2>{{1, 1}, {5, 1}, {1, 3}});
}

TEST_CASE(
    "Transform: numbers show their result while the dialog is open; Cancel and Esc take it back, OK is one step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 3});
    driver.key('V');
    const auto box = [&] { return boundsOf(*driver.document().shapes[0]); };
    driver.key('M', kControlShift);
    driver.settle();
    fill(driver, "dialog/transform/x", "2");
    CHECK(box() == Box2{{3, 1}, {7, 3}});
    fill(driver, "dialog/transform/scalex", "50");
    driver.settle();
    CHECK(box() == Box2{{4, 1}, {6, 3}});
    driver.click("dialog/transform/cancel");
    driver.settle();
    CHECK(box() == Box2{{1, 1}, {5, 3}});
    CHECK(driver.undoLabel() == "Draw rectangle");
    driver.key('M', kControlShift);
    driver.settle();
    fill(driver, "dialog/transform/scaley", "0");
    CHECK(driver.has("dialog/transform/fault"));
    driver.key(key::kEscape);
    driver.settle();
    CHECK(box() == Box2{{1, 1}, {5, 3}});
    driver.key('M', kControlShift);
    driver.settle();
    fill(driver, "dialog/transform/angle", "90");
    driver.click("dialog/transform/ok");
    driver.settle();
    CHECK(box() == Box2{{2, 0}, {4, 4}});
    CHECK(driver.undoLabel() == "Transform");
    driver.key('Z', kControl);
    CHECK(box() == Box2{{1, 1}, {5, 3}});
}

TEST_CASE("Dialogs with a preview: Esc and Cancel keep the redo steps") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {5, 3});
    driver.rectangle({6, 1}, {8, 3});
    driver.key('Z', kControl);
    driver.key('A', kControl);
    for (const bool escape : {true, false}) {
        driver.key('F', kControlShift);
        driver.settle();
        CHECK(driver.document().shapes[0]->as<RectangleForm>().radius > 0.0);
        CHECK(driver.context().document.redoLabel().empty());
        escape ? driver.key(key::kEscape) : static_cast<void>(driver.click("dialog/fillet/cancel"));
        driver.settle();
        CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 0.0);
        CHECK(driver.context().document.redoLabel() == "Draw rectangle");
    }
}

TEST_CASE("Dialogs with a preview: a dropped file withdraws the preview before it asks about changes") {
    const TemporaryFolder place;
    const std::filesystem::path file = place.path / "other.forefront";
    REQUIRE(writeProject(file, {}).empty());
    for (const bool saved : {true, false}) {
        CAPTURE(saved);
        Draughtsman driver;
        driver.rectangle({1, 1}, {5, 3});
        if (saved) {
            driver.context().document.markSaved({});
        }
        driver.key('A', kControl);
        driver.key('F', kControlShift);
        driver.settle();
        REQUIRE(driver.document().shapes[0]->as<RectangleForm>().radius > 0.0);
        driver.editor().input().push({.kind = InputKind::Drop, .paths = {file.string()}});
        driver.settle();
        CHECK_FALSE(driver.has("dialog/fillet/ok"));
        if (!saved) {
            CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 0.0);
            REQUIRE(driver.click("dialog/unsaved/discard"));
            driver.settle();
        }
        CHECK(driver.document().shapes.empty());
        CHECK(driver.undoLabel().empty());
        CHECK_FALSE(driver.context().dialogs.any());
        driver.rectangle({1, 1}, {5, 3}); // the canvas takes input again
        CHECK(driver.document().shapes.size() == 1);
    }
}

TEST_CASE("Arrays: the default step and centre never put copies on the original") {
    Draughtsman driver;
    const auto places = [&] {
        std::set<std::pair<double, double>> distinct;
        for (const SizeSource &source : driver.document().spacing.sources) {
            distinct.emplace(source.a.x, source.a.y);
        }
        for (const auto &shape : driver.document().shapes) {
            distinct.emplace(shape->nodes[0].x, shape->nodes[0].y);
        }
        return distinct.size();
    };
    const auto tryArrays = [&] {
        for (const auto &[letter, dialog, count] :
             {std::tuple('L', "lineararray", 3), std::tuple('P', "polararray", 6)}) {
            CAPTURE(dialog);
            driver.key(letter, kControlShift);
            driver.settle();
            const std::string name = std::string("dialog/") + dialog;
            CHECK_FALSE(driver.has(name + "/fault"));
            CHECK(places() == static_cast<std::size_t>(count));
            driver.click(name + "/cancel");
            driver.settle();
        }
    };
    SizeSource source;
    source.a = {4, 4};
    driver.context().document.apply(*addSource(driver.document(), source), "Add source");
    driver.context().selection.sources = {0};
    tryArrays();
    driver.context().selection.clear();
    driver.key('Z', kControl);
    Shape line;
    line.form = PathForm{.closed = false};
    line.nodes = {{5, 2}, {5, 7}};
    driver.context().document.apply(*addShape(driver.document(), line), "Draw line");
    driver.key('A', kControl);
    tryArrays();
}

TEST_CASE("Arrays: copies are shown while the number is typed, and become the selection") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {9, 9});
    driver.rectangle({1, 4}, {2, 5});
    driver.key('V');
    driver.key('P', kControlShift);
    driver.settle();
    fill(driver, "dialog/polararray/count", "4");
    CHECK(driver.document().shapes.size() == 5);
    driver.click("dialog/polararray/ok");
    driver.settle();
    CHECK(driver.document().shapes.size() == 5);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{3, 4, 5});
    CHECK(driver.undoLabel() == "Polar array");
    driver.key('Z', kControl);
    CHECK(driver.document().shapes.size() == 2);
    driver.clickPlace({1, 4.5});
    driver.key('L', kControlShift);
    driver.settle();
    fill(driver, "dialog/lineararray/x", "2");
    driver.click("dialog/lineararray/ok");
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 4);
    CHECK(boundsOf(*driver.document().shapes[3]) == Box2{{5, 4}, {6, 5}});
}

TEST_CASE("Align: a submenu lines up the selected shapes; each entry is one undo step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {2, 2});
    driver.rectangle({4, 5}, {6, 6});
    driver.key('A', kControl);
    driver.click("menu/Shape");
    driver.hover("menu/shape.arrange");
    driver.frames(40); // the submenu opens after a moment
    driver.click("menu/shape.arrange/shape.alignLeft");
    CHECK(boundsOf(*driver.document().shapes[1]).min == Vec2{1, 5});
    CHECK(driver.undoLabel() == "Align left");
    CHECK_FALSE(driver.context().actions.find("shape.distributeX")->enabled(driver.context()));
}

TEST_CASE("Fillet, chamfer, offset: typed sizes show on the canvas; OK is one undo step") {
    Draughtsman driver;
    openFillet(driver);
    fill(driver, "dialog/fillet/size", "9");
    CHECK(driver.has("dialog/fillet/fault"));
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Rectangle);
    fill(driver, "dialog/fillet/size", "1");
    CHECK_FALSE(driver.has("dialog/fillet/fault"));
    driver.click("dialog/fillet/ok");
    driver.settle();
    CHECK(driver.document().shapes[0]->kind() == ShapeKind::Rectangle);
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 1.0);
    CHECK(driver.undoLabel() == "Fillet");
    driver.key('Z', kControl);
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 0.0);
    driver.clickPlace({9, 8}); // one node
    driver.key('K', kControlShift);
    driver.settle();
    fill(driver, "dialog/chamfer/size", "2");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(54.0));
    driver.key('Z', kControl);
    driver.key('A', kControl);
    driver.key('O', kControlShift);
    driver.settle();
    fill(driver, "dialog/offset/size", "-1");
    driver.click("dialog/offset/ok");
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(areaOf(*driver.document().shapes[1]) == doctest::Approx(30.0));
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{2});
}

TEST_CASE("Dialogs with a preview: a text that is no number is refused at its field, and nothing is applied") {
    struct Sample {
        int key;
        const char *dialog, *field;
    };
    for (const Sample &sample :
         {Sample{'F', "fillet", "size"}, Sample{'K', "chamfer", "size"}, Sample{'O', "offset", "size"},
          Sample{'M', "transform", "x"}, Sample{'L', "lineararray", "count"}, Sample{'P', "polararray", "angle"}}) {
        CAPTURE(sample.dialog);
        Draughtsman driver;
        driver.rectangle({1, 1}, {9, 8});
        driver.key('V');
        driver.key(sample.key, kControlShift);
        driver.settle();
        const std::string name = std::string("dialog/") + sample.dialog, field = name + '/' + sample.field;
        const auto refuses = [&] { return driver.has(field + "/fault") && driver.has(name + "/ok"); };
        driver.fill(field, "abc");
        CHECK(refuses());
        driver.key(key::kEnter);
        driver.settle();
        CHECK(refuses());
        driver.type("2"); // the field has the focus again
        driver.frames(2);
        CHECK_FALSE(driver.has(field + "/fault"));
        driver.key('A', kControl);
        driver.type("abc");
        driver.click(name + "/ok");
        driver.settle();
        CHECK(refuses());
        driver.key(key::kEscape); // brings the number back
        driver.settle();
        REQUIRE(driver.has(name + "/ok"));
        driver.key(key::kEscape);
        driver.settle();
        CHECK(driver.undoLabel() == "Draw rectangle");
        driver.key(sample.key, kControlShift); // the refused text is forgotten
        driver.settle();
        CHECK_FALSE(driver.has(field + "/fault"));
        driver.key(key::kEnter);
        driver.settle();
        CHECK_FALSE(driver.has(name + "/ok"));
    }
}

TEST_CASE("Dialogs with a preview: a number shows its result, or why there is none, while it is typed") {
    Draughtsman driver;
    openFillet(driver);
    driver.type("1");
    driver.settle();
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 1.0);
    driver.type("0");
    driver.settle();
    REQUIRE(driver.has("dialog/fillet/fault"));
    CHECK(shows(driver, driver.context().widgets.find("dialog/fillet/fault")->rect, driver.context().theme.bad));
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 0.0);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.has("dialog/fillet/fault"));
    driver.type("2*"); // no number yet
    driver.settle();
    CHECK(driver.has("dialog/fillet/fault"));
    driver.type("1");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/fillet/fault"));
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius == 2.0);
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("dialog/fillet/ok"));
    CHECK(driver.undoLabel() == "Fillet");
    driver.key('Z', kControl);
    CHECK(driver.undoLabel() == "Draw rectangle");
}

TEST_CASE("Dialogs with a preview: Enter answers a question above, and applies nothing") {
    for (const int enter : {key::kEnter, key::kKeypadEnter}) {
        CAPTURE(enter);
        Draughtsman driver;
        openFillet(driver);
        bool answered = false;
        const QuestionDialog::Answer yes{"yes", "Yes", true, [&answered](Shell &) { answered = true; }};
        driver.context().dialogs.open(std::make_unique<QuestionDialog>("sure", "Sure?", "Enter is for this.",
                                                                       std::vector<QuestionDialog::Answer>{yes}));
        driver.settle();
        driver.key(enter);
        driver.settle();
        CHECK(answered);
        CHECK_FALSE(driver.has("dialog/sure/yes"));
        CHECK(driver.has("dialog/fillet/ok"));
        driver.key(enter);
        driver.settle();
        CHECK_FALSE(driver.has("dialog/fillet/ok"));
        CHECK(driver.undoLabel() == "Fillet");
    }
}

TEST_CASE("Dialogs with a preview: the first number has the focus, and typing replaces it") {
    Draughtsman driver;
    openFillet(driver);
    driver.type("1");
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("dialog/fillet/ok"));
    CHECK(driver.document().shapes[0]->as<RectangleForm>().radius > 0.0);
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(56.0 - 4.0 + std::numbers::pi));
    driver.key('Z', kControl);
    driver.clickPlace({9, 8}); // the size of a single node cannot be proposed from the node
    driver.key('K', kControlShift);
    driver.settle();
    CHECK_FALSE(driver.has("dialog/chamfer/fault"));
    CHECK(areaOf(*driver.document().shapes[0]) < 56.0);
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.has("dialog/chamfer/ok"));
    CHECK(areaOf(*driver.document().shapes[0]) == doctest::Approx(56.0));
}

TEST_CASE("Slot: two centres and a radius, by clicks or typed") {
    Draughtsman driver;
    driver.key('U');
    driver.clickPlace({2, 5});
    driver.clickPlace({6, 5});
    driver.moveToPlace({4, 6});
    driver.type("1.5");
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(boundsOf(*driver.document().shapes[0]).max.x == doctest::Approx(7.5));
    CHECK(boundsOf(*driver.document().shapes[0]).min.y == doctest::Approx(3.5));
    CHECK(driver.undoLabel() == "Draw slot");
    CHECK(displayName(*driver.document().shapes[0]) == "slot 1");
    driver.key(key::kRightBracket, kControl); // a quarter turn
    CHECK(displayName(*driver.document().shapes[0]) == "slot 1");
    driver.key('Z', kControl);
    driver.key('Z', kControl);
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Measure: two clicks read distance and angle and leave the document alone") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 5});
    const std::uint64_t before = driver.context().document.revision();
    driver.key('M');
    driver.clickPlace({1, 1});
    driver.clickPlace({4, 5});
    const auto &tool = dynamic_cast<const MeasureTool &>(driver.context().tools.current());
    CHECK(tool.reading(driver.context()) == "5   \xce\x94x 3   \xce\x94y 4   \xe2\x88\xa0 53.13\xc2\xb0");
    CHECK(driver.context().document.revision() == before);
    driver.clickPlace({1, 1}); // begins anew
    driver.moveToPlace({1, 5});
    CHECK(tool.reading(driver.context()).starts_with("4 "));
    driver.key(key::kEscape);
    CHECK(tool.reading(driver.context()).empty());
}
