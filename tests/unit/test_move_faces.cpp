// Faces are moved with their borders and copied as closed shapes.
#include "core/drawing/commands/copy_faces.hpp"
#include "core/drawing/commands/move_faces.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/two_counties.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/face_drawing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;
using forefront::test::twoCounties;

namespace {

using Nodes = std::vector<Vec2>;

Result<Document> movedFace(const Document &document, Vec2 at, Vec2 by) {
    const FaceDrawing drawing(document);
    return moveFaces(drawing.index, *drawing.map, {drawing.faceAt(at)}, by);
}

/// Returns true if each marker lies in the face with its tag, and these are all faces.
bool isMeshable(const Document &document) {
    return validate(toDomain(document)).empty();
}

} // namespace

TEST_CASE("Move faces: a county moves with its border, and its neighbour follows") {
    const Result<Document> moved = movedFace(twoCounties(), {2, 2}, {-1, 0.5});
    REQUIRE_MESSAGE(moved.ok(), codeOf(moved));
    CHECK(moved->shapes[0]->nodes == Nodes{{3, 0.5}, {-1, 0.5}, {-1, 3.5}, {3, 3.5}});
    CHECK(moved->shapes[1]->nodes == Nodes{{3, 3.5}, {8, 3}, {8, 0}, {3, 0.5}});
    CHECK(moved->shapes[2]->nodes == Nodes{{3, 0.5}, {3, 3.5}});
    CHECK(moved->regionMarkers[0].at == Vec2{0, 1.5});
    CHECK(moved->regionMarkers[1].at == Vec2{4.5, 1}); // still in its face
    CHECK(isMeshable(*moved));
}

TEST_CASE("Move faces: the marker of a neighbour stays in its face") {
    const Result<Document> moved = movedFace(twoCounties(), {2, 2}, {2, 0});
    REQUIRE_MESSAGE(moved.ok(), codeOf(moved));
    const FaceDrawing after(*moved);
    const std::uint32_t east = after.faceAt({7, 1.5});
    CHECK(after.map->faceOf(moved->regionMarkers[1]) == east);
    CHECK(after.map->faces()[east].tag == 3);
    CHECK(after.map->faces()[after.faceAt({4.5, 1})].tag == 2);
    CHECK(isMeshable(*moved));
}

TEST_CASE("Move faces: the marker beside a curved border stays in its face") {
    Document document =
        documentOf({square({0, 0}, 10), makeShape(ShapeKind::Circle, {{3, 5}, {5, 5}}, ShapeUse::Constraint)});
    document = *addRegionMarker(*addRegionMarker(document, {{3, 5}, 2}), {{7, 5}, 3});
    const Result<Document> moved = movedFace(document, {3, 6}, {4, 0});
    REQUIRE_MESSAGE(moved.ok(), codeOf(moved));
    const FaceDrawing after(*moved);
    CHECK(after.map->faceOf(moved->regionMarkers[1]) == after.faceAt({1, 1}));
    CHECK(moved->regionMarkers[0].at == Vec2{7, 5});
}

TEST_CASE("Move faces: what lies in a face moves with it") {
    Document document = twoCounties();
    document = *addShapes(document, {makeShape(ShapeKind::Circle, {{2, 1.5}, {2.5, 1.5}}, ShapeUse::Constraint),
                                     makeShape(ShapeKind::Polyline, {{3, 1}, {3, 2}}, ShapeUse::Constraint),
                                     makeShape(ShapeKind::Circle, {{6, 1.5}, {6.5, 1.5}}, ShapeUse::Constraint)});
    document = *addRegionMarker(document, {{2, 1.5}, 4});
    const Result<Document> moved = movedFace(document, {0.5, 0.5}, {0, 1});
    REQUIRE_MESSAGE(moved.ok(), codeOf(moved));
    CHECK(moved->shapes[3]->nodes.front() == Vec2{2, 2.5});
    CHECK(moved->shapes[4]->nodes == Nodes{{3, 2}, {3, 3}});
    CHECK(moved->shapes[5] == document.shapes[5]);
    CHECK(moved->regionMarkers[2].at == Vec2{2, 2.5});
    CHECK(isMeshable(*moved));
}

TEST_CASE("Move faces: a county within the closed outline of its map moves with its part of the outline") {
    Document map = twoCounties();
    map.shapes.erase(map.shapes.begin(), map.shapes.begin() + 2);
    map = *addShape(map, makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {8, 0}, {8, 3}, {4, 3}, {0, 3}}));
    const Result<Document> moved = movedFace(map, {2, 2}, {1, 0.5});
    REQUIRE_MESSAGE(moved.ok(), codeOf(moved));
    CHECK(moved->shapes[0]->nodes == Nodes{{5, 0.5}, {5, 3.5}});
    CHECK(moved->shapes[1]->nodes == Nodes{{1, 0.5}, {5, 0.5}, {8, 0}, {8, 3}, {5, 3.5}, {1, 3.5}});
    CHECK(isMeshable(*moved));
}

TEST_CASE("Move faces: locked and hidden borders are refused, and so is no face") {
    const Document counties = twoCounties();
    CHECK(codeOf(movedFace(*setLocked(counties, {3}, true), {2, 2}, {1, 0})) == "border-locked");
    CHECK(codeOf(movedFace(*setHidden(counties, {1}, true), {2, 2}, {1, 0})) == "border-hidden");
    CHECK(codeOf(movedFace(*setLocked(counties, {2}, true), {2, 2}, {1, 0})) == "joined-locked");
    const FaceDrawing drawing(counties);
    CHECK(codeOf(moveFaces(drawing.index, *drawing.map, {}, {1, 0})) == "no-face");
}

TEST_CASE("Copy faces: each is a closed shape with its region, its tags and its names") {
    Document counties = twoCounties();
    counties = *setRegionArea(counties, 0, 0.5);
    counties.boundaryNames[2] = "between";
    counties.spacing.partSizes[2] = {0.25, 0.2};
    counties.spacing.partSizes[9] = {0.25, 0.2};
    const FaceDrawing drawing(counties);
    const Document west = copyFaces(counties, *drawing.map, {drawing.faceAt({2, 2})});
    REQUIRE(west.shapes.size() == 1);
    CHECK(isClosed(*west.shapes[0]));
    CHECK(areaOf(*west.shapes[0]) == doctest::Approx(12.0));
    CHECK(west.shapes[0]->use == ShapeUse::Boundary);
    REQUIRE(west.regionMarkers.size() == 1);
    CHECK(west.regionMarkers[0] == counties.regionMarkers[0]);
    CHECK(west.regionNames.at(2) == "West");
    CHECK(west.boundaryNames.at(2) == "between");
    const std::vector<std::int32_t> tags = segmentTagsOf(*west.shapes[0]);
    CHECK(std::count(tags.begin(), tags.end(), 2) == 1);
    CHECK(west.spacing.partSizes.size() == 1);
    CHECK(isMeshable(west));
    const Document both = copyFaces(counties, *drawing.map, {0, 1});
    CHECK(both.shapes.size() == 2);
    CHECK(both.regionMarkers.size() == 2);
}

TEST_CASE("Copy faces: holes and curves stay what they are") {
    const FaceDrawing ring(
        documentOf({makeShape(ShapeKind::Circle, {{5, 5}, {9, 5}}), makeShape(ShapeKind::Circle, {{5, 5}, {6, 5}})}));
    const Document copy = copyFaces(*ring.document, *ring.map, {ring.faceAt({5, 7})});
    REQUIRE(copy.shapes.size() == 2);
    CHECK(copy.shapes[0]->is<CircleForm>());
    CHECK(copy.shapes[1]->is<CircleForm>());
    const FaceDrawing after(copy);
    REQUIRE(after.map->faces().size() == 1);
    CHECK(after.map->faces()[0].area == doctest::Approx(15.0 * std::numbers::pi));
    CHECK(after.faceAt({5, 5}) == kNoIndex);
}
