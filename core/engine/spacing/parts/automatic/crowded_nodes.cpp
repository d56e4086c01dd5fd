#include "core/engine/spacing/parts/automatic/crowded_nodes.hpp"

#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

constexpr std::uint32_t kCrowded = 8; ///< lines that end at a node

/// A line that leaves a node, by its angle.
struct LineEnd {
    double angle = 0.0;
    std::uint32_t position = 0;
    bool atStart = false; ///< the line starts at the node
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

/// Enters the neighbours of the lines around a node, by angle.
void linkNeighbours(std::span<LineEnd> lines, std::vector<std::array<std::array<std::uint32_t, 2>, 2>> &next) {
    std::sort(lines.begin(), lines.end(), [](const LineEnd &a, const LineEnd &b) {
        return a.angle != b.angle ? a.angle < b.angle : a.position < b.position;
    });
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::uint32_t after = lines[(k + 1) % lines.size()].position;
        const std::uint32_t before = lines[(k + lines.size() - 1) % lines.size()].position;
        // Seen along the line, the next counter-clockwise is on the left at its start, on the right at its end.
        next[lines[k].position][lines[k].atStart ? 0 : 1] =
            lines[k].atStart ? std::array{after, before} : std::array{before, after};
    }
}

} // namespace

CrowdedNodes::CrowdedNodes(const Domain &domain, std::span<const PlacedSegment> segments)
    : domain_(domain), segments_(segments) {
    const std::vector<std::uint32_t> counts = linesAtNodes(domain, segments);
    if (std::none_of(counts.begin(), counts.end(), [](std::uint32_t count) { return count >= kCrowded; })) {
        return;
    }
    Rows<LineEnd> around(domain.nodes.size(), [&](const auto &add) {
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const PlacedSegment &line = segments[i];
            if (line.index >= domain.segments.size()) {
                continue;
            }
            const DomainSegment &ends = domain.segments[line.index];
            const Vec2 along = line.b - line.a;
            if (counts[ends.a] >= kCrowded) {
                add(ends.a, LineEnd{std::atan2(along.y, along.x), i, true});
            }
            if (counts[ends.b] >= kCrowded) {
                add(ends.b, LineEnd{std::atan2(-along.y, -along.x), i, false});
            }
        }
    });
    next_.assign(segments.size(), {{{kNoIndex, kNoIndex}, {kNoIndex, kNoIndex}}});
    for (std::size_t node = 0; node < around.size(); ++node) {
        linkNeighbours(around[node], next_);
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
