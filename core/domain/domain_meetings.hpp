#pragma once

#include "core/domain/domain_graph.hpp"
#include "core/geometry/edge_meetings.hpp"

#include <vector>

namespace forefront {

/// All that keeps the segments of a domain from being simple; edges and points are those of the graph.
struct DomainMeetings {
    struct Duplicate {
        std::uint32_t first = 0;  ///< the edge of least index between these ends
        std::uint32_t second = 0; ///< one that repeats it
    };
    struct Touch {
        std::uint32_t point = 0; ///< canonical; lies in the interior of the edge
        std::uint32_t edge = 0;
    };
    std::vector<Duplicate> duplicates;
    std::vector<EdgeMeeting> crossings;
    std::vector<EdgeMeeting> overlaps;
    std::vector<Touch> touches; ///< also of constraint points
    bool complete = true;       ///< false: more than `most`, the search was given up

    bool empty() const { return duplicates.empty() && crossings.empty() && overlaps.empty() && touches.empty(); }
};

DomainMeetings findDomainMeetings(const DomainGraph &graph, const PlaneSweepResult &sweep, std::size_t most);

} // namespace forefront
