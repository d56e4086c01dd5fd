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

/// Returns true if this is the first (or last) part of a given line.
bool isFirstPart(const JoinedLines &joined, std::uint32_t line) {
    return line == 0 || joined.source[line - 1] != joined.source[line];
}
bool isLastPart(const JoinedLines &joined, std::uint32_t line) {
    return line + 1 == joined.source.size() || joined.source[line + 1] != joined.source[line];
}

/// Notes each place that moved once, in the order of the lines.
void noteMovedEnds(const JoinedLines &joined, ChangeList &changes) {
    const SnappedLines &snapped = joined.snapped;
    std::vector<MovedEnd> moved;
    for (std::uint32_t i = 0; i < joined.lines.size(); ++i) {
        const SnapLine &line = joined.lines[i];
        const Vec2 a = snapped.nodes[snapped.first[i]], b = snapped.nodes[lastNode(snapped, i)];
        if (line.a != a && isFirstPart(joined, i)) {
            moved.push_back({line.a, i, distance(line.a, a)});
        }
        if (line.b != b && isLastPart(joined, i)) {
            moved.push_back({line.b, i, distance(line.b, b)});
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

/// Notes an input line of which nothing is left, at its first part.
void noteVanished(const JoinedLines &joined, std::uint32_t first, ChangeList &changes) {
    std::uint32_t end = first;
    while (end < joined.lines.size() && joined.source[end] == joined.source[first]) {
        ++end;
    }
    const SnapLine &line = joined.lines[first];
    if (line.a != line.b && joined.snapped.starts[first] == joined.snapped.starts[end]) {
        changes.add(ChangeKind::ShortPieces, line.a, 0.0, first);
    }
}

/// Notes where curves meet. A node near a curve counts if the curve leads through it now.
void noteMeetings(const JoinedLines &joined, ChangeList &changes) {
    const SnappedLines &snapped = joined.snapped;
    for (const ChordMeeting &meeting : joined.meetings) {
        const auto [first, end] = std::equal_range(joined.source.begin(), joined.source.end(), meeting.chord);
        const auto line = static_cast<std::uint32_t>(first - joined.source.begin());
        const auto endLine = static_cast<std::uint32_t>(end - joined.source.begin());
        bool led = meeting.kind == ChangeKind::CrossingSegments || meeting.kind == ChangeKind::TouchingCurves;
        for (std::uint32_t part = line + 1; part < endLine && !led; ++part) {
            const std::uint32_t node = snapped.first[part];
            led = node != snapped.first[line] && node != lastNode(snapped, endLine - 1) &&
                  distance(snapped.nodes[node], meeting.at) <= 2.0 * snapped.radius;
        }
        if (led) {
            changes.add(meeting.kind, meeting.at, meeting.gap, line);
        }
    }
}

/// Notes lines with chords that a limit left undivided.
void noteUndivided(const JoinedLines &joined, ChangeList &changes) {
    for (const ChordCut &cut : joined.left) {
        const auto line = std::lower_bound(joined.source.begin(), joined.source.end(), cut.chord);
        changes.add(ChangeKind::UndividedCurves, cut.at, 0.0, static_cast<std::uint32_t>(line - joined.source.begin()));
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

void noteJoining(const JoinedLines &joined, ChangeList &changes) {
    const SnappedLines &snapped = joined.snapped;
    noteMovedEnds(joined, changes);
    noteMeetings(joined, changes);
    noteUndivided(joined, changes);
    std::vector<std::uint8_t> seen(snapped.nodes.size(), 0);
    for (std::uint32_t i = 0; i < joined.lines.size(); ++i) {
        const SnapLine &line = joined.lines[i];
        if (isFirstPart(joined, i)) {
            noteVanished(joined, i, changes);
        }
        std::uint32_t node = snapped.first[i];
        for (std::uint32_t k = snapped.starts[i]; k < snapped.starts[i + 1]; ++k) {
            const PlaneEdge &edge = snapped.edges[snapped.ways[k] / 2];
            const Vec2 at = snapped.nodes[node];
            if (k > snapped.starts[i] && snapped.crossing[node] == 0) {
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
