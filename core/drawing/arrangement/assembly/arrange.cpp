#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/assembly/assembler.hpp"
#include "core/drawing/arrangement/cover/hidden_shapes.hpp"
#include "core/drawing/arrangement/curves/joined_lines.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/coordinate_range.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace forefront {

namespace {

Box2 boundsOf(const ArrangementInput &input) {
    Box2 box;
    for (const ArrangementPiece &piece : input.pieces) {
        box.add(piece.a);
        box.add(piece.b);
    }
    return box;
}

Diagnostics checkRange(const ArrangementInput &input, const Box2 &box) {
    for (const ArrangementPiece &piece : input.pieces) {
        for (const Vec2 p : {piece.a, piece.b}) {
            if (!isFinite(p)) {
                return error("non-finite", "a coordinate is not a finite number", "correct its coordinates");
            }
        }
    }
    if (!box.empty() && (tooLarge(box.min) || tooLarge(box.max) || tooSmall(box) || tooFarAway(box))) {
        Diagnostics faults =
            error("out-of-range", "the coordinates are too large, too small, or too far from the origin",
                  "scale and move the drawing first");
        faults.front().at = box.min;
        return faults;
    }
    return {};
}

/// Checks that each contour enters each of its nodes as often as it leaves it; even-odd contours must pass an even
/// number of times.
Diagnostics checkClosed(const ArrangementInput &input, const JoinedLines &joined) {
    const SnappedLines &snapped = joined.snapped;
    std::vector<std::uint64_t> balance(input.contours.size(), 0);
    const auto mix = [](std::uint64_t node) { // SplitMix64 (S. Vigna): sums of such numbers vanish only by pairs
        node = (node + 1) * 0x9e3779b97f4a7c15ULL;
        node = (node ^ (node >> 30)) * 0xbf58476d1ce4e5b9ULL;
        node = (node ^ (node >> 27)) * 0x94d049bb133111ebULL;
        return node ^ (node >> 31);
    };
    std::vector<std::uint32_t> piece(input.contours.size(), 0);
    for (std::uint32_t i = 0; i < joined.lines.size(); ++i) {
        const ArrangementPiece &about = input.pieces[joined.source[i]];
        if (about.role != PieceRole::Outline || snapped.starts[i] == snapped.starts[i + 1]) {
            continue;
        }
        const std::uint32_t lastWay = snapped.ways[snapped.starts[i + 1] - 1];
        const PlaneEdge &last = snapped.edges[lastWay / 2];
        const std::uint64_t from = mix(snapped.first[i]), to = mix(lastWay % 2 != 0 ? last.a : last.b);
        std::uint64_t &sum = balance[about.contour];
        sum = input.contours[about.contour].rule == FillRule::EvenOdd ? sum ^ from ^ to : sum + to - from;
        piece[about.contour] = joined.source[i];
    }
    const auto open = std::find_if(balance.begin(), balance.end(), [](std::uint64_t sum) { return sum != 0; });
    if (open == balance.end()) {
        return {};
    }
    Diagnostics faults = error("open-contour", "an outline is not closed", "close the outline");
    faults.front().at = input.pieces[piece[static_cast<std::size_t>(open - balance.begin())]].b;
    return faults;
}

/// Joins all pieces, except pieces of hidden shapes.
JoinedLines joinPieces(const ArrangementInput &input, double tolerance, const std::stop_token &stop) {
    constexpr double kClear = 4.0; // minimum clearance, in tolerances
    const std::vector<std::uint8_t> hidden = findHiddenShapes(input, kClear * tolerance);
    std::vector<SnapLine> lines;
    std::vector<CurveStretch> stretches;
    std::vector<std::uint32_t> pieceOfLine;
    lines.reserve(input.pieces.size());
    stretches.reserve(input.pieces.size());
    pieceOfLine.reserve(input.pieces.size());
    for (std::uint32_t k = 0; k < input.pieces.size(); ++k) {
        const ArrangementPiece &piece = input.pieces[k];
        if (hidden.empty() || piece.role != PieceRole::Outline || hidden[input.contours[piece.contour].shape] == 0) {
            lines.push_back({piece.a, piece.b});
            stretches.push_back(piece.stretch);
            pieceOfLine.push_back(k);
        }
    }
    JoinedLines joined = joinLines(lines, stretches, input.curves, tolerance, stop);
    for (std::uint32_t &source : joined.source) {
        source = pieceOfLine[source];
    }
    for (ChordMeeting &meeting : joined.meetings) {
        meeting.chord = pieceOfLine[meeting.chord];
        meeting.other = pieceOfLine[meeting.other];
    }
    for (ChordCut &cut : joined.left) {
        cut.chord = pieceOfLine[cut.chord];
    }
    return joined;
}

/// Arranges the pieces. Sets `reduced` to the input to arrange instead if lines repeat outlines.
Result<Arrangement> arrangeOnce(const ArrangementInput &input, std::optional<ReducedDrawing> &reduced,
                                const std::stop_token &stop) {
    const Box2 box = boundsOf(input);
    if (Diagnostics faults = checkRange(input, box); !faults.empty()) {
        return faults;
    }
    const JoinedLines joined = joinPieces(input, std::max(input.tolerance, resolutionOf(box)), stop);
    const SnappedLines &snapped = joined.snapped;
    if (!snapped.finished) {
        return error("cancelled", "arranging the drawing was cancelled");
    }
    if (Diagnostics faults = checkClosed(input, joined); !faults.empty()) {
        return faults;
    }
    const PlaneSweepResult sweep = sweepPlane(snapped.nodes, snapped.edges, stop);
    if (stop.stop_requested()) {
        return error("cancelled", "joining the pieces was cancelled");
    }
    if (sweep.droppedCount != 0) {
        return error("arrangement-failed", "segments still cross or touch after joining",
                     "please report this file as a bug");
    }
    Assembler assembler(input, joined, findFaces(snapped.nodes, snapped.edges, sweep));
    Arrangement result = assembler.run();
    result.radius = snapped.radius;
    reduced = assembler.reduced();
    return result;
}

} // namespace

std::uint32_t ArrangementInput::addFeature(std::int32_t regionTag, std::string name) {
    features.push_back({regionTag, std::move(name)});
    return static_cast<std::uint32_t>(features.size() - 1);
}

std::uint32_t ArrangementInput::addShape(std::uint32_t feature, std::string name, std::uint32_t limit) {
    shapes.push_back({feature, std::move(name), limit});
    return static_cast<std::uint32_t>(shapes.size() - 1);
}

std::uint32_t ArrangementInput::addClip(std::uint32_t within) {
    clips.push_back({within});
    return static_cast<std::uint32_t>(clips.size() - 1);
}

std::uint32_t ArrangementInput::addClipPart(std::uint32_t clip, std::uint32_t limit, bool removes) {
    shapes.push_back({kNoIndex, {}, limit, clip, removes});
    return static_cast<std::uint32_t>(shapes.size() - 1);
}

std::uint32_t ArrangementInput::addContour(std::uint32_t shape, FillRule rule, bool hole) {
    contours.push_back({shape, rule, hole});
    return static_cast<std::uint32_t>(contours.size() - 1);
}

void ArrangementInput::addRing(std::uint32_t contour, std::span<const Vec2> nodes, std::int32_t tag,
                               std::span<const CurveStretch> stretches) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Vec2 a = nodes[k], b = nodes[(k + 1) % nodes.size()];
        if (a != b) {
            pieces.push_back(
                {a, b, contour, tag, PieceRole::Outline, k < stretches.size() ? stretches[k] : CurveStretch{}});
        }
    }
}

void ArrangementInput::addChain(std::span<const Vec2> nodes, std::int32_t tag, std::span<const CurveStretch> stretches,
                                std::uint32_t limit, double reach) {
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        if (nodes[k - 1] != nodes[k]) {
            pieces.push_back({nodes[k - 1], nodes[k], 0, tag, PieceRole::Constraint,
                              k - 1 < stretches.size() ? stretches[k - 1] : CurveStretch{}, limit, kNoShape, reach});
        }
    }
}

void ArrangementInput::addPoint(Vec2 at, std::int32_t tag) {
    pieces.push_back({at, at, 0, tag, PieceRole::Point});
}

Result<Arrangement> arrange(const ArrangementInput &input, const std::stop_token &stop) {
    std::optional<ReducedDrawing> reduced;
    Result<Arrangement> first = arrangeOnce(input, reduced, stop);
    if (!first || !reduced) {
        return first;
    }
    const ReducedDrawing rest = *std::exchange(reduced, std::nullopt);
    Result<Arrangement> second = arrangeOnce(rest.input, reduced, stop);
    if (second) {
        for (std::uint32_t &piece : second->nodePiece) {
            piece = rest.source[piece];
        }
        for (PieceStretch &stretch : second->stretches) {
            stretch.piece = rest.source[stretch.piece];
        }
        for (std::uint32_t &piece : second->pointPiece) {
            piece = rest.source[piece];
        }
        second->changes = std::move(first->changes); // those of the drawing as it was given
    }
    return second;
}

} // namespace forefront
