#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/region_fill.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/distinct_tags.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

TEST_CASE("fillRegion: each face has one marker, which a second fill replaces") {
    // A square with a hole, an island in the hole, and constraints that divide the ring around the hole into two faces.
    Document document =
        *addShapes({}, {makeShape(ShapeKind::Polygon, {{0, 0}, {10, 0}, {10, 5}, {10, 10}, {0, 10}, {0, 5}}),
                        makeShape(ShapeKind::Polygon, {{2, 2}, {8, 2}, {8, 5}, {8, 8}, {2, 8}, {2, 5}}),
                        square({4, 4}, 2), makeShape(ShapeKind::Polyline, {{0, 5}, {2, 5}}, ShapeUse::Constraint),
                        makeShape(ShapeKind::Polyline, {{8, 5}, {10, 5}}, ShapeUse::Constraint)});
    document = *fillRegion(document, {1, 1}, 2);
    document = *fillRegion(document, {1, 9}, 3);
    document = *fillRegion(document, {5, 5}, 4);
    REQUIRE(document.regionMarkers.size() == 3);
    document = *fillRegion(document, {9, 4}, 5); // the same face as (1, 1)
    REQUIRE(document.regionMarkers.size() == 3);
    CHECK(document.regionMarkers.back().tag == 5);
    CHECK(document.regionMarkers[0].tag == 3);
    CHECK(regionTags(document) == std::vector<std::int32_t>{1, 3, 4, 5});
}

TEST_CASE("fillRegion: is refused outside the domain and in holes, with the place") {
    const Document document = *addShapes({}, {square({0, 0}, 10), square({2, 2}, 6)});
    for (const Vec2 at : {Vec2{5, 5}, Vec2{-1, 5}, Vec2{11, 0}, Vec2{std::nan(""), 0}}) {
        const Result<Document> refused = fillRegion(document, at, 2);
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.faults().front().code == "region-marker-outside");
        CHECK(refused.faults().front().at.has_value());
    }
    CHECK(fillRegion(document, {1, 1}, 0).faults().front().code == "bad-tag");
    CHECK_FALSE(fillRegion({}, {0, 0}, 1).ok());
}

TEST_CASE("fillRegion: where shapes cross, the faces between the crossings are filled") {
    Document document = *addShapes({}, {square({0, 0}, 10), square({5, 5}, 10)});
    document = *fillRegion(document, {1, 1}, 2);
    document = *fillRegion(document, {14, 14}, 3);
    document = *fillRegion(document, {9, 1}, 4); // the same face as (1, 1)
    CHECK(document.regionMarkers.size() == 2);
    CHECK(fillRegion(document, {7, 7}, 5).faults().front().code == "region-marker-outside"); // covered twice
    const Result<RepairedDrawing> repaired = repairDrawing(document);
    REQUIRE(repaired.ok());
    CHECK(repaired->left.empty());
    CHECK(repaired->document.regionMarkers == document.regionMarkers);
}

TEST_CASE("insertDrawing: shapes get new ids, are scaled, and become the selection; names keep their meaning") {
    Document here = *addShape({}, square({0, 0}, 1));
    here = *setBoundaryName(here, 1, "wall");
    Document there = *addShapes({}, {square({2, 2}, 2), makeShape(ShapeKind::Circle, {{1, 1}, {2, 1}})});
    there = *setBoundaryName(there, 1, "shore");
    there = *setBoundaryName(there, 2, "inlet");
    there = *addRegionMarker(there, {{3, 3}, 7});
    there = *setSize(there, 0.5);
    Insertion insertion;
    const Document both = insertDrawing(here, there, 10.0, &insertion);
    const Selection &added = insertion.added;
    REQUIRE(both.shapes.size() == 3);
    CHECK(both.shapes[1]->nodes[0] == Vec2{20, 20});
    CHECK(both.regionMarkers[0].at == Vec2{30, 30});
    CHECK(both.boundaryNames == std::map<std::int32_t, std::string>{{1, "wall"}, {2, "inlet"}, {3, "shore"}});
    CHECK(both.shapes[1]->tag == 3);
    CHECK(both.shapes[2]->tag == 3);
    CHECK(both.regionMarkers[0].tag == 7);
    CHECK(both.spacing.automatic());
    CHECK(added.shapes == std::set<std::uint32_t>{2, 3});
    CHECK(added.markers.size() == 1);
    Document rest = deleteSelection(both, added);
    rest.boundaryNames.erase(2);
    rest.boundaryNames.erase(3);
    CHECK(sameContent(rest, here));
}

TEST_CASE("withDistinctTags: equal names share a tag, other parts get free ones, with all that refers to them") {
    Document here = *addShapes({}, {square({0, 0}, 1), square({5, 5}, 1), square({9, 9}, 1)});
    here = *setShapeTag(here, {2}, 2);
    here = *setShapeTag(here, {3}, 4);
    here = *setBoundaryName(here, 1, "quay");
    here = *setBoundaryName(here, 4, "shore");
    here = *addRegionMarker(here, {{0.5, 0.5}, 3});
    here = *setRegionName(here, 3, "basin");
    Document there = *addShapes({}, {square({20, 0}, 1), square({22, 0}, 1), square({24, 0}, 1), square({26, 0}, 1)});
    for (const std::uint32_t id : {2U, 3U, 4U}) {
        there = *setShapeTag(there, {id}, static_cast<std::int32_t>(id));
    }
    there = *setBoundaryName(there, 1, "shore"); // known under another tag
    there = *setBoundaryName(there, 4, "dam");   // its tag is taken
    there.elementCounts[4] = {.count = 8};
    there.periodic = {{3, 4}};
    there.layers.push_back({.tag = 4});
    there.cracks = {4};
    there.mapped = {{.region = 3}};
    there.formulas[{NumberOwner::ofPart(4), Quantity::Elements}] = "n";
    there = *addRegionMarker(there, {{20.5, 0.5}, 3});
    there = *setRegionName(there, 3, "lake");
    const Document other = withDistinctTags(there, here);
    CHECK(other.shapes[0]->tag == 4);
    CHECK(other.shapes[1]->tag == 2); // nameless in both
    CHECK(other.shapes[2]->tag == 3); // free
    CHECK(other.shapes[3]->tag == 5);
    CHECK(other.boundaryNames == std::map<std::int32_t, std::string>{{4, "shore"}, {5, "dam"}});
    CHECK(other.elementCounts.contains(5));
    CHECK(other.periodic == std::vector<PeriodicSpec>{{3, 5}});
    CHECK(other.layers.front().tag == 5);
    CHECK(other.cracks == std::vector<std::int32_t>{5});
    CHECK(other.mapped.front().region == 4);
    CHECK(other.formulas.contains({NumberOwner::ofPart(5), Quantity::Elements}));
    CHECK(other.regionMarkers.front().tag == 4);
    CHECK(other.regionNames == std::map<std::int32_t, std::string>{{4, "lake"}});
    CHECK(sameContent(withDistinctTags(there, {}), there));
    CHECK(sameContent(withDistinctTags(there, there), there));
}
