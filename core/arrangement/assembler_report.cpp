#include "core/arrangement/assembler.hpp"
#include "core/arrangement/face_points.hpp"
#include "core/base/ids.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/predicates.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

void Assembler::note(ChangeKind kind, Vec2 at, double displacement, std::uint32_t piece) {
    auto change = std::find_if(result_.changes.begin(), result_.changes.end(),
                               [&](const ArrangementChange &known) { return known.kind == kind; });
    if (change == result_.changes.end()) {
        result_.changes.push_back({kind, 0, 0.0, {}, piece, {}});
        change = result_.changes.end() - 1;
    }
    ++change->count;
    change->displacement = kind == ChangeKind::OverlapsDecided ? change->displacement + displacement
                                                               : std::max(change->displacement, displacement);
    if (change->places.size() < ArrangementChange::kPlaces) {
        change->places.push_back(at);
    }
}

void Assembler::report() {
    reportNodes();
    for (std::uint32_t i = 0; i < input_.pieces.size(); ++i) {
        reportPiece(i);
    }
    reportOverlaps();
    std::sort(result_.changes.begin(), result_.changes.end(),
              [](const ArrangementChange &s, const ArrangementChange &t) { return s.kind < t.kind; });
}

/// Each place that moved, once, and each node made where pieces cross.
void Assembler::reportNodes() {
    std::vector<std::pair<Vec2, std::uint32_t>> moved;
    std::vector<std::uint8_t> seen(snapped_.nodes.size(), 0);
    for (std::uint32_t i = 0; i < input_.pieces.size(); ++i) {
        const Vec2 to = snapped_.nodes[snapped_.first[i]];
        if (input_.pieces[i].a != to) {
            moved.emplace_back(input_.pieces[i].a, i);
        }
        std::uint32_t node = snapped_.first[i];
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
            const PlaneEdge &edge = snapped_.edges[snapped_.ways[k] / 2];
            node = edge.a == node ? edge.b : edge.a;
            if (snapped_.crossing[node] != 0 && seen[node] == 0) {
                seen[node] = 1;
                note(ChangeKind::CrossingSegments, snapped_.nodes[node], 0.0, i);
            }
        }
        if (input_.pieces[i].b != snapped_.nodes[node]) {
            moved.emplace_back(input_.pieces[i].b, i);
        }
    }
    const auto less = [](const auto &s, const auto &t) {
        return s.first.x != t.first.x   ? s.first.x < t.first.x
               : s.first.y != t.first.y ? s.first.y < t.first.y
                                        : s.second < t.second;
    };
    std::sort(moved.begin(), moved.end(), less);
    moved.erase(
        std::unique(moved.begin(), moved.end(), [](const auto &s, const auto &t) { return s.first == t.first; }),
        moved.end());
    std::sort(moved.begin(), moved.end(), [](const auto &s, const auto &t) {
        return s.second != t.second ? s.second < t.second : s.first.x < t.first.x;
    });
    for (const auto &[from, piece] : moved) {
        const Vec2 to = snapped_.nodes[snapped_.first[piece]];
        const bool isFirst = input_.pieces[piece].a == from;
        const std::uint32_t last = snapped_.starts[piece + 1];
        double gap = distance(from, to);
        if (!isFirst && last > snapped_.starts[piece]) {
            const std::uint32_t way = snapped_.ways[last - 1];
            const PlaneEdge &edge = snapped_.edges[way / 2];
            gap = distance(from, snapped_.nodes[way % 2 == 0 ? edge.b : edge.a]);
        }
        note(ChangeKind::WeldedNodes, from, gap, piece);
    }
}

/// Records how the way of a piece differs from the piece.
void Assembler::reportPiece(std::uint32_t piece) {
    const ArrangementPiece &about = input_.pieces[piece];
    if (about.a != about.b && snapped_.starts[piece] == snapped_.starts[piece + 1]) {
        note(ChangeKind::ShortPieces, about.a, 0.0, piece);
    }
    std::uint32_t node = snapped_.first[piece];
    for (std::uint32_t k = snapped_.starts[piece]; k < snapped_.starts[piece + 1]; ++k) {
        const std::uint32_t edge = snapped_.ways[k] / 2;
        const PlaneEdge &ends = snapped_.edges[edge];
        const Vec2 middle = midpoint(snapped_.nodes[ends.a], snapped_.nodes[ends.b]);
        if (k > snapped_.starts[piece] && snapped_.crossing[node] == 0) {
            const Vec2 at = snapped_.nodes[node];
            const bool exact = onSegment(about.a, about.b, at);
            note(exact ? ChangeKind::TouchingSegments : ChangeKind::BentSegments, at,
                 exact ? 0.0 : distanceToSegment(about.a, about.b, at), piece);
        }
        node = ends.a == node ? ends.b : ends.a;
        if (kept(edge) || added_[edge] != 0) {
            continue;
        }
        added_[edge] = 1; // each edge counts once
        switch (fate_[edge]) {
        case Fate::Folded:
            note(ChangeKind::FoldedOutlines, middle, 0.0, piece);
            break;
        case Fate::Inner:
            note(ChangeKind::InnerOutlines, middle, 0.0, piece);
            break;
        case Fate::Outside:
            note(ChangeKind::OutsideLines, middle, 0.0, piece);
            break;
        case Fate::Boundary:
        case Fate::Constraint:
            break;
        }
    }
}

/// Returns true if several features cover the face and do not lie one inside the other.
bool Assembler::overlap(std::uint32_t face) const {
    const auto rival = [&](std::uint32_t k) { return cover_.rivals.begin() + cover_.rivalStarts[face + k]; };
    std::vector<std::uint32_t> features(rival(0), rival(1));
    std::sort(features.begin(), features.end(),
              [&](std::uint32_t f, std::uint32_t g) { return cover_.holders[f].size() > cover_.holders[g].size(); });
    return std::adjacent_find(features.begin(), features.end(),
                              [&](std::uint32_t f, std::uint32_t g) { return !cover_.nested(f, g); }) != features.end();
}

void Assembler::reportOverlaps() {
    std::vector<std::uint32_t> edgeOf(faces_.count, kNoIndex);
    for (std::uint32_t e = 0; e < snapped_.edges.size(); ++e) {
        for (const std::uint32_t face : {faces_.left[e], faces_.right[e]}) {
            edgeOf[face] = std::min(edgeOf[face], e);
        }
    }
    bool any = false;
    for (std::uint32_t face = 1; face < faces_.count; ++face) {
        if (!overlap(face)) {
            continue;
        }
        const PlaneEdge &edge = snapped_.edges[edgeOf[face]];
        note(ChangeKind::OverlapsDecided, midpoint(snapped_.nodes[edge.a], snapped_.nodes[edge.b]), cover_.area[face],
             0);
        if (!any) {
            any = true;
            const std::uint32_t first = cover_.rivalStarts[face];
            const std::string &f = input_.features[cover_.rivals[first]].name;
            const std::string &g = input_.features[cover_.rivals[first + 1]].name;
            result_.changes.back().between = f.empty() || g.empty() ? "" : f + " and " + g;
        }
    }
}

} // namespace forefront
