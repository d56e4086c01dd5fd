#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/region_fill.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

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

TEST_CASE("insertDrawing: shapes get new ids, are scaled, and become the selection; existing names take precedence") {
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
    CHECK(both.boundaryNames.at(1) == "wall");
    CHECK(both.boundaryNames.at(2) == "inlet");
    CHECK(both.spacing.automatic());
    CHECK(added.shapes == std::set<std::uint32_t>{2, 3});
    CHECK(added.markers.size() == 1);
    CHECK(sameContent(*setBoundaryName(deleteSelection(both, added), 2, ""), here));
}
