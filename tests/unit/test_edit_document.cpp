#include "core/drawing/document/document.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/hole_markers.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <variant>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

std::vector<Vec2> box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

} // namespace

TEST_CASE("toDomain: coinciding nodes of different shapes become one node") {
    const Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    const Domain domain = toDomain(document);
    CHECK(domain.nodes.size() == 6);
    CHECK(domain.segments.size() == 7); // they share a side
}

TEST_CASE("toDomain: zeros of either sign and nearly equal nodes are one place; others stay apart") {
    const auto nodesWith = [](double y) {
        return toDomain(documentOf({makeShape(ShapeKind::Polyline, {{0.0, 0.0}, {1.0, 0.0}}),
                                    makeShape(ShapeKind::Polyline, {{-0.0, -0.0}, {0.5, 0.5}, {1.0, y}})}))
            .nodes.size();
    };
    CHECK(nodesWith(std::nextafter(0.0, 1.0)) == 3);
    CHECK(nodesWith(1e-7) == 3);
    CHECK(nodesWith(1e-5) == 4);
}

TEST_CASE("toDomain: a circle becomes a polygon within the tolerance, at a multiple of four corners") {
    Document document = documentOf({makeShape(ShapeKind::Circle, {{2, 1}, {5, 1}})});
    for (const double tolerance : {0.1, 0.01, 0.002, 1e-4}) {
        document.circleTolerance = tolerance;
        const Domain domain = toDomain(document);
        CHECK(domain.nodes.size() % 4 == 0);
        CHECK(domain.segments.size() == domain.nodes.size());
        CHECK(domain.nodes[0] == Vec2{5, 1});
        for (const DomainSegment &s : domain.segments) {
            const double sagitta = 3.0 - distance(midpoint(domain.nodes[s.a], domain.nodes[s.b]), {2, 1});
            CHECK(sagitta > 0.0);
            CHECK(sagitta <= tolerance * 3.0);
        }
    }
}

TEST_CASE("toDomain: circles that nearly touch are divided until their chords do not cross") {
    for (const double gap : {5e-4, 1e-6}) {
        CAPTURE(gap);
        // The hole comes nearest to the disc's edge at the middle of one of its 52 chords.
        const double angle = std::numbers::pi / 52.0, offset = 0.5 - gap;
        const Vec2 centre{offset * std::cos(angle), offset * std::sin(angle)};
        const Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}}),
                                              makeShape(ShapeKind::Circle, {centre, centre + Vec2{0.5, 0.0}})});
        DomainSources sources;
        const Domain domain = toDomain(document, sources);
        CHECK(validate(domain).empty());
        CHECK(domain.segments.size() > 104);
        CHECK(domain.segments.size() < 160);
        CHECK(sources.segments.size() == domain.segments.size());
        CHECK(sources.nodes.size() == domain.nodes.size());
        MeshingJob job;
        job.domain = domain;
        CHECK(meshDomain(job).ok());
    }
    // Circles that do cross stay as they are.
    const Domain crossing = toDomain(documentOf(
        {makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}}), makeShape(ShapeKind::Circle, {{0.7, 0}, {1.7, 0}})}));
    CHECK(crossing.segments.size() == 104);
    CHECK_FALSE(validate(crossing).empty());
}

TEST_CASE("toDomain: circles that nearly touch are divided beside circles that cross") {
    const double angle = std::numbers::pi / 52.0, offset = 0.5 - 1e-5;
    const Vec2 centre{offset * std::cos(angle), offset * std::sin(angle)};
    const Domain domain = toDomain(documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}}),
                                               makeShape(ShapeKind::Circle, {centre, centre + Vec2{0.5, 0.0}}),
                                               makeShape(ShapeKind::Circle, {{5, 0}, {6, 0}}),
                                               makeShape(ShapeKind::Circle, {{5.7, 0}, {6.7, 0}})}));
    CHECK(domain.segments.size() > 208);
    CHECK(domain.segments.size() < 280);
    CHECK(validate(domain).size() == 2); // the crossings of the others
}

TEST_CASE("circleCorners: the number of corners is in range for any tolerance") {
    CHECK(circleCorners(0.002) == 52);
    CHECK(circleCorners(0.9) == 8);
    CHECK(circleCorners(5.0) == 8);
    CHECK(circleCorners(0.0) == 4096);
    CHECK(circleCorners(-1.0) == 4096);
    CHECK(circleCorners(1e-300) == 4096);
    CHECK(circleCorners(std::nan("")) == 4096);
}

TEST_CASE("toDomain: keeps tags per segment, uses, points and names") {
    Shape rectangle = makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 2}});
    rectangle.segmentTags = {1, 2, 3, 4};
    Document document =
        documentOf({rectangle, makeShape(ShapeKind::Polyline, {{1, 1}, {2, 1}}, ShapeUse::Constraint, 7),
                    makeShape(ShapeKind::Point, {{3, 1}}, ShapeUse::Constraint, 9)});
    document.boundaryNames[2] = "outlet";
    document.regionNames[1] = "water";
    document.regionMarkers.push_back({{1, 0.5}, 1});
    const Domain domain = toDomain(document);
    REQUIRE(domain.segments.size() == 5);
    for (std::int32_t k = 0; k < 4; ++k) {
        CHECK(domain.segments[static_cast<std::size_t>(k)].tag == k + 1);
        CHECK(domain.segments[static_cast<std::size_t>(k)].role == SegmentRole::Boundary);
    }
    CHECK(domain.nodes[domain.segments[1].a] == Vec2{4, 0});
    CHECK(domain.nodes[domain.segments[1].b] == Vec2{4, 2});
    CHECK(domain.segments[4].tag == 7);
    CHECK(domain.segments[4].role == SegmentRole::Constraint);
    REQUIRE(domain.points.size() == 1);
    CHECK(domain.nodes[domain.points[0].node] == Vec2{3, 1});
    CHECK(domain.points[0].tag == 9);
    CHECK(domain.boundaryNames.at(2) == "outlet");
    CHECK(domain.regionNames.at(1) == "water");
    CHECK(domain.regionMarkers.size() == 1);
}

TEST_CASE("fromDomain: loops become polygons and chains polylines, for any order of the segments") {
    Domain domain;
    addLoop(domain, box(0, 0, 10, 10), 3);
    addLoop(domain, box(2, 2, 4, 4), 5);
    domain.nodes.insert(domain.nodes.end(), {{5, 5}, {6, 6}, {7, 5}});
    domain.segments.push_back({8, 9, 2, SegmentRole::Constraint});
    domain.segments.push_back({10, 9, 4, SegmentRole::Constraint});
    std::swap(domain.segments[0], domain.segments[6]);
    std::swap(domain.segments[2].a, domain.segments[2].b);
    const Document document = fromDomain(domain);
    REQUIRE(document.shapes.size() == 3);
    CHECK(document.shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(document.shapes[0]->nodes.size() == 4);
    CHECK(document.shapes[1]->kind() == ShapeKind::Polygon);
    CHECK(document.shapes[2]->kind() == ShapeKind::Polyline);
    CHECK(document.shapes[2]->use == ShapeUse::Constraint);
    CHECK(document.shapes[2]->segmentTags == std::vector<std::int32_t>{2, 4});
    CHECK(document.nextId == 4);
    CHECK(sortedSegments(toDomain(document)) == sortedSegments(domain));
}

TEST_CASE("fromDomain: an unreferenced node stays, and only as a node") {
    Domain domain;
    addLoop(domain, box(0, 0, 1, 1));
    domain.nodes.push_back({0.5, 0.5});
    const Domain back = toDomain(fromDomain(domain));
    CHECK(back.nodes.size() == 5);
    CHECK(back.points.empty());
}

TEST_CASE("fromDomain: indices out of range are left out") {
    Domain domain;
    addLoop(domain, box(0, 0, 1, 1));
    domain.segments.push_back({3, 900, 1, SegmentRole::Boundary});
    domain.points.push_back({77, 1});
    for (const InsideRule rule : {InsideRule::EvenOdd, InsideRule::HoleMarkers}) {
        domain.insideRule = rule;
        CHECK(toDomain(fromDomain(domain)).segments.size() == 4);
    }
}

TEST_CASE("fromDomain then toDomain: the same segments, nodes, points and tags for random graphs") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random(seed);
        Domain domain;
        const std::uint32_t n = 2 + random.below(30);
        for (std::uint32_t k = 0; k < n; ++k) {
            domain.nodes.push_back({static_cast<double>(k), random.real(0, 9)});
        }
        for (std::uint32_t k = 0, m = random.below(2 * n); k < m; ++k) {
            const std::uint32_t a = random.below(n), b = (a + 1 + random.below(n - 1)) % n;
            domain.segments.push_back({a, b, static_cast<std::int32_t>(1 + random.below(3)),
                                       random.below(4) == 0 ? SegmentRole::Constraint : SegmentRole::Boundary});
        }
        for (std::uint32_t k = 0; k < n; k += 5) {
            domain.points.push_back({k, 2});
        }
        const Document document = fromDomain(domain);
        const Domain back = toDomain(document);
        REQUIRE(sortedSegments(back) == sortedSegments(domain));
        REQUIRE(sortedNodes(back) == sortedNodes(domain));
        REQUIRE(back.points.size() == domain.points.size());
        // A second round trip changes nothing.
        const Document again = fromDomain(back);
        REQUIRE(sortedSegments(toDomain(again)) == sortedSegments(domain));
    }
}

TEST_CASE("fromDomain: hole markers in nested loops become even-odd") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    addLoop(domain, box(0, 0, 10, 10));
    addLoop(domain, box(2, 2, 8, 8));
    addLoop(domain, box(4, 4, 6, 6)); // an island in the hole
    domain.holeMarkers = {{3, 3}};
    const Domain back = toDomain(fromDomain(domain));
    CHECK(back.insideRule == InsideRule::EvenOdd);
    CHECK(back.segments.size() == 12);
    for (const DomainSegment &s : back.segments) {
        CHECK(s.role == SegmentRole::Boundary);
    }
    CHECK(insideEvenOdd(back, {1, 1}));
    CHECK_FALSE(insideEvenOdd(back, {3, 3}));
    CHECK(insideEvenOdd(back, {5, 5}));
}

TEST_CASE("fromDomain: a nested loop without a hole marker becomes a constraint") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    addLoop(domain, box(0, 0, 10, 10));
    addLoop(domain, box(2, 2, 4, 4), 6);
    addLoop(domain, box(6, 6, 8, 8));
    domain.holeMarkers = {{7, 7}};
    // A chain that hangs from the outer loop into the domain bounds nothing.
    domain.nodes.push_back({5, 1});
    domain.segments.push_back({0, 12, 8, SegmentRole::Boundary});
    const Domain back = toDomain(fromDomain(domain));
    REQUIRE(back.segments.size() == 13);
    for (const DomainSegment &s : back.segments) {
        CHECK((s.role == SegmentRole::Constraint) == (s.tag != 1));
    }
    CHECK(insideEvenOdd(back, {3, 3}));
    CHECK_FALSE(insideEvenOdd(back, {7, 7}));
}

TEST_CASE("fromDomain: faces that share segments keep their inside, and what lies in a hole bounds nothing") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    // Three boxes in a row; the middle one is a hole with a segment across it.
    domain.nodes = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}};
    for (std::uint32_t k = 0; k < 8; ++k) {
        domain.segments.push_back({k, (k + 1) % 8, 1, SegmentRole::Boundary});
    }
    domain.segments.push_back({1, 6, 2, SegmentRole::Boundary});
    domain.segments.push_back({2, 5, 3, SegmentRole::Boundary});
    domain.segments.push_back({1, 5, 4, SegmentRole::Boundary});
    domain.holeMarkers = {{1.25, 0.75}, {1.75, 0.25}};
    const Domain even = withEvenOddRoles(domain);
    CHECK(insideEvenOdd(even, {0.5, 0.5}));
    CHECK_FALSE(insideEvenOdd(even, {1.3, 0.7}));
    CHECK_FALSE(insideEvenOdd(even, {1.7, 0.3}));
    CHECK(insideEvenOdd(even, {2.5, 0.5}));
    // Gone: the diagonal inside the hole and the two sides between hole and outside.
    CHECK(even.segments.size() == 8);
}

TEST_CASE("fromDomain: an open outline of a domain with hole markers stays, for validation to report") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    domain.nodes = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    domain.segments = {{0, 1}, {1, 2}, {2, 3}};
    const Document document = fromDomain(domain);
    REQUIRE(document.shapes.size() == 1);
    CHECK(document.shapes.front()->use == ShapeUse::Boundary);
    CHECK(document.shapes.front()->nodes.size() == 4);
}

TEST_CASE("idleHoleMarkers: markers outside every loop, on a segment, or all if segments cross") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    domain.nodes = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {6, 3}, {6, 6}, {3, 6}};
    for (const std::uint32_t first : {0U, 4U}) {
        for (std::uint32_t k = 0; k < 4; ++k) {
            domain.segments.push_back({first + k, first + (k + 1) % 4});
        }
    }
    domain.holeMarkers = {{5, 5}, {20, 20}, {9, 4}};
    CHECK(idleHoleMarkers(domain) == std::vector<Vec2>{{20, 20}, {9, 4}});
    domain.segments.push_back({0, 6});
    CHECK(idleHoleMarkers(domain) == domain.holeMarkers);
    domain.insideRule = InsideRule::EvenOdd;
    CHECK(idleHoleMarkers(domain).empty());
}

TEST_CASE("withEvenOddRoles: agrees with the markers on random cell patterns") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        // A board of skewed cells, each a separate face; some are marked as holes. A ring of loose squares beside it.
        constexpr std::uint32_t kSide = 6;
        Domain domain;
        domain.insideRule = InsideRule::HoleMarkers;
        for (std::uint32_t j = 0; j <= kSide; ++j) {
            for (std::uint32_t i = 0; i <= kSide; ++i) {
                domain.nodes.push_back({i + random.real(-0.2, 0.2), j + random.real(-0.2, 0.2)});
            }
        }
        const auto node = [](std::uint32_t i, std::uint32_t j) { return j * (kSide + 1) + i; };
        for (std::uint32_t j = 0; j <= kSide; ++j) {
            for (std::uint32_t i = 0; i <= kSide; ++i) {
                if (i < kSide) {
                    domain.segments.push_back({node(i, j), node(i + 1, j), 1, SegmentRole::Boundary});
                }
                if (j < kSide) {
                    domain.segments.push_back({node(i, j + 1), node(i, j), 1, SegmentRole::Boundary});
                }
            }
        }
        std::vector<Vec2> probes;
        std::vector<bool> inside;
        for (std::uint32_t j = 0; j < kSide; ++j) {
            for (std::uint32_t i = 0; i < kSide; ++i) {
                const Vec2 centre{i + 0.5, j + 0.5};
                const bool hole = random.below(3) == 0;
                if (hole) {
                    domain.holeMarkers.push_back(centre);
                }
                probes.push_back(centre);
                inside.push_back(!hole);
                // In the middle of some cells is a loose square; its inside is a separate face.
                if (random.below(3) == 0) {
                    const Vec2 low = centre + Vec2{0.08, 0.08};
                    const bool islandHole = random.below(2) == 0;
                    addLoop(domain, box(low.x, low.y, low.x + 0.1, low.y + 0.1));
                    probes.push_back(low + Vec2{0.05, 0.05});
                    inside.push_back(!islandHole);
                    if (islandHole) {
                        domain.holeMarkers.push_back(probes.back());
                    }
                }
            }
        }
        const Domain even = withEvenOddRoles(domain);
        for (std::size_t k = 0; k < probes.size(); ++k) {
            REQUIRE(insideEvenOdd(even, probes[k]) == inside[k]);
        }
    }
}

TEST_CASE("withEvenOddRoles: handles crossing, repeated and non-finite input") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Random random(seed);
        Domain domain;
        domain.insideRule = InsideRule::HoleMarkers;
        const std::uint32_t n = 3 + random.below(12);
        for (std::uint32_t k = 0; k < n; ++k) {
            // A coarse lattice: many nodes coincide, segments overlap and have no length.
            domain.nodes.push_back({static_cast<double>(random.below(4)), static_cast<double>(random.below(4))});
        }
        domain.nodes.push_back({std::nan(""), 1.0});
        domain.nodes.push_back({std::numeric_limits<double>::infinity(), 1.0});
        for (std::uint32_t k = 0; k < 2 * n; ++k) {
            domain.segments.push_back({random.below(n + 3), random.below(n + 2), 1, SegmentRole::Boundary});
        }
        domain.holeMarkers = {random.place(4), {std::nan(""), 0.0}};
        const Domain even = withEvenOddRoles(domain);
        CHECK(even.nodes.size() == domain.nodes.size());
        CHECK(even.segments.size() <= domain.segments.size());
        CHECK(fromDomain(domain).shapes.size() > 0);
    }
}

TEST_CASE("Shape geometry: bounds, area, length and inside test of every kind") {
    const Shape rectangle = makeShape(ShapeKind::Rectangle, {{4, 3}, {1, 1}});
    CHECK(areaOf(rectangle) == doctest::Approx(6));
    CHECK(lengthOf(rectangle) == doctest::Approx(10));
    CHECK(contains(rectangle, {2, 2}));
    CHECK_FALSE(contains(rectangle, {0, 2}));
    CHECK(handleCount(rectangle) == 4);
    CHECK(boundsOf(rectangle) == Box2{{1, 1}, {4, 3}});

    const Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {3, 4}});
    CHECK(circleRadius(circle) == 5.0);
    CHECK(areaOf(circle) == doctest::Approx(25 * std::numbers::pi));
    CHECK(boundsOf(circle) == Box2{{-5, -5}, {5, 5}});
    CHECK(contains(circle, {-4.9, 0}));
    CHECK_FALSE(contains(circle, {-4, -4}));

    const Shape polyline = makeShape(ShapeKind::Polyline, {{0, 0}, {3, 4}, {3, 5}});
    CHECK(areaOf(polyline) == 0.0);
    CHECK(lengthOf(polyline) == doctest::Approx(6));
    CHECK_FALSE(contains(polyline, {2.9, 4}));
    CHECK(displayName(polyline) == "polyline 0");
}

TEST_CASE("Shape: each kind has a form; a form other than the shape's is refused") {
    for (const ShapeKind kind : valuesOf<ShapeKind>()) {
        CAPTURE(wordOf(kind));
        Shape shape;
        shape.form = formOf(kind);
        CHECK(shape.kind() == kind);
        CHECK(shape.isPolygon() == (kind == ShapeKind::Polygon));
        CHECK(shape.isPolyline() == (kind == ShapeKind::Polyline));
        CHECK(isPath(shape) == shape.is<PathForm>());
        if (kind != ShapeKind::Slot) {
            CHECK_THROWS_AS(shape.as<SlotForm>(), std::bad_variant_access);
        }
    }
}
