#include "core/engine/boundary/discretise.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/plane_sweep.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace forefront;
using namespace forefront::testing;

namespace {

Domain polygon(const std::vector<Vec2> &nodes) {
    Domain domain;
    domain.nodes = nodes;
    const auto count = static_cast<std::uint32_t>(nodes.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        domain.segments.push_back({i, (i + 1) % count});
    }
    return domain;
}

const Domain kSquare = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

std::size_t piecesOf(const DiscreteDomain &domain, std::uint32_t source) {
    return static_cast<std::size_t>(std::count_if(domain.segments.begin(), domain.segments.end(),
                                                  [&](const DiscreteSegment &s) { return s.source == source; }));
}

bool isSimple(const DiscreteDomain &domain) {
    std::vector<PlaneEdge> edges;
    for (const DiscreteSegment &s : domain.segments) {
        edges.push_back({s.a, s.b});
    }
    const PlaneSweepResult sweep = sweepPlane(domain.nodes, edges);
    return sweep.droppedCount == 0 && sweep.order.size() == domain.nodes.size();
}

} // namespace

TEST_CASE("discretise: a unit square with spacing 0.1 has forty nodes a tenth apart") {
    const auto discrete = discretise(kSquare, constantSpacing(0.1), false);
    REQUIRE(discrete.ok());
    CHECK(discrete->nodes.size() == 40);
    REQUIRE(discrete->segments.size() == 40);
    for (const DiscreteSegment &s : discrete->segments) {
        CHECK(distance(discrete->nodes[s.a], discrete->nodes[s.b]) == doctest::Approx(0.1).epsilon(1e-12));
        CHECK(s.leftRegion == 0);
        CHECK(s.rightRegion == kOutside);
    }
    REQUIRE(discrete->regions.size() == 1);
    CHECK(discrete->area() == 1.0);
    CHECK(discrete->bounds() == Box2{{0, 0}, {1, 1}});
}

TEST_CASE("discretise: spacing that grows over twelve orders of magnitude is followed, not refused") {
    for (const double minimum : {1e-6, 1e-9, 1e-12}) {
        CAPTURE(minimum);
        const auto discrete = discretise(kSquare, spacingAround({0, 0}, minimum, 0.3), false);
        REQUIRE(discrete.ok());
        // The integral along a side from the origin: growth up to `minimum` / 0.3, then logarithmic.
        const double pieces = (1.0 + std::log(0.3 / minimum)) / 0.3;
        CHECK(std::fabs(static_cast<double>(piecesOf(*discrete, 0)) - pieces) < 1.5);
        CHECK(piecesOf(*discrete, 0) == piecesOf(*discrete, 3));
        double shortest = 1.0;
        for (const DiscreteSegment &s : discrete->segments) {
            shortest = std::min(shortest, distance(discrete->nodes[s.a], discrete->nodes[s.b]));
        }
        CHECK(shortest == doctest::Approx(minimum).epsilon(0.2));
    }
}

TEST_CASE("discretise: finds a dip of the spacing between the ends and the middle of a segment") {
    // Two dips on the lower side, none near its ends or its middle; nothing limits the growth.
    const SpacingFunction spacing(
        [](Vec2 p) {
            return 0.01 + 8.0 * std::min(distance(p, {0.27, 0}), distance(p, {0.81, 0}));
        },
        0.01, 9.0);
    const auto discrete = discretise(kSquare, spacing, false);
    REQUIRE(discrete.ok());
    double integral = 0.0;
    for (int i = 0; i < 100000; ++i) {
        integral += 1e-5 / spacing.at({(i + 0.5) * 1e-5, 0.0});
    }
    CHECK(integral > 2.0);
    CHECK(std::fabs(static_cast<double>(piecesOf(*discrete, 0)) - integral) < 1.0);
}

TEST_CASE("discretise: sides of a needle a few last digits apart get fewer nodes rather than cross") {
    int relaxed = 0;
    for (int round = 0; round < 200; ++round) {
        CAPTURE(round);
        RandomSource random(static_cast<std::uint64_t>(round));
        const Vec2 apex{1e6 * random.unit(), 1e6 * random.unit()};
        const Vec2 far = apex + Vec2{random.between(0.5, 2.0), random.between(0.5, 2.0)};
        Vec2 other = far;
        for (int step = random.integer(1, 4); step > 0; --step) {
            other.y = std::nextafter(other.y, 2e6);
        }
        const Domain needle = polygon({apex, far, other});
        const double rho = distance(apex, far) / random.integer(2, 200);
        const auto discrete = discretise(needle, constantSpacing(rho), false);
        REQUIRE(discrete.ok());
        REQUIRE(isSimple(*discrete));
        REQUIRE(discrete->regions.size() == 1);
        const auto expected = static_cast<std::size_t>(2.0 * distance(apex, far) / rho);
        relaxed += piecesOf(*discrete, 0) + piecesOf(*discrete, 2) < expected ? 1 : 0;
    }
    CHECK(relaxed > 20);
}

TEST_CASE("discretise: a constraint point next to a rounded node stays on its side") {
    int tried = 0, relaxed = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        RandomSource random(seed);
        const Vec2 corner{1e5 * random.unit(), 1e5 * random.unit()};
        const Domain triangle = polygon(
            {corner, corner + Vec2{1.0, random.between(0.1, 0.9)}, corner + Vec2{random.between(-0.5, 0.5), 1.0}});
        const auto plain = discretise(triangle, constantSpacing(0.05), false);
        REQUIRE(plain.ok());
        for (const DiscreteSegment &piece : plain->segments) {
            const Vec2 node = plain->nodes[piece.b];
            const Vec2 p{std::nextafter(node.x, corner.x + random.between(-1, 1)), node.y};
            Domain withPoint = triangle;
            withPoint.nodes.push_back(random.chance(0.5) ? node : p);
            withPoint.points.push_back({3, 1});
            if (hasErrors(validate(withPoint))) {
                continue; // it lies outside or at a corner
            }
            ++tried;
            const auto discrete = discretise(withPoint, constantSpacing(0.05), false);
            REQUIRE(discrete.ok());
            REQUIRE(isSimple(*discrete));
            relaxed += discrete->segments.size() < plain->segments.size() ? 1 : 0;
            Domain cut = withPoint;
            cut.nodes = discrete->nodes;
            cut.segments.clear();
            for (const DiscreteSegment &s : discrete->segments) {
                cut.segments.push_back({s.a, s.b});
            }
            REQUIRE_FALSE(hasErrors(validate(cut)));
        }
    }
    CHECK(tried > 100);
    CHECK(relaxed > 50);
}

TEST_CASE("discretise: accepts every domain that passes validation") {
    int passed = 0, refused = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        CAPTURE(seed);
        Domain domain = randomDomain(seed);
        RandomSource random(seed + 77);
        const auto nodes = static_cast<int>(domain.nodes.size());
        const auto anyNode = [&] { return static_cast<std::uint32_t>(random.integer(0, nodes - 1)); };
        const Box2 box = domain.bounds();
        const auto anywhere = [&] {
            return Vec2{random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y)};
        };
        if (random.chance(0.3)) {
            domain.segments.push_back(
                {anyNode(), anyNode(), 1, random.chance(0.5) ? SegmentRole::Constraint : SegmentRole::Boundary});
        }
        if (random.chance(0.2)) {
            domain.segments[static_cast<std::size_t>(random.integer(0, 2))].role = SegmentRole::Constraint;
        }
        if (random.chance(0.4)) {
            domain.insideRule = InsideRule::HoleMarkers;
            for (int i = random.integer(0, 3); i > 0; --i) {
                domain.holeMarkers.push_back(random.chance(0.8) ? anywhere() : domain.nodes[anyNode()]);
            }
        }
        if (random.chance(0.3)) {
            domain.points.push_back({anyNode(), 2});
        }
        if (random.chance(0.3)) {
            domain.nodes.push_back(random.chance(0.7) ? anywhere() : midpoint(box.min, domain.nodes[anyNode()]));
            domain.points.push_back({static_cast<std::uint32_t>(nodes), 3});
        }
        if (random.chance(0.1)) {
            domain.nodes[anyNode()] = anywhere();
        }
        const bool valid = !hasErrors(validate(domain));
        (valid ? passed : refused) += 1;
        for (const bool keep : {true, false}) {
            const auto discrete = discretise(domain, constantSpacing(0.02 * box.diagonal()), keep);
            if (valid) {
                REQUIRE(discrete.ok());
                REQUIRE(isSimple(*discrete));
                REQUIRE_FALSE(discrete->regions.empty());
                REQUIRE(discrete->area() > 0.0);
            }
        }
    }
    CHECK(passed > 800);
    CHECK(refused > 800);
}

TEST_CASE("discretise: refuses invalid domains") {
    Domain crossing = polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
    Domain outside = kSquare;
    outside.nodes.insert(outside.nodes.end(), {{2, 2}, {3, 2}});
    outside.segments.push_back({4, 5, 1, SegmentRole::Constraint});
    Domain badIndex = kSquare;
    badIndex.segments[0].a = 77;
    Domain notFinite = kSquare;
    notFinite.nodes[2].x = std::nan("");
    Domain lonely = kSquare;
    lonely.nodes.push_back({0.5, 0.5});
    Domain pointOutside = lonely;
    pointOutside.nodes[4] = {5, 5};
    pointOutside.points = {{4, 1}};
    for (const Domain &domain : {crossing, outside, badIndex, notFinite, lonely, pointOutside}) {
        for (const bool keep : {false, true}) {
            const auto refused = discretise(domain, constantSpacing(0.1), keep);
            REQUIRE_FALSE(refused.ok());
            CHECK(refused.faults()[0].code == "invalid-domain");
        }
    }
}

TEST_CASE("discretise: spacing that is not a positive number is reported with its place") {
    const double bad[] = {0.0, -1.0, std::nan("")};
    for (const double value : bad) {
        const SpacingFunction spacing([&](Vec2 p) { return p.x == 0.5 && p.y == 0.0 ? value : 0.4; }, 0.4, 0.4);
        const auto refused = discretise(kSquare, spacing, false);
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.faults()[0].code == "expression-value");
        REQUIRE(refused.faults()[0].at.has_value());
        CHECK(*refused.faults()[0].at == Vec2{0.5, 0.0});
    }
}

TEST_CASE("discretise: stops when cancelled while running") {
    std::stop_source source;
    const SpacingFunction spacing(
        [&](Vec2) {
            source.request_stop();
            return 1e-5;
        },
        1e-5, 1e-5);
    const auto stopped = discretise(kSquare, spacing, false, {nullptr, source.get_token()});
    REQUIRE_FALSE(stopped.ok());
    CHECK(stopped.faults()[0].code == "cancelled");
    const auto keptButStopped = discretise(kSquare, spacing, true, {nullptr, source.get_token()});
    REQUIRE_FALSE(keptButStopped.ok());
}
