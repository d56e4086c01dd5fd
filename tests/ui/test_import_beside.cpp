#include "core/drawing/names/region_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Import: undone, the drawing before is in view again") {
    const TemporaryFolder place;
    {
        Draughtsman driver;
        driver.rectangle({1, 1}, {9, 8});
        REQUIRE(writeProject(place.path / "lake.forefront", *setBoundaryName(driver.document(), 1, "lake")).empty());
    }
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    const double zoom = driver.context().view.camera.zoom;
    driver.key('I', kControl);
    driver.frames(5);
    driver.chooseFile("import", place.path / "lake.forefront");
    driver.fill("dialog/importoptions/scale", "1500");
    driver.click("dialog/importoptions/ok");
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(driver.document().shapes[1]->tag == 2); // its part is not that of the rectangle
    CHECK(driver.context().view.camera.zoom < 0.01 * zoom);
    driver.key('Z', kControl);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.context().view.camera.zoom > 0.3 * zoom);
}

} // namespace forefront::test
