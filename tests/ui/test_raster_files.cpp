#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <fstream>

namespace forefront::test {

TEST_CASE("Add raster: the expression calls it by the name of its file; removing it is a fault of the expression") {
    const TemporaryFolder place;
    std::ofstream(place.path / "depth.asc") << "ncols 2\nnrows 2\nxllcorner -2\nyllcorner -2\ncellsize 8\n2 4\n2 4\n";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    driver.context().actions.run("file.addRaster", driver.context());
    driver.frames(5);
    driver.chooseFile("addraster", place.path / "depth.asc");
    driver.settle();
    CHECK_FALSE(driver.context().dialogs.any());
    CHECK(driver.undoLabel() == "Add raster");
    REQUIRE(driver.document().spacing.rasters.contains("depth"));
    driver.context().document.apply(setExpression(driver.document(), "0.25*depth(x,y)"), "Change expression");
    driver.settle();
    REQUIRE(driver.context().preview->spacing != nullptr);
    CHECK(driver.context().preview->spacing->at({6, 5}) == doctest::Approx(0.75).epsilon(0.02));
    driver.key('Z', kControl);
    driver.key('Z', kControl);
    CHECK(driver.document().spacing.rasters.empty());
}

} // namespace forefront::test
