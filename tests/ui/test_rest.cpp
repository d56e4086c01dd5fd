#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

TEST_CASE("Rest: with a mesh, no panel, layer or lesson asks for frames while nothing happens") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key(key::kF5);
    driver.settle();
    const auto check = [&](const std::string &what) {
        driver.context().animate();
        driver.settle();
        CAPTURE(what);
        CHECK(driver.editor().sleepSeconds() >= 0.5);
        CHECK_FALSE(driver.editor().needsFrame());
    };
    check("the mesh");
    for (const auto &panel : driver.context().panels) {
        driver.showPanel(panel->id());
        check(panel->id());
    }
    for (const LayerSlot &slot : driver.context().layers) {
        showLayer(driver.context().layers, slot.layer->id(), true);
        check(slot.layer->id());
    }
    driver.context().view.runPlot = true;
    check("plots of the run");
    driver.key(key::kF1 + 3);
    check("lessons");
}

} // namespace forefront::test
