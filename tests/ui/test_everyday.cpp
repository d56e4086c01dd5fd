#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace forefront::test {

namespace {

const Diagnostic *lastMessage(Draughtsman &driver) {
    const auto &entries = driver.context().log.entries();
    return entries.empty() ? nullptr : &entries.back().diagnostic;
}

} // namespace

TEST_CASE("Refusals: a command that does nothing says so as a warning, not as a success") {
    Draughtsman driver;
    driver.key('L');
    driver.clickPlace({1, 1});
    driver.clickPlace({9, 8});
    driver.key(key::kEnter);
    driver.key('J');
    driver.clickPlace({5, 4.5}); // crossed by nothing
    driver.settle();
    REQUIRE(lastMessage(driver) != nullptr);
    CHECK(lastMessage(driver)->severity == Severity::Warning);
    CHECK(driver.has("canvas/error"));
    CHECK_FALSE(driver.has("canvas/note"));
}

TEST_CASE("Pen: freehand of the polygon tool does not stay on for the polyline tool") {
    Draughtsman driver;
    driver.key('P');
    driver.click("options/pen/Freehand");
    driver.settle();
    driver.key('L');
    driver.clickPlace({1, 1});
    driver.clickPlace({9, 8});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes[0]->nodes.size() == 2);
    driver.key('P');
    driver.settle();
    CHECK(driver.has("options/freehand/Smooth")); // it stays on for its own tool
}

TEST_CASE("Brush: its size and radius come from the drawing at the first stroke, not from an earlier view") {
    Draughtsman driver;
    driver.key('B'); // on an empty canvas of 10 units
    driver.settle();
    driver.key('V');
    Shape lake;
    lake.form = RectangleForm{};
    lake.nodes = {{0, 0}, {6000, 4000}};
    driver.context().document.apply(*addShape(Document(), lake), "Draw");
    driver.settle();
    driver.key('F');
    driver.settle();
    driver.key('B');
    driver.settle();
    const double pixels = 36.0 / driver.context().view.camera.zoom;
    const double before = driver.context().preview->spacing->at({3000, 2000});
    driver.dragPlaces({3000, 2000}, {3000, 2000});
    driver.settle();
    const double painted = driver.context().preview->spacing->at({3000, 2000});
    CHECK(painted < 0.6 * before);
    CHECK(painted > 0.2 * before);
    const SpacingSample beside = driver.context().preview->spacing->sample({3000 + 0.5 * pixels, 2000});
    CHECK(beside.origin == SpacingOrigin::Paint); // the ring has the radius that it shows
}

TEST_CASE("Snapping: to the grid comes back when a drawing without a picture is opened") {
    Draughtsman driver;
    driver.context().snapping.toGrid = false;
    driver.context().snapping.offForPicture = true;
    Document traced = driver.document();
    traced.picture = BackgroundPicture{.file = "shore.png", .corner = {0, 0}, .size = {12, 6}};
    driver.context().document.apply(traced, "Add background picture");
    driver.settle();
    CHECK_FALSE(driver.context().snapping.toGrid);
    driver.context().document.load({}, {});
    driver.settle();
    CHECK(driver.context().snapping.toGrid);
}

TEST_CASE("Probe: measure, value and place are shown at the element, whatever panel is open") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key(key::k2);
    driver.settle();
    REQUIRE(driver.run().mesh);
    const double zoom = driver.context().view.camera.zoom;
    driver.key('I');
    driver.settle();
    driver.clickPlace({5, 4.4});
    driver.settle();
    driver.frames(2);
    REQUIRE(driver.context().probe.chosen.has_value());
    CHECK(driver.has("probe/plate/place"));
    driver.key('V');
    CHECK(driver.context().actions.run("run.worst", driver.context()));
    driver.settle();
    driver.frames(2);
    CHECK(driver.has("probe/plate/value"));
    CHECK(driver.has("probe/plate/place"));
    CHECK(driver.context().view.camera.zoom > zoom);
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.has("probe/plate/place"));
}

TEST_CASE("Rounded rectangle: a click on its side selects the straight part, and names that alone") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 7});
    driver.key('V');
    driver.fill("inspector/cornerradius", "2");
    driver.clickPlace({9, 4});
    driver.clickPlace({9, 4});
    REQUIRE(driver.context().selection.segments == std::set<SegmentRef>{{1, 1}});
    driver.key(key::kF1 + 1);
    driver.type("load");
    driver.key(key::kEnter);
    driver.settle();
    const Shape &box = *driver.document().shapes[0];
    const std::int32_t load = segmentTag(box, 1);
    CHECK(driver.document().boundaryNames.at(load) == "load");
    for (std::size_t part = 0; part < taggedSegments(box); ++part) {
        CHECK((segmentTag(box, part) == load) == (part == 1));
    }
    driver.key(key::k2);
    driver.settle();
    double length = 0.0;
    for (const TaggedEdge &edge : driver.run().mesh->mesh.edges) {
        const auto &nodes = driver.run().mesh->mesh.nodes;
        length += edge.tag == load ? distance(nodes[index(edge.a)], nodes[index(edge.b)]) : 0.0;
    }
    CHECK(length == doctest::Approx(2.0));
    const Vec2 corner{7.0 + std::sqrt(2.0), 5.0 + std::sqrt(2.0)};
    driver.clickPlace({5, 4});
    driver.clickPlace(corner);
    driver.clickPlace(corner);
    CHECK(driver.context().selection.segments == std::set<SegmentRef>{{1, 5}});
}

TEST_CASE("Notes: shapes that overlap are offered a union, with a preview") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {6, 6});
    driver.rectangle({4, 4}, {9, 8});
    driver.key('V');
    driver.key(key::k2);
    driver.settle();
    REQUIRE(driver.has("canvas/error/combine"));
    driver.click("canvas/error/combine");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1); // previewed
    driver.click("dialog/combine/ok");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.undoLabel() == "Combine shapes");
    CHECK_FALSE(driver.context().actions.find("edit.combine")->enabled(driver.context()));
}

TEST_CASE("Export: after a click on a solver, what is typed is the name") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key(key::k2);
    driver.settle();
    driver.key('E', kControl);
    driver.settle();
    driver.click("dialog/export/browse");
    driver.settle();
    REQUIRE(driver.has("dialog/export/path"));
    driver.click("dialog/export/path");
    driver.key('A', kControl);
    driver.type(place.path.string());
    driver.key(key::kEnter);
    driver.settle();
    driver.click("dialog/export/preset/su2");
    driver.type("channel");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "channel.su2"));
}

TEST_CASE("Export: another format changes the ending of the typed name alone") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key(key::k2);
    driver.settle();
    driver.key('E', kControl);
    driver.settle();
    driver.click("dialog/export/name");
    driver.key('A', kControl);
    driver.type((place.path / "channel.v2").string());
    driver.click("dialog/export/preset/su2");
    driver.frames(3);
    driver.click("dialog/export/preset/paraview");
    driver.frames(3);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(std::filesystem::exists(place.path / "channel.v2.vtu"));
}

TEST_CASE("Notes: when opening a file leaves something out, a button of the notice opens the log") {
    const TemporaryFolder place;
    std::ofstream(place.path / "label.svg") << R"(<svg viewBox="0 0 10 10"><rect width="9" height="6"/>)"
                                            << R"(<text x="3" y="5">Label</text></svg>)";
    Draughtsman driver;
    driver.key('O', kControl);
    driver.settle();
    driver.chooseFile("open", place.path / "label.svg");
    driver.frames(5);
    REQUIRE(driver.logHas("left-out"));
    REQUIRE(driver.has("canvas/error/log"));
    driver.click("canvas/error/log");
    driver.frames(5);
    CHECK(driver.has("panel/log"));
    CHECK_FALSE(driver.has("canvas/error/log"));
}

TEST_CASE("Open: letters and arrow keys go through the list of files") {
    const TemporaryFolder place;
    Draughtsman driver;
    for (const char *name : {"anvil", "bracket", "bridge"}) {
        REQUIRE(writeProject(place.path / (std::string(name) + ".forefront"), driver.document()).empty());
    }
    driver.key('O', kControl);
    driver.settle();
    driver.click("dialog/open/path");
    driver.key('A', kControl);
    driver.type(place.path.string());
    driver.key(key::kEnter);
    driver.settle();
    driver.click("dialog/open/list/anvil.forefront");
    driver.frames(30);
    driver.keys("bri");
    driver.key(key::kUp);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.context().document.path() == place.path / "bracket.forefront");
}

} // namespace forefront::test
