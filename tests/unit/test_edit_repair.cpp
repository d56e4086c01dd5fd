#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

RepairedDrawing repaired(const Document &document, double tolerance = 0.0) {
    Result<RepairedDrawing> result = repairDrawing(document, tolerance);
    REQUIRE(result.ok());
    const Result<RepairedDrawing> again = repairDrawing(result->document, tolerance);
    REQUIRE(again.ok());
    CHECK(again->changes.empty());
    return *std::move(result);
}

} // namespace

TEST_CASE("repairDrawing: shapes that it does not change stay the same objects") {
    Shape bow = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 4}, {4, 0}, {0, 4}}, ShapeUse::Boundary, 3);
    bow.name = "bow";
    Document document = documentOf({makeShape(ShapeKind::Circle, {{20, 0}, {21, 0}}), bow,
                                    makeShape(ShapeKind::Point, {{20, 0.5}}, ShapeUse::Constraint, 6)});
    document.regionMarkers = {{{20, 0}, 4, 0.5}};
    document.boundaryNames = {{3, "ribbon"}};
    const RepairedDrawing result = repaired(document);
    CHECK(result.left.empty());
    REQUIRE(result.document.shapes.size() == 4);
    CHECK(result.document.shapes[0] == document.shapes[0]);
    CHECK(result.document.shapes[1] == document.shapes[2]);
    for (std::size_t k = 2; k < 4; ++k) {
        const Shape &half = *result.document.shapes[k];
        CHECK(half.kind() == ShapeKind::Polygon);
        CHECK(half.name == "bow");
        CHECK(half.tag == 3);
        CHECK(half.id > 3);
        CHECK(areaOf(half) == doctest::Approx(4.0));
    }
    CHECK(result.document.regionMarkers == document.regionMarkers);
    CHECK(result.document.boundaryNames == document.boundaryNames);
}

TEST_CASE("repairDrawing: neighbours that share a part of a side stay as they are, and points outside are dropped") {
    const Document document = documentOf({square({0, 0}, 2), square({2, 1}, 2), square({9, 9}, 1),
                                          makeShape(ShapeKind::Point, {{7, 7}}, ShapeUse::Constraint),
                                          makeShape(ShapeKind::Point, {{1, 1}}, ShapeUse::Boundary)});
    const RepairedDrawing result = repaired(document);
    CHECK(result.left.empty());
    REQUIRE(result.document.shapes.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(result.document.shapes[k] == document.shapes[k]);
    }
}

TEST_CASE("repairDrawing: neighbours whose sizes along a part of a side differ become one outline with a constraint") {
    Shape fine = square({2, 1}, 2);
    fine.segmentSizes[3].size = 0.1; // along the common part
    Document document = documentOf({square({0, 0}, 2), fine, square({9, 9}, 1)});
    CHECK(repaired(document).changes.empty()); // it holds for both
    Shape coarse = *document.shapes[0];
    coarse.segmentSizes[1].size = 0.3;
    document.shapes[0] = std::make_shared<const Shape>(coarse);
    const RepairedDrawing result = repaired(document);
    CHECK(result.left.empty());
    REQUIRE(result.document.shapes.size() == 3);
    CHECK(result.document.shapes[0] == document.shapes[2]);
    CHECK(areaOf(*result.document.shapes[1]) == doctest::Approx(8.0));
    CHECK(result.document.shapes[2]->use == ShapeUse::Constraint);
}

TEST_CASE("repairDrawing: neighbours that share a whole side stay as they are") {
    const Document document =
        documentOf({square({0, 0}, 2), square({2, 0}, 2), makeShape(ShapeKind::Point, {{7, 7}}, ShapeUse::Constraint)});
    const RepairedDrawing result = repaired(document);
    CHECK(result.left.empty());
    REQUIRE(result.document.shapes.size() == 2);
    CHECK(result.document.shapes[0] == document.shapes[0]);
    CHECK(result.document.shapes[1] == document.shapes[1]);
}

TEST_CASE("repairDrawing: a valid drawing has no changes; an open one keeps its fault") {
    CHECK(repaired(documentOf({square({0, 0}, 2), makeShape(ShapeKind::Circle, {{1, 1}, {1.5, 1}})})).changes.empty());
    const RepairedDrawing open =
        repaired(documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {2, 0}, {2, 2}, {0, 0.1}})}));
    CHECK(open.changes.empty());
    CHECK(hasErrors(open.left));
    const RepairedDrawing closed =
        repaired(documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {2, 0}, {2, 2}, {0, 0.1}})}), 0.2);
    CHECK(closed.left.empty());
    REQUIRE(closed.document.shapes.size() == 1);
    CHECK(closed.document.shapes.front()->kind() == ShapeKind::Polygon);
}
