#include "core/drawing/domain/neighbour_sides.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace forefront {
namespace {

/// A segment of a loop, by its ends.
struct LoopSegment {
    std::uint32_t low = 0, high = 0; ///< nodes
    std::uint32_t segment = 0;
    std::uint32_t loop = 0;
    bool areaToLeft = false; ///< of the way from `low` to `high`

    bool hasSameEnds(const LoopSegment &other) const { return low == other.low && high == other.high; }
    friend bool operator<(const LoopSegment &a, const LoopSegment &b) {
        return std::tuple(a.low, a.high, a.segment) < std::tuple(b.low, b.high, b.segment);
    }
};

/// Returns twice the signed area within the chords of a loop.
double twiceArea(const Domain &domain, const DrawnLoop &loop) {
    const Vec2 origin = domain.nodes[domain.segments[loop.first].a]; // far from 0, products would lose digits
    double sum = 0.0;
    for (std::uint32_t s = loop.first; s < loop.end; ++s) {
        sum += cross(domain.nodes[domain.segments[s].a] - origin, domain.nodes[domain.segments[s].b] - origin);
    }
    return sum;
}

/// Returns for each node whether several loops have it.
std::vector<bool> sharedNodes(const Domain &domain, std::span<const DrawnLoop> loops) {
    std::vector<std::uint32_t> loopOf(domain.nodes.size(), 0); // number of the first loop, from 1
    std::vector<bool> shared(domain.nodes.size(), false);
    for (std::uint32_t k = 0; k < loops.size(); ++k) {
        for (std::uint32_t s = loops[k].first; s < loops[k].end; ++s) {
            std::uint32_t &loop = loopOf[domain.segments[s].a];
            shared[domain.segments[s].a] = shared[domain.segments[s].a] || (loop != 0 && loop != k + 1);
            loop = loop == 0 ? k + 1 : loop;
        }
    }
    return shared;
}

} // namespace

std::vector<NeighbourSide> neighbourSides(const Domain &domain, std::span<const DrawnLoop> loops) {
    const std::vector<bool> shared = sharedNodes(domain, loops);
    std::vector<LoopSegment> found;
    for (std::uint32_t k = 0; k < loops.size(); ++k) {
        const bool counterClockwise = twiceArea(domain, loops[k]) > 0.0;
        for (std::uint32_t s = loops[k].first; s < loops[k].end; ++s) {
            const auto [low, high] = std::minmax(domain.segments[s].a, domain.segments[s].b);
            if (shared[low] && shared[high] && !domain.segments[s].stretch.follows()) {
                found.push_back({low, high, s, k, counterClockwise == (domain.segments[s].a == low)});
            }
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<NeighbourSide> sides;
    for (std::size_t k = 0, next = 0; k < found.size(); k = next) {
        next = k + 1;
        while (next < found.size() && found[next].hasSameEnds(found[k])) {
            ++next;
        }
        const bool beside =
            next == k + 2 && found[k].loop != found[k + 1].loop && found[k].areaToLeft != found[k + 1].areaToLeft;
        if (beside) {
            sides.push_back({found[k].segment, found[k + 1].segment});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const NeighbourSide &a, const NeighbourSide &b) { return a.dropped < b.dropped; });
    return sides;
}

} // namespace forefront
