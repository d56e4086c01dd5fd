#include "core/engine/boundary/changed_boundary.hpp"

#include "core/engine/boundary/misplaced_nodes.hpp"
#include "core/engine/geometry/plane_sweep.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

void sumAreas(DiscreteDomain &boundary) {
    std::vector<Vec2> origin(boundary.regions.size());
    std::vector<std::uint8_t> known(boundary.regions.size(), 0);
    std::vector<CompensatedSum> twice(boundary.regions.size());
    const auto add = [&](std::uint32_t region, Vec2 a, Vec2 b) {
        if (region == kOutside) {
            return;
        }
        if (known[region] == 0) {
            known[region] = 1;
            origin[region] = a;
        }
        twice[region].add(cross(a - origin[region], b - a)); // smaller products than with the other ends
    };
    for (const DiscreteSegment &piece : boundary.segments) {
        add(piece.leftRegion, boundary.nodes[piece.a], boundary.nodes[piece.b]);
        add(piece.rightRegion, boundary.nodes[piece.b], boundary.nodes[piece.a]);
    }
    for (std::size_t region = 0; region < twice.size(); ++region) {
        boundary.regions[region].area = 0.5 * twice[region].value();
    }
}

bool isProper(const DiscreteDomain &boundary) {
    std::vector<PlaneEdge> edges;
    edges.reserve(boundary.segments.size());
    for (const DiscreteSegment &s : boundary.segments) {
        edges.push_back({s.a, s.b});
    }
    const PlaneSweepResult sweep = sweepPlane(boundary.nodes, edges);
    return sweep.droppedCount == 0 && misplacedNodes(boundary, sweep).empty();
}

} // namespace forefront
