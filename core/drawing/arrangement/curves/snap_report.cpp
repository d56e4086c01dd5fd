#include "core/drawing/arrangement/curves/snap_report.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/predicates.hpp"

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

/// Reports how lines were joined, except those set aside.
class JoiningReport {
  public:
    JoiningReport(const JoinedLines &joined, const std::vector<std::uint8_t> &aside, ChangeList &changes)
        : joined_(joined), snapped_(joined.snapped), aside_(aside), changes_(changes) {}

    void run() {
        noteMovedEnds();
        noteMeetings();
        noteUndivided();
        if (!aside_.empty()) {
            findOwners();
        }
        std::vector<std::uint8_t> seen(snapped_.nodes.size(), 0);
        for (std::uint32_t i = 0; i < joined_.lines.size(); ++i) {
            if (isAside(joined_.source[i])) {
                continue;
            }
            if (isFirstPart(joined_, i)) {
                noteVanished(i);
            }
            noteNodes(i, seen);
        }
    }

  private:
    bool isAside(std::uint32_t given) const { return !aside_.empty() && aside_[given] != 0; }

    /// Notes each place that moved once, in the order of the lines.
    void noteMovedEnds() {
        std::vector<MovedEnd> moved;
        for (std::uint32_t i = 0; i < joined_.lines.size(); ++i) {
            if (isAside(joined_.source[i])) {
                continue;
            }
            const SnapLine &line = joined_.lines[i];
            const Vec2 a = snapped_.nodes[snapped_.first[i]], b = snapped_.nodes[lastNode(snapped_, i)];
            if (line.a != a && isFirstPart(joined_, i)) {
                moved.push_back({line.a, i, distance(line.a, a)});
            }
            if (line.b != b && isLastPart(joined_, i)) {
                moved.push_back({line.b, i, distance(line.b, b)});
            }
        }
        std::sort(moved.begin(), moved.end(), [](const MovedEnd &s, const MovedEnd &t) {
            return std::tie(s.from.x, s.from.y, s.line) < std::tie(t.from.x, t.from.y, t.line);
        });
        const auto same = [](const MovedEnd &s, const MovedEnd &t) { return s.from == t.from; };
        moved.erase(std::unique(moved.begin(), moved.end(), same), moved.end());
        std::stable_sort(moved.begin(), moved.end(),
                         [](const MovedEnd &s, const MovedEnd &t) { return s.line < t.line; });
        for (const MovedEnd &end : moved) {
            changes_.add(ChangeKind::WeldedNodes, end.from, end.gap, end.line);
        }
    }

    /// Notes an input line of which nothing is left, at its first part.
    void noteVanished(std::uint32_t first) {
        std::uint32_t end = first;
        while (end < joined_.lines.size() && joined_.source[end] == joined_.source[first]) {
            ++end;
        }
        const SnapLine &line = joined_.lines[first];
        if (line.a != line.b && snapped_.starts[first] == snapped_.starts[end]) {
            changes_.add(ChangeKind::ShortPieces, line.a, 0.0, first);
        }
    }

    /// Notes where curves meet. A node near a curve counts if the curve leads through it now.
    void noteMeetings() {
        for (const ChordMeeting &meeting : joined_.meetings) {
            if (isAside(meeting.chord) || isAside(meeting.other)) {
                continue;
            }
            const auto [first, end] = std::equal_range(joined_.source.begin(), joined_.source.end(), meeting.chord);
            const auto line = static_cast<std::uint32_t>(first - joined_.source.begin());
            const auto endLine = static_cast<std::uint32_t>(end - joined_.source.begin());
            bool led = meeting.kind == ChangeKind::CrossingSegments || meeting.kind == ChangeKind::TouchingCurves;
            for (std::uint32_t part = line + 1; part < endLine && !led; ++part) {
                const std::uint32_t node = snapped_.first[part];
                led = node != snapped_.first[line] && node != lastNode(snapped_, endLine - 1) &&
                      distance(snapped_.nodes[node], meeting.at) <= 2.0 * snapped_.radius;
            }
            if (led) {
                changes_.add(meeting.kind, meeting.at, meeting.gap, line);
            }
        }
    }

    /// Notes lines with chords that a limit left undivided.
    void noteUndivided() {
        for (const ChordCut &cut : joined_.left) {
            if (!isAside(cut.chord)) {
                const auto line = std::lower_bound(joined_.source.begin(), joined_.source.end(), cut.chord);
                changes_.add(ChangeKind::UndividedCurves, cut.at, 0.0,
                             static_cast<std::uint32_t>(line - joined_.source.begin()));
            }
        }
    }

    /// Finds the nodes that are there even without the lines set aside: their own ends, and where two of them meet.
    void findOwners() {
        owned_.assign(snapped_.nodes.size(), 0);
        std::vector<std::uint32_t> through(snapped_.nodes.size(), kNoIndex); // the given line, if only one
        const auto pass = [&](std::uint32_t node, std::uint32_t given) {
            owned_[node] = owned_[node] != 0 || (through[node] != kNoIndex && through[node] != given) ? 1 : 0;
            through[node] = given;
        };
        for (std::uint32_t i = 0; i < joined_.lines.size(); ++i) {
            const std::uint32_t given = joined_.source[i];
            if (isAside(given)) {
                continue;
            }
            std::uint32_t node = snapped_.first[i];
            owned_[node] = isFirstPart(joined_, i) ? 1 : owned_[node];
            pass(node, given);
            for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
                const PlaneEdge &edge = snapped_.edges[snapped_.ways[k] / 2];
                node = edge.a == node ? edge.b : edge.a;
                pass(node, given);
            }
            owned_[node] = isLastPart(joined_, i) ? 1 : owned_[node];
        }
    }

    /// Notes crossings and other nodes along a line.
    void noteNodes(std::uint32_t i, std::vector<std::uint8_t> &seen) {
        const SnapLine &line = joined_.lines[i];
        const auto owned = [&](std::uint32_t node) { return owned_.empty() || owned_[node] != 0; };
        std::uint32_t node = snapped_.first[i];
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
            const PlaneEdge &edge = snapped_.edges[snapped_.ways[k] / 2];
            const Vec2 at = snapped_.nodes[node];
            if (k > snapped_.starts[i] && snapped_.crossing[node] == 0 && owned(node)) {
                const bool exact = onSegment(line.a, line.b, at);
                changes_.add(exact ? ChangeKind::TouchingSegments : ChangeKind::BentSegments, at,
                             exact ? 0.0 : distanceToSegment(line.a, line.b, at), i);
            }
            node = edge.a == node ? edge.b : edge.a;
            if (snapped_.crossing[node] != 0 && seen[node] == 0 && owned(node)) {
                seen[node] = 1;
                changes_.add(ChangeKind::CrossingSegments, snapped_.nodes[node], 0.0, i);
            }
        }
    }

    const JoinedLines &joined_;
    const SnappedLines &snapped_;
    const std::vector<std::uint8_t> &aside_;
    ChangeList &changes_;
    std::vector<std::uint8_t> owned_; ///< per node; empty: all
};

} // namespace

std::uint32_t lastNode(const SnappedLines &snapped, std::uint32_t line) {
    if (snapped.starts[line] == snapped.starts[line + 1]) {
        return snapped.first[line];
    }
    const std::uint32_t way = snapped.ways[snapped.starts[line + 1] - 1];
    return way % 2 == 0 ? snapped.edges[way / 2].b : snapped.edges[way / 2].a;
}

void noteJoining(const JoinedLines &joined, ChangeList &changes, const std::vector<std::uint8_t> &aside) {
    JoiningReport(joined, aside, changes).run();
}

} // namespace forefront
