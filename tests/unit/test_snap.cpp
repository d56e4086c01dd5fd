#include "core/drawing/arrangement/snapping/cluster.hpp"
#include "core/drawing/arrangement/snapping/snap_lines.hpp"
#include "core/engine/geometry/edge_meetings.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

using EdgeSet = std::set<std::array<double, 4>>;

EdgeSet edgeSet(const SnappedLines &snapped) {
    EdgeSet set;
    for (const PlaneEdge &edge : snapped.edges) {
        const Vec2 a = snapped.nodes[edge.a], b = snapped.nodes[edge.b];
        const bool forth = comesBefore(a, b);
        const Vec2 p = forth ? a : b, q = forth ? b : a;
        set.insert({p.x, p.y, q.x, q.y});
    }
    return set;
}

std::vector<SnapLine> linesOf(const SnappedLines &snapped) {
    std::vector<SnapLine> lines;
    for (const PlaneEdge &edge : snapped.edges) {
        lines.push_back({snapped.nodes[edge.a], snapped.nodes[edge.b]});
    }
    return lines;
}

/// Edges meet only at common ends; each way leads from near one end of its line to near the other.
void checkSound(const std::vector<SnapLine> &lines, const SnappedLines &snapped) {
    const PlaneSweepResult sweep = sweepPlane(snapped.nodes, snapped.edges);
    CHECK(sweep.droppedCount == 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::uint32_t node = snapped.first[i];
        REQUIRE(distance(snapped.nodes[node], lines[i].a) <= snapped.radius);
        for (std::uint32_t k = snapped.starts[i]; k < snapped.starts[i + 1]; ++k) {
            const PlaneEdge &edge = snapped.edges[snapped.ways[k] / 2];
            const bool back = snapped.ways[k] % 2 != 0;
            REQUIRE((back ? edge.b : edge.a) == node);
            node = back ? edge.a : edge.b;
            REQUIRE(distanceToSegment(lines[i].a, lines[i].b, snapped.nodes[node]) <= snapped.displacement + 1e-15);
        }
        REQUIRE(distance(snapped.nodes[node], lines[i].b) <= snapped.radius);
    }
}

/// Lines of many kinds: long, short, collinear, nearly coincident, through common points, needles.
std::vector<SnapLine> randomLines(RandomSource &random, double radius) {
    std::vector<SnapLine> lines;
    const auto point = [&] { return Vec2{random.between(0.0, 1.0), random.between(0.0, 1.0)}; };
    const auto step = [&](double size) { return Vec2{random.between(-size, size), random.between(-size, size)}; };
    const int count = random.integer(2, 40);
    for (int i = 0; i < count; ++i) {
        const SnapLine *earlier =
            lines.empty() ? nullptr
                          : &lines[static_cast<std::size_t>(random.integer(0, static_cast<int>(lines.size()) - 1))];
        switch (earlier == nullptr ? 0 : random.integer(0, 8)) {
        case 0:
        case 1:
            lines.push_back({point(), point()});
            break;
        case 2: { // a short one
            const Vec2 p = point();
            lines.push_back({p, p + step(10.0 * radius)});
            break;
        }
        case 3: // on the same line, in part
            lines.push_back({lerp(earlier->a, earlier->b, random.between(-0.5, 1.5)),
                             lerp(earlier->a, earlier->b, random.between(-0.5, 1.5))});
            break;
        case 4: // the same back again
            lines.push_back({earlier->b, earlier->a});
            break;
        case 5: // nearly the same
            lines.push_back({earlier->a + step(2.0 * radius), earlier->b + step(2.0 * radius)});
            break;
        case 6: // ends on it
            lines.push_back({lerp(earlier->a, earlier->b, random.unit()), point()});
            break;
        case 7: // a needle
            lines.push_back({earlier->a, earlier->b + step(3.0 * radius)});
            break;
        default: // goes on from it
            lines.push_back({earlier->b, point()});
            break;
        }
    }
    return lines;
}

} // namespace

TEST_CASE("clusterPlaces: leaders keep their distance, and every place is near its leader") {
    RandomSource random(5);
    for (int run = 0; run < 50; ++run) {
        std::vector<Vec2> places;
        const int count = random.integer(1, 300);
        const int columns = random.chance(0.5) ? 1000000 : 20; // with many equal coordinates, too
        std::set<std::pair<double, double>> seen;
        for (int i = 0; i < count; ++i) {
            const Vec2 p{random.integer(0, columns) / static_cast<double>(columns),
                         random.integer(0, columns) / static_cast<double>(columns)};
            if (seen.insert({p.x, p.y}).second) {
                places.push_back(p);
            }
        }
        std::vector<std::uint8_t> preferred(places.size(), 0);
        for (std::uint8_t &flag : preferred) {
            flag = random.chance(0.2) ? 1 : 0;
        }
        const double radius = random.between(0.001, 0.2);
        const auto leader = clusterPlaces(places, preferred, radius);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double own = distance(places[i], places[leader[i]]);
            REQUIRE(own <= radius);
            REQUIRE(leader[leader[i]] == leader[i]);
            for (std::size_t j = 0; j < places.size(); ++j) {
                if (leader[j] == j && j != i) {
                    REQUIRE(distance(places[i], places[j]) >= (leader[i] == i ? radius : own));
                }
            }
        }
    }
}

TEST_CASE("snapLines: a crossing, a touch and an overlap become nodes") {
    const std::vector<SnapLine> lines{{{0, 0}, {4, 0}}, {{1, -1}, {1, 1}}, {{2, 0}, {2, 1}}, {{3, 0}, {6, 0}}};
    const SnappedLines snapped = snapLines(lines, 1e-9);
    CHECK(edgeSet(snapped) == EdgeSet{{0, 0, 1, 0},
                                      {1, 0, 2, 0},
                                      {2, 0, 3, 0},
                                      {3, 0, 4, 0},
                                      {4, 0, 6, 0},
                                      {1, -1, 1, 0},
                                      {1, 0, 1, 1},
                                      {2, 0, 2, 1}});
    CHECK(snapped.displacement == 0.0);
    CHECK(snapped.starts == std::vector<std::uint32_t>{0, 4, 6, 7, 9});
}

TEST_CASE("snapLines: lines far apart stay unchanged, bit for bit") {
    const std::vector<SnapLine> lines{{{0.1, 0.2}, {0.3, 0.7}}, {{0.1, 0.2}, {0.9, 0.1}}, {{0.5, 0.5}, {0.5, 0.5}}};
    const SnappedLines snapped = snapLines(lines, 0.01);
    CHECK(snapped.nodes == std::vector<Vec2>{{0.1, 0.2}, {0.3, 0.7}, {0.9, 0.1}, {0.5, 0.5}});
    CHECK(snapped.edges.size() == 2);
    CHECK(snapped.starts == std::vector<std::uint32_t>{0, 1, 2, 2});
}

TEST_CASE("snapLines: a gap narrower than the radius is closed, and a wider one stays") {
    const auto gapOf = [](double gap) {
        // Two squares side by side, the right one with a node halfway up.
        const std::vector<Vec2> left{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        const std::vector<Vec2> right{{1 + gap, 0}, {2, 0}, {2, 1}, {1 + gap, 1}, {1 + gap, 0.5}};
        std::vector<SnapLine> lines;
        for (const auto &ring : {left, right}) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                lines.push_back({ring[k], ring[(k + 1) % ring.size()]});
            }
        }
        return snapLines(lines, 0.01);
    };
    CHECK(gapOf(0.009).edges.size() == 8);
    CHECK(gapOf(0.009).displacement == doctest::Approx(0.009));
    CHECK(gapOf(0.011).edges.size() == 9);
    CHECK(gapOf(0.011).displacement == 0.0);
}

TEST_CASE("snapLines: random lines keep clear of each other in any order, and a second pass changes nothing") {
    const char *wanted = std::getenv("FOREFRONT_ARRANGEMENTS"); // 2,000 outside of quick runs
    const int runs = wanted != nullptr ? std::atoi(wanted) : 200;
    for (int run = 0; run < runs; ++run) {
        CAPTURE(run);
        RandomSource random(static_cast<std::uint64_t>(run));
        constexpr std::array kTolerances{1e-12, 1e-6, 1e-4, 1e-3, 1e-2, 5e-2};
        const double tolerance = kTolerances[static_cast<std::size_t>(run) % kTolerances.size()];
        std::vector<SnapLine> lines = randomLines(random, tolerance);
        const SnappedLines snapped = snapLines(lines, tolerance);
        checkSound(lines, snapped);
        CHECK(snapped.displacement <= tolerance * (1.0 + 1e-9));

        const SnappedLines twice = snapLines(linesOf(snapped), snapped.radius);
        CHECK(edgeSet(twice) == edgeSet(snapped));
        CHECK(twice.displacement == 0.0);

        for (std::size_t i = lines.size(); i > 1; --i) {
            std::swap(lines[i - 1], lines[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
            if (random.chance(0.5)) {
                std::swap(lines[i - 1].a, lines[i - 1].b);
            }
        }
        CHECK(edgeSet(snapLines(lines, tolerance)) == edgeSet(snapped));
    }
}

TEST_CASE("snapLines: does not join again once no line needs a new pin") {
    // The first line ends up farther away than the radius, also when it is pinned there; half the radius is needed.
    const std::vector<SnapLine> lines{
        {{0.316, 0.765}, {0.816, 0.085}}, {{0.847, 0.040}, {0.225, 0.458}}, {{0.316, 0.765}, {0.937, 0.015}}};
    const SnappedLines snapped = snapLines(lines, 0.05);
    checkSound(lines, snapped);
    CHECK(snapped.radius == 0.025);
    CHECK(snapped.passes == 3);
}

TEST_CASE("snapLines: soon halves the radius where lines are too crowded for pins to help") {
    constexpr double kTolerance = 0.01;
    RandomSource random(3);
    std::vector<SnapLine> lines; // nearly parallel, a fifth of the tolerance apart
    for (int i = 0; i < 400; ++i) {
        const double y = 0.2 * kTolerance * i;
        lines.push_back(
            {{random.between(0.0, 0.1), y}, {random.between(0.9, 1.0), y + random.between(0.0, 3.0 * kTolerance)}});
    }
    const SnappedLines snapped = snapLines(lines, kTolerance);
    checkSound(lines, snapped);
    CHECK(snapped.radius < kTolerance);
    CHECK(snapped.displacement <= kTolerance * (1.0 + 1e-9));
    CHECK(snapped.passes <= 6);
    const SnappedLines again = snapLines(lines, kTolerance, snapped, {});
    CHECK(edgeSet(again) == edgeSet(snapped));
    CHECK(again.passes < snapped.passes);
}

TEST_CASE("snapLines: fewer passes are needed where pins are known, whatever the order and direction of the lines") {
    constexpr double kTolerance = 0.02;
    RandomSource random(11);
    const auto place = [&] { return Vec2{random.between(0.0, 1.0), random.between(0.0, 1.0)}; };
    int pinned = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<SnapLine> lines;
        for (int i = 0; i < 12; ++i) {
            lines.push_back({place(), place()});
        }
        const SnappedLines snapped = snapLines(lines, kTolerance);
        std::reverse(lines.begin(), lines.end());
        for (SnapLine &line : lines) {
            std::swap(line.a, line.b);
        }
        const SnappedLines again = snapLines(lines, kTolerance, snapped, {});
        CHECK(edgeSet(again) == edgeSet(snapped));
        if (!snapped.pins.empty()) {
            ++pinned;
            CHECK(again.passes == 1);
            CHECK(snapped.passes > 1);
        }
    }
    CHECK(pinned > 20);
}
