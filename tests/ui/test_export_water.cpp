#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/replayed_script.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace forefront::test {

using forefront::testing::TemporaryFolder;

namespace {

/// A bay whose right side is named "sea", and has the tag 2.
void drawBay(Draughtsman &driver) {
    driver.rectangle({1, 1}, {9, 8});
    const std::uint32_t shape = driver.document().shapes.back()->id;
    REQUIRE(driver.context().applyCommand(
        nameBoundaryPart(driver.document(), {.shapes = {}, .segments = {{shape, 1}}}, "sea"), "Name"));
    driver.settle();
    REQUIRE(segmentTag(*driver.document().shapes.back(), 1) == 2);
}

void askFor(Draughtsman &driver, const std::string &preset) {
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    driver.click("dialog/export/preset/" + preset);
    driver.settle();
}

std::string announcedText(Draughtsman &driver) {
    return driver.context().log.entries().back().diagnostic.message;
}

} // namespace

TEST_CASE("Export of water models: open parts and the elevation go into the file and stay with the document") {
    const TemporaryFolder place;
    Draughtsman driver;
    drawBay(driver);
    driver.key(key::kF5);
    driver.settle();
    const std::uint64_t hash = meshHash(driver.run().mesh->view());
    askFor(driver, "adcirc");
    REQUIRE(driver.has("dialog/export/open/1"));
    driver.click("dialog/export/open/2");
    driver.fill("dialog/export/elevation", "-4 - 0.5*x");
    driver.chooseFile("export", place / "bay.14");
    REQUIRE(std::filesystem::exists(place / "bay.14"));
    CHECK(announcedText(driver).find("land") == std::string::npos);
    CHECK(announcedText(driver).find("depth") == std::string::npos);
    const Result<MeshField> bed = readField(place / "bay.14", "elevation");
    REQUIRE(bed.ok());
    for (std::size_t n = 0; n < bed->mesh.nodes.size(); ++n) {
        CHECK(bed->values[n] == doctest::Approx(-4.0 - 0.5 * bed->mesh.nodes[n].x));
    }
    std::size_t open = 0;
    for (const TaggedEdge &edge : bed->mesh.edges) {
        const bool right = bed->mesh.nodes[index(edge.a)].x > 8.99 && bed->mesh.nodes[index(edge.b)].x > 8.99;
        CHECK((boundaryName(bed->mesh.boundaryNames, edge.tag) == "open_1") == right);
        open += right ? 1 : 0;
    }
    CHECK(open > 3);
    CHECK(driver.document().openBoundaries == std::vector{2});
    CHECK(driver.document().elevation == "-4 - 0.5*x");
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK(meshHash(driver.run().mesh->view()) == hash);
    driver.key('Z', {Modifiers::kControl}); // one command
    CHECK(driver.document().openBoundaries.empty());
    CHECK(driver.document().elevation.empty());
    driver.key('Y', {Modifiers::kControl});

    askFor(driver, "telemac"); // as they were
    driver.chooseFile("export", place / "bay.slf");
    std::ifstream conditions(place / "bay.cli");
    const std::string codes((std::istreambuf_iterator<char>(conditions)), {});
    CHECK(codes.find("5 4 4 ") != std::string::npos);
    CHECK(codes.find("2 2 2 ") != std::string::npos);
}

TEST_CASE("Export of water models: what batch says of land and depths is said in the dialog and when it is done") {
    const TemporaryFolder place;
    Draughtsman driver;
    drawBay(driver);
    askFor(driver, "adcirc");
    CHECK(driver.has("dialog/export/land"));
    CHECK_FALSE(driver.has("dialog/export/names"));       // the file has none
    CHECK_FALSE(driver.has("dialog/export/inner-edges")); // nor these
    driver.chooseFile("export", place / "bay.14");
    REQUIRE(std::filesystem::exists(place / "bay.14"));
    CHECK(announcedText(driver).find("all of the boundary is land; check") != std::string::npos);
    CHECK(announcedText(driver).find("all nodes have the depth 0") != std::string::npos);
    CHECK(driver.document().openBoundaries.empty());
    CHECK(driver.has("canvas/note"));
    askFor(driver, "adcirc");
    driver.fill("dialog/export/elevation", "4 + x/100");
    driver.chooseFile("export", place / "dry.14");
    CHECK(driver.logHas("dry-elevations"));
    askFor(driver, "su2");
    CHECK_FALSE(driver.has("dialog/export/open/1"));
    CHECK_FALSE(driver.has("dialog/export/elevation"));
    CHECK(driver.has("dialog/export/names"));
}

TEST_CASE("Export of water models: an elevation without a value is refused, and nothing is written") {
    const TemporaryFolder place;
    Draughtsman driver;
    drawBay(driver);
    askFor(driver, "adcirc");
    driver.fill("dialog/export/elevation", "-deep(x,y)");
    CHECK(driver.logHas("expression-syntax"));
    REQUIRE(driver.has("dialog/export/ok"));
    CHECK_FALSE(driver.context().widgets.find("dialog/export/ok")->enabled);
    driver.fill("dialog/export/elevation", "log(x - 5)"); // not finite in half of the bay
    driver.chooseFile("export", place / "bay.14");
    CHECK(driver.logHas("no-elevation"));
    CHECK(driver.has("canvas/error"));
    CHECK(place.fileCount() == 0);
}

TEST_CASE("Export of water models: a recorded script has them") {
    const TemporaryFolder place;
    Draughtsman driver;
    drawBay(driver);
    driver.context().actions.run("file.recordScript", driver.context());
    driver.settle();
    driver.chooseFile("recordscript", place / "day.jsonl");
    askFor(driver, "adcirc");
    driver.click("dialog/export/open/2");
    driver.fill("dialog/export/elevation", "-4 - 0.5*x");
    driver.chooseFile("export", place / "bay.14");
    driver.context().actions.run("file.recordScript", driver.context());
    driver.settle();
    std::ifstream file(place / "day.jsonl");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    INFO(text);
    CHECK(text.find(R"("file": "bay.14", "format": "adcirc", "open": ["sea"], "elevation": "-4 - 0.5*x"})") !=
          std::string::npos);
    CHECK(text.find("\"change\"") != std::string::npos);
    const Document replayed = replayedScript(text);
    CHECK(replayed.openBoundaries == driver.document().openBoundaries);
    CHECK(replayed.elevation == driver.document().elevation);
}

} // namespace forefront::test
