#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/boundary_loops.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Two squares of side 4, the second one 2 to the right and above; tags 1 and 2.
Document twoSquares() {
    Shape first = square({0, 0}, 4), second = square({2, 2}, 4);
    first.name = "plate";
    second.tag = 2;
    return documentOf({first, second});
}

Document combined(const Document &document, std::set<std::uint32_t> ids, ShapeOperation operation) {
    Selection made;
    Result<Document> result = combineShapes(document, ids, operation, &made);
    REQUIRE(result.ok());
    CHECK(validate(toDomain(*result)).empty());
    REQUIRE_FALSE(made.shapes.empty());
    for (const std::uint32_t id : made.shapes) {
        REQUIRE(findShape(*result, id) != nullptr);
    }
    return *std::move(result);
}

double totalArea(const Document &document) {
    double sum = 0.0;
    for (const auto &shape : document.shapes) {
        sum += shape->use == ShapeUse::Boundary ? areaOf(*shape) : 0.0;
    }
    return sum;
}

/// Length of the segments by tag.
std::map<std::int32_t, double> lengths(const Document &document) {
    std::map<std::int32_t, double> result;
    const Domain domain = toDomain(document);
    for (const DomainSegment &segment : domain.segments) {
        result[segment.tag] += distance(domain.nodes[segment.a], domain.nodes[segment.b]);
    }
    return result;
}

using Lengths = std::map<std::int32_t, double>;

} // namespace

TEST_CASE("combineShapes: two squares, by each operation, with the tags of their sides and the name of the first") {
    const Document document = twoSquares();
    const struct {
        ShapeOperation operation;
        std::size_t shapes;
        double area;
        Lengths lengths;
    } expected[] = {{ShapeOperation::Union, 1, 28.0, {{1, 12.0}, {2, 12.0}}},
                    {ShapeOperation::Difference, 1, 12.0, {{1, 12.0}, {2, 4.0}}},
                    {ShapeOperation::Intersection, 1, 4.0, {{1, 4.0}, {2, 4.0}}},
                    {ShapeOperation::Exclusion, 2, 24.0, {{1, 16.0}, {2, 16.0}}},
                    {ShapeOperation::Divide, 2, 16.0, {{1, 16.0}, {2, 4.0}}}};
    for (const auto &row : expected) {
        CAPTURE(static_cast<int>(row.operation));
        const Document result = combined(document, {1, 2}, row.operation);
        CHECK(result.shapes.size() == row.shapes);
        CHECK(totalArea(result) == doctest::Approx(row.area));
        CHECK(lengths(result) == row.lengths);
        for (const auto &shape : result.shapes) {
            CHECK(shape->name == "plate");
            CHECK(shape->id > 2);
        }
    }
}

TEST_CASE("combineShapes: a divided shape keeps its outline, and the lines inside are constraints") {
    const Document result = combined(twoSquares(), {1, 2}, ShapeOperation::Divide);
    REQUIRE(result.shapes.size() == 2);
    CHECK(result.shapes[0]->use == ShapeUse::Boundary);
    CHECK(isClosed(*result.shapes[0]));
    CHECK(result.shapes[1]->use == ShapeUse::Constraint);
    CHECK(result.shapes[1]->kind() == ShapeKind::Polyline);
    CHECK(result.shapes[1]->tag == 2);
}

TEST_CASE("combineShapes: the other shapes stay, and the result takes the place of the first") {
    Document document = documentOf({square({20, 0}, 1), square({0, 0}, 4), square({30, 0}, 1), square({2, 2}, 4)});
    const Document result = combined(document, {2, 4}, ShapeOperation::Union);
    REQUIRE(result.shapes.size() == 3);
    CHECK(result.shapes[0] == document.shapes[0]);
    CHECK(result.shapes[2] == document.shapes[2]);
}

TEST_CASE("combineShapes: a hole becomes a separate shape, touching shapes unite, and several shapes combine at once") {
    const Document hole =
        combined(documentOf({square({0, 0}, 4), square({1, 1}, 1)}), {1, 2}, ShapeOperation::Difference);
    REQUIRE(hole.shapes.size() == 2);
    CHECK(insideEvenOdd(toDomain(hole), {3, 3}));
    CHECK_FALSE(insideEvenOdd(toDomain(hole), {1.5, 1.5}));
    const Document row = documentOf({square({0, 0}, 1), square({1, 0}, 1), square({2, 0}, 1)});
    CHECK(combined(row, {1, 2, 3}, ShapeOperation::Union).shapes.size() == 1);
    const Document stack = documentOf({square({0, 0}, 4), square({1, 1}, 4), square({2, 2}, 4)});
    CHECK(totalArea(combined(stack, {1, 2, 3}, ShapeOperation::Intersection)) == doctest::Approx(4.0));
    CHECK(totalArea(combined(stack, {1, 2, 3}, ShapeOperation::Difference)) == doctest::Approx(7.0));
}

TEST_CASE("combineShapes: circles and rectangles combine by their outlines") {
    const Document document = documentOf({makeShape(ShapeKind::Rectangle, {{0, -5}, {5, 5}}),
                                          makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}, ShapeUse::Boundary, 3)});
    const Document result = combined(document, {1, 2}, ShapeOperation::Difference);
    CHECK(totalArea(result) == doctest::Approx(50.0 - 2.0 * std::numbers::pi).epsilon(0.01));
    CHECK(lengths(result).at(3) == doctest::Approx(2.0 * std::numbers::pi).epsilon(0.01));
}

TEST_CASE("combineShapes: shapes that are tiny beside another one become valid shapes, combined or repaired") {
    testing::RandomSource random(12);
    const auto around = [&](Vec2 at, double size) {
        return at + size * Vec2{2.0 * random.unit() - 1.0, 2.0 * random.unit() - 1.0};
    };
    const auto checkAll = [](const Document &document) {
        for (const auto &shape : document.shapes) {
            const Diagnostics faults = checkShape(*shape);
            CHECK_MESSAGE(faults.empty(), faults.front().message);
        }
    };
    int made = 0;
    for (int i = 0; i < 40; ++i) {
        const double size = std::pow(10.0, -1.0 - 0.2 * i);
        CAPTURE(size);
        const Vec2 centre = around({0, 0}, 1.0), on = around({3, 0}, 1.0);
        const Vec2 at = Curve::circle(centre, on).point(random.unit());
        const Document document = documentOf({makeShape(ShapeKind::Circle, {centre, on}),
                                              slotAround(around(at, size), around(at, size), 0.7 * size),
                                              slotAround(around(at, size), around(at, size), 0.4 * size)});
        for (const auto operation : {ShapeOperation::Union, ShapeOperation::Difference, ShapeOperation::Intersection,
                                     ShapeOperation::Exclusion, ShapeOperation::Divide}) {
            if (const auto result = combineShapes(document, {1, 2, 3}, operation)) {
                checkAll(*result);
                ++made;
            }
        }
        const auto repaired = repairDrawing(document);
        REQUIRE(repaired.ok());
        checkAll(repaired->document);
    }
    CHECK(made > 100);
}

TEST_CASE("combineShapes: refuses open shapes, single ones, unknown ones, and an empty result") {
    const Document document =
        documentOf({square({0, 0}, 1), makeShape(ShapeKind::Polyline, {{0, 0}, {1, 1}}), square({5, 5}, 1)});
    const auto code = [&](std::set<std::uint32_t> ids, ShapeOperation operation) {
        const auto result = combineShapes(document, ids, operation);
        REQUIRE_FALSE(result.ok());
        return result.faults().front().code;
    };
    CHECK(code({1, 2}, ShapeOperation::Union) == "not-possible");
    CHECK(code({1}, ShapeOperation::Union) == "not-possible");
    CHECK(code({1, 9}, ShapeOperation::Union) == "no-such-shape");
    CHECK(code({1, 3}, ShapeOperation::Intersection) == "not-possible");
    Selection selection;
    selection.shapes = {1, 2};
    CHECK_FALSE(canCombine(document, selection));
    selection.shapes = {1, 3};
    CHECK(canCombine(document, selection));
}

TEST_CASE("combineShapes: the results for random polygons cover what the operation defines") {
    Random random(5);
    std::size_t tested = 0;
    for (int round = 0; round < 120; ++round) {
        CAPTURE(round);
        std::vector<Shape> shapes;
        const std::uint32_t count = 2 + random.below(3);
        for (std::uint32_t k = 0; k < count; ++k) {
            std::vector<Vec2> nodes;
            for (std::uint32_t i = 3 + random.below(6); i > 0; --i) {
                nodes.push_back(round % 2 == 0 ? random.place(1.0)
                                               : Vec2{1.0 * random.below(5) - 2.0, 1.0 * random.below(5) - 2.0});
            }
            shapes.push_back(makeShape(ShapeKind::Polygon, nodes));
        }
        const Document document = documentOf(shapes);
        std::set<std::uint32_t> ids;
        for (const auto &shape : document.shapes) {
            ids.insert(shape->id);
        }
        for (const ShapeOperation operation :
             {ShapeOperation::Union, ShapeOperation::Difference, ShapeOperation::Intersection,
              ShapeOperation::Exclusion, ShapeOperation::Divide}) {
            const auto result = combineShapes(document, ids, operation);
            const Domain domain = result ? toDomain(*result) : Domain();
            if (result) {
                REQUIRE(validate(domain).empty());
            }
            for (int i = 0; i < 20; ++i) {
                const Vec2 p = random.place(2.0) + Vec2{1e-5, 1e-5};
                std::size_t covers = 0;
                for (const auto &shape : document.shapes) {
                    covers += contains(*shape, p) ? 1 : 0;
                }
                const bool first = contains(*document.shapes.front(), p);
                const bool expected = operation == ShapeOperation::Union          ? covers > 0
                                      : operation == ShapeOperation::Difference   ? first && covers == 1
                                      : operation == ShapeOperation::Intersection ? covers == count
                                      : operation == ShapeOperation::Exclusion    ? covers % 2 == 1
                                                                                  : first;
                REQUIRE(insideEvenOdd(domain, p) == expected);
                ++tested;
            }
        }
    }
    CHECK(tested == 120 * 5 * 20);
}

TEST_CASE("boundaryLoops: the inside is on the left, and each face has its own loops") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const auto family = static_cast<testing::DomainFamily>(seed % testing::kDomainFamilies);
        if (family == testing::DomainFamily::FarAway) {
            continue; // places beside a segment round onto it
        }
        const Domain domain = testing::randomDomain(family, seed);
        const auto loops = boundaryLoops(domain);
        REQUIRE(loops.has_value());
        std::set<std::uint32_t> segments;
        for (const BoundaryLoop &loop : *loops) {
            REQUIRE(loop.nodes.size() == loop.segments.size());
            for (std::size_t k = 0; k < loop.nodes.size(); ++k) {
                const DomainSegment &segment = domain.segments[loop.segments[k]];
                REQUIRE(segments.insert(loop.segments[k]).second);
                const std::set<std::uint32_t> ends{segment.a, segment.b};
                REQUIRE(ends == std::set<std::uint32_t>{loop.nodes[k], loop.nodes[(k + 1) % loop.nodes.size()]});
                const Vec2 a = domain.nodes[loop.nodes[k]], b = domain.nodes[loop.nodes[(k + 1) % loop.nodes.size()]];
                const Vec2 left = midpoint(a, b) + 1e-6 * Vec2{a.y - b.y, b.x - a.x};
                REQUIRE(insideEvenOdd(domain, left));
            }
        }
        std::size_t boundary = 0;
        for (const DomainSegment &segment : domain.segments) {
            boundary += segment.role == SegmentRole::Boundary ? 1 : 0;
        }
        REQUIRE(segments.size() == boundary);
    }
    Domain touching = toDomain(documentOf({square({0, 0}, 1), square({1, 1}, 1)}));
    CHECK(boundaryLoops(touching)->size() == 2);
    touching.segments.pop_back();
    CHECK_FALSE(boundaryLoops(touching).has_value());
}
