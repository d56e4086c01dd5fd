#include "core/engine/geometry/edge_meetings.hpp"
#include "core/engine/geometry/plane_sweep.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace forefront;

namespace {

bool improper(SegmentMeeting kind) {
    return kind != SegmentMeeting::Apart && kind != SegmentMeeting::SharedEnd;
}

struct SweepPicture {
    std::vector<Vec2> points;
    std::vector<PlaneEdge> edges;

    SegmentMeeting meeting(std::size_t e, std::size_t f) const {
        return meet(points[edges[e].a], points[edges[e].b], points[edges[f].a], points[edges[f].b]);
    }
};

/// Random edges, many of them degenerate on the coarse lattices.
SweepPicture randomPicture(std::mt19937_64 &random, int size, int edgeCount) {
    std::uniform_int_distribution<int> coordinate(0, size), choice(0, 3 * edgeCount);
    SweepPicture picture;
    for (int i = 0; i <= 3 * edgeCount; ++i) {
        picture.points.push_back({1.0 * coordinate(random), 1.0 * coordinate(random)});
    }
    for (int i = 0; i < edgeCount; ++i) {
        picture.edges.push_back(
            {static_cast<std::uint32_t>(choice(random)), static_cast<std::uint32_t>(choice(random))});
    }
    return picture;
}

std::vector<std::uint32_t> droppedEdges(const PlaneSweepResult &sweep) {
    std::vector<std::uint32_t> dropped;
    for (std::uint32_t e = 0; e < sweep.dropped.size(); ++e) {
        if (sweep.dropped[e] != 0) {
            dropped.push_back(e);
        }
    }
    return dropped;
}

bool before(Vec2 a, Vec2 b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Returns the edge with its lower end first, as in the sweep.
std::pair<Vec2, Vec2> ends(const SweepPicture &picture, std::size_t edge) {
    const Vec2 a = picture.points[picture.edges[edge].a], b = picture.points[picture.edges[edge].b];
    return before(a, b) ? std::pair{a, b} : std::pair{b, a};
}

bool spans(Vec2 low, Vec2 high, Vec2 p) {
    return before(low, p) && before(p, high);
}

/// Returns the point of an edge at the abscissa x; the upper end of a vertical edge.
double heightAt(Vec2 low, Vec2 high, double x) {
    return low.x == high.x ? high.y : low.y + (high.y - low.y) * (x - low.x) / (high.x - low.x);
}

} // namespace

TEST_CASE("PlaneSweep: remaining edges never meet, and no edge is dropped needlessly") {
    std::mt19937_64 random(5);
    int simple = 0, faulty = 0;
    for (int round = 0; round < 3000; ++round) {
        const int edgeCount = 1 + round % 12, size = 2 + (round / 12) % 40;
        const SweepPicture picture = randomPicture(random, size, edgeCount);
        const PlaneSweepResult sweep = sweepPlane(picture.points, picture.edges);
        bool anyMeeting = false;
        for (std::size_t e = 0; e < picture.edges.size(); ++e) {
            const bool empty = picture.points[picture.edges[e].a] == picture.points[picture.edges[e].b];
            REQUIRE((!empty || sweep.dropped[e] == 1));
            anyMeeting |= empty;
            for (std::size_t f = 0; f < e; ++f) {
                const bool meets = improper(picture.meeting(e, f));
                anyMeeting |= meets;
                REQUIRE_FALSE((meets && sweep.dropped[e] == 0 && sweep.dropped[f] == 0));
            }
        }
        REQUIRE(anyMeeting == (sweep.droppedCount > 0));
        REQUIRE(sweep.droppedCount == droppedEdges(sweep).size());
        (anyMeeting ? faulty : simple) += 1;
    }
    CHECK(simple > 300);
    CHECK(faulty > 300);
}

TEST_CASE("PlaneSweep: finds the edge directly below each point, and the edge that an isolated point lies on") {
    std::mt19937_64 random(6);
    int found = 0, on = 0;
    for (int round = 0; round < 2000; ++round) {
        SweepPicture picture = randomPicture(random, 3 + round % 20, 1 + round % 9);
        PlaneSweepResult sweep = sweepPlane(picture.points, picture.edges);
        for (std::size_t e = picture.edges.size(); e-- > 0;) {
            if (sweep.dropped[e] != 0) {
                picture.edges.erase(picture.edges.begin() + static_cast<std::ptrdiff_t>(e));
            }
        }
        sweep = sweepPlane(picture.points, picture.edges);
        REQUIRE(sweep.droppedCount == 0);
        for (const std::uint32_t p : sweep.order) {
            const Vec2 at = picture.points[p];
            bool hasEdges = false;
            std::uint32_t lies = kNoIndex;
            double highest = -1.0;
            for (std::uint32_t e = 0; e < picture.edges.size(); ++e) {
                const auto [low, high] = ends(picture, e);
                hasEdges |= low == at || high == at;
                if (low == at || high == at) {
                    continue;
                }
                lies = onSegment(low, high, at) ? e : lies;
                if (spans(low, high, at) && orientation(low, high, at) > 0) {
                    highest = std::max(highest, heightAt(low, high, at.x));
                }
            }
            if (!hasEdges && lies != kNoIndex) {
                REQUIRE(sweep.on[p] == lies);
                ++on;
                continue;
            }
            REQUIRE(sweep.on[p] == kNoIndex);
            REQUIRE((sweep.below[p] == kNoIndex) == (highest < 0.0));
            if (sweep.below[p] != kNoIndex) {
                const auto [low, high] = ends(picture, sweep.below[p]);
                REQUIRE(spans(low, high, at));
                REQUIRE(orientation(low, high, at) > 0);
                REQUIRE(heightAt(low, high, at.x) == highest);
                ++found;
            }
        }
    }
    CHECK(found > 1000);
    CHECK(on > 100);
}

TEST_CASE("EdgeMeetings: the pairs with a dropped edge are all pairs that meet") {
    std::mt19937_64 random(7);
    for (int round = 0; round < 1000; ++round) {
        const SweepPicture picture = randomPicture(random, 2 + round % 30, 1 + round % 40);
        const PlaneSweepResult sweep = sweepPlane(picture.points, picture.edges);
        const EdgeMeetings meetings =
            findMeetings(picture.points, picture.edges, droppedEdges(sweep), picture.edges.size() * 100);
        REQUIRE(meetings.complete);
        std::size_t next = 0;
        for (std::uint32_t e = 0; e < picture.edges.size(); ++e) {
            for (std::uint32_t f = e + 1; f < picture.edges.size(); ++f) {
                if (improper(picture.meeting(e, f))) {
                    REQUIRE(next < meetings.list.size());
                    REQUIRE(meetings.list[next].first == e);
                    REQUIRE(meetings.list[next].second == f);
                    REQUIRE(meetings.list[next].kind == picture.meeting(e, f));
                    ++next;
                }
            }
        }
        REQUIRE(next == meetings.list.size());
    }
}

TEST_CASE("PlaneSweep: many long edges side by side do not take quadratic work") {
    // 100,000 edges that all overlap in x and in y: a comb of slanted parallels.
    SweepPicture picture;
    const std::uint32_t count = 100000;
    for (std::uint32_t i = 0; i < count; ++i) {
        picture.points.push_back({0.001 * i, 0.0});
        picture.points.push_back({200.0 + 0.001 * i, 150.0});
        picture.edges.push_back({2 * i, 2 * i + 1});
    }
    CHECK(sweepPlane(picture.points, picture.edges).droppedCount == 0);
    picture.points.push_back({-1.0, 100.0}); // one that crosses them all
    picture.points.push_back({400.0, 100.0});
    picture.edges.push_back({2 * count, 2 * count + 1});
    const PlaneSweepResult sweep = sweepPlane(picture.points, picture.edges);
    CHECK(sweep.droppedCount == 1);
    CHECK(sweep.dropped[count] == 1);
    const EdgeMeetings some = findMeetings(picture.points, picture.edges, droppedEdges(sweep), 200);
    CHECK(some.list.size() == 200);
    CHECK_FALSE(some.complete);
    CHECK(findMeetings(picture.points, picture.edges, droppedEdges(sweep), 2 * count).list.size() == count);
}

TEST_CASE("PlaneSweep: a fan of edges and many overlapping edges do not take quadratic work") {
    SweepPicture fan;
    fan.points = {{0.0, 0.0}, {300.0, 0.5}};
    const std::uint32_t count = 50000;
    for (std::uint32_t i = 0; i < count; ++i) { // all from one node and all into another one
        fan.points.push_back({100.0, 1.0 * i});
        fan.edges.push_back({0, i + 2});
        fan.edges.push_back({i + 2, 1});
    }
    CHECK(sweepPlane(fan.points, fan.edges).droppedCount == 0);
    SweepPicture heap;
    for (std::uint32_t i = 0; i < count; ++i) { // on one line, each over the next thousand
        heap.points.push_back({1.0 * i, 2.0 * i});
        heap.points.push_back({1.0 * i + 1000.5, 2.0 * i + 2001.0});
        heap.edges.push_back({2 * i, 2 * i + 1});
    }
    const PlaneSweepResult sweep = sweepPlane(heap.points, heap.edges);
    CHECK(sweep.droppedCount > count / 2);
    const EdgeMeetings meetings = findMeetings(heap.points, heap.edges, droppedEdges(sweep), 100000);
    CHECK(meetings.list.size() == 100000);
    CHECK_FALSE(meetings.complete);
}
