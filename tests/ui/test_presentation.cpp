#include "core/teaching/moment/short_texts.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/shell/presentation.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

namespace forefront::test {

TEST_CASE("Presentation: the canvas, the caption and the ten steps alone, larger; Esc goes back") {
    MeshedSquare driver;
    chooseWorkspace(driver.context(), WorkspaceKind::Draw);
    driver.settle();
    const double before = driver.canvas().width * driver.canvas().height;
    const float scale = driver.context().scale;
    driver.key(key::kF11);
    driver.settle();
    for (const char *gone : {"menu/File", "options", "tool/select", "status/pointer", "canvas/tools", "hints"}) {
        CAPTURE(gone);
        CHECK_FALSE(driver.has(gone));
    }
    CHECK(driver.context().scale == doctest::Approx(1.5F * scale));
    CHECK(driver.canvas().width * driver.canvas().height > 0.8 * before);
    CHECK(driver.has("timeline/play"));
    for (int step = 1; step <= 10; ++step) {
        CAPTURE(step);
        REQUIRE(driver.has("presentation/" + std::to_string(step)));
        const PixelRect row = driver.context().widgets.find("presentation/" + std::to_string(step))->rect;
        CHECK(row.y + row.height <= 800.0); // all ten fit
    }
    driver.key(key::kHome);
    driver.settle();
    driver.key('.'); // stepping works as ever
    driver.settle();
    CHECK(driver.run().advance == 1);
    driver.key(key::kEscape);
    driver.settle();
    CHECK(driver.has("menu/File"));
    CHECK_FALSE(driver.has("presentation/1"));
    CHECK(driver.context().settings.workspace == WorkspaceKind::Draw);
    CHECK(driver.context().scale == scale);
    driver.key(key::kF11);
    driver.settle();
    driver.click("presentation/leave");
    driver.settle();
    CHECK(driver.has("menu/File"));
}

TEST_CASE("Presentation: A, B, C and the candidates keep their labels, in larger letters") {
    MeshedSquare driver;
    chooseWorkspace(driver.context(), WorkspaceKind::Step);
    driver.context().run.seek(3);
    driver.settle();
    driver.context().run.step(Granularity::Event, 8);
    driver.settle();
    const auto labels = [&] {
        std::map<std::string, double> heights;
        for (const CanvasPainter::Placed &label : driver.editor().canvas().labels()) {
            heights[label.text] = label.rect.height;
        }
        return heights;
    };
    // The base is as long on the screen as in a drawing that has just enough room for its labels.
    const AdvanceExplanation &advance = *driver.run().explanation;
    driver.context().view.camera.zoom =
        66.0 * static_cast<double>(driver.context().scale) / distance(advance.a, advance.b);
    driver.context().view.fitted.reset();
    driver.settle();
    const std::map<std::string, double> before = labels();
    REQUIRE(before.contains("C"));
    REQUIRE(before.size() >= 4);
    driver.key(key::kF11);
    driver.settle();
    REQUIRE(driver.has("presentation/1"));
    const std::map<std::string, double> presented = labels();
    for (const auto &label : before) {
        CAPTURE(label.first);
        REQUIRE(presented.contains(label.first));
        CHECK(presented.at(label.first) > 1.3 * label.second);
    }
}

TEST_CASE("Presentation: the program of a front of quadrilaterals is the one of the panel Steps") {
    CHECK(shell::presentedLine(Step::Update, nullptr, true) == squareStepLine(Step::Update));
    CHECK(shell::presentedLine(Step::Update, nullptr, true).find("ABC") == std::string::npos);
    CHECK(shell::presentedLine(Step::Update, nullptr, false).find("ABC") != std::string::npos);
}

} // namespace forefront::test
