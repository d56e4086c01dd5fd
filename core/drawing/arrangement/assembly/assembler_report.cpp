#include "core/drawing/arrangement/assembly/assembler.hpp"
#include "core/drawing/arrangement/assembly/face_points.hpp"
#include "core/drawing/arrangement/curves/snap_report.hpp"
#include "core/engine/base/ids.hpp"

#include <algorithm>

namespace forefront {

void Assembler::report() {
    noteJoining(joined_, changes_, asidePieces());
    changes_.renumberPieces(joined_.source);
    std::uint32_t line = 0;
    for (std::uint32_t piece = 0; piece < input_.pieces.size(); ++piece) {
        if (line == lineCount() || joined_.source[line] != piece) {
            reportHidden(piece);
        }
        for (; line < lineCount() && joined_.source[line] == piece; ++line) {
            reportLine(line);
        }
    }
    reportOverlaps();
    reportVanished();
    result_.changes = changes_.take();
}

/// Returns, per piece, whether it is of the outline of a clip or of a synthetic contour; empty if there are none.
std::vector<std::uint8_t> Assembler::asidePieces() const {
    const bool made = std::any_of(input_.contours.begin(), input_.contours.end(),
                                  [](const ArrangementContour &contour) { return contour.synthetic; });
    std::vector<std::uint8_t> aside(input_.clips.empty() && !made ? 0 : input_.pieces.size(), 0);
    for (std::size_t k = 0; k < aside.size(); ++k) {
        aside[k] = input_.ofClip(input_.pieces[k]) || input_.isSynthetic(input_.pieces[k]) ? 1 : 0;
    }
    return aside;
}

/// Records that a piece of a hidden shape, which has not been joined with others, is not in the domain.
void Assembler::reportHidden(std::uint32_t piece) {
    const ArrangementPiece &hidden = input_.pieces[piece];
    if (!input_.isSynthetic(hidden)) {
        changes_.add(ChangeKind::InnerOutlines, midpoint(hidden.a, hidden.b), 0.0, piece);
    }
}

/// Records the edges along a line that are not in the domain.
void Assembler::reportLine(std::uint32_t line) {
    const std::uint32_t piece = joined_.source[line];
    if (input_.isSynthetic(input_.pieces[piece])) {
        return;
    }
    for (std::uint32_t k = snapped_.starts[line]; k < snapped_.starts[line + 1]; ++k) {
        const std::uint32_t edge = snapped_.ways[k] / 2;
        const PlaneEdge &ends = snapped_.edges[edge];
        const Vec2 middle = midpoint(snapped_.nodes[ends.a], snapped_.nodes[ends.b]);
        if (fate_[edge] == Fate::Shared) {
            fate_[edge] = Fate::Constraint; // each edge counts once
            changes_.add(ChangeKind::SharedBoundaries, middle, 0.0, piece);
        }
        if (kept(edge) || added_[edge] != 0) {
            continue;
        }
        added_[edge] = 1; // each edge counts once
        switch (fate_[edge]) {
        case Fate::Folded:
            changes_.add(ChangeKind::FoldedOutlines, middle, 0.0, piece);
            break;
        case Fate::Inner:
            changes_.add(ChangeKind::InnerOutlines, middle, 0.0, piece);
            break;
        case Fate::Outside:
            changes_.add(ChangeKind::OutsideLines, middle, 0.0, piece);
            break;
        case Fate::Clipped:
            changes_.add(ChangeKind::ClippedSegments, middle, 0.0, piece);
            break;
        case Fate::Repeated:
            changes_.add(ChangeKind::RepeatedOutlines, middle, repeated_.at(edge), piece);
            break;
        case Fate::Boundary:
        case Fate::Constraint:
        case Fate::Shared:
        case Fate::OfClip:
            break;
        }
    }
}

/// Returns true if several features cover the face and none of them lies inside another.
bool Assembler::overlap(std::uint32_t face) const {
    const auto rival = [&](std::uint32_t k) { return cover_.rivals.begin() + cover_.rivalStarts[face + k]; };
    std::vector<std::uint32_t> features(rival(0), rival(1));
    std::sort(features.begin(), features.end(),
              [&](std::uint32_t f, std::uint32_t g) { return cover_.holders[f].size() > cover_.holders[g].size(); });
    return std::adjacent_find(features.begin(), features.end(),
                              [&](std::uint32_t f, std::uint32_t g) { return !cover_.nested(f, g); }) != features.end();
}

/// Notes the faces that several features cover, the largest first, each with a point inside it.
void Assembler::reportOverlaps() {
    if (input_.layered) {
        return;
    }
    std::vector<std::uint32_t> found;
    for (std::uint32_t face = 1; face < faces_.count; ++face) {
        if (overlap(face)) {
            found.push_back(face);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [&](std::uint32_t f, std::uint32_t g) { return cover_.area[f] > cover_.area[g]; });
    for (std::size_t k = 0; k < found.size(); ++k) {
        const bool shown = k < ArrangementChange::kPlaces;
        changes_.add(ChangeKind::OverlapsDecided, shown ? placeInside(found[k]) : Vec2{}, cover_.area[found[k]],
                     k == 0 ? joined_.source[firstLineAround(found[k])] : 0);
    }
    if (!found.empty()) {
        const std::uint32_t first = cover_.rivalStarts[found.front()];
        const std::string &f = input_.features[cover_.rivals[first]].name;
        const std::string &g = input_.features[cover_.rivals[first + 1]].name;
        changes_.find(ChangeKind::OverlapsDecided)->names = f.empty() || g.empty() ? "" : f + " and " + g;
    }
}

/// Notes the features that own no face or, if there is only one feature, the shapes that have no edge left.
void Assembler::reportVanished() {
    constexpr std::size_t kNames = 3;
    const bool single = input_.features.size() < 2;
    std::vector<std::uint8_t> left(single ? input_.shapes.size() : input_.features.size(), 0);
    const auto unit = [&](const ArrangementPiece &piece) {
        const std::uint32_t shape = input_.contours[piece.contour].shape;
        return single ? shape : input_.shapes[shape].feature;
    };
    const auto ofShape = [&](const ArrangementPiece &piece) {
        return piece.role == PieceRole::Outline && !input_.ofClip(piece);
    };
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1] && single; ++k) {
            if (ofShape(pieceOf(i)) && kept(snapped_.ways[k] / 2)) {
                left[unit(pieceOf(i))] = 1;
                if (pieceOf(i).shows != kNoShape) {
                    left[pieceOf(i).shows] = 1;
                }
            }
        }
    }
    for (std::size_t shape = 0; shape < cover_.clipBounds.size() && single; ++shape) {
        left[shape] = cover_.clipBounds[shape] != 0 ? 1 : left[shape];
    }
    for (const std::uint32_t owner : cover_.owner) {
        if (!single && owner != kNoIndex) {
            left[owner] = 1;
        }
    }
    std::vector<std::string> names;
    for (std::uint32_t k = 0; k < input_.pieces.size(); ++k) { // hidden shapes have no lines
        const ArrangementPiece &piece = input_.pieces[k];
        if (ofShape(piece) && left[unit(piece)] == 0) {
            const std::uint32_t gone = unit(piece);
            left[gone] = 1; // counts once
            changes_.add(ChangeKind::VanishedShapes, piece.a, 0.0, k);
            const std::string &name = single ? input_.shapes[gone].name : input_.features[gone].name;
            if (!name.empty() && names.size() < kNames) {
                names.push_back(name);
            }
        }
    }
    for (const std::string &name : names) {
        std::string &text = changes_.find(ChangeKind::VanishedShapes)->names;
        text += (text.empty() ? "" : ", ") + name;
    }
}

/// Returns a point in a bounded face; the middle of one of its edges if rounding leaves no room.
Vec2 Assembler::placeInside(std::uint32_t face) const {
    std::vector<FaceEdge> edges;
    for (std::uint32_t e = 0; e < snapped_.edges.size(); ++e) {
        const bool left = faces_.left[e] == face, right = faces_.right[e] == face;
        if (left || right) {
            edges.push_back({snapped_.nodes[snapped_.edges[e].a], snapped_.nodes[snapped_.edges[e].b], left && right});
        }
    }
    return pointInFace(edges).value_or(midpoint(edges.front().a, edges.front().b));
}

std::uint32_t Assembler::firstLineAround(std::uint32_t face) const {
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
            const std::uint32_t edge = snapped_.ways[k] / 2;
            if (faces_.left[edge] == face || faces_.right[edge] == face) {
                return i;
            }
        }
    }
    return 0;
}

} // namespace forefront
