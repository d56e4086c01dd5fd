#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/sharp_corners.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/parts/automatic/automatic.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace forefront;

namespace {

Domain loopOf(const std::vector<Vec2> &loop) {
    Domain domain;
    addLoop(domain, loop);
    return domain;
}

std::vector<Vec2> circleLoop(Vec2 centre, double radius, int pieces) {
    std::vector<Vec2> loop;
    for (int i = 0; i < pieces; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / pieces;
        loop.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return loop;
}

std::shared_ptr<const SpacingField> automatic(const Domain &domain) {
    auto field = SpacingField::build({}, domain);
    REQUIRE(field.ok());
    return *field;
}

} // namespace

TEST_CASE("Automatic spacing: a square without details gets a spacing in proportion to its size") {
    const auto field = automatic(loopOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    CHECK(field->at({0.5, 0.5}) == doctest::Approx(std::sqrt(2.0) / 45.0));
    CHECK(field->sample({0.5, 0.5}).describe == "automatic: size of the domain");
}

TEST_CASE("Automatic spacing: respects short segments next to neighbours of any size") {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<Vec2> loop;
    double angle = 0.0;
    while (angle < 6.2) {
        loop.push_back(10.0 * Vec2{std::cos(angle), std::sin(angle)});
        angle += 0.001 * std::pow(200.0, share(random));
    }
    const Domain domain = loopOf(loop);
    const auto field = automatic(domain);
    for (const PlacedSegment &segment : placedSegments(domain)) {
        const Vec2 middle = midpoint(segment.a, segment.b);
        CHECK(field->at(middle) <= segment.length() * 1.006);
        CHECK(field->at(middle) >= field->minimum());
    }
}

TEST_CASE("Automatic spacing: two elements fit across a channel, and open water stays coarse") {
    // Two basins of 4 x 4 joined by a channel of width 0.1.
    const Domain domain = loopOf(
        {{0, 0}, {4, 0}, {4, 1.9}, {6, 1.9}, {6, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 2.0}, {4, 2.0}, {4, 4}, {0, 4}});
    const auto field = automatic(domain);
    for (double x = 4.05; x < 6.0; x += 0.1) {
        CHECK(field->at({x, 1.95}) <=
              1.001 * (0.1 / std::sqrt(3.0) + 0.25 * 0.05)); // two rows of equilateral triangles
        CHECK(field->at({x, 1.95}) >= 0.045);
    }
    CHECK(field->at({1.5, 1}) == doctest::Approx(field->maximum()));
    CHECK(field->sample({5, 1.95}).describe.find("narrow channel") != std::string::npos);
    // No edge leads from one side to the other.
    MeshingJob job;
    job.domain = domain;
    const auto outcome = meshDomain(job);
    REQUIRE(outcome);
    const TriMesh mesh = takeTriMesh(outcome->mesh);
    for (const Element &element : mesh.elements) {
        for (int k = 0; k < 3; ++k) {
            const Vec2 a = mesh.nodes[index(element[k])], b = mesh.nodes[index(element[(k + 1) % 3])];
            const bool inChannel = a.x > 4.1 && a.x < 5.9 && b.x > 4.1 && b.x < 5.9;
            CHECK_FALSE((inChannel && std::fabs(a.y - b.y) > 0.099));
        }
    }
}

TEST_CASE("Automatic spacing: sizes follow the width of a long wedge, so that its elements are regular") {
    MeshingJob job;
    job.domain = loopOf({{0, 0}, {100, 0}, {100, 1}}); // 0.57 degrees
    const auto outcome = meshDomain(job);
    REQUIRE(outcome);
    CHECK(measureQuality(outcome->mesh, nullptr).alphaGeometricMean > 0.97);
    CHECK(outcome->mesh.triangles().size() < 2000);
}

TEST_CASE("Automatic spacing: a corner is refined the more the sharper it is, from 60 degrees down") {
    const auto sizeAtTip = [](double degrees) {
        const double half = degrees / 360.0 * std::numbers::pi;
        const Vec2 side{2.0 * std::cos(half), 2.0 * std::sin(half)};
        return automatic(loopOf({{0, 0}, {side.x, -side.y}, side}))->at({0.02, 0.0});
    };
    double last = sizeAtTip(80.0);
    CHECK(sizeAtTip(60.01) == doctest::Approx(last).epsilon(0.2));
    for (double degrees = 59.99; degrees > 20.0; degrees -= 4.0) {
        const double size = sizeAtTip(degrees);
        CHECK(size < 1.1 * last);
        CHECK(size > 0.7 * last);
        last = size;
    }
    CHECK(last < 0.6 * sizeAtTip(80.0));
}

TEST_CASE("Automatic spacing: a narrow tip is one long element, unless a size is given or something is beyond it") {
    const auto shortestAtTip = [](MeshingJob job) {
        const auto outcome = meshDomain(job);
        REQUIRE(outcome);
        const TriMesh mesh = takeTriMesh(outcome->mesh);
        double shortest = 1e9;
        for (const TaggedEdge &edge : mesh.edges) {
            const Vec2 a = mesh.nodes[index(edge.a)], b = mesh.nodes[index(edge.b)];
            shortest = a == Vec2{} || b == Vec2{} ? std::min(shortest, distance(a, b)) : shortest;
        }
        return shortest;
    };
    MeshingJob job;
    job.domain = loopOf({{0, 0}, {100, 0}, {100, 1}});
    CHECK(shortestAtTip(job) > 5.0);
    MeshingJob turned = job; // the other order and direction of segments, the other ends
    turned.domain = loopOf({{100, 1}, {0, 0}, {100, 0}});
    CHECK(shortestAtTip(turned) == shortestAtTip(job));
    MeshingJob sized = job;
    sized.spacing.size = 0.5;
    CHECK(shortestAtTip(sized) < 0.51);
    MeshingJob limited = job;
    limited.spacing.maximum = 1.0;
    CHECK(shortestAtTip(limited) < 1.01);
    MeshingJob neighboured = job; // with a region on the other side of one segment
    neighboured.domain.nodes.push_back({0, -50});
    neighboured.domain.segments.push_back({0, 3, 1});
    neighboured.domain.segments.push_back({3, 1, 1});
    neighboured.domain.segments[0].role = SegmentRole::Constraint;
    CHECK(shortestAtTip(neighboured) < 2.5);
    MeshingJob shared = job; // a tip at a node where four segments meet
    for (const Vec2 node : {Vec2{-100, 0}, Vec2{-100, -1}}) {
        shared.domain.nodes.push_back(node);
    }
    shared.domain.segments.push_back({0, 3, 1});
    shared.domain.segments.push_back({3, 4, 1});
    shared.domain.segments.push_back({4, 0, 1});
    CHECK(shortestAtTip(shared) > 5.0);
}

TEST_CASE("Automatic spacing: ignores gaps outside the domain") {
    // Two squares 0.02 apart: the strait between them is no part of the domain.
    Domain domain = loopOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    addLoop(domain, std::vector<Vec2>{{1.02, 0}, {2.02, 0}, {2.02, 1}, {1.02, 1}});
    const auto field = automatic(domain);
    CHECK(field->at({0.99, 0.5}) == doctest::Approx(field->maximum()));
    CHECK(field->minimum() == field->maximum());
}

TEST_CASE("Automatic spacing: orientation and order of the segments do not matter") {
    Domain domain = loopOf({{0, 0}, {4, 0}, {4, 1.9}, {6, 1.9}, {6, 0}, {10, 0}, {10, 4}, {0, 4}});
    addLoop(domain, circleLoop({2, 3.7}, 0.2, 24));
    Domain shuffled = domain;
    std::mt19937 random(5);
    std::shuffle(shuffled.segments.begin(), shuffled.segments.end(), random);
    for (DomainSegment &segment : shuffled.segments) {
        if (random() % 2 == 0) {
            std::swap(segment.a, segment.b);
        }
    }
    const auto one = automatic(domain);
    const auto other = automatic(shuffled);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p{10 * share(random), 4 * share(random)};
        CHECK(one->at(p) == doctest::Approx(other->at(p)).epsilon(0.01));
    }
    // Between the hole and the wall, 0.1 wide.
    CHECK(one->at({2, 3.95}) <= 0.07);
}

TEST_CASE("Automatic spacing: a needle is refined towards its tip, within a limit") {
    const auto field = automatic(loopOf({{0, 0}, {10, 0}, {10, 0.6}}));
    CHECK(field->at({1.0, 0.03}) < 0.08);
    CHECK(field->minimum() > 0.003); // 1/64 of the size beside it
}

TEST_CASE("Automatic spacing: a slit far narrower than the elements beside it is not refined, but reported") {
    // Two basins of 4 x 4 joined by a slit of width 0.001; elements are 0.24 long at most.
    MeshingJob job;
    job.domain = loopOf(
        {{0, 0}, {4, 0}, {4, 1.9}, {6, 1.9}, {6, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 1.901}, {4, 1.901}, {4, 4}, {0, 4}});
    const auto field = automatic(job.domain);
    CHECK(field->at({5, 1.9005}) == doctest::Approx(field->maximum()));
    const auto outcome = meshDomain(job);
    REQUIRE(outcome.ok());
    const SharpCorners forced = sharpCorners(outcome->mesh, 20.0);
    CHECK(forced.corners.empty());
    REQUIRE(forced.narrow.size() == 1);
    CHECK(forced.narrow[0].width == doctest::Approx(0.001).epsilon(0.01));
    CHECK(forced.narrow[0].elements < 40);
    CHECK(forced.minAngleElsewhere > 20.0);
}

TEST_CASE("Automatic spacing: a narrow place between two tips is refined, however narrow") {
    // Two basins that meet in a passage of width 0.001 between two corners of 90 degrees.
    MeshingJob job;
    job.domain =
        loopOf({{0, 0}, {4, 0}, {5, 1}, {6, 0}, {10, 0}, {10, 2.002}, {6, 2.002}, {5, 1.001}, {4, 2.002}, {0, 2.002}});
    CHECK(automatic(job.domain)->at({5, 1.0005}) < 0.002);
    const auto outcome = meshDomain(job);
    REQUIRE(outcome.ok());
    CHECK(measureQuality(outcome->mesh, nullptr).minAngle > 20.0);
    CHECK(outcome->mesh.triangles().size() < 4000);
}

TEST_CASE("Automatic spacing: a wedge of half a degree costs thousands of elements at most, most of them good") {
    MeshingJob job;
    job.domain = loopOf({{0, 0}, {10, 0}, {10, 0.0873}});
    const auto outcome = meshDomain(job);
    REQUIRE(outcome.ok());
    CHECK(outcome->mesh.triangles().size() < 6000);
    CHECK(measureQuality(outcome->mesh, nullptr).alphaGeometricMean > 0.9);
    CHECK(sharpCorners(outcome->mesh, 20.0).minAngleElsewhere > 20.0);
}

TEST_CASE("Automatic spacing: a very long and thin channel stays affordable") {
    const double length = 1000.0;
    const auto field = automatic(loopOf({{0, 0}, {length, 0}, {length, 0.001}, {0, 0.001}}));
    // about ∫ ds/ρ along the channel: far from the two million that two elements across would need
    double pieces = 0.0;
    for (double x = 0.5; x < length; x += 1.0) {
        pieces += 1.0 / field->at({x, 0.0005});
    }
    CHECK(pieces < 60000.0);
}

TEST_CASE("Automatic spacing: at an isolated point the spacing is its distance to the nearest part of the domain") {
    Domain domain = loopOf({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    domain.nodes.push_back({5, 5});
    domain.nodes.push_back({5.05, 5});
    domain.points = {{4, 1}, {5, 1}};
    const auto field = automatic(domain);
    CHECK(field->at({5, 5}) == doctest::Approx(0.05));
    CHECK(field->at({1, 1}) == doctest::Approx(field->maximum()));
}

TEST_CASE("Automatic spacing: a point at a node of the boundary changes nothing") {
    // At such coordinates the distance from a segment to its own end is 1e-17.
    MeshingJob job;
    job.domain = loopOf({{0, 0.3}, {0.01000000000002773, 0.3}, {0, 0.01000000000002488}});
    const auto plain = meshDomain(job);
    job.domain.points.push_back({0, 1});
    const auto marked = meshDomain(job);
    REQUIRE(plain);
    REQUIRE(marked);
    CHECK(marked->mesh.triangles().size() == plain->mesh.triangles().size());
}

TEST_CASE("Automatic spacing: keeps the gradation within 2 % and its own bounds") {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 6; ++round) {
        Domain domain = loopOf(circleLoop({0, 0}, 10, 20 + 40 * round));
        for (int hole = 0; hole < 5; ++hole) {
            const double angle = hole * 1.2566;
            addLoop(domain, circleLoop(6.0 * Vec2{std::cos(angle), std::sin(angle)}, 0.3 + 3.0 * share(random),
                                       12 + static_cast<int>(60 * share(random))));
        }
        const auto field = automatic(domain);
        for (int i = 0; i < 4000; ++i) {
            const auto somewhere = [&] { return Vec2{20 * share(random) - 10, 20 * share(random) - 10}; };
            const Vec2 p = somewhere();
            const Vec2 q = i % 2 == 0 ? somewhere() : p + 0.02 * somewhere();
            const double a = field->at(p);
            const double b = field->at(q);
            REQUIRE(std::fabs(a - b) <= 0.25 * distance(p, q) + 0.012 * std::max(a, b));
            REQUIRE(a >= field->minimum() * (1 - 1e-6));
            REQUIRE(a <= field->maximum() * (1 + 1e-6));
        }
    }
}

TEST_CASE("Automatic spacing: with very many segments, the spacing may grow by half at some, and the gradation stays "
          "within 10 %") {
    std::mt19937 random(29);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<Vec2> loop;
    while (loop.size() < 3 * kManySites) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(loop.size()) / (3.0 * kManySites);
        loop.push_back((10.0 + 2.0 * std::sin(9.0 * angle) + 0.002 * share(random)) *
                       Vec2{std::cos(angle), std::sin(angle)});
    }
    const Domain domain = loopOf(loop);
    const auto field = automatic(domain);
    double atMost = 0.0;
    for (const PlacedSegment &segment : placedSegments(domain)) {
        const double ratio = field->at(midpoint(segment.a, segment.b)) / segment.length();
        REQUIRE(ratio < 1.6);
        atMost = std::max(atMost, ratio);
    }
    CHECK(atMost > 1.1); // not every segment has its own site
    for (int i = 0; i < 4000; ++i) {
        const auto somewhere = [&] { return Vec2{24 * share(random) - 12, 24 * share(random) - 12}; };
        const Vec2 p = somewhere();
        const Vec2 q = i % 2 == 0 ? somewhere() : p + 0.01 * somewhere();
        const double a = field->at(p);
        const double b = field->at(q);
        REQUIRE(std::fabs(a - b) <= 0.25 * distance(p, q) + 0.1 * std::max(a, b));
    }
}

TEST_CASE("Automatic spacing: broken domains neither crash nor give unusable values") {
    Domain domain;
    CHECK(automatic(domain)->at({0, 0}) > 0.0);
    domain.nodes = {{0, 0}, {1, 0}, {std::nan(""), 1}, {1, 0}};
    domain.segments = {{0, 1, 1, SegmentRole::Boundary},
                       {1, 2, 1, SegmentRole::Boundary},
                       {2, 77, 1, SegmentRole::Boundary},
                       {1, 3, 1, SegmentRole::Boundary},
                       {0, 0, 1, SegmentRole::Constraint}};
    domain.points = {{99, 1}, {2, 1}, {0, 1}};
    CHECK(automatic(domain)->at({0.5, 0}) > 0.0);
    CHECK(std::isfinite(automatic(domain)->at({0.5, 0})));
}

TEST_CASE("Automatic spacing: scales with the domain, however small or large or far away") {
    Domain domain = loopOf({{0, 0}, {4, 0}, {4, 1.9}, {6, 1.9}, {6, 0}, {10, 0}, {10, 4}, {0, 4}});
    addLoop(domain, circleLoop({2, 3.7}, 0.2, 24));
    const auto field = automatic(domain);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const double scale : {std::ldexp(1.0, -200), std::ldexp(1.0, 200), 1.0}) {
        const Vec2 offset = scale == 1.0 ? Vec2{1e6, -3e5} : Vec2{0, 0};
        Domain other = domain;
        for (Vec2 &node : other.nodes) {
            node = scale * node + offset;
        }
        const auto scaled = automatic(other);
        for (int i = 0; i < 500; ++i) {
            const Vec2 p{10 * share(random), 4 * share(random)};
            REQUIRE(scaled->at(scale * p + offset) == doctest::Approx(scale * field->at(p)).epsilon(0.01).scale(0.0));
        }
    }
}
