// Where a corner or an end of one shape lies on another, the domain of a drawing has a node of both.
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/shared_sides.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

Shape outlineWithTags(std::vector<Vec2> nodes, std::vector<std::int32_t> tags) {
    Shape shape = makeShape(ShapeKind::Polygon, std::move(nodes));
    shape.segmentTags = std::move(tags);
    return shape;
}

} // namespace

TEST_CASE("Divide at joints: an end that lies on a side divides it, exactly or up to rounding") {
    const Vec2 corner{10, 1}, next{9.7, 11};
    for (int k = 1; k < 50; ++k) {
        const Vec2 end = corner + (k / 50.0) * (next - corner);
        const Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, corner, next, {0, 10}}),
                                              makeShape(ShapeKind::Polyline, {{3, 3}, end}, ShapeUse::Constraint)});
        DomainSources sources;
        const Domain domain = toDomain(document, sources);
        CHECK(validate(domain).empty());
        CHECK(domain.segments.size() == 6);
        REQUIRE(sources.segments.size() == 6);
        CHECK(sources.segments[1].node == 1);
        CHECK(sources.segments[2].node == 1);
        CHECK(sources.segments[3].node == 2);
    }
}

TEST_CASE(
    "Divide at joints: a node farther than the same place, one of the same shape and one at an end divide nothing") {
    const auto segmentsWith = [](Vec2 end) {
        return toDomain(
                   documentOf({square({0, 0}, 4), makeShape(ShapeKind::Polyline, {{1, 1}, end}, ShapeUse::Constraint)}))
            .segments.size();
    };
    CHECK(segmentsWith({4, 2}) == 6);
    CHECK(segmentsWith({4 - 1e-8, 2}) == 6);
    CHECK(segmentsWith({4 - 1e-5, 2}) == 5);
    CHECK(segmentsWith({4, 1e-10}) == 5);
    const Document folded = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 4}, {2, 0}})});
    CHECK(toDomain(folded).segments.size() == 4);
    CHECK_FALSE(validate(toDomain(folded)).empty());
}

TEST_CASE("Divide at joints: an end held on a circle or a point on a side is a node of both in the mesh") {
    Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}),
                                    makeShape(ShapeKind::Polyline, {{0.5, 0}, {1.2, 1.6}}, ShapeUse::Constraint),
                                    makeShape(ShapeKind::Point, {{-1.2, 1.6}}, ShapeUse::Constraint)});
    const Domain domain = toDomain(document);
    CHECK(validate(domain).empty());
    const auto meets = [&](Vec2 at) {
        return std::count_if(domain.segments.begin(), domain.segments.end(), [&](const DomainSegment &segment) {
            return segment.stretch.follows() && (domain.nodes[segment.a] == at || domain.nodes[segment.b] == at);
        });
    };
    CHECK(meets({1.2, 1.6}) == 2);
    CHECK(meets({-1.2, 1.6}) == 2);
    document.spacing.size = 0.3;
    CHECK(meshDomain(jobOf(document)).ok());
}

TEST_CASE("Divide at joints: sides that two shapes have in common in part are one line there") {
    for (const bool turned : {false, true}) {
        CAPTURE(turned);
        // A column of three floors beside a wall, on a slope so that nothing is exact.
        const auto onSlope = [](double along, double across) {
            return Vec2{1, 2} + along * Vec2{0.6, 0.8} + across * Vec2{-0.8, 0.6};
        };
        const auto block = [&](double from, double to, double low, double high) {
            std::vector<Vec2> nodes{onSlope(from, low), onSlope(to, low), onSlope(to, high), onSlope(from, high)};
            if (turned && low == 0.0) {
                std::reverse(nodes.begin(), nodes.end());
            }
            return makeShape(ShapeKind::Polygon, nodes);
        };
        Document document =
            documentOf({block(0, 9, -3, 0), block(1, 3, 0, 2), block(3, 5.5, 0, 2), block(5.5, 10, 0, 2)});
        const Domain domain = toDomain(document);
        CHECK(validate(domain).empty());
        CHECK(innerLines(domain) == 5); // three floors on the wall, two walls between them
        document.spacing.size = 0.5;
        CHECK(meshedArea(document) == doctest::Approx(27.0 + 18.0));
    }
}

TEST_CASE("Divide at joints: the parts of a side with a number of elements share it") {
    Document document = documentOf({outlineWithTags({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {1, 7, 1, 1}),
                                    makeShape(ShapeKind::Polyline, {{3, 3}, {10, 1}}, ShapeUse::Constraint),
                                    makeShape(ShapeKind::Polyline, {{3, 5}, {10, 4}}, ShapeUse::Constraint)});
    document.spacing.size = 1.0;
    for (const std::uint32_t count : {3U, 4U, 7U, 24U}) {
        document.elementCounts[7] = {.count = count};
        const Result<MeshingOutcome> meshed = meshDomain(jobOf(document));
        REQUIRE_MESSAGE(meshed.ok(), meshed.faults().front().message);
        CHECK(forefront::testing::edgesTagged(meshed->mesh, 7) == count);
    }
    document.elementCounts[7] = {.count = 2}; // cannot have two inner nodes
    CHECK_FALSE(meshDomain(jobOf(document)).ok());
}

TEST_CASE("Divide at joints: the parts of a side keep their numbers of elements where chords before it are halved") {
    for (const double gap : {1e-2, 1e-4}) { // at the smaller one, the chords of the two circles are halved
        CAPTURE(gap);
        Document document = documentOf(
            {makeShape(ShapeKind::Circle, {{5, 5}, {6, 5}}),
             makeShape(ShapeKind::Circle, {{5, 5}, Vec2{5, 5} + (1.0 - gap) * Vec2{std::cos(0.03), std::sin(0.03)}}),
             outlineWithTags({{-10, 0}, {-6, 0}, {-6, 2}, {-10, 2}}, {7, 1, 1, 1}),
             makeShape(ShapeKind::Polyline, {{-9, 0}, {-9, 1}}, ShapeUse::Constraint)});
        document.spacing.size = 1.0;
        document.elementCounts[7] = {.count = 20};
        const PlacedSizes placed = jobOf(document).spacing.placed;
        CHECK(std::count(placed.elements.begin(), placed.elements.end(), 5U) == 1);
        CHECK(std::count(placed.elements.begin(), placed.elements.end(), 15U) == 1);
        CHECK(std::count(placed.elements.begin(), placed.elements.end(), 20U) == 0);
    }
}

TEST_CASE("Divide at joints: what a constraint holds on a side is meshed after each drag") {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {10, 1}, {9.7, 11}, {0, 10}}),
                                    makeShape(ShapeKind::Polyline, {{3, 3}, {9.9, 4.3}}, ShapeUse::Constraint)});
    const std::uint32_t outline = document.shapes[0]->id, line = document.shapes[1]->id;
    Result<Document> held = addConstraint(document, ConstraintKind::OnCurve,
                                          {{line, SketchPartKind::Node, 1}, {outline, SketchPartKind::Segment, 1}});
    REQUIRE(held.ok());
    held->spacing.size = 1.0;
    CHECK(meshDomain(jobOf(*held)).ok());
}

TEST_CASE(
    "Divide at joints: a line along a side, so near that it is on it up to rounding, leaves a valid domain valid") {
    const Document document = documentOf(
        {square({0, 0}, 4), makeShape(ShapeKind::Polyline, {{0, 0}, {2, 2e-11}, {4, 0}}, ShapeUse::Constraint)});
    CHECK(toDomain(document).segments.size() == 6);
    CHECK(validate(toDomain(document)).empty());
}
