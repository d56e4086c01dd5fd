#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/picking/face_map.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

std::shared_ptr<const FaceMap> mapOfDrawing(const Document &document) {
    return faceMapOf(std::make_shared<const Domain>(toDomain(document)));
}

} // namespace

TEST_CASE("FaceMap: faces have the areas of their curves, without their holes") {
    Document document = *addShapes({}, {square({0, 0}, 10), makeShape(ShapeKind::Circle, {{5, 5}, {7, 5}}),
                                        makeShape(ShapeKind::Circle, {{2, 2}, {3, 2}}, ShapeUse::Constraint)});
    document = *addRegionMarker(document, {{2, 2}, 4});
    const auto map = mapOfDrawing(document);
    REQUIRE(map->faces().size() == 2);
    const std::uint32_t disc = map->faceAt({2.5, 2.5}), plate = map->faceAt({9, 9});
    REQUIRE(disc != kNoIndex);
    REQUIRE(plate != kNoIndex);
    CHECK(map->faces()[disc].area == doctest::Approx(std::numbers::pi).epsilon(1e-12));
    CHECK(map->faces()[plate].area == doctest::Approx(100.0 - 5.0 * std::numbers::pi).epsilon(1e-12));
    CHECK(map->faces()[disc].marker == 0);
    CHECK(map->faces()[disc].tag == 4);
    CHECK(map->faces()[plate].marker == kNoIndex);
    CHECK(map->faceOf(document.regionMarkers[0]) == disc);
    CHECK(map->faceAt({5, 5}) == kNoIndex); // hole
    CHECK(map->faceAt({-1, 5}) == kNoIndex);
    CHECK(map->faceAt({11, 5}) == kNoIndex);
}

TEST_CASE("FaceMap: where shapes cross, the faces are those after a repair") {
    const auto map = mapOfDrawing(*addShapes({}, {square({0, 0}, 10), square({5, 5}, 10)}));
    REQUIRE(map->faces().size() == 2);
    CHECK(map->faces()[map->faceAt({1, 1})].area == doctest::Approx(75.0));
    CHECK(map->faces()[map->faceAt({14, 14})].area == doctest::Approx(75.0));
    CHECK(map->faceAt({7, 7}) == kNoIndex);
    CHECK(mapOfDrawing({})->faces().empty());
    CHECK(mapOfDrawing({})->faceAt({0, 0}) == kNoIndex);
}

TEST_CASE("FaceMap: the faces beside an edge are those found near it") {
    Document document =
        *addShapes({}, {makeShape(ShapeKind::Polygon, {{0, 0}, {4, 1}, {9, 0}, {8, 5}, {9, 9}, {4, 8}, {0, 9}, {1, 4}}),
                        makeShape(ShapeKind::Polyline, {{4, 1}, {3, 4}, {4, 8}}, ShapeUse::Constraint),
                        makeShape(ShapeKind::Polyline, {{8, 5}, {6, 5}}, ShapeUse::Constraint), square({5, 2}, 1)});
    const auto map = mapOfDrawing(document);
    REQUIRE(map->faces().size() == 2);
    for (const MappedEdge &edge : map->edges()) {
        const Vec2 middle = midpoint(edge.a, edge.b), side = 1e-6 * leftNormal(edge.b - edge.a);
        CHECK(map->faceAt(middle + side) == edge.left);
        CHECK(map->faceAt(middle - side) == edge.right);
    }
}
