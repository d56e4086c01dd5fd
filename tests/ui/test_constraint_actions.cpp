#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/mesh/quality.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::test {

namespace {

/// A drawing of a slanted quadrilateral, two circles and a short line.
class Sketcher : public Draughtsman {
  public:
    Sketcher() {
        polygon({{1, 1}, {6, 1.4}, {5.7, 5}, {1.2, 4.6}});
        key('C');
        dragPlaces({2.5, 2.5}, {3, 2.5});
        dragPlaces({4.5, 3}, {5.1, 3});
        key('V');
        key(key::kEscape);
        context().selection.clear();
    }
    void choose(const std::vector<SegmentRef> &segments, const std::vector<NodeRef> &nodes = {}) {
        context().selection.clear();
        context().selection.segments.insert(segments.begin(), segments.end());
        context().selection.nodes.insert(nodes.begin(), nodes.end());
        settle();
    }
    /// Runs an action that must be enabled.
    void constrain(const std::string &word) {
        const std::string id = "constraint." + word;
        CAPTURE(id);
        REQUIRE(context().actions.find(id) != nullptr);
        CHECK(context().actions.find(id)->enabled(context()));
        context().actions.run(id, context());
        settle();
    }
    bool offers(const std::string &word) { return context().actions.find("constraint." + word)->enabled(context()); }
    /// Returns true if a message of the log contains a text.
    bool names(std::string_view text) {
        const auto &entries = context().log.entries();
        return std::any_of(entries.begin(), entries.end(), [&](const MessageLog::Entry &entry) {
            return entry.diagnostic.message.find(text) != std::string::npos;
        });
    }
    Vec2 at(std::uint32_t shape, std::size_t node) { return handlesOf(*findShape(document(), shape))[node]; }
    double radius(std::uint32_t shape) { return circleRadius(*findShape(document(), shape)); }
};

} // namespace

TEST_CASE("Sketch: constraints of selected parts hold, one undo step each") {
    Sketcher driver;
    const Document before = driver.document();
    driver.choose({{1, 0}});
    CHECK_FALSE(driver.offers("parallel"));
    driver.constrain("horizontal");
    CHECK(driver.at(1, 0).y == doctest::Approx(driver.at(1, 1).y));
    CHECK(driver.undoLabel() == "Add Horizontal 1");
    driver.choose({{1, 3}});
    driver.constrain("vertical");
    driver.choose({{1, 0}, {1, 2}});
    driver.constrain("parallel");
    CHECK(driver.at(1, 2).y == doctest::Approx(driver.at(1, 3).y));
    driver.choose({{1, 1}, {1, 2}});
    driver.constrain("perpendicular");
    CHECK(driver.at(1, 1).x == doctest::Approx(driver.at(1, 2).x));
    driver.choose({{2, 0}, {3, 0}});
    driver.constrain("equal");
    CHECK(driver.radius(2) == doctest::Approx(driver.radius(3)));
    driver.constrain("concentric");
    CHECK(distance(driver.at(2, 0), driver.at(3, 0)) < 1e-6);
    CHECK(driver.document().constraints.size() == 6);
    for (int k = 0; k < 6; ++k) {
        driver.key('Z', {Modifiers::kControl});
    }
    CHECK(driver.document().shapes == before.shapes);
    CHECK(driver.document().constraints.empty());
}

TEST_CASE("Sketch: each kind is offered for parts that it fits, and none for a size source") {
    Sketcher driver;
    driver.choose({}, {{1, 0}, {1, 1}});
    for (const char *word :
         {"coincident", "horizontal", "vertical", "length", "distance", "horizontalDistance", "verticalDistance"}) {
        CAPTURE(word);
        CHECK(driver.offers(word));
    }
    CHECK_FALSE(driver.offers("radius"));
    driver.choose({{1, 0}}, {{1, 2}});
    for (const char *word : {"onCurve", "midpoint", "distance"}) {
        CAPTURE(word);
        CHECK(driver.offers(word));
    }
    driver.choose({{1, 0}, {1, 2}});
    for (const char *word : {"parallel", "perpendicular", "collinear", "equal", "angle"}) {
        CAPTURE(word);
        CHECK(driver.offers(word));
    }
    driver.choose({{1, 0}, {2, 0}});
    CHECK(driver.offers("tangent"));
    driver.choose({{1, 0}}, {{1, 2}, {1, 3}});
    CHECK(driver.offers("symmetric"));
    driver.choose({}, {{1, 2}});
    CHECK(driver.offers("fixed"));
    driver.choose({{2, 0}});
    CHECK(driver.offers("radius"));
    CHECK(driver.offers("diameter"));
    driver.context().selection.sources.insert(0);
    CHECK_FALSE(driver.offers("radius"));
}

TEST_CASE("Sketch: circles and edges that are selected with Shift get the distance of their centres") {
    Sketcher driver;
    const auto click = [&](Vec2 place, bool shift) {
        driver.hold({Modifiers::kShift}, shift);
        driver.clickPlace(place);
        driver.hold({Modifiers::kShift}, false);
        driver.settle();
    };
    const auto distanceParts = [&] {
        driver.constrain("distance");
        const std::vector<SketchPart> parts = driver.document().constraints.back()->parts;
        driver.key(key::kEscape); // the field of the new value
        driver.key('Z', {Modifiers::kControl});
        driver.settle();
        return parts;
    };
    const SketchPart first{2, SketchPartKind::Node, 0}, second{3, SketchPartKind::Node, 0};
    const Vec2 onFirst{2.5, 3}, onSecond{4.5, 3.6}, onEdge{3, 1.16};
    click(onFirst, false);
    click(onEdge, true);
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{1, 2});
    CHECK(distanceParts() == std::vector<SketchPart>{first, {1, SketchPartKind::Segment, 0}});
    CHECK(driver.offers("tangent"));
    const auto menu = driver.context().actions.find("shape.dimension");
    CHECK(menu->enabled(driver.context())); // else the menu of the selection leaves it out
    click(onFirst, false);
    click(onSecond, true);
    CHECK(distanceParts() == std::vector<SketchPart>{first, second});
    for (const char *word : {"horizontalDistance", "verticalDistance"}) {
        CHECK(driver.offers(word));
    }
    driver.key(key::kEscape);
    click(onEdge, false);
    click(onEdge, false); // the edge itself
    click(onFirst, true);
    CHECK(distanceParts() == std::vector<SketchPart>{first, {1, SketchPartKind::Segment, 0}});
    // Alone, a clicked shape is meant as a whole.
    driver.key(key::kEscape);
    click(onEdge, false);
    CHECK_FALSE(driver.offers("length"));
    CHECK_FALSE(menu->enabled(driver.context()));
}

TEST_CASE("Sketch: of sides that are not parallel, the angle is offered and no distance") {
    Sketcher driver;
    driver.choose({{1, 0}, {1, 3}});
    CHECK(driver.offers("angle"));
    CHECK_FALSE(driver.offers("distance"));
}

TEST_CASE("Sketch: a number typed over an expression of the same value is not reported as a mismatch") {
    Sketcher driver;
    Result<Document> named = setParameters(driver.document(), {{"d", "1"}});
    REQUIRE(named.ok());
    driver.context().document.apply(*std::move(named), "Parameters");
    driver.context().selection.clear();
    driver.context().selection.shapes = {2};
    driver.settle();
    driver.fill("inspector/radius", "d/2");
    REQUIRE(driver.radius(2) == 0.5);
    REQUIRE(driver.document().formulas.size() == 1);
    driver.fill("inspector/radius", "0.5");
    CHECK(driver.document().formulas.empty());
    CHECK_FALSE(driver.names("no longer matches"));
}

TEST_CASE("Sketch: the inspector edits dimensions, also by parameters, shows what is free, and removes") {
    Sketcher driver;
    driver.choose({{2, 0}});
    driver.constrain("diameter");
    REQUIRE(driver.has("inspector/sketch"));
    const std::string row = "inspector/constraint/" + std::to_string(driver.document().constraints.front()->id);
    driver.fill(row, "1.6");
    CHECK(driver.radius(2) == doctest::Approx(0.8));
    CHECK(driver.undoLabel() == "Change Diameter 1");
    Result<Document> named = setParameters(driver.document(), {{"d", "2"}});
    REQUIRE(named.ok());
    driver.context().document.apply(*std::move(named), "Parameters");
    driver.fill(row, "d/2");
    CHECK(driver.radius(2) == doctest::Approx(0.5));
    named = setParameters(driver.document(), {{"d", "3"}});
    REQUIRE(named.ok());
    driver.context().applyCommand(std::move(named), "Change parameter");
    driver.settle();
    CHECK(driver.radius(2) == doctest::Approx(0.75));
    driver.click(row + "/remove");
    CHECK(driver.document().constraints.empty());
    CHECK_FALSE(driver.has("inspector/sketch"));
    CHECK(driver.radius(2) == doctest::Approx(0.75));
}

TEST_CASE("Sketch: constraints that cannot hold together are refused by name and change nothing") {
    Sketcher driver;
    driver.choose({}, {{1, 0}});
    driver.constrain("fixed");
    driver.choose({}, {{1, 1}});
    driver.constrain("fixed");
    const std::shared_ptr<const Document> before = driver.context().document.current();
    driver.choose({{1, 0}});
    driver.constrain("horizontal");
    CHECK(driver.context().document.current() == before);
    CHECK(driver.logHas("constraint-conflict"));
    bool named = false;
    for (const MessageLog::Entry &entry : driver.context().log.entries()) {
        named = named || entry.diagnostic.message.find("Fixed 2") != std::string::npos;
    }
    CHECK(named);
}

TEST_CASE("Sketch: a segment cannot be horizontal and vertical, for it would vanish") {
    Sketcher driver;
    driver.choose({{1, 0}});
    driver.constrain("horizontal");
    const std::shared_ptr<const Document> before = driver.context().document.current();
    driver.constrain("vertical");
    CHECK(driver.context().document.current() == before);
    CHECK(driver.logHas("constraint-conflict"));
}

TEST_CASE("Sketch: deleting a shape names the constraints that go with it") {
    Sketcher driver;
    driver.choose({{2, 0}});
    driver.constrain("radius");
    driver.key(key::kEscape); // the field of the new dimension
    driver.context().selection.clear();
    driver.context().selection.shapes.insert(2);
    driver.key(key::kDelete);
    CHECK(driver.document().constraints.empty());
    bool named = false;
    for (const MessageLog::Entry &entry : driver.context().log.entries()) {
        named = named || entry.diagnostic.message.find("Removed 1 sketch constraint: Radius 1") == 0;
    }
    CHECK(named);
}

TEST_CASE("Sketch: what an operation removes is named once it is accepted") {
    Sketcher driver;
    driver.choose({{2, 0}});
    driver.constrain("radius");
    driver.context().selection.clear();
    driver.context().selection.shapes.insert(2);
    driver.settle();
    driver.context().actions.run("shape.transform", driver.context());
    driver.frames(3);
    driver.fill("dialog/transform/scalex", "150");
    if (driver.has("dialog/transform/ok")) {
        driver.click("dialog/transform/ok");
    }
    driver.settle();
    CHECK(driver.document().constraints.empty());
    CHECK(driver.names("Removed 1 sketch constraint: Radius 1"));
}

TEST_CASE("Sketch: a dragged node takes along what its constraints hold, and the drag is one step") {
    Sketcher driver;
    driver.choose({{1, 0}});
    driver.constrain("horizontal");
    driver.key('V');
    driver.context().selection.clear();
    driver.context().selection.nodes.insert({1, 1});
    driver.settle();
    const Vec2 from = driver.at(1, 1);
    driver.dragPlaces(from, from + Vec2{0.5, 0.8});
    CHECK(driver.at(1, 1).y == doctest::Approx(driver.at(1, 0).y));
    CHECK(driver.at(1, 1).x > from.x + 0.3);
    driver.key('Z', {Modifiers::kControl});
    CHECK(distance(driver.at(1, 1), from) < 1e-12);
}

TEST_CASE("Sketch: construction geometry is not meshed") {
    Sketcher driver;
    const auto meshedArea = [&] {
        driver.key('2');
        driver.settle();
        REQUIRE(driver.run().mesh != nullptr);
        return measureQuality(driver.run().mesh->view(), nullptr).area;
    };
    const double area = meshedArea();
    driver.context().selection.clear();
    driver.context().selection.shapes.insert(2);
    driver.settle();
    driver.context().actions.run("shape.construction", driver.context());
    driver.settle();
    CHECK(driver.context().actions.find("shape.construction")->checked(driver.context()));
    CHECK(findShape(driver.document(), 2)->construction);
    CHECK(meshedArea() > area + 0.5); // the hole is gone
}

} // namespace forefront::test
