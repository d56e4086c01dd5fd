#include "core/engine/spacing/parts/automatic/crowded_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

constexpr std::uint32_t kCrowded = 8; ///< lines that end at a node

/// A line that leaves a node, by its angle.
struct LineEnd {
    double angle;
    std::uint32_t position;
    bool atStart; ///< the line starts at the node
};

std::vector<std::uint32_t> linesAtNodes(const Domain &domain, std::span<const PlacedSegment> segments) {
    std::vector<std::uint32_t> counts(domain.nodes.size(), 0);
    for (const PlacedSegment &segment : segments) {
        if (segment.index < domain.segments.size()) {
            ++counts[domain.segments[segment.index].a];
            ++counts[domain.segments[segment.index].b];
        }
    }
    return counts;
}

} // namespace

CrowdedNodes::CrowdedNodes(const Domain &domain, std::span<const PlacedSegment> segments)
    : domain_(domain), segments_(segments) {
    const std::vector<std::uint32_t> counts = linesAtNodes(domain, segments);
    if (std::none_of(counts.begin(), counts.end(), [](std::uint32_t count) { return count >= kCrowded; })) {
        return;
    }
    std::vector<std::vector<LineEnd>> around(domain.nodes.size());
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const PlacedSegment &line = segments[i];
        if (line.index >= domain.segments.size()) {
            continue;
        }
        const DomainSegment &ends = domain.segments[line.index];
        const Vec2 along = line.b - line.a;
        if (counts[ends.a] >= kCrowded) {
            around[ends.a].push_back({std::atan2(along.y, along.x), i, true});
        }
        if (counts[ends.b] >= kCrowded) {
            around[ends.b].push_back({std::atan2(-along.y, -along.x), i, false});
        }
    }
    next_.assign(segments.size(), {{{kNoIndex, kNoIndex}, {kNoIndex, kNoIndex}}});
    for (std::vector<LineEnd> &spokes : around) {
        std::sort(spokes.begin(), spokes.end(), [](const LineEnd &a, const LineEnd &b) {
            return a.angle != b.angle ? a.angle < b.angle : a.position < b.position;
        });
        for (std::size_t k = 0; k < spokes.size(); ++k) {
            const std::uint32_t after = spokes[(k + 1) % spokes.size()].position;
            const std::uint32_t before = spokes[(k + spokes.size() - 1) % spokes.size()].position;
            // Seen along the line, the next counter-clockwise is on the left at its start, on the right at its end.
            next_[spokes[k].position][spokes[k].atStart ? 0 : 1] =
                spokes[k].atStart ? std::array{after, before} : std::array{before, after};
        }
    }
}

CrowdedNodes::Hidden CrowdedNodes::hiddenFrom(std::uint32_t position, Vec2 a, Vec2 b) const {
    Hidden hidden;
    if (next_.empty()) {
        return hidden;
    }
    const PlacedSegment &own = segments_[position];
    const DomainSegment &ends = domain_.segments[own.index];
    hidden.direction_ = own.b - own.a;
    for (const std::size_t end : {0U, 1U}) {
        Hidden::End &found = hidden.ends_[end];
        found.next = next_[position][end];
        const Vec2 node = end == 0 ? own.a : own.b;
        const double farthest = std::max(distance(node, a), distance(node, b));
        for (const std::size_t side : {0U, 1U}) {
            // From a place on the line to one on another line, the way crosses the next line no farther from the node.
            found.hides[side] = found.next[side] != kNoIndex && segments_[found.next[side]].length() >= farthest;
        }
        found.node = !found.hides[0] && !found.hides[1] ? kNoIndex : end == 0 ? ends.a : ends.b;
    }
    return hidden;
}

bool CrowdedNodes::Hidden::contains(std::uint32_t position, const PlacedSegment &line,
                                    const DomainSegment &ends) const {
    for (const End &end : ends_) {
        if (end.node == kNoIndex || (ends.a != end.node && ends.b != end.node) || position == end.next[0] ||
            position == end.next[1]) {
            continue;
        }
        const Vec2 away = ends.a == end.node ? line.b - line.a : line.a - line.b;
        const double turn = cross(direction_, away);
        if (turn != 0.0 && end.hides[turn > 0.0 ? 0 : 1]) {
            return true;
        }
    }
    return false;
}

} // namespace forefront
