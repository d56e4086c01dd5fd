#include "core/drawing/arrangement/repeated_lines/near_lines.hpp"

#include "core/drawing/arrangement/repeated_lines/outline_search.hpp"

#include <algorithm>
#include <vector>

namespace forefront {

NearLines findNearLines(const Domain &domain, std::span<const std::uint8_t> isLine) {
    constexpr double kNear = 1.0 / 64.0; // the gap beside a shorter segment needs few elements
    std::vector<PlaneEdge> edges;
    std::vector<BesideEdge> about;
    for (std::size_t s = 0; s < domain.segments.size(); ++s) {
        const DomainSegment &segment = domain.segments[s];
        edges.push_back({segment.a, segment.b});
        const BesideRole role = isLine[s] != 0                          ? BesideRole::Line
                                : segment.role == SegmentRole::Boundary ? BesideRole::Outline
                                                                        : BesideRole::Dropped;
        about.push_back({role, 0.0, true, segment.stretch});
    }
    const EdgeShapes shapes(domain.nodes, edges, about, domain.curves);
    const OutlineSearch outlines(shapes, about);
    NearLines near;
    for (std::uint32_t s = 0; s < edges.size(); ++s) {
        if (about[s].role != BesideRole::Line) {
            continue;
        }
        const Vec2 middle = shapes.at(s, 0.5);
        const double limit = kNear * distance(shapes.a(s), shapes.b(s));
        const auto place = outlines.placeNear(middle, limit);
        if (place && distance(middle, *place) <= limit) {
            if (near.count++ == 0) {
                near.nearest = limit;
                near.first = middle;
                near.segment = s;
            }
            near.nearest = std::min(near.nearest, distance(middle, *place));
        }
    }
    return near;
}

} // namespace forefront
