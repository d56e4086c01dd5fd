#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace forefront::test {

namespace {

void importMap(Draughtsman &driver, const std::filesystem::path &file, const char *coordinates) {
    std::ofstream(file) << R"({"type": "Polygon", "coordinates": [[)" << coordinates << "]]}";
    driver.key('I', {Modifiers::kControl});
    driver.frames(5);
    driver.chooseFile("import", file);
    REQUIRE(driver.has("dialog/importoptions/ok"));
}

constexpr const char *kNorth = "[24,60],[25,60],[25,61],[24,61],[24,60]";

} // namespace

TEST_CASE("Import: a map in longitudes and latitudes is projected to metres unless degrees are kept") {
    const TemporaryFolder place;
    Draughtsman driver;
    importMap(driver, place.path / "lake.geojson", kNorth);
    REQUIRE(driver.has("dialog/importoptions/degrees/keep degrees"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(boundsOf(driver.document()).size().y > 111'000.0);
    CHECK(driver.logHas("projected"));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();

    importMap(driver, place.path / "lake.geojson", kNorth);
    driver.click("dialog/importoptions/degrees/keep degrees");
    driver.settle();
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(boundsOf(driver.document()) == Box2{{24, 60}, {25, 61}});
    CHECK_FALSE(driver.logHas("degrees")); // said on purpose
}

TEST_CASE("Import: a small plan near the origin stays as it is, and large coordinates offer no projection") {
    const TemporaryFolder place;
    Draughtsman driver;
    importMap(driver, place.path / "plan.geojson", "[0,0],[4,0],[4,3],[0,3],[0,0]");
    CHECK(driver.has("dialog/importoptions/degrees/keep degrees"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(boundsOf(driver.document()) == Box2{{0, 0}, {4, 3}});
    importMap(driver, place.path / "basin.geojson",
              "[687123,5312345],[687923,5312345],[687923,5312945],[687123,5312345]");
    CHECK_FALSE(driver.has("dialog/importoptions/degrees/keep degrees"));
}

TEST_CASE(
    "Open: a map in longitudes and latitudes is opened as it is, with a warning that names the way to project it") {
    const TemporaryFolder place;
    std::ofstream(place.path / "lake.geojson") << R"({"type": "Polygon", "coordinates": [[)" << kNorth << "]]}";
    Draughtsman driver;
    driver.editor().input().push({.kind = InputKind::Drop, .paths = {(place.path / "lake.geojson").string()}});
    driver.settle();
    CHECK(boundsOf(driver.document()) == Box2{{24, 60}, {25, 61}});
    REQUIRE(driver.logHas("degrees"));
    bool named = false;
    for (const MessageLog::Entry &entry : driver.context().log.entries()) {
        named = named || (entry.diagnostic.code == "degrees" && entry.announced &&
                          entry.diagnostic.message.find("\"Project to metres\"") != std::string::npos);
    }
    CHECK(named);
}

} // namespace forefront::test
