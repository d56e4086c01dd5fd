// Faces as selected items: their outlines, borders, markers and places.
#include "core/drawing/picking/selected_faces.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/two_counties.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/face_drawing.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;
using forefront::test::twoCounties;

namespace {

/// A square with a line from side to side, at x = 4; neither half is a region.
Document dividedSquare() {
    return documentOf({square({0, 0}, 10), makeShape(ShapeKind::Polyline, {{4, 0}, {4, 10}}, ShapeUse::Constraint)});
}

} // namespace

TEST_CASE("Selected faces: the edges and the outline of a face are those around it") {
    const FaceDrawing drawing(twoCounties());
    REQUIRE(drawing.map->faces().size() == 2);
    for (std::uint32_t face = 0; face < 2; ++face) {
        CHECK(drawing.map->edgesOf(face).size() == 4);
        for (const std::uint32_t e : drawing.map->edgesOf(face)) {
            const MappedEdge &edge = drawing.map->edges()[e];
            CHECK((edge.left == face) != (edge.right == face));
        }
        const std::vector<Vec2> outline = drawing.map->outlineOf(face);
        CHECK(outline.size() == 4);
        CHECK(signedArea(outline) == doctest::Approx(12.0));
    }
}

TEST_CASE("Selected faces: the outline has no holes, even one that touches it") {
    const Document holes =
        documentOf({square({0, 0}, 10), square({2, 2}, 2), makeShape(ShapeKind::Polygon, {{10, 0}, {8, 3}, {7, 2}})});
    const FaceDrawing drawing(holes);
    const std::uint32_t face = drawing.faceAt({1, 9});
    REQUIRE(face != kNoIndex);
    CHECK(drawing.map->edgesOf(face).size() == 11);
    CHECK(signedArea(drawing.map->outlineOf(face)) == doctest::Approx(100.0));
}

TEST_CASE("Selected faces: the border of a county is whole lines, shared with its neighbour") {
    const FaceDrawing drawing(twoCounties());
    const std::uint32_t west = drawing.faceAt({2, 2}), east = drawing.faceAt({6, 2});
    const auto border = [&](const std::set<std::uint32_t> &faces) {
        return borderOf(drawing.index, *drawing.map, faces).lines;
    };
    CHECK(border({west}) == selected({1, 3}));
    CHECK(border({east}) == selected({2, 3}));
    CHECK(border({west, east}) == selected({1, 2, 3}));
    CHECK(border({}).empty());
}

TEST_CASE("Selected faces: a border has the parts of shapes that bound more than the face, and curves") {
    const FaceDrawing divided(dividedSquare());
    const Selection left = borderOf(divided.index, *divided.map, {divided.faceAt({1, 1})}).lines;
    CHECK(left.shapes == std::set<std::uint32_t>{2});
    CHECK(left.segments == std::set<SegmentRef>{{1, 0}, {1, 2}, {1, 3}});
    const FaceDrawing ring(
        documentOf({makeShape(ShapeKind::Circle, {{5, 5}, {9, 5}}), makeShape(ShapeKind::Circle, {{5, 5}, {6, 5}})}));
    CHECK(borderOf(ring.index, *ring.map, {ring.faceAt({5, 7})}).lines == selected({1, 2}));
}

TEST_CASE("Selected faces: locked and hidden lines of a border are reported") {
    const Document counties = twoCounties();
    const FaceDrawing locked(*setLocked(counties, {3}, true)), hidden(*setHidden(counties, {2}, true));
    CHECK(borderOf(locked.index, *locked.map, {locked.faceAt({2, 2})}).locked == std::set<std::uint32_t>{3});
    CHECK(borderOf(hidden.index, *hidden.map, {hidden.faceAt({2, 2})}).hiddenEdges == 0);
    CHECK(borderOf(hidden.index, *hidden.map, {hidden.faceAt({6, 2})}).hiddenEdges == 3);
}

TEST_CASE("Selected faces: a region is selected by its marker, another face by a place") {
    Document document = dividedSquare();
    document = *addRegionMarker(document, {{1, 1}, 2});
    const FaceDrawing drawing(document);
    const std::uint32_t left = drawing.faceAt({2, 5}), right = drawing.faceAt({7, 5});
    Selection selection;
    CHECK_FALSE(selection.onlyFaces());
    selectFace(*drawing.map, left, {2, 5}, selection);
    CHECK(selection.markers == std::set<std::uint32_t>{0});
    CHECK(selection.faces.empty());
    selectFace(*drawing.map, right, {7, 5}, selection);
    CHECK(selection.faces.contains(Vec2{7, 5}));
    CHECK(selection.size() == 2);
    CHECK(selection.onlyFaces());
    CHECK(selectedFaces(*drawing.map, document, selection) == std::set<std::uint32_t>{left, right});
    deselectFace(*drawing.map, document, left, selection);
    CHECK_FALSE(isFaceSelected(*drawing.map, document, selection, left));
    CHECK(isFaceSelected(*drawing.map, document, selection, right));
    selection.shapes.insert(1);
    CHECK_FALSE(selection.onlyFaces());
    deselectFace(*drawing.map, document, right, selection);
    CHECK(selection == selected({1}));
}

TEST_CASE("Selected faces: a marker has its face at once, and another one once it has moved") {
    const FaceDrawing drawing(twoCounties());
    const std::uint32_t west = drawing.faceAt({2, 2}), east = drawing.faceAt({6, 2});
    CHECK(drawing.map->faceOf(*drawing.document, 0) == west);
    CHECK(drawing.map->faceOf(*drawing.document, 1) == east);
    const Document moved = *moveRegionMarker(*drawing.document, 0, {7, 2});
    CHECK(drawing.map->faceOf(moved, 0) == east);
    const Document outside = *moveRegionMarker(moved, 1, {9, 9});
    CHECK(drawing.map->faceOf(outside, 1) == kNoIndex);
}
