#include "core/engine/domain/domain_meetings.hpp"
#include "tests/support/domain_builder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

using namespace forefront;
using forefront::testing::RandomSource;

namespace {

DomainMeetings meetingsOf(const Domain &domain, std::size_t limit = 1000) {
    const DomainGraph graph = graphOf(domain);
    return findDomainMeetings(graph, sweepPlane(graph.points, graph.edges), limit);
}

Domain linesOf(const std::vector<std::array<Vec2, 2>> &lines) {
    Domain domain;
    for (const auto &[a, b] : lines) {
        const auto first = static_cast<std::uint32_t>(domain.nodes.size());
        domain.nodes.push_back(a);
        domain.nodes.push_back(b);
        domain.segments.push_back({first, first + 1, 1, SegmentRole::Constraint});
    }
    return domain;
}

} // namespace

TEST_CASE("DomainMeetings: segments that only share ends do not meet") {
    Domain domain = linesOf({{{{0, 0}, {1, 0}}}, {{{1, 0}, {1, 1}}}, {{{1, 1}, {0, 0}}}});
    const DomainMeetings meetings = meetingsOf(domain);
    CHECK(meetings.empty());
    CHECK(meetings.complete);
}

TEST_CASE("DomainMeetings: a crossing is listed once, with its edges in order") {
    const DomainMeetings meetings = meetingsOf(linesOf({{{{0, 0}, {2, 2}}}, {{{0, 2}, {2, 0}}}}));
    REQUIRE(meetings.crossings.size() == 1);
    CHECK(meetings.crossings[0].first == 0);
    CHECK(meetings.crossings[0].second == 1);
    CHECK(meetings.touches.empty());
    CHECK(meetings.overlaps.empty());
    CHECK(meetings.duplicates.empty());
}

TEST_CASE("DomainMeetings: repeated edges refer to the first, in either direction") {
    const std::array<Vec2, 2> there{{{0, 0}, {1, 0}}}, back{{{1, 0}, {0, 0}}};
    const DomainMeetings meetings = meetingsOf(linesOf({there, back, there}));
    REQUIRE(meetings.duplicates.size() == 2);
    CHECK(meetings.duplicates[0].first == 0);
    CHECK(meetings.duplicates[0].second == 1);
    CHECK(meetings.duplicates[1].first == 0);
    CHECK(meetings.duplicates[1].second == 2);
    CHECK(meetings.overlaps.empty()); // the repetition already covers it
}

TEST_CASE("DomainMeetings: ends and constraint points on a segment are touches") {
    Domain domain = linesOf({{{{0, 0}, {4, 0}}}, {{{1, 0}, {1, 1}}}});
    domain.nodes.push_back({3, 0});
    domain.points.push_back({4, 1});
    const DomainGraph graph = graphOf(domain);
    const DomainMeetings meetings = meetingsOf(domain);
    std::set<std::pair<std::uint32_t, std::uint32_t>> touches;
    for (const DomainMeetings::Touch &touch : meetings.touches) {
        touches.emplace(graph.node[touch.point], graph.segment[touch.edge]);
    }
    CHECK(touches == std::set<std::pair<std::uint32_t, std::uint32_t>>{{2, 0}, {4, 0}});
    CHECK(meetings.touches.size() == 2);
    CHECK(meetings.crossings.empty());
}

TEST_CASE("DomainMeetings: an overlap does not repeat its ends as touches") {
    const DomainMeetings meetings = meetingsOf(linesOf({{{{0, 0}, {3, 0}}}, {{{1, 0}, {4, 0}}}}));
    REQUIRE(meetings.overlaps.size() == 1);
    CHECK(meetings.touches.empty());
    CHECK(meetings.crossings.empty());
}

TEST_CASE("DomainMeetings: markers on a segment do not count") {
    Domain domain = linesOf({{{{0, 0}, {4, 0}}}});
    domain.holeMarkers.push_back({1, 0});
    domain.regionMarkers.push_back({{2, 0}, 1});
    CHECK(meetingsOf(domain).empty());
}

TEST_CASE("DomainMeetings: reports when the search stops at its limit") {
    std::vector<std::array<Vec2, 2>> lines;
    for (int i = 1; i <= 10; ++i) {
        lines.push_back({{{0, static_cast<double>(i)}, {11, static_cast<double>(i)}}});
        lines.push_back({{{static_cast<double>(i), 0}, {static_cast<double>(i), 11}}});
    }
    CHECK(meetingsOf(linesOf(lines)).crossings.size() == 100);
    const DomainMeetings few = meetingsOf(linesOf(lines), 7);
    CHECK_FALSE(few.complete);
    CHECK(few.crossings.size() == 7);
}

TEST_CASE("DomainMeetings: random segments agree with testing every pair") {
    RandomSource random(3);
    for (int round = 0; round < 60; ++round) {
        std::vector<std::array<Vec2, 2>> lines;
        const bool onGrid = round % 2 == 0; // then touches and overlaps abound
        const auto place = [&] {
            return onGrid ? Vec2{static_cast<double>(random.integer(0, 5)), static_cast<double>(random.integer(0, 5))}
                          : Vec2{random.unit(), random.unit()};
        };
        while (lines.size() < 25) {
            const Vec2 a = place(), b = place();
            const auto same = [&](const auto &line) {
                return (line[0] == a && line[1] == b) || (line[0] == b && line[1] == a);
            };
            if (a != b && std::none_of(lines.begin(), lines.end(), same)) {
                lines.push_back({a, b});
            }
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> crossings, overlaps;
        bool touching = false;
        for (std::uint32_t e = 0; e < lines.size(); ++e) {
            for (std::uint32_t f = e + 1; f < lines.size(); ++f) {
                const SegmentMeeting kind = meet(lines[e][0], lines[e][1], lines[f][0], lines[f][1]);
                touching = touching || kind == SegmentMeeting::Touching;
                if (kind == SegmentMeeting::Crossing) {
                    crossings.emplace(e, f);
                } else if (kind == SegmentMeeting::Overlapping) {
                    overlaps.emplace(e, f);
                }
            }
        }
        const DomainMeetings found = meetingsOf(linesOf(lines));
        const auto pairs = [](const std::vector<EdgeMeeting> &list) {
            std::set<std::pair<std::uint32_t, std::uint32_t>> result;
            for (const EdgeMeeting &meeting : list) {
                result.emplace(meeting.first, meeting.second);
            }
            return result;
        };
        CHECK(pairs(found.crossings) == crossings);
        CHECK(pairs(found.overlaps) == overlaps);
        CHECK((found.touches.empty() || touching || !overlaps.empty()));
        CHECK((!touching || !found.touches.empty() || !overlaps.empty()));
    }
}
