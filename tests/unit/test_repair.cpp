#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stop_token>

using namespace forefront;
using namespace forefront::testing;
using samples::codes;

namespace {

std::vector<std::uint32_t> addLoop(Domain &domain, const std::vector<Vec2> &polygon, std::int32_t tag = 1) {
    std::vector<std::uint32_t> nodes;
    for (const Vec2 p : polygon) {
        nodes.push_back(static_cast<std::uint32_t>(domain.nodes.size()));
        domain.nodes.push_back(p);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        domain.segments.push_back({nodes[i], nodes[(i + 1) % nodes.size()], tag});
    }
    return nodes;
}

std::vector<Vec2> squareLoop(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// Returns the repaired domain, which must be valid; repairing again changes nothing.
Domain repaired(const Domain &domain) {
    const auto result = repair(domain);
    REQUIRE(result.ok());
    REQUIRE(codes(validate(result->domain)) == std::set<std::string>{});
    REQUIRE(result->segmentSource.size() == result->domain.segments.size());
    const auto again = repair(result->domain);
    REQUIRE(again.ok());
    REQUIRE(again->changes.empty());
    REQUIRE(again->domain.nodes == result->domain.nodes);
    return result->domain;
}

std::size_t constraintCount(const Domain &domain) {
    std::size_t count = 0;
    for (const DomainSegment &segment : domain.segments) {
        count += segment.role == SegmentRole::Constraint ? 1 : 0;
    }
    return count;
}

} // namespace

TEST_CASE("repair: the pieces of a divided segment share its number of elements") {
    Domain domain;
    addLoop(domain, squareLoop(0.0, 0.0, 10.0));
    for (const Vec2 p : {Vec2{1.0, 5.0}, Vec2{9.0, 5.0}, Vec2{7.0, 2.0}, Vec2{7.0, 8.0}}) {
        domain.nodes.push_back(p);
    }
    domain.segments.push_back({4, 5, 2, SegmentRole::Constraint});
    domain.segments.push_back({6, 7, 3, SegmentRole::Constraint});
    SpacingSpec spacing;
    carryElements(domain, *repair(domain), spacing);
    CHECK(spacing.placed.elements.empty());
    spacing.placed.elements = {0, 0, 0, 0, 40, 0};
    const Repaired made = *repair(domain);
    CHECK(checkSpacing(spacing, made.domain).front().code == "bad-element-counts"); // for the domain before
    carryElements(domain, made, spacing);
    const Domain &result = made.domain;
    CHECK(checkSpacing(spacing, result).empty());
    const SegmentElements counts = spacing.placed.elements;
    std::map<double, std::uint32_t> elements; // by length
    for (std::size_t s = 0; s < result.segments.size(); ++s) {
        const DomainSegment &segment = result.segments[s];
        if (segment.tag == 2) {
            elements[distance(result.nodes[segment.a], result.nodes[segment.b])] = counts[s];
        } else {
            CHECK(counts[s] == 0);
        }
    }
    CHECK(elements == std::map<double, std::uint32_t>{{2.0, 10}, {6.0, 30}});
}

TEST_CASE("repair: merges nodes, drops duplicate, empty and unreferenced parts, and reports each change") {
    Domain domain;
    addLoop(domain, squareLoop(0, 0, 1));
    domain.nodes.push_back({0, 0});
    domain.segments[3].b = 4;             // closes with a second node in the same place
    domain.segments.push_back({1, 1});    // no length
    domain.segments.push_back({2, 1, 9}); // repeats segment 1
    domain.nodes.push_back({7, 7});       // unreferenced
    const auto result = repair(domain);
    REQUIRE(result.ok());
    CHECK(codes(notesOf(result->changes)) ==
          std::set<std::string>{"duplicate-node", "duplicate-segment", "unreferenced-node", "zero-length"});
    const Domain whole = repaired(domain);
    CHECK(whole.nodes.size() == 4);
    CHECK(whole.segments.size() == 4);
    CHECK(insideArea(whole) == 1.0);
}

TEST_CASE("repair: a valid domain is left exactly as it is") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        const auto result = repair(domain);
        REQUIRE(result.ok());
        REQUIRE(result->changes.empty());
        REQUIRE(result->domain.nodes == domain.nodes);
        REQUIRE(result->domain.segments.size() == domain.segments.size());
        for (std::size_t s = 0; s < domain.segments.size(); ++s) {
            REQUIRE(result->domain.segments[s].a == domain.segments[s].a);
            REQUIRE(result->domain.segments[s].b == domain.segments[s].b);
            REQUIRE(result->domain.segments[s].tag == domain.segments[s].tag);
            REQUIRE(result->domain.segments[s].role == domain.segments[s].role);
        }
        REQUIRE(result->domain.points.size() == domain.points.size());
    }
}

TEST_CASE("repair: crossings become nodes, and tags stay with the pieces") {
    Domain bowTie;
    addLoop(bowTie, {{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    for (std::int32_t s = 0; s < 4; ++s) {
        bowTie.segments[static_cast<std::size_t>(s)].tag = s + 1;
    }
    const Domain domain = repaired(bowTie);
    CHECK(domain.nodes.size() == 5);
    CHECK(domain.nodes.back() == Vec2{1, 1});
    REQUIRE(domain.segments.size() == 6);
    CHECK(insideArea(domain) == 2.0);
    std::multiset<std::int32_t> tags;
    for (const DomainSegment &segment : domain.segments) {
        tags.insert(segment.tag);
    }
    CHECK(tags == std::multiset<std::int32_t>{1, 1, 2, 3, 3, 4});
}

TEST_CASE("repair: crossing loops follow the even-odd rule") {
    Domain domain;
    addLoop(domain, squareLoop(0, 0, 2));
    addLoop(domain, squareLoop(1, 1, 2));
    CHECK(insideArea(repaired(domain)) == 6.0);
}

TEST_CASE("repair: neighbours that share part of a side keep it as a constraint") {
    Domain domain;
    addLoop(domain, squareLoop(0, 0, 2), 1);
    addLoop(domain, squareLoop(2, 1, 2), 2);
    const Domain whole = repaired(domain);
    CHECK(insideArea(whole) == 8.0);
    CHECK(constraintCount(whole) == 1);
    Domain row; // whole sides in common
    for (int i = 0; i < 5; ++i) {
        addLoop(row, squareLoop(i, 0, 1));
    }
    CHECK(insideArea(repaired(row)) == 5.0);
    CHECK(constraintCount(repaired(row)) == 4);
}

TEST_CASE("repair: a loop given twice counts once") {
    Domain domain;
    addLoop(domain, squareLoop(0, 0, 4));
    addLoop(domain, squareLoop(1, 1, 1));
    addLoop(domain, squareLoop(0, 0, 4));
    const Domain whole = repaired(domain);
    CHECK(insideArea(whole) == 15.0);
    CHECK(constraintCount(whole) == 0);
}

TEST_CASE("repair: a boundary folded onto itself is dropped outside the domain and stays as a constraint inside") {
    Domain outside;
    addLoop(outside, {{0, 0}, {2, 0}, {2, 2}, {5, 2}, {2, 2}, {0, 2}});
    CHECK(repaired(outside).segments.size() == 4);
    CHECK(insideArea(repaired(outside)) == 4.0);
    Domain inside;
    addLoop(inside, {{0, 0}, {2, 0}, {2, 2}, {1, 1}, {2, 2}, {0, 2}});
    CHECK(constraintCount(repaired(inside)) == 1);
    CHECK(insideArea(repaired(inside)) == 4.0);
}

TEST_CASE("repair: lines that should meet in one point do so despite rounding") {
    Domain domain;
    addLoop(domain, squareLoop(-2, -2, 4));
    for (int i = 0; i < 7; ++i) { // spokes through the origin
        const double angle = 0.3 + 0.4 * i;
        const auto a = static_cast<std::uint32_t>(domain.nodes.size());
        domain.nodes.push_back({std::cos(angle), std::sin(angle)});
        domain.nodes.push_back({-0.7 * std::cos(angle), -0.7 * std::sin(angle)});
        domain.segments.push_back({a, a + 1, 1, SegmentRole::Constraint});
    }
    const Domain whole = repaired(domain);
    CHECK(whole.nodes.size() == 4 + 14 + 1);
    CHECK(whole.segments.size() == 4 + 14);
}

TEST_CASE("repair: random closed polygons that cross themselves keep inside and outside") {
    RandomSource random(31);
    int tested = 0;
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        const bool lattice = round % 3 == 0;
        std::vector<Vec2> polygon;
        for (int i = random.integer(4, 25); i > 0; --i) {
            polygon.push_back(lattice ? Vec2{1.0 * random.integer(0, 9), 1.0 * random.integer(0, 9)}
                                      : Vec2{random.unit(), 1e5 + random.unit()});
        }
        Domain domain;
        addLoop(domain, polygon);
        const auto result = repair(domain);
        REQUIRE(result.ok());
        const std::set<std::string> left = codes(validate(result->domain));
        if (left == std::set<std::string>{"empty-domain"}) {
            continue; // it was folded flat
        }
        REQUIRE(left == std::set<std::string>{});
        if (lattice) {
            continue; // sides that repeat count once where that closes the boundary: not the same as even-odd
        }
        Domain probe = result->domain;
        const Box2 box = probe.bounds();
        std::vector<Vec2> places;
        for (int i = 0; i < 40; ++i) {
            places.push_back({random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y)});
            probe.regionMarkers.push_back({places.back(), 1});
        }
        const DomainGraph graph = graphOf(probe);
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        const Faces faces = findFaces(graph.points, graph.edges, sweep);
        const FaceLabels labels = labelFaces(probe, graph, faces);
        for (std::size_t i = 0; i < places.size(); ++i) {
            double gap = 1.0; // rounded crossings shift the boundary by last digits
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                gap = std::min(gap, distanceToSegment(polygon[k], polygon[(k + 1) % polygon.size()], places[i]));
            }
            if (gap > 1e-9) {
                const bool inside = labels.inside[faces.ofPoint[graph.regionMarker[i]]] != 0;
                REQUIRE(inside == (locate(polygon, places[i]) == PointPlace::Inside));
                ++tested;
            }
        }
    }
    CHECK(tested > 3000);
}

TEST_CASE("repair: random lattice junk becomes simple") {
    RandomSource random(32);
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        Domain domain;
        const int size = random.integer(2, 12);
        for (int i = random.integer(3, 40); i > 0; --i) {
            domain.nodes.push_back({0.1 * random.integer(0, size), 0.1 * random.integer(0, size)});
        }
        const int last = static_cast<int>(domain.nodes.size()) - 1;
        for (int i = random.integer(1, 60); i > 0; --i) {
            domain.segments.push_back({static_cast<std::uint32_t>(random.integer(0, last)),
                                       static_cast<std::uint32_t>(random.integer(0, last)), 1,
                                       random.chance(0.5) ? SegmentRole::Boundary : SegmentRole::Constraint});
        }
        domain.points.push_back({0, 1});
        const auto result = repair(domain);
        REQUIRE(result.ok());
        const DomainGraph graph = graphOf(result->domain);
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        REQUIRE(sweep.droppedCount == 0);
        REQUIRE(graph.edges.size() == result->domain.segments.size());
        REQUIRE(sweep.order.size() == graph.points.size());
    }
}

TEST_CASE("repair: names the given node and segment that each part comes from") {
    Domain domain;
    domain.nodes = {{9, 9}, {0, 0}, {2, 2}, {2, 0}, {0, 2}}; // the first is unused, the segments cross
    for (std::uint32_t k = 0; k < 4; ++k) {
        domain.segments.push_back({1 + k, 1 + (k + 1) % 4});
    }
    const auto result = repair(domain);
    REQUIRE(result.ok());
    REQUIRE(result->nodeSource.size() == result->domain.nodes.size());
    std::size_t added = 0;
    for (std::size_t n = 0; n < result->nodeSource.size(); ++n) {
        const std::uint32_t source = result->nodeSource[n];
        added += source == kNoIndex ? 1 : 0;
        CHECK(result->domain.nodes[n] == (source == kNoIndex ? Vec2{1, 1} : domain.nodes[source]));
    }
    CHECK(added == 1);
}

TEST_CASE("repair: leaves and reports faults that cannot be repaired safely") {
    Domain open;
    addLoop(open, squareLoop(0, 0, 1));
    open.segments.pop_back();
    CHECK(codes(validate(repair(open)->domain)) == std::set<std::string>{"open-chain"});
    Domain number;
    addLoop(number, squareLoop(0, 0, 1));
    number.nodes[1].x = std::numeric_limits<double>::quiet_NaN();
    CHECK(codes(validate(repair(number)->domain)).contains("non-finite"));
    Domain index;
    addLoop(index, squareLoop(0, 0, 1));
    index.segments[0].b = 1000;
    CHECK(codes(validate(repair(index)->domain)).contains("bad-index"));
    CHECK(codes(validate(repair({})->domain)) == std::set<std::string>{"empty-domain"});
}

TEST_CASE("repair: a stop request ends it, whatever the domain and the tolerance") {
    Domain domain;
    addLoop(domain, squareLoop(0, 0, 1));
    std::stop_source stop;
    REQUIRE(repair(domain, 0.0, stop.get_token()).ok());
    stop.request_stop();
    for (const double tolerance : {0.0, 1e-6}) {
        const Result<Repaired> stopped = repair(domain, tolerance, stop.get_token());
        REQUIRE_FALSE(stopped.ok());
        CHECK(stopped.faults().front().code == "cancelled");
    }
}

TEST_CASE("repair: curves that cross although their chords do not are split where they do") {
    Domain domain; // a hexagon for a circle, and a line between its lowest chord and its curve
    domain.curves.push_back(Curve::arc({0, 0}, {1, 0}, {0, 1}, -1.5707963267948966 - 0.5235987755982988));
    for (std::uint32_t k = 0; k < 6; ++k) {
        domain.nodes.push_back(domain.curves[0].point(k / 6.0));
        domain.segments.push_back({k, (k + 1) % 6, 1, SegmentRole::Boundary, {0, k / 6.0, (k + 1) / 6.0}});
    }
    addLoop(domain, {{-2, -3}, {2, -3}, {2, -0.95}, {-2, -0.95}}, 2);
    REQUIRE(validate(domain).empty());
    const Result<Repaired> repaired = repair(domain, 0.0);
    REQUIRE(repaired.ok());
    CHECK(validate(repaired->domain).empty());
    std::size_t crossings = 0;
    for (const Vec2 node : repaired->domain.nodes) {
        crossings += node.y == -0.95 && std::fabs(lengthSquared(node) - 1.0) < 1e-14 ? 1 : 0;
    }
    CHECK(crossings == 2);
}
