#include "tests/ui/edit_driver.hpp"
#include "ui/workspace/checks_summary.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

namespace forefront::test {

namespace {

void setMinimumAngle(Draughtsman &driver, double degrees) {
    Document next = driver.document();
    next.limits[MeshLimit::MinAngle] = degrees;
    driver.context().document.apply(std::move(next), "Limit");
    driver.settle();
}

} // namespace

TEST_CASE("Checks: one line says whether all is well, with the worst value and its limit") {
    Draughtsman driver;
    CHECK(checksSummary(driver.context()).state == ChecksSummary::State::None);
    driver.rectangle({0, 0}, {8, 8});
    driver.key(key::kF5);
    driver.settle();
    CHECK(checksSummary(driver.context()).state == ChecksSummary::State::Ready);
    CHECK_FALSE(driver.has("status/checks"));
    setMinimumAngle(driver, 5.0);
    CHECK(checksSummary(driver.context()).line == "1 limit met");
    setMinimumAngle(driver, 59.5);
    const ChecksSummary summary = checksSummary(driver.context());
    CHECK(summary.state == ChecksSummary::State::Violated);
    CHECK(summary.brief == "1 limit fails");
    CHECK(summary.line.starts_with("1 limit fails: minimum angle "));
    CHECK(summary.line.ends_with("\xc2\xb0 < 59.5\xc2\xb0"));
    driver.click("status/checks");
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
    CHECK(driver.has("checks/violated")); // no green tick beside a violated limit
    CHECK_FALSE(driver.has("checks/summary"));
}

TEST_CASE("Checks: the status bar has one verdict, also for a drawing with errors and warnings") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {6, 6});
    driver.rectangle({4, 4}, {9, 8});
    driver.key('V');
    driver.settle();
    REQUIRE_FALSE(driver.context().preview->faults.empty());
    CHECK(driver.has("status/checks"));
    CHECK_FALSE(driver.has("status/faults"));
    CHECK(checksSummary(driver.context()).state == ChecksSummary::State::Violated);
    driver.click("status/checks");
    driver.settle();
    CHECK(driver.has("checks/violated"));

    auto preview = std::make_shared<DocumentPreview>(*driver.context().preview);
    for (Diagnostic &fault : preview->faults) {
        fault.severity = Severity::Warning;
    }
    const std::size_t warnings = preview->faults.size();
    driver.context().preview = preview;
    const ChecksSummary summary = checksSummary(driver.context());
    CHECK(summary.warns);
    CHECK(summary.state == ChecksSummary::State::Ready);
    CHECK(summary.brief == std::to_string(warnings) + (warnings == 1 ? " warning" : " warnings"));
}

TEST_CASE("Checks: shapes that overlap are offered a union there, too") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {6, 6});
    driver.rectangle({4, 4}, {9, 8});
    driver.key('V');
    driver.workspace(WorkspaceKind::Judge);
    driver.showPanel("checks");
    driver.settle();
    REQUIRE(driver.has("checks/combine"));
    REQUIRE(driver.has("checks/repair"));
    CHECK_FALSE(driver.context()
                    .widgets.find("checks/combine")
                    ->rect.overlaps(driver.context().widgets.find("checks/repair")->rect));
    driver.click("checks/combine");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1); // previewed
    driver.click("dialog/combine/ok");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.undoLabel() == "Combine shapes");
    CHECK_FALSE(driver.has("checks/combine"));
}

TEST_CASE("Status bar: the chip of the mesh leads to a new mesh when the drawing has changed") {
    Draughtsman driver;
    CHECK_FALSE(driver.has("status/mesh"));
    driver.rectangle({0, 0}, {8, 8});
    driver.key('V');
    driver.settle();
    REQUIRE(driver.has("status/mesh"));
    driver.click("status/mesh");
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    driver.rectangle({2, 2}, {3, 3});
    driver.key('V');
    driver.settle();
    REQUIRE(driver.context().run.outOfDate());
    driver.click("status/mesh");
    driver.settle();
    CHECK_FALSE(driver.context().run.outOfDate());
}

TEST_CASE("Status bar: the badge of the log counts warnings until the log was open") {
    Draughtsman driver;
    REQUIRE(driver.has("status/log"));
    const double quiet = driver.context().widgets.find("status/log")->rect.width;
    driver.context().log.add(Diagnostic{.severity = Severity::Warning, .code = "test", .message = "a warning"});
    driver.settle();
    CHECK(driver.context().widgets.find("status/log")->rect.width > quiet);
    driver.click("status/log");
    driver.settle();
    CHECK(driver.has("panel/log"));
    CHECK(driver.context().widgets.find("status/log")->rect.width == quiet);
    driver.click("status/log");
    driver.settle();
    CHECK_FALSE(driver.has("panel/log"));
}

TEST_CASE("Status bar: nothing in it overlaps, however narrow the window") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {8, 8});
    driver.key(key::kF5);
    setMinimumAngle(driver, 59.5);
    for (const int width : {1440, 900, 640, 400}) {
        driver.platform().resize({width, 700}, 1.0);
        driver.settle();
        CAPTURE(width);
        double end = 0.0;
        std::map<double, PixelRect> cells;
        for (const auto &[name, widget] : driver.context().widgets.all()) {
            if (name.starts_with("status/")) {
                cells.emplace(widget.rect.x, widget.rect);
            }
        }
        for (const auto &[x, rect] : cells) {
            CHECK(x >= end - 0.5);
            end = rect.x + rect.width;
        }
        CHECK(end <= width + 0.5);
    }
}

} // namespace forefront::test
