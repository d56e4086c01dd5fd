#pragma once

#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/geometry/edge_meetings.hpp"

#include <vector>

namespace forefront {

/// All crossings, contacts and overlaps that keep the segments of a domain from being simple. Edges and points are
/// indices into the graph.
struct DomainMeetings {
    struct Duplicate {
        std::uint32_t first = 0;  ///< the first edge between these ends
        std::uint32_t second = 0; ///< an edge that repeats it
    };
    struct Touch {
        std::uint32_t point = 0; ///< canonical; lies in the interior of the edge
        std::uint32_t edge = 0;
    };
    std::vector<Duplicate> duplicates;
    std::vector<EdgeMeeting> crossings;
    std::vector<EdgeMeeting> overlaps;
    std::vector<Touch> touches; ///< of nodes and constraint points; without those implied by an overlap
    bool complete = true;       ///< false if the search stopped at its limit

    bool empty() const { return duplicates.empty() && crossings.empty() && overlaps.empty() && touches.empty(); }
};

/// Finds all meetings, but at most `limit` crossings and overlaps. `sweep` is the sweep of the graph.
DomainMeetings findDomainMeetings(const DomainGraph &graph, const PlaneSweepResult &sweep, std::size_t limit);

} // namespace forefront
