#include "core/drawing/recovery/recovery_journal.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/workspace/checks_summary.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Returns the right end and the height of what is drawn in the column, by name.
std::vector<std::pair<std::string, PixelRect>> columnWidgets(Driver &driver) {
    std::vector<std::pair<std::string, PixelRect>> widgets;
    for (const auto &[name, widget] : driver.context().widgets.all()) {
        if (name.starts_with("panel/") || name.starts_with("statistics/") || name.starts_with("inspector/")) {
            widgets.emplace_back(name, widget.rect);
        }
    }
    return widgets;
}

} // namespace

TEST_CASE("Judge: an unfinished mesh is named as such, with a button that finishes the run") {
    MeshedSquare driver;
    driver.context().run.seek(20);
    driver.settle();
    driver.workspace(WorkspaceKind::Judge);
    for (const char *panel : {"checks", "histogram"}) {
        driver.showPanel(panel);
    }
    driver.settle();
    CHECK(unfinishedText(driver.context()).starts_with("Unfinished mesh: advance 20 of "));
    CHECK(checksSummary(driver.context()).brief == "unfinished mesh");
    CHECK(driver.has("checks/unfinished"));
    CHECK(driver.has("histogram/unfinished"));
    CHECK(driver.has("worst/unfinished"));
    REQUIRE(driver.click("worst/finish"));
    driver.settle();
    CHECK(driver.run().advance == driver.run().known);
    CHECK(unfinishedText(driver.context()).empty());
    CHECK_FALSE(driver.has("worst/unfinished"));
    CHECK_FALSE(driver.has("checks/unfinished"));
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
}

TEST_CASE("Judge: Home, End and the arrows belong to the list of worst places while it has the focus") {
    MeshedSquare driver;
    driver.workspace(WorkspaceKind::Judge);
    driver.settle();
    const std::size_t last = driver.context().judgement->worst.size() - 1;
    REQUIRE(last > 1);
    driver.click("worst/0");
    driver.settle();
    driver.key(key::kEnd);
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
    CHECK(driver.context().probe.rank == last);
    driver.key(key::kUp);
    driver.settle();
    CHECK(driver.context().probe.rank == last - 1);
    driver.key(key::kHome);
    driver.settle();
    CHECK(driver.context().probe.rank == 0);
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
}

TEST_CASE("Freehand: another document begins with corners, and a click says what to do") {
    Draughtsman driver;
    driver.key('P');
    driver.settle();

    driver.click("options/pen/Freehand");
    driver.settle();
    REQUIRE(driver.has("options/freehand/Smooth"));
    driver.clickPlace({3, 3});
    driver.settle();
    const auto &labels = driver.editor().canvas().labels();
    CHECK(std::any_of(labels.begin(), labels.end(),
                      [](const auto &label) { return label.text.starts_with("drag to draw freehand"); }));
    driver.key('N', {Modifiers::kControl});
    driver.settle();
    driver.polygon({{1, 1}, {8, 1}, {8, 7}});
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Recovery: a crash keeps the path that is being drawn, as an open shape") {
    const TemporaryFolder state;
    EditorSetup setup;
    setup.stateFolder = state.path;
    Draughtsman driver(setup);
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.clickPlace({8, 1});
    driver.clickPlace({8, 7});
    REQUIRE(driver.document().shapes.empty());
    std::filesystem::path journal;
    driver.until([&] {
        std::error_code notYet;
        for (const auto &entry : std::filesystem::directory_iterator(state.path / "recovery", notYet)) {
            journal = entry.path().extension() == ".journal" ? entry.path() : journal;
        }
        return !journal.empty() && std::filesystem::file_size(journal) > 0;
    });
    const TemporaryFolder after; // the file as a killed program leaves it, without its lock
    std::vector<OrphanedJournal> orphans;
    driver.until([&] {
        std::filesystem::copy_file(journal, after.path / "1-0.journal",
                                   std::filesystem::copy_options::overwrite_existing);
        orphans = findOrphanedJournals(after.path);
        const auto left = orphans.empty() ? Result<Document>(Diagnostics{})
                                          : parseProject(orphans.front().text(), orphans.front().file().string());
        return left && !left->shapes.empty() && left->shapes.front()->nodes.size() == 3;
    });
    const Result<Document> left = parseProject(orphans.front().text(), orphans.front().file().string());
    CHECK_FALSE(isClosed(*left->shapes.front()));
    CHECK(left->shapes.front()->nodes.size() == 3);
}

TEST_CASE("Messages: warnings stay until they are dismissed or the drawing has changed, outcomes pass") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = "left-out";
    warning.message = "two lines are left out";
    driver.context().log.add(warning);
    driver.context().log.announce("saved");
    driver.frames(60);
    CHECK(driver.has("canvas/note"));
    driver.frames(60 * 12);
    CHECK_FALSE(driver.has("canvas/note"));
    CHECK(driver.has("canvas/error"));
    REQUIRE(driver.click("canvas/error/close"));
    driver.settle();
    CHECK_FALSE(driver.has("canvas/error"));
    driver.context().log.add(warning);
    driver.frames(60 * 12);
    CHECK(driver.has("canvas/error"));
    driver.rectangle({2, 2}, {3, 3});
    driver.settle();
    CHECK_FALSE(driver.has("canvas/error"));
}

TEST_CASE("Messages: an outcome lets the pointer through to what lies below it, and pales there") {
    Draughtsman driver;
    driver.key('R');
    driver.context().log.announce("a long outcome of a command that lies over the middle of the canvas");
    driver.settle();
    const PixelRect plate = driver.context().widgets.find("canvas/news")->rect;
    const Pixel middle = plate.centre();
    driver.moveTo(middle);
    driver.settle();
    REQUIRE(driver.has("canvas/news")); // still there
    CHECK(driver.document().shapes.empty());
    driver.drag(middle, {middle.x + 60.0, middle.y - 200.0});
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Title: a long name is shortened in its middle, and the dot of unsaved changes stays") {
    const TemporaryFolder place;
    const std::filesystem::path file =
        place.path /
        "a very long name of a drawing that nobody could fit into any title bar of any window, second.json";
    { std::ofstream(file) << projectText(Document()); }
    EditorSetup setup;
    setup.file = file;
    Driver driver(setup);
    driver.settle();
    CHECK_FALSE(driver.has("menu/unsaved"));
    Document changed = *driver.context().document.current();
    changed.spacing.size = 0.5;
    driver.context().document.apply(std::move(changed), "Size");
    driver.settle();
    REQUIRE(driver.has("menu/unsaved"));
    const PixelRect dot = driver.context().widgets.find("menu/unsaved")->rect;
    const PixelRect search = driver.context().widgets.find("menu/palette")->rect;
    CHECK(dot.x + dot.width <= search.x);
}

TEST_CASE("File dialogs: each purpose begins in the folder where it was used last, in the next session too") {
    const TemporaryFolder place, settings;
    std::filesystem::create_directories(place.path / "drawings");
    std::ofstream(place.path / "drawings" / "part.svg")
        << R"(<svg viewBox="0 0 100 60"><rect width="100" height="60" fill="#888"/></svg>)";
    EditorSetup setup;
    setup.settingsFolder = settings.path;
    for (const bool again : {false, true}) {
        Draughtsman driver(setup);
        driver.context().actions.run("file.import", driver.context());
        driver.settle();
        driver.chooseFile("import", again ? std::filesystem::path("part.svg") : place.path / "drawings" / "part.svg");
        driver.settle();
        CHECK(driver.has("dialog/importoptions/ok"));
        driver.click("dialog/importoptions/cancel");
        driver.settle();
    }
}

TEST_CASE("SVG: opening and importing a drawing agree on white shapes") {
    const TemporaryFolder place;
    const std::filesystem::path file = place.path / "part.svg";
    {
        std::ofstream(file) << R"(<svg viewBox="0 0 100 60"><rect width="100" height="60" fill="#888"/>
<circle cx="30" cy="30" r="10" fill="#fff"/></svg>)";
    }
    Draughtsman driver;
    driver.context().actions.run("file.open", driver.context());
    driver.settle();
    driver.chooseFile("open", file);
    driver.settle();
    CHECK(driver.document().shapes.size() == 2); // the plate and its hole
    CHECK(driver.logHas("svg-white"));
}

TEST_CASE("Column: its panels come to rest at any height, and a scroll bar does not move their contents") {
    MeshedSquare driver;
    driver.context().selection.shapes = {1};
    for (const char *panel : {"statistics", "inspector", "meshing"}) {
        driver.showPanel(panel);
    }
    double width = 0.0;
    for (const int height : {500, 560, 600, 640, 700, 760, 820, 900, 1000, 1200, 1600, 2200}) {
        CAPTURE(height);
        driver.platform().resize({1280, height}, 1.0);
        driver.frames(6);
        const auto first = columnWidgets(driver);
        driver.frames(1);
        const auto second = columnWidgets(driver);
        driver.frames(1);
        CHECK(second.size() == columnWidgets(driver).size());
        REQUIRE(first.size() == second.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            CAPTURE(first[k].first);
            CHECK(first[k].second.y == second[k].second.y);
            CHECK(first[k].second.width == second[k].second.width);
        }
        const auto *const name = driver.context().widgets.find("inspector/name");
        REQUIRE(name != nullptr);
        width = width > 0.0 ? width : name->rect.width;
        CHECK(name->rect.width == width);
    }
}

} // namespace forefront::test
