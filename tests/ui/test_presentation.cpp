#include "tests/ui/meshed_square.hpp"
#include "ui/parts/shown_panels.hpp"

#include <doctest/doctest.h>

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

} // namespace forefront::test
