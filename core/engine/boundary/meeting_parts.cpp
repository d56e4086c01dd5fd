#include "core/engine/boundary/meeting_parts.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/boundary/misplaced_nodes.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/edge_meetings.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

class PartMeetingFinder {
  public:
    explicit PartMeetingFinder(const Division &division) : division_(division), discrete_(division.discrete) {}

    MeetingParts run(const std::stop_token &stop) {
        std::vector<PlaneEdge> edges;
        edges.reserve(discrete_.segments.size());
        for (const DiscreteSegment &piece : discrete_.segments) {
            edges.push_back({piece.a, piece.b});
        }
        const PlaneSweepResult sweep = sweepPlane(discrete_.nodes, edges, stop);
        if (stop.stop_requested()) {
            return {};
        }
        if (sweep.order.size() != discrete_.nodes.size() || sweep.droppedCount != 0) {
            addMeetings(edges, sweep);
        } else {
            addMisplaced(sweep);
        }
        std::sort(result_.segments.begin(), result_.segments.end());
        result_.segments.erase(std::unique(result_.segments.begin(), result_.segments.end()), result_.segments.end());
        return std::move(result_);
    }

  private:
    bool isCurved(std::uint32_t piece) const {
        return !division_.pieces.empty() && division_.pieces[piece].chain != kNoIndex;
    }

    void addPart(std::uint32_t piece) {
        if (isCurved(piece)) {
            result_.pieces.push_back(division_.pieces[piece]);
        } else {
            result_.segments.push_back(discrete_.segments[piece].source);
        }
    }

    /// Adds the pieces that meet; where a curved piece meets a straight one, only the curved one.
    void addMeetings(std::span<const PlaneEdge> edges, const PlaneSweepResult &sweep) {
        std::vector<std::uint32_t> dropped;
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            const bool moved = sweep.canonical[edges[e].a] != edges[e].a || sweep.canonical[edges[e].b] != edges[e].b;
            if (sweep.dropped[e] != 0 || moved) {
                dropped.push_back(e);
            }
        }
        std::vector<std::uint8_t> meetsCurve(edges.size(), 0);
        for (const EdgeMeeting &meeting : findMeetings(discrete_.nodes, edges, dropped, 1'000'000).list) {
            const bool curved = isCurved(meeting.first) || isCurved(meeting.second);
            for (const std::uint32_t e : {meeting.first, meeting.second}) {
                meetsCurve[e] = curved ? 1 : meetsCurve[e];
                if (!curved || isCurved(e)) {
                    addPart(e);
                }
            }
        }
        for (const std::uint32_t e : dropped) {
            if (meetsCurve[e] == 0) {
                addPart(e);
            }
        }
    }

    /// Called when no pieces meet: adds the pieces that may have pushed constraint points or entire loops to another
    /// region.
    void addMisplaced(const PlaneSweepResult &sweep) {
        std::vector<std::uint32_t> misplaced = misplacedNodes(discrete_, sweep);
        addStraightAround(misplaced, sweep);
        for (std::size_t i = 0; i < discrete_.points.size(); ++i) {
            const std::uint32_t node = discrete_.points[i].node, on = sweep.on[node], below = sweep.below[node];
            if (on != kNoIndex) {
                addPart(on);
            } else if (regionAbove(discrete_, below) != division_.pointRegion[i]) {
                misplaced.push_back(node);
                // Either the segment below it as given has been pushed above it, or the one below it now under it.
                if (const std::uint32_t given = division_.pointBelow[i];
                    given != kNoIndex &&
                    (division_.curves == nullptr || division_.curves->chainOf(given) == kNoIndex)) {
                    result_.segments.push_back(given);
                }
                if (below != kNoIndex) {
                    addPart(below);
                }
            }
        }
        if (division_.curves != nullptr && !misplaced.empty()) {
            addCurvesAround(misplaced);
        }
    }

    /// Adds the straight pieces at some nodes and directly below them: rounding has turned one past another, which ends
    /// beside it.
    void addStraightAround(const std::vector<std::uint32_t> &nodes, const PlaneSweepResult &sweep) {
        if (nodes.empty()) {
            return;
        }
        std::vector<std::uint8_t> marked(discrete_.nodes.size(), 0);
        for (const std::uint32_t node : nodes) {
            marked[node] = 1;
            if (const std::uint32_t below = sweep.below[node]; below != kNoIndex && !isCurved(below)) {
                addPart(below);
            }
        }
        for (std::uint32_t e = 0; e < discrete_.segments.size(); ++e) {
            const DiscreteSegment &piece = discrete_.segments[e];
            if ((marked[piece.a] != 0 || marked[piece.b] != 0) && !isCurved(e)) {
                addPart(e);
            }
        }
    }

    /// Adds the curved pieces that may have a node between them and their curve; adds all curved pieces if some node
    /// has none.
    void addCurvesAround(const std::vector<std::uint32_t> &nodes) {
        std::vector<std::uint32_t> curved;
        std::vector<Box2> boxes;
        for (std::uint32_t e = 0; e < discrete_.segments.size(); ++e) {
            if (isCurved(e)) {
                const CurveStretch &stretch = discrete_.stretches[e];
                curved.push_back(e);
                boxes.push_back(discrete_.curves[stretch.curve].bounds(stretch.t0, stretch.t1));
                boxes.back().add(
                    boxOf(discrete_.nodes[discrete_.segments[e].a], discrete_.nodes[discrete_.segments[e].b]));
            }
        }
        const BoxTree tree(boxes);
        bool all = true; // found at all nodes
        for (const std::uint32_t node : nodes) {
            bool found = false;
            tree.query(boxAround(discrete_.nodes[node], 0.0), [&](std::uint32_t item) {
                addPart(curved[item]);
                found = true;
            });
            all = all && found;
        }
        for (std::size_t k = 0; k < curved.size() && !all; ++k) {
            addPart(curved[k]);
        }
    }

    const Division &division_;
    const DiscreteDomain &discrete_;
    MeetingParts result_;
};

} // namespace

MeetingParts findMeetingParts(const Division &division, const std::stop_token &stop) {
    return PartMeetingFinder(division).run(stop);
}

} // namespace forefront
