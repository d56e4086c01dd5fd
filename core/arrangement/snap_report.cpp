#include "core/arrangement/snap_report.hpp"

#include "core/geometry/polygon.hpp"
#include "core/geometry/predicates.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace forefront {

namespace {

/// An end of a line that became a node elsewhere.
struct MovedEnd {
    Vec2 from;
    std::uint32_t line = 0;
    double gap = 0.0;
};

/// Notes each place that moved once, in the order of the lines.
void noteMovedEnds(std::span<const SnapLine> lines, const SnappedLines &snapped, ChangeList &changes) {
    std::vector<MovedEnd> moved;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        const Vec2 a = snapped.nodes[snapped.first[i]], b = snapped.nodes[lastNode(snapped, i)];
        if (lines[i].a != a) {
            moved.push_back({lines[i].a, i, distance(lines[i].a, a)});
        }
        if (lines[i].b != b) {
            moved.push_back({lines[i].b, i, distance(lines[i].b, b)});
        }
    }
    std::sort(moved.begin(), moved.end(), [](const MovedEnd &s, const MovedEnd &t) {
        return std::tie(s.from.x, s.from.y, s.line) < std::tie(t.from.x, t.from.y, t.line);
    });
    moved.erase(
        std::unique(moved.begin(), moved.end(), [](const MovedEnd &s, const MovedEnd &t) { return s.from == t.from; }),
        moved.end());
    std::stable_sort(moved.begin(), moved.end(), [](const MovedEnd &s, const MovedEnd &t) { return s.line < t.line; });
    for (const MovedEnd &end : moved) {
        changes.add(ChangeKind::WeldedNodes, end.from, end.gap, end.line);
    }
}

} // namespace

std::uint32_t lastNode(const SnappedLines &snapped, std::uint32_t line) {
    if (snapped.starts[line] == snapped.starts[line + 1]) {
        return snapped.first[line];
    }
    const std::uint32_t way = snapped.ways[snapped.starts[line + 1] - 1];
    return way % 2 == 0 ? snapped.edges[way / 2].b : snapped.edges[way / 2].a;
}

void noteSnapping(std::span<const SnapLine> lines, const SnappedLines &snapped, ChangeList &changes) {
    noteMovedEnds(lines, snapped, changes);
    std::vector<std::uint8_t> seen(snapped.nodes.size(), 0);
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        const SnapLine &line = lines[i];
        const std::uint32_t first = snapped.starts[i], last = snapped.starts[i + 1];
        if (line.a != line.b && first == last) {
            changes.add(ChangeKind::ShortPieces, line.a, 0.0, i);
        }
        std::uint32_t node = snapped.first[i];
        for (std::uint32_t k = first; k < last; ++k) {
            const PlaneEdge &edge = snapped.edges[snapped.ways[k] / 2];
            const Vec2 at = snapped.nodes[node];
            if (k > first && snapped.crossing[node] == 0) {
                const bool exact = onSegment(line.a, line.b, at);
                changes.add(exact ? ChangeKind::TouchingSegments : ChangeKind::BentSegments, at,
                            exact ? 0.0 : distanceToSegment(line.a, line.b, at), i);
            }
            node = edge.a == node ? edge.b : edge.a;
            if (snapped.crossing[node] != 0 && seen[node] == 0) {
                seen[node] = 1;
                changes.add(ChangeKind::CrossingSegments, snapped.nodes[node], 0.0, i);
            }
        }
    }
}

} // namespace forefront
