#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace forefront::test {

namespace {

std::ptrdiff_t edges(Draughtsman &driver, std::int32_t tag) {
    driver.key(key::kF5);
    driver.settle();
    const TriMesh &mesh = driver.run().mesh->mesh;
    return std::count_if(mesh.edges.begin(), mesh.edges.end(), [&](const TaggedEdge &edge) { return edge.tag == tag; });
}

/// Returns the number of edges along one segment of a shape, as meshed.
std::ptrdiff_t along(Draughtsman &driver, SegmentRef segment) {
    driver.key(key::kF5); // the inspector compares with the mesh
    driver.settle();
    constexpr std::int32_t kApart = 999;
    const Document &document = driver.document();
    const bool whole = taggedSegments(*findShape(document, segment.shape)) == 1;
    const auto outcome = meshDomain(
        jobOf(whole ? *setShapeTag(document, {segment.shape}, kApart) : *setSegmentTag(document, {segment}, kApart)));
    REQUIRE(outcome);
    const std::vector<TaggedEdge> &edges = outcome->mesh.edges;
    return std::count_if(edges.begin(), edges.end(), [](const TaggedEdge &edge) { return edge.tag == kApart; });
}

void clear(Draughtsman &driver, std::string_view field) {
    driver.click(field);
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    driver.settle();
}

} // namespace

TEST_CASE("Elements: a number for one segment, for several and for a circle; each is one undo step") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('C');
    driver.dragPlaces({5, 4}, {6.5, 4});
    Document sized = driver.document();
    sized.spacing.size = 3.0;
    driver.context().document.apply(std::move(sized), "Size");
    driver.key('V');
    driver.key(key::kEscape);
    driver.clickPlace({3, 1});
    driver.clickPlace({3, 1});
    REQUIRE(driver.context().selection.segments == std::set<SegmentRef>{{1, 0}});
    driver.fill("inspector/elements", "13");
    CHECK(driver.undoLabel() == "Set number of elements");
    CHECK(driver.document().shapes[0]->segmentTags.empty()); // a number of elements is no boundary
    CHECK(along(driver, {1, 0}) == 13);
    driver.drag(driver.pixel({9, 4}), driver.pixel({9, 4}), 1, {Modifiers::kShift});
    driver.frames(30);
    REQUIRE(driver.context().selection.segments.size() == 2);
    driver.fill("inspector/elements", "9");
    CHECK(along(driver, {1, 0}) == 9);
    CHECK(along(driver, {1, 1}) == 9);
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes[0]->segmentSizes.size() == 1);
    driver.clickPlace({5, 5.5});
    REQUIRE(driver.context().selection.shapes == std::set<std::uint32_t>{2});
    driver.fill("inspector/elements", "40");
    CHECK(along(driver, {2, 0}) == 40);
    driver.fill("inspector/elements", "2.5");
    CHECK(driver.has("inspector/elements/fault"));
    CHECK(along(driver, {2, 0}) == 40);
    CHECK_FALSE(driver.has("inspector/elements/meshed"));
    driver.fill("inspector/elements", "4");
    CHECK(along(driver, {2, 0}) == 4);
    driver.frames(2);
    CHECK_FALSE(driver.has("inspector/elements/meshed"));
    const double below = driver.context().widgets.find("inspector/centre/x")->rect.y;
    driver.fill("inspector/elements", "2"); // a closed curve has at least three
    CHECK(along(driver, {2, 0}) == 3);
    driver.frames(2);
    CHECK(driver.has("inspector/elements/meshed"));
    CHECK(driver.context().widgets.find("inspector/centre/x")->rect.y == below); // the note moves nothing
    clear(driver, "inspector/elements");
    CHECK(driver.document().shapes[1]->segmentSizes.empty());
    CHECK(driver.document().shapes[0]->segmentSizes.size() == 1);
    CHECK(boundaryTags(driver.document()) == std::vector<std::int32_t>{1, 2}); // those of the shapes; counts make none
}

TEST_CASE("Elements: a circle of a parameter keeps its number when the parameter changes, and after saving") {
    Draughtsman driver;
    driver.rectangle({0.5, 0.5}, {9.5, 9.5});
    driver.showPanel("parameters");
    driver.settle();
    driver.click("parameters/add");
    driver.settle();
    driver.fill("parameters/0/name", "d");
    driver.fill("parameters/0/expression", "3");
    Document sized = driver.document();
    sized.spacing.size = 3.0;
    sized.spacing.segmentsPerTurn = 0.0;
    driver.context().document.apply(std::move(sized), "Size");
    driver.key('C');
    driver.clickPlace({5, 5});
    driver.moveToPlace({7, 5});
    driver.key('D');
    driver.type("d/2");
    driver.key(key::kEnter);
    driver.key('V');
    driver.clickPlace({5, 5.6});
    REQUIRE(driver.context().selection.shapes == std::set<std::uint32_t>{2});
    driver.fill("inspector/elements", "60");
    CHECK(along(driver, {2, 0}) == 60);
    for (const char *d : {"4", "1.7", "6.5"}) {
        CAPTURE(d);
        driver.fill("parameters/0/expression", d);
        CHECK(along(driver, {2, 0}) == 60);
        driver.frames(2);
        CHECK_FALSE(driver.has("inspector/elements/meshed"));
    }
    const Document reopened = *parseProject(projectText(driver.document()), "test");
    driver.context().document.load(reopened, {});
    driver.settle();
    CHECK(along(driver, {2, 0}) == 60);
    driver.key('Z', {Modifiers::kControl}); // nothing to undo
    CHECK(along(driver, {2, 0}) == 60);
}

TEST_CASE("Elements: the number takes an expression, and a size replaces it") {
    Draughtsman driver;
    driver.context().document.apply(*setParameters(driver.document(), {{"n", "30"}}), "Add parameter");
    driver.rectangle({0.5, 0.5}, {9.5, 9.5});
    driver.key('C');
    driver.dragPlaces({5, 5}, {6.5, 5});
    driver.key('V');
    driver.clickPlace({5, 5.6});
    driver.fill("inspector/elements", "2*n");
    CHECK(elementCount(driver.document(), {2, 0}) == 60U);
    CHECK(driver.document().formulas.at("shape/2/segmentElements/0"_number) == "2*n");
    driver.context().document.apply(*overrideParameters(driver.document(), {{"n", "40"}}), "Change parameter");
    driver.settle();
    CHECK(elementCount(driver.document(), {2, 0}) == 80U);
    driver.fill("inspector/segmentgrowth", "0.5");
    const auto own = [&] { return *segmentSize(driver.document(), {2, 0}); };
    CHECK(own() == SegmentSize{.size = 0.0, .elements = 80, .growth = 0.5});
    driver.fill("inspector/segmentsize", "0.25");
    CHECK(driver.document().formulas.empty());
    CHECK(own() == SegmentSize{.size = 0.25, .elements = 0, .growth = 0.5});
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().formulas.at("shape/2/segmentElements/0"_number) == "2*n");
    CHECK(elementCount(driver.document(), {2, 0}) == 80U);
}

TEST_CASE("Elements: a copy has the number of its original, whatever its size") {
    Draughtsman driver;
    driver.rectangle({0.5, 0.5}, {9.5, 9.5});
    driver.key('C');
    driver.dragPlaces({3, 3}, {4, 3});
    Document sized = driver.document();
    sized.spacing.size = 3.0;
    driver.context().document.apply(std::move(sized), "Size");
    driver.key('V');
    driver.clickPlace({3, 3.5});
    driver.fill("inspector/elements", "60");
    driver.key('C', {Modifiers::kControl});
    driver.key('V', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 3);
    driver.fill("inspector/centre/x", "7");
    driver.fill("inspector/radius", "0.5");
    CHECK(driver.context().selection.shapes == std::set<std::uint32_t>{3});
    CHECK(along(driver, {2, 0}) == 60);
    CHECK(along(driver, {3, 0}) == 60);
}

TEST_CASE("Elements: new shapes have no number, and the tag that shapes have") {
    Draughtsman driver;
    driver.key('C');
    driver.dragPlaces({5, 5}, {6, 5});
    driver.key('V');
    driver.settle();
    driver.fill("inspector/elements", "60");
    driver.rectangle({0.5, 0.5}, {9.5, 9.5});
    CHECK(driver.document().shapes[1]->tag == 1);
    CHECK(driver.document().shapes[1]->segmentSizes.empty());
    CHECK(along(driver, {1, 0}) == 60);
    driver.context().document.apply(*setPartElements(driver.document(), 1, PartElements{40, 0.2}), "Number of a part");
    driver.rectangle({1, 1}, {2, 2});
    CHECK(driver.document().shapes[2]->tag == 2); // does not join a part with a number
    driver.fill("options/tag", "1");              // chosen
    driver.rectangle({7, 7}, {8, 8});
    CHECK(driver.document().shapes[3]->tag == 1);
}

TEST_CASE("Spacing: the number of elements per turn is a field") {
    Draughtsman driver;
    driver.key('C');
    driver.dragPlaces({5, 4}, {7, 4});
    driver.showPanel("spacing");
    driver.fill("spacing/perturn", "100");
    CHECK(driver.undoLabel() == "Change elements per turn");
    CHECK(edges(driver, 1) >= 100);
    driver.fill("spacing/perturn", "-1");
    CHECK(driver.document().spacing.segmentsPerTurn == 100.0);
    CHECK(driver.logHas("bad-size"));
}

TEST_CASE("Spacing: the number of elements across narrow places is a field") {
    Draughtsman driver;
    driver.rectangle({1, 4}, {9, 5});
    driver.showPanel("spacing");
    driver.fill("spacing/size", "2");
    REQUIRE(driver.context().preview->spacing != nullptr);
    CHECK(driver.context().preview->spacing->at({5, 4.5}) == doctest::Approx(2.0));
    driver.fill("spacing/across", "2*2");
    CHECK(driver.undoLabel() == "Change elements per gap");
    CHECK(driver.document().spacing.elementsAcross == 4.0);
    CHECK(driver.context().preview->spacing->at({5, 4.5}) == doctest::Approx(0.25).epsilon(0.02));
    driver.fill("spacing/across", "-1");
    CHECK(driver.document().spacing.elementsAcross == 4.0);
    CHECK(driver.logHas("bad-size"));
    driver.key(key::kEscape); // the field still had the focus
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.document().spacing.elementsAcross.has_value());
}

TEST_CASE("Inspector: several tags are not shown as one, and a number gives all of them one") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 4});
    driver.fill("options/tag", "7");
    driver.rectangle({5, 1}, {9, 4});
    driver.key('V');
    driver.key('A', {Modifiers::kControl});
    driver.frames(2);
    REQUIRE(driver.context().selection.shapes.size() == 2);
    CHECK_FALSE(driver.has("inspector/tag/name"));
    driver.fill("inspector/tag", "3");
    for (const auto &shape : driver.document().shapes) {
        CHECK(shape->tag == 3);
    }
    CHECK(driver.undoLabel() == "Change tag");
}

TEST_CASE("Tags: a shape drawn after the tag of new shapes got a name or a size gets another tag") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {2, 2});
    Document named = driver.document();
    named.boundaryNames[named.shapes[0]->tag] = "airfoil";
    driver.context().document.apply(std::move(named), "Name");
    driver.rectangle({0, 0}, {9, 8});
    CHECK(driver.document().shapes[1]->tag != driver.document().shapes[0]->tag);
    CHECK_FALSE(driver.document().boundaryNames.contains(driver.document().shapes[1]->tag));
}

TEST_CASE("Elements: the field is not shown for shapes of several segments") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.settle();
    CHECK(driver.has("inspector/segmentsize"));
    CHECK_FALSE(driver.has("inspector/elements"));
}

} // namespace forefront::test
