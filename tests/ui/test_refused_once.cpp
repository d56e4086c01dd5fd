#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/tools/common/drawing_tool.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace forefront::test {

namespace {

/// Returns the number of notices on the canvas.
int notices(const Draughtsman &driver) {
    return (driver.has("canvas/error") ? 1 : 0) + (driver.has("canvas/note") ? 1 : 0);
}

/// Expects that the reason is beside a field and nowhere else.
void expectAtField(Draughtsman &driver, const std::string &field, const std::string &text) {
    CAPTURE(field);
    driver.fill(field, text);
    driver.frames(3);
    CHECK(driver.has(field + "/fault"));
    CHECK(notices(driver) == 0);
    CHECK_FALSE(driver.has("tooltip"));
    driver.click(field);
    driver.key(key::kEscape);
    driver.frames(3);
}

} // namespace

TEST_CASE("A refusal is shown once: in fields of panels, of the options bar and of parameters") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    expectAtField(driver, "inspector/cornerradius", "-1");
    expectAtField(driver, "inspector/cornerradius", "1+");
    expectAtField(driver, "inspector/tag", "0");
    driver.showPanel("spacing");
    expectAtField(driver, "spacing/size", "-1");
    expectAtField(driver, "spacing/expression", "0.2+*");
    driver.showPanel("parameters");
    driver.click("parameters/add");
    driver.settle();
    expectAtField(driver, "parameters/0/expression", "2*(");
    expectAtField(driver, "parameters/0/name", "2x");
    driver.key('R');
    driver.settle();
    expectAtField(driver, "options/cornerradius", "-1");
    expectAtField(driver, "options/tag", "0");
}

TEST_CASE("A refusal is shown once: numbers typed on the canvas") {
    Draughtsman driver;
    driver.key('C');
    driver.moveToPlace({5, 5});
    driver.clickPlace({5, 5});
    driver.keys("0");
    driver.key(key::kEnter);
    driver.frames(3);
    CHECK(driver.document().shapes.empty());
    CHECK(notices(driver) == 0);
    CHECK_FALSE(driver.has("tooltip"));
    CHECK(driver.context().log.entries().empty());
}

TEST_CASE("A refusal is shown once: files that cannot be read or written, in the dialog") {
    const TemporaryFolder place;
    std::ofstream(place.path / "bad.geojson") << R"({"type": "FeatureCollection", "features": [)";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.context().actions.run("file.import", driver.context());
    driver.settle();
    driver.chooseFile("import", place.path / "bad.geojson");
    driver.frames(3);
    REQUIRE(driver.has("dialog/import/warning"));
    CHECK(notices(driver) == 0);
    driver.click("dialog/import/cancel");
    driver.settle();
    CHECK(notices(driver) == 0);

    driver.key(key::k2);
    driver.settle();
    driver.frames(700); // the notice of the mesh, if any, is gone
    driver.key('E', kControl);
    driver.settle();
    driver.click("dialog/export/name");
    driver.key('A', kControl);
    driver.type((place.path / "missing" / "plate.msh").string());
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.has("dialog/export/warning"));
    CHECK(notices(driver) == 0);
}

TEST_CASE("Status bar: the number of new messages leaves out what a field or dialog shows") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.settle();
    const double before = driver.context().widgets.find("status/log")->rect.width;
    driver.fill("inspector/cornerradius", "-1");
    driver.frames(3);
    REQUIRE(driver.has("inspector/cornerradius/fault"));
    CHECK(driver.context().widgets.find("status/log")->rect.width == before);
}

} // namespace forefront::test
