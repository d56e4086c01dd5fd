#include "tests/ui/edit_driver.hpp"
#include "ui/editor/snapshot_pace.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/tooltip.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace forefront::test {

namespace {

/// A square that takes long enough to mesh to observe the run in progress.
struct LongRun : Draughtsman {
    LongRun() {
        rectangle({0, 0}, {8, 8});
        Document fine = document();
        fine.spacing.size = 0.004;
        context().document.apply(std::move(fine), "Fine");
        settle();
        workspace(WorkspaceKind::Mesh);
        key('R'); // its options are shown during the run
        key(key::kF5);
    }
    ~LongRun() {
        key(key::kEscape);
        settle();
    }
    LongRun(const LongRun &) = delete;
    LongRun &operator=(const LongRun &) = delete;
};

} // namespace

TEST_CASE("Notes: the progress of a long run does not cover the tool options") {
    LongRun driver;
    driver.until([&] { return driver.has("run/progress") && driver.run().advance > 5000; });
    driver.frames(2);
    const PixelRect cancel = driver.context().widgets.find("run/cancel")->rect;
    const PixelRect progress = driver.context().widgets.find("run/progress")->rect;
    for (const char *option : {"options/tag", "options/snap/drawing", "options/snap/grid"}) {
        REQUIRE(driver.has(option));
        const PixelRect rect = driver.context().widgets.find(option)->rect;
        CHECK_FALSE(rect.overlaps(cancel));
        CHECK_FALSE(rect.overlaps(progress));
    }
    driver.click("run/cancel");
    driver.settle();
    CHECK(driver.run().state == RunState::Cancelled);
    CHECK_FALSE(driver.has("run/progress"));
}

TEST_CASE("SnapshotPace: snapshots that are slow to draw are drawn rarely during a run, and at once when it stops") {
    SnapshotPace pace;
    CHECK(pace.due(100.0, true));
    pace.recordFrame(100.0, 0.2);
    CHECK_FALSE(pace.due(100.3, true));
    CHECK(pace.due(100.3, false));
    CHECK(pace.due(pace.next(), true));
    CHECK(pace.next() == doctest::Approx(100.4));
    pace.recordFrame(200.0, 60.0); // a stopped machine
    CHECK(pace.due(201.0, true));
}

TEST_CASE("Timeline: a move and a release in one frame seek to the point of release") {
    Driver driver;
    driver.key(key::kF5);
    driver.workspace(WorkspaceKind::Step);
    const PixelRect bar = driver.context().widgets.find("timeline/scrubber")->rect;
    const double y = bar.centre().y;
    driver.press({bar.x + bar.width - 8, y});
    InputQueue &input = driver.editor().input();
    input.push({.kind = InputKind::MouseMove, .x = bar.x + 0.25 * bar.width, .y = y});
    input.push({.kind = InputKind::MouseButton, .code = 0, .pressed = false});
    driver.settle();
    const double part = static_cast<double>(driver.run().advance) / static_cast<double>(driver.run().known);
    CHECK(std::abs(part - 0.25) < 0.03);
}

TEST_CASE("Status: the mesh hash can be copied only with its mesh") {
    Driver driver;
    driver.key(key::kF5);
    driver.settle();
    const auto offersHash = [&driver] {
        const Pixel at = driver.context().widgets.find("status/pointer")->rect.centre();
        driver.press(at, MouseButton::Right);
        driver.release(at, MouseButton::Right);
        driver.settle();
        const bool offered = driver.has("contextmenu/status/hash");
        driver.key(key::kEscape);
        driver.settle();
        return offered;
    };
    CHECK(offersHash());
    driver.key(key::kComma);
    driver.settle();
    CHECK_FALSE(offersHash());
    driver.key(key::kPeriod);
    driver.settle();
    CHECK(offersHash());
}

TEST_CASE("Notes: a crossing is repaired from the message that reports it") {
    Draughtsman driver;
    driver.polygon({{0, 0}, {8, 6}, {8, 0}, {0, 6}});
    driver.settle();
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.run().state == RunState::Failed);
    REQUIRE(driver.has("canvas/error/goto"));
    driver.click("canvas/error/repair");
    driver.settle();
    CHECK(driver.context().preview->faults.empty());
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
}

TEST_CASE("Notes: when the last shape is undone, the caption of its mesh goes, too") {
    Draughtsman driver;
    driver.workspace(WorkspaceKind::Step);
    const PixelRect caption = driver.context().widgets.find("timeline/caption")->rect;
    const auto empty = driver.picture();
    driver.rectangle({1, 1}, {9, 8});
    driver.key(key::kF5);
    driver.settle();
    REQUIRE(driver.run().state == RunState::Finished);
    CHECK(driver.picture().differences(empty, caption) > 200);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.document().shapes.empty());
    CHECK(driver.picture().differences(empty, caption) == 0);
}

TEST_CASE("Notes: undo hides a reported fault, and drawing it again reports it again") {
    Draughtsman driver;
    driver.workspace(WorkspaceKind::Step);
    driver.rectangle({1, 1}, {9, 8});
    driver.rectangle({4, 4}, {12, 6});
    driver.settle();
    driver.key(key::kF5);
    driver.settle();
    REQUIRE(driver.run().state == RunState::Failed);
    REQUIRE(driver.has("canvas/error"));
    driver.click("canvas/error/goto");
    CHECK(driver.context().view.flag.has_value());
    const PixelRect caption = driver.context().widgets.find("timeline/caption")->rect;
    const auto failed = driver.picture();
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.has("canvas/error"));
    CHECK_FALSE(driver.has("canvas/outofdate")); // there was no mesh
    CHECK_FALSE(driver.context().view.flag.has_value());
    CHECK(driver.picture().differences(failed, caption) > 200);
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.has("canvas/error"));
}

TEST_CASE("MessageLog: an entry belongs to a revision of the document") {
    DocumentStore document;
    MessageLog log(document);
    const std::uint64_t first = document.revision();
    log.add(error("a", "now"));
    document.load({}, {});
    REQUIRE(document.revision() != first);
    log.add(error("b", "late"), first);
    log.note("seen anyway");
    log.announce("done");
    const auto &entries = log.entries();
    CHECK(entries[0].revision == first);
    CHECK(entries[1].revision == first);
    CHECK(entries[0].announced);
    CHECK_FALSE(entries[2].announced);
    CHECK(entries[3].announced);
    CHECK(entries[3].revision == document.revision());
}

TEST_CASE("Notes: if there are several faults, the message shows the first and counts the rest") {
    Draughtsman driver;
    driver.polygon({{0, 0}, {8, 6}, {8, 0}, {0, 6}});
    driver.polygon({{1, 8}, {9, 8}, {9, 9}, {4, 7}});
    driver.settle();
    driver.key(key::kF5);
    driver.settle();
    REQUIRE(driver.run().state == RunState::Failed);
    REQUIRE(driver.run().diagnostics.size() > 1);
    CHECK(driver.has("canvas/error/more"));
    driver.click("canvas/error/goto");
    REQUIRE(driver.run().diagnostics.front().at.has_value());
    CHECK(distance(driver.context().view.camera.centre, *driver.run().diagnostics.front().at) < 1e-9);
}

TEST_CASE("Timeline: a step is an advance in the fast method and an element in the classic one") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.workspace(WorkspaceKind::Step);
    CHECK(driver.has("timeline/granularity/Advance"));
    driver.key(key::kPeriod);
    driver.settle();
    Document classic = driver.document();
    classic.options.method = Method::Classic;
    driver.context().document.apply(std::move(classic), "Classic");
    driver.frames(2);
    CHECK(driver.has("timeline/granularity/Advance")); // the run on the timeline is still the fast one
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.has("timeline/granularity/Element"));
    driver.click("timeline/granularity/Element");
    driver.key(key::kHome);
    driver.settle();
    driver.key(key::kPeriod);
    driver.settle();
    CHECK(driver.run().quality.elements == 1);
}

TEST_CASE("Tooltips: appear once the pointer rests; at the lower edge they appear above their widget") {
    Driver driver;
    driver.workspace(WorkspaceKind::Step);
    driver.hover("timeline/back");
    driver.frames(8);
    const auto early = driver.picture();
    bool asked = false; // draws frames until the tooltip appears; an idle window draws no others
    for (int i = 0; i < 40; ++i) {
        CHECK((asked || driver.context().nextFrameAt < driver.platform().now() + 0.5));
        driver.frames(1);
        asked = asked || driver.context().redraw > 0;
    }
    CHECK(asked);
    const auto late = driver.picture();
    const PixelRect button = driver.context().widgets.find("timeline/back")->rect;
    const PixelRect neighbour = driver.context().widgets.find("timeline/forward")->rect;
    const PixelRect above{button.x, button.y - 40, 200, 30};
    CHECK(late.differences(early, above) > 1000);
    CHECK(late.differences(early, button) == 0);
    CHECK(late.differences(early, neighbour) == 0);
}

TEST_CASE("Tooltips: a tooltip of a panel covers none of its fields") {
    Draughtsman driver;
    driver.platform().resize({1280, 1000}, 1.0); // high enough for both panels without scrolling
    driver.rectangle({0, 0}, {8, 8});
    driver.key(key::kEscape);
    driver.showPanel("spacing");
    for (const char *field : {"spacing/size", "spacing/expression", "spacing/minimum", "spacing/gradation",
                              "spacing/fromboundary", "meshing/method/Fast", "meshing/keepboundary", "meshing/grid"}) {
        CAPTURE(field);
        driver.showPanel(std::string_view(field).substr(0, 7)); // spacing or meshing
        REQUIRE(driver.hover(field));
        driver.frames(40);
        REQUIRE(driver.has("tooltip"));
        const PixelRect tip = driver.context().widgets.find("tooltip")->rect;
        CHECK(tip.width > 40.0);
        CHECK(tip.x >= 0.0);
        for (const auto &[name, widget] : driver.context().widgets.all()) {
            if (name.starts_with("spacing/") || name.starts_with("meshing/") || name.starts_with("panel/")) {
                const std::string message = name;
                CHECK_MESSAGE(!tip.overlaps(widget.rect), message);
            }
        }
    }
    driver.key('R');
    driver.hover("options/tag");
    driver.frames(40);
    REQUIRE(driver.has("tooltip"));
    CHECK_FALSE(
        driver.context().widgets.find("tooltip")->rect.overlaps(driver.context().widgets.find("options")->rect));
}

TEST_CASE("Tooltips: lie outside the window of their widget and inside the display") {
    const PixelSize display{1280, 800};
    const Pixel size{250, 44};
    const auto check = [&](const PixelRect &window, const PixelRect &widget) {
        const PixelRect tip = ui::placeTooltip(widget, window, size, display, widget.centre().x, 6.0);
        CHECK(tip.x >= 0.0);
        CHECK(tip.y >= 0.0);
        CHECK(tip.x + tip.width <= 1280.0);
        CHECK(tip.y + tip.height <= 800.0);
        CHECK_FALSE(tip.overlaps(window));
        CHECK_FALSE(tip.overlaps(widget));
    };
    check({975, 34, 305, 660}, {1070, 660, 200, 26}); // a field low in the column
    check({0, 34, 46, 660}, {6, 42, 34, 34});         // a tool
    check({0, 695, 1280, 78}, {1200, 703, 60, 26});   // the timeline
    check({0, 0, 1280, 34}, {1240, 4, 26, 26});       // the menu bar
    check({58, 46, 500, 40}, {300, 53, 76, 26});      // options of a tool
    // Above the widget if there is no room elsewhere.
    const PixelRect wide{100, 50, 1080, 700}, button{700, 400, 80, 26};
    CHECK_FALSE(ui::placeTooltip(button, wide, size, display, 740, 6.0).overlaps(button));
}

TEST_CASE("Notes: cancelling is shown in the next frame, before the partial mesh") {
    LongRun driver;
    driver.until([&] { return driver.run().advance > 20000; });
    const std::uint64_t before = driver.run().sequence;
    driver.editor().input().push({.kind = InputKind::Key, .code = key::kEscape, .pressed = true});
    driver.frames(1);
    CHECK(driver.has("run/cancelling"));
    CHECK_FALSE(driver.has("run/cancel"));
    CHECK(driver.run().sequence == before);
    driver.editor().input().push({.kind = InputKind::Key, .code = key::kEscape, .pressed = false});
    driver.settle();
    CHECK(driver.run().state == RunState::Cancelled);
    CHECK_FALSE(driver.has("run/cancelling"));
    driver.key(key::kF5);
    // Wait for this run, and for a stage whose label will not change under the click.
    const auto advancing = [&] { return driver.run().state == RunState::Running && driver.run().advance > 20000; };
    driver.until(advancing);
    driver.frames(2);
    driver.click("run/cancel");
    driver.until([&] { return driver.run().state == RunState::Cancelled; });
}

TEST_CASE("Text: lines break between words, never within a number, and none is too wide") {
    Driver driver;
    const std::string text =
        "6326 triangles, 3272 nodes in 0.00843 s; minimum \xce\xb1 0.799, mean 0.981\nand then max(0.1, "
        "0.2*dist(3, 2)) and supercalifragilisticexpialidocious";
    for (const float width : {60.0F, 90.0F, 133.0F, 200.0F, 1000.0F}) {
        CAPTURE(width);
        const std::string lines = ui::wrapped(text, width); // in the font of the last frame
        std::istringstream each(lines);
        for (std::string line; std::getline(each, line);) {
            const bool oneWord = line.find(' ') == std::string::npos;
            CHECK((oneWord || ImGui::CalcTextSize(line.c_str()).x <= width));
        }
        std::string back = lines;
        std::replace(back.begin(), back.end(), '\n', ' ');
        std::string whole = text;
        std::replace(whole.begin(), whole.end(), '\n', ' ');
        CHECK(back == whole);
    }
}

TEST_CASE("Meshing panel: the options are part of the document, and undo restores them") {
    Draughtsman driver;
    driver.platform().resize({1280, 900}, 1.0);
    driver.settle();
    driver.rectangle({0, 0}, {8, 8});
    driver.key(key::kEscape);
    driver.showPanel("meshing");
    REQUIRE(driver.document().options.improve == ImproveLevel::Default);
    driver.click("meshing/improve/None");
    CHECK(driver.document().options.improve == ImproveLevel::None);
    REQUIRE(driver.document().options.method == Method::Fast);
    driver.click("meshing/method/Classic");
    CHECK(driver.document().options.method == Method::Classic);
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    CHECK_FALSE(driver.run().improved);
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().options.method == Method::Fast);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.document().options.improve == ImproveLevel::Default);
    CHECK(driver.context().run.outOfDate());
}

TEST_CASE("Panels: the hints of empty panels fit into the narrowest column") {
    Draughtsman driver;
    for (const double width : {304.0, 240.0}) {
        CAPTURE(width);
        driver.context().settings.panelWidth = width;
        driver.settle();
        const double right = driver.canvas().x + driver.canvas().width + width;
        for (const std::string panel : {"statistics", "histogram", "checks"}) {
            CAPTURE(panel);
            driver.showPanel(panel);
            driver.frames(2);
            REQUIRE(driver.has(panel + "/empty"));
            const PixelRect text = driver.context().widgets.find(panel + "/empty")->rect;
            CHECK(text.x + text.width <= right - 8.0);
        }
        const PixelRect here = driver.context().widgets.find("inspector/here")->rect;
        CHECK(here.x + here.width <= right - 8.0);
    }
    driver.rectangle({1, 1}, {9, 8}); // now the inspector asks to point at the canvas
    driver.moveTo({driver.canvas().x + driver.canvas().width + 120.0, 100.0});
    driver.settle();
    REQUIRE_FALSE(driver.context().view.pointer);
    const PixelRect here = driver.context().widgets.find("inspector/here")->rect;
    CHECK(here.x + here.width <= driver.canvas().x + driver.canvas().width + 240.0 - 8.0);
}

TEST_CASE("Spacing panel: no field is cut off at the edge of the column") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {8, 8});
    driver.key(key::kEscape);
    driver.showPanel("spacing");
    const PixelRect column = driver.context().widgets.find("spacing/size")->rect;
    const PixelRect lengths = driver.context().widgets.find("spacing/fromboundary")->rect;
    CHECK(lengths.x >= column.x - 1.0);
    CHECK(lengths.x + lengths.width <= column.x + column.width + 1.0);
}

} // namespace forefront::test
