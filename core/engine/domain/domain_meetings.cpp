#include "core/engine/domain/domain_meetings.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace forefront {

namespace {

using Touch = DomainMeetings::Touch;

bool touchLess(const Touch &s, const Touch &t) {
    return std::tie(s.edge, s.point) < std::tie(t.edge, t.point);
}
bool touchEqual(const Touch &s, const Touch &t) {
    return s.edge == t.edge && s.point == t.point;
}

class MeetingFinder {
  public:
    MeetingFinder(const DomainGraph &graph, const PlaneSweepResult &sweep) : graph_(graph), sweep_(sweep) {}

    DomainMeetings run(std::size_t limit) {
        if (sweep_.droppedCount > 0) {
            findDuplicates();
            findPairs(limit);
        }
        for (std::uint32_t point = 0; point < graph_.node.size(); ++point) { // markers may lie anywhere
            if (sweep_.on[point] != kNoIndex) {
                result_.touches.push_back({point, sweep_.on[point]});
            }
        }
        sortTouches();
        return std::move(result_);
    }

  private:
    std::array<std::uint32_t, 2> ends(std::uint32_t edge) const {
        return {sweep_.canonical[graph_.edges[edge].a], sweep_.canonical[graph_.edges[edge].b]};
    }

    void findDuplicates() {
        repeats_.assign(graph_.edges.size(), 0);
        std::vector<std::array<std::uint32_t, 3>> keys;
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            const auto [a, b] = ends(e);
            keys.push_back({std::min(a, b), std::max(a, b), e});
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t i = 1, first = 0; i < keys.size(); ++i) {
            if (keys[i][0] == keys[first][0] && keys[i][1] == keys[first][1]) {
                repeats_[keys[i][2]] = 1;
                result_.duplicates.push_back({keys[first][2], keys[i][2]});
            } else {
                first = i;
            }
        }
        std::sort(result_.duplicates.begin(), result_.duplicates.end(),
                  [](const auto &s, const auto &t) { return s.second < t.second; });
    }

    /// Finds meetings of dropped edges with other edges and with constraint points without segments. Ignores repeated
    /// edges.
    void findPairs(std::size_t limit) {
        std::vector<PlaneEdge> edges;
        std::vector<std::uint32_t> edgeOf, queries;
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            if (repeats_[e] == 0) {
                if (sweep_.dropped[e] != 0) {
                    queries.push_back(static_cast<std::uint32_t>(edges.size()));
                }
                edges.push_back(graph_.edges[e]);
                edgeOf.push_back(e);
            }
        }
        // If a duplicate stayed in the sweep instead of the first edge, that edge is queried needlessly, which is
        // harmless.
        std::vector<std::uint8_t> hasEdges(graph_.points.size(), 0);
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            hasEdges[ends(e)[0]] = hasEdges[ends(e)[1]] = 1;
        }
        for (std::uint32_t point = 0; point < graph_.node.size(); ++point) {
            if (hasEdges[sweep_.canonical[point]] == 0 && sweep_.canonical[point] == point) {
                edges.push_back({point, point});
            }
        }
        EdgeMeetings found = findMeetings(graph_.points, edges, queries, limit);
        result_.complete = found.complete;
        for (EdgeMeeting &meeting : found.list) {
            if (meeting.second >= edgeOf.size()) {
                result_.touches.push_back({edges[meeting.second].a, edgeOf[meeting.first]});
                continue;
            }
            meeting.first = edgeOf[meeting.first];
            meeting.second = edgeOf[meeting.second];
            switch (meeting.kind) {
            case SegmentMeeting::Crossing:
                result_.crossings.push_back(meeting);
                break;
            case SegmentMeeting::Touching:
                addTouch(meeting.first, meeting.second, result_.touches);
                addTouch(meeting.second, meeting.first, result_.touches);
                break;
            case SegmentMeeting::Overlapping:
                result_.overlaps.push_back(meeting);
                addTouch(meeting.first, meeting.second, covered_);
                addTouch(meeting.second, meeting.first, covered_);
                break;
            case SegmentMeeting::Apart:
            case SegmentMeeting::SharedEnd:
                break;
            }
        }
    }

    /// Adds the ends of one edge that lie in the interior of the other.
    void addTouch(std::uint32_t edge, std::uint32_t other, std::vector<Touch> &touches) const {
        const auto [a, b] = ends(other);
        for (const std::uint32_t point : ends(edge)) {
            if (point != a && point != b && onSegment(graph_.points[a], graph_.points[b], graph_.points[point])) {
                touches.push_back({point, other});
            }
        }
    }

    /// Keeps each touch once, and none that an overlap implies.
    void sortTouches() {
        std::sort(covered_.begin(), covered_.end(), touchLess);
        std::vector<Touch> &touches = result_.touches;
        std::sort(touches.begin(), touches.end(), touchLess);
        touches.erase(std::unique(touches.begin(), touches.end(), touchEqual), touches.end());
        std::erase_if(touches, [&](const Touch &touch) {
            return std::binary_search(covered_.begin(), covered_.end(), touch, touchLess);
        });
    }

    const DomainGraph &graph_;
    const PlaneSweepResult &sweep_;
    std::vector<std::uint8_t> repeats_; // per edge: a duplicate of an earlier one
    std::vector<Touch> covered_;
    DomainMeetings result_;
};

} // namespace

DomainMeetings findDomainMeetings(const DomainGraph &graph, const PlaneSweepResult &sweep, std::size_t limit) {
    return MeetingFinder(graph, sweep).run(limit);
}

} // namespace forefront
