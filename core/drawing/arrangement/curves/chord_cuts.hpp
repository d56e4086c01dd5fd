#pragma once

#include "core/drawing/arrangement/change.hpp"
#include "core/engine/geometry/curve_part.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace forefront {

/// A straight line between two nodes and the part of a curve that it stands for.
struct Chord {
    CurvePart part; ///< the line itself if it follows no curve
    Vec2 a;         ///< node at part.t0, near the curve
    Vec2 b;         ///< node at part.t1
    std::uint32_t curve = kNoCurve;
    bool fresh = true; ///< to be compared with all others; the rest are known to fit each other

    bool follows() const { return curve != kNoCurve; }
};

/// A place where a chord has to be divided.
struct ChordCut {
    std::uint32_t chord = 0;
    double t = 0.0; ///< parameter of the chord's part
    Vec2 at;        ///< the new node
};

/// A place where chords meet because their curves do.
struct ChordMeeting {
    ChangeKind kind = ChangeKind::CrossingSegments; ///< or TouchingCurves, TouchingSegments, BentSegments
    Vec2 at;
    double gap = 0.0; ///< between the curves, or the curve and the node
    std::uint32_t chord = 0;
    std::uint32_t other = 0; ///< the chord that it meets, or of the node
};

struct ChordCuts {
    std::vector<ChordCut> cuts;
    std::vector<ChordMeeting> meetings;
    std::size_t comparisons = 0; ///< pairs of chords looked at; a measure of the work
    bool finished = true;        ///< false if asked to stop
};

/// Finds where chords have to be divided so that they meet as their curves do: where curves cross, or touch within the
/// tolerance; where a node is within the tolerance of a curve but not of its chord; and where a node lies between a
/// curve and its chord. When nothing is left to divide, chords that do not share an end cross as often as their curves
/// do, apart from crossings no deeper than the tolerance, because no end of another chord lies between a chord and its
/// curve.
ChordCuts findChordCuts(std::span<const Chord> chords, double tolerance, const std::stop_token &stop);

} // namespace forefront
