#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/faces.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace forefront;

namespace {

std::uint32_t addLoop(Domain &domain, const std::vector<Vec2> &nodes, SegmentRole role = SegmentRole::Boundary) {
    const auto first = static_cast<std::uint32_t>(domain.nodes.size());
    const auto count = static_cast<std::uint32_t>(nodes.size());
    domain.nodes.insert(domain.nodes.end(), nodes.begin(), nodes.end());
    for (std::uint32_t i = 0; i < count; ++i) {
        domain.segments.push_back({first + i, first + (i + 1) % count, 1, role});
    }
    return static_cast<std::uint32_t>(domain.segments.size() - count);
}

std::vector<Vec2> square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

struct Subdivision {
    DomainGraph graph;
    Faces faces;
    FaceLabels labels;
};

Subdivision subdivide(const Domain &domain) {
    Subdivision result;
    result.graph = graphOf(domain);
    const PlaneSweepResult sweep = sweepPlane(result.graph.points, result.graph.edges);
    REQUIRE(sweep.droppedCount == 0);
    result.faces = findFaces(result.graph.points, result.graph.edges, sweep);
    result.labels = labelFaces(domain, result.graph, result.faces);
    return result;
}

/// Returns twice the area of each face from its edges; the unbounded one has minus the sum of the others.
std::vector<double> twiceAreas(const std::vector<Vec2> &points, const std::vector<PlaneEdge> &edges,
                               const Faces &faces) {
    std::vector<double> areas(faces.count, 0.0);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const double part = cross(points[edges[e].a], points[edges[e].b]);
        areas[faces.left[e]] += part;
        areas[faces.right[e]] -= part;
    }
    return areas;
}

} // namespace

TEST_CASE("Faces: a hole is outside and an island in it is inside, for any orientation of loops") {
    Domain domain;
    const auto outer = addLoop(domain, square(0, 0, 10));
    const std::vector<Vec2> clockwise{{2, 2}, {2, 8}, {8, 8}, {8, 2}};
    const auto hole = addLoop(domain, clockwise);
    const auto island = addLoop(domain, square(4, 4, 2));
    const auto other = addLoop(domain, square(20, 0, 1));
    const Subdivision s = subdivide(domain);
    CHECK(s.faces.count == 5);
    CHECK(s.faces.right[outer] == 0);
    CHECK(s.faces.left[hole] == s.faces.left[outer]);
    CHECK(s.faces.right[hole] == s.faces.right[island]);
    CHECK(s.faces.right[other] == 0);
    CHECK(s.labels.inside[0] == 0);
    CHECK(s.labels.inside[s.faces.left[outer]] == 1);
    CHECK(s.labels.inside[s.faces.right[hole]] == 0);
    CHECK(s.labels.inside[s.faces.left[island]] == 1);
    CHECK(s.labels.inside[s.faces.left[other]] == 1);
}

TEST_CASE("Faces: closed constraints divide faces, but open ones and points do not; markers give tags") {
    Domain domain;
    const auto outer = addLoop(domain, square(0, 0, 10));
    const auto inner = addLoop(domain, square(1, 1, 2), SegmentRole::Constraint);
    const auto first = static_cast<std::uint32_t>(domain.nodes.size());
    domain.nodes.insert(domain.nodes.end(), {{5, 5}, {6, 6}, {7, 5}, {8, 8}});
    domain.segments.push_back({first, first + 1, 1, SegmentRole::Constraint});
    domain.segments.push_back({first + 1, first + 2, 1, SegmentRole::Constraint});
    domain.segments.push_back({0, first, 1, SegmentRole::Constraint}); // from a corner of the outer loop
    domain.points.push_back({first + 3, 1});
    domain.regionMarkers = {{{2, 2}, 7}, {{9, 9}, 4}, {{8.5, 9}, 5}};
    Subdivision s;
    // The corner (1, 1) of the inner loop lies on the segment from (0, 0) to (5, 5): move the loop away.
    for (std::uint32_t i = 4; i < 8; ++i) {
        domain.nodes[i].y += 4.0;
    }
    domain.regionMarkers[0].at.y += 4.0;
    s = subdivide(domain);
    CHECK(s.faces.count == 3);
    const std::uint32_t field = s.faces.left[outer];
    CHECK(s.faces.right[inner] == field);
    CHECK(s.labels.inside[s.faces.left[inner]] == 1);
    CHECK(s.labels.tag[s.faces.left[inner]] == 7);
    CHECK(s.labels.tag[field] == 4);
    CHECK(s.labels.marker[field] == 1);
    CHECK(s.faces.ofPoint[first + 3] == field);
    for (const std::size_t e : {8U, 9U, 10U}) {
        CHECK(s.faces.left[e] == field);
        CHECK(s.faces.right[e] == field);
    }
}

TEST_CASE("Faces: loops that touch at a node stay apart") {
    Domain domain;
    const auto first = addLoop(domain, square(0, 0, 1));
    domain.nodes.insert(domain.nodes.end(), {{2, 1}, {2, 2}, {1, 2}});
    for (const auto &[a, b] : {std::pair{2U, 4U}, {4U, 5U}, {5U, 6U}, {6U, 2U}}) {
        domain.segments.push_back({a, b, 1, SegmentRole::Boundary});
    }
    // A hole that touches the outer loop in a node from inside.
    domain.nodes.insert(domain.nodes.end(), {{0.25, 0.5}, {0.5, 0.25}});
    for (const auto &[a, b] : {std::pair{0U, 7U}, {7U, 8U}, {8U, 0U}}) {
        domain.segments.push_back({a, b, 1, SegmentRole::Boundary});
    }
    const Subdivision s = subdivide(domain);
    CHECK(s.faces.count == 4);
    CHECK(s.labels.inside[s.faces.left[first]] == 1);
    CHECK(s.labels.inside[s.faces.left[4]] == 1);
    CHECK(s.faces.left[4] != s.faces.left[first]);
    CHECK(s.faces.left[8] == s.faces.left[first]); // from (0, 0) up to (0.25, 0.5): the hole lies to the right
    CHECK(s.labels.inside[s.faces.right[8]] == 0);
}

TEST_CASE("Faces: with HoleMarkers every bounded face without a marker is inside") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    const auto outer = addLoop(domain, square(0, 0, 10));
    const auto inner = addLoop(domain, square(4, 4, 2));
    CHECK(subdivide(domain).labels.inside[subdivide(domain).faces.left[inner]] == 1);
    domain.holeMarkers = {{5, 5}};
    const Subdivision s = subdivide(domain);
    CHECK(s.labels.inside[s.faces.left[inner]] == 0);
    CHECK(s.labels.inside[s.faces.left[outer]] == 1);
}

TEST_CASE("Faces: random subdivisions obey Euler's formula, and every bounded face has positive area") {
    std::mt19937_64 random(21);
    std::uniform_int_distribution<int> coordinate(0, 24);
    std::size_t faceTotal = 0;
    for (int round = 0; round < 1500; ++round) {
        std::vector<Vec2> points;
        for (int i = 0; i < 4 + round % 60; ++i) {
            points.push_back({1.0 * coordinate(random), 1.0 * coordinate(random)});
        }
        std::uniform_int_distribution<std::uint32_t> choice(0, static_cast<std::uint32_t>(points.size() - 1));
        std::vector<PlaneEdge> all, edges;
        for (int i = 0; i < 4 * static_cast<int>(points.size()); ++i) {
            all.push_back({choice(random), choice(random)});
        }
        const PlaneSweepResult raw = sweepPlane(points, all);
        for (std::size_t e = 0; e < all.size(); ++e) {
            if (raw.dropped[e] == 0) {
                edges.push_back(all[e]);
            }
        }
        const PlaneSweepResult sweep = sweepPlane(points, edges);
        const Faces faces = findFaces(points, edges, sweep);
        faceTotal += faces.count;

        std::vector<std::uint32_t> root(points.size());
        std::set<std::uint32_t> withEdges;
        for (std::uint32_t p = 0; p < root.size(); ++p) {
            root[p] = sweep.canonical[p];
        }
        for (const PlaneEdge &edge : edges) {
            withEdges.insert(sweep.canonical[edge.a]);
            withEdges.insert(sweep.canonical[edge.b]);
            const std::uint32_t from = root[edge.a], to = root[edge.b];
            std::replace(root.begin(), root.end(), from, to);
        }
        std::set<std::uint32_t> components;
        for (const std::uint32_t p : withEdges) {
            components.insert(root[p]);
        }
        REQUIRE(withEdges.size() + faces.count == edges.size() + components.size() + 1);
        const std::vector<double> areas = twiceAreas(points, edges, faces); // exact: small integers
        double sum = 0.0;
        for (std::uint32_t face = 1; face < faces.count; ++face) {
            REQUIRE(areas[face] > 0.0);
            sum += areas[face];
        }
        REQUIRE(areas[0] == -sum);
        for (std::uint32_t p = 0; p < points.size(); ++p) {
            REQUIRE((faces.ofPoint[p] != kNoIndex) ==
                    (!withEdges.contains(sweep.canonical[p]) && sweep.on[sweep.canonical[p]] == kNoIndex));
        }
    }
    CHECK(faceTotal > 3000);
}

namespace {

/// Counts along a ray to the right, exactly.
bool crossesBoundaryOddly(const Domain &domain, Vec2 p) {
    bool odd = false;
    for (const DomainSegment &segment : domain.segments) {
        const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        if (segment.role == SegmentRole::Boundary && (a.y <= p.y) != (b.y <= p.y)) {
            odd ^= orientation(a, b, p) == (b.y > a.y ? 1 : -1);
        }
    }
    return odd;
}

bool onAnySegment(const Domain &domain, Vec2 p) {
    return std::any_of(domain.segments.begin(), domain.segments.end(), [&](const DomainSegment &segment) {
        return onSegment(domain.nodes[segment.a], domain.nodes[segment.b], p);
    });
}

} // namespace

TEST_CASE(
    "Faces: points of random domains are inside if and only if a ray crosses the boundary an odd number of times") {
    std::size_t insides = 0, onSegments = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        Domain domain = forefront::testing::randomDomain(seed);
        forefront::testing::RandomSource random(seed);
        const Box2 box = domain.bounds();
        domain.regionMarkers.clear();
        const auto nodes = static_cast<int>(domain.nodes.size());
        for (int i = 0; i < 40; ++i) {
            const Vec2 anywhere{random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y)};
            const Vec2 node = domain.nodes[static_cast<std::size_t>(random.integer(0, nodes - 1))];
            const Vec2 sameHeight{anywhere.x, node.y}, sameColumn{node.x, anywhere.y};
            const Vec2 nextTo{std::nextafter(node.x, anywhere.x), node.y};
            for (const Vec2 p : {anywhere, node, sameHeight, sameColumn, nextTo}) {
                domain.regionMarkers.push_back({p, i + 1});
            }
        }
        const Subdivision s = subdivide(domain);
        for (std::size_t m = 0; m < domain.regionMarkers.size(); ++m) {
            const Vec2 p = domain.regionMarkers[m].at;
            const std::uint32_t face = s.faces.ofPoint[s.graph.regionMarker[m]];
            const bool on = onAnySegment(domain, p);
            REQUIRE(on == (face == kNoIndex));
            if (on) {
                ++onSegments;
            } else {
                REQUIRE((s.labels.inside[face] != 0) == crossesBoundaryOddly(domain, p));
                insides += s.labels.inside[face];
            }
        }
    }
    CHECK(insides > 10000);
    CHECK(onSegments > 10000);
}
