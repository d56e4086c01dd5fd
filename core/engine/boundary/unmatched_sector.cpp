#include "core/engine/boundary/unmatched_sector.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace forefront {

namespace {

/// A segment seen from one of its ends.
struct SectorSide {
    std::uint32_t other = 0;           ///< node at the far end
    std::uint32_t left = 0, right = 0; ///< regions beside it, seen from this end
};

/// Returns true for directions in [0, 180) degrees; comparing coordinates is exact.
bool pointsUp(Vec2 centre, Vec2 p) {
    return p.y > centre.y || (p.y == centre.y && p.x > centre.x);
}

bool isBefore(Vec2 centre, Vec2 p, Vec2 q) {
    const bool up = pointsUp(centre, p);
    return up != pointsUp(centre, q) ? up : orientation(centre, p, q) > 0;
}

} // namespace

std::optional<std::uint32_t> unmatchedSector(const DiscreteDomain &boundary) {
    std::vector<std::uint32_t> first(boundary.nodes.size() + 1, 0);
    for (const DiscreteSegment &s : boundary.segments) {
        ++first[s.a + 1];
        ++first[s.b + 1];
    }
    std::inclusive_scan(first.begin(), first.end(), first.begin());
    std::vector<SectorSide> sides(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (const DiscreteSegment &s : boundary.segments) {
        sides[next[s.a]++] = {s.b, s.leftRegion, s.rightRegion};
        sides[next[s.b]++] = {s.a, s.rightRegion, s.leftRegion};
    }
    for (std::uint32_t node = 0; node < boundary.nodes.size(); ++node) {
        const std::span<SectorSide> around = std::span(sides).subspan(first[node], first[node + 1] - first[node]);
        const Vec2 centre = boundary.nodes[node];
        std::ranges::sort(around, [&](const SectorSide &p, const SectorSide &q) {
            return isBefore(centre, boundary.nodes[p.other], boundary.nodes[q.other]);
        });
        for (std::size_t k = 0; k < around.size(); ++k) {
            if (around[k].left != around[(k + 1) % around.size()].right) {
                return node;
            }
        }
    }
    return std::nullopt;
}

} // namespace forefront
