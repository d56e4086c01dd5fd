#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/parts/shown_panels.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

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

TEST_CASE("Rule: its figures come from the extent of the drawing, and negative values are elevations") {
    const TemporaryFolder place;
    std::ofstream(place.path / "bed.asc") << "ncols 2\nnrows 2\nxllcorner -2\nyllcorner -2\ncellsize 8\n-2 -4\n-2 -4\n";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9}); // a diagonal of 11.3
    driver.context().actions.run("file.addRaster", driver.context());
    driver.frames(5);
    driver.chooseFile("addraster", place.path / "bed.asc");
    driver.settle();
    chooseWorkspace(driver.context(), WorkspaceKind::Size);
    driver.settle();
    driver.click("spacing/presets");
    driver.settle();
    REQUIRE(driver.click("contextmenu/wavelength"));
    driver.settle();
    const std::string expression = driver.document().spacing.expression.value_or("");
    CAPTURE(expression);
    CHECK(expression.find("0.028") != std::string::npos);
    CHECK(expression.find("-bed(x,y)") != std::string::npos);
    driver.settle();
    CHECK(driver.context().preview->spacing != nullptr);
}

} // namespace forefront::test
