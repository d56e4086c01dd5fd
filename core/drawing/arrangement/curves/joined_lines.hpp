#pragma once

#include "core/drawing/arrangement/curves/chord_cuts.hpp"
#include "core/drawing/arrangement/snapping/snap_lines.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <tuple>
#include <vector>

namespace forefront {

/// Limits on the work of dividing chords, far above what real drawings need. Chords left undivided are reported.
struct DivisionLimits {
    int rounds = 48;                  ///< each may halve a chord
    std::size_t partsPerLine = 16;    ///< on average, in addition to the spare parts
    std::size_t spareParts = 100'000; ///< shared by all lines
    int repeats = 8;                  ///< of dividing after joining
};

/// Lines, some of them chords of curves, with the chords divided so that they meet where their curves do.
class LineDivision {
  public:
    /// `stretches`: per line, the part of a curve that it is a chord of. A line whose ends are off its curve by more
    /// than a few tolerances, or which follows a straight line, counts as straight.
    LineDivision(std::span<const SnapLine> lines, std::span<const CurveStretch> stretches,
                 std::span<const Curve> curves, double tolerance, const DivisionLimits &limits = {});

    bool followsCurves() const { return followsCurves_; }
    /// Returns the given tolerance, or the minimum that rounding of points on curves allows.
    double tolerance() const { return tolerance_; }

    /// Divides chords until they fit their curves, or a limit is reached. Returns false if asked to stop.
    bool divide(const std::stop_token &stop);
    /// Divides chords that do not fit now that joining has moved nodes by up to the joining distance. Returns false if
    /// there are none, or the number of repeats has been reached.
    bool divideAfter(const SnappedLines &snapped, const std::stop_token &stop);

    /// Returns the parts in the order of the lines, each in the direction of its line.
    std::vector<SnapLine> parts() const;
    /// Returns the part of a curve that each part of a line follows.
    std::vector<CurveStretch> partStretches() const;
    /// Returns, per part, the line that it belongs to.
    const std::vector<std::uint32_t> &sources() const { return source_; }
    /// Returns where curves meet; `chord` is the index of a line.
    const std::vector<ChordMeeting> &meetings() const { return meetings_; }
    /// Returns the cuts that a limit prevented or joining undid, the first of each line; `chord` is the index of a
    /// line.
    std::vector<ChordCut> left() const;

  private:
    /// The key of a chord that has been compared with all others after joining, and the last cut found on it.
    struct Compared {
        std::uint32_t curve = kNoCurve;
        std::array<double, 6> numbers{}; ///< parameters and ends
        std::optional<ChordCut> cut;

        bool operator<(const Compared &other) const {
            return std::tie(curve, numbers) < std::tie(other.curve, other.numbers);
        }
        bool operator==(const Compared &other) const { return curve == other.curve && numbers == other.numbers; }
    };

    static Compared comparedOf(const Chord &chord);
    void takeCompared(std::vector<Chord> &joined, double radius);
    bool atLimit() const;
    void leave(std::span<const ChordCut> cuts);
    Chord chordOf(std::uint32_t line) const;
    void apply(ChordCuts found);
    void addParts(std::uint32_t chord, std::span<const ChordCut> cuts);
    std::vector<Chord> joinedChords(const SnappedLines &snapped, std::vector<std::uint32_t> &part);
    Chord joinedChord(std::uint32_t part, Vec2 from, Vec2 to) const;
    SnapLine partLine(std::uint32_t part) const;
    CurveStretch partStretch(std::uint32_t part) const;

    std::span<const SnapLine> lines_;
    std::span<const CurveStretch> stretches_;
    std::span<const Curve> curves_;
    double tolerance_;
    DivisionLimits limits_;
    int repeats_ = 0;
    bool followsCurves_ = false;
    std::vector<Chord> chords_;          ///< the parts of the lines
    std::vector<std::uint32_t> source_;  ///< per chord
    std::vector<std::uint8_t> backward_; ///< per chord: 1 if it runs from b to a
    std::vector<Chord> nextChords_;      ///< while dividing
    std::vector<std::uint32_t> nextSource_;
    std::vector<std::uint8_t> nextBackward_;
    std::vector<ChordMeeting> meetings_;
    std::vector<ChordCut> left_;
    std::vector<Compared> compared_; ///< the chords of the last comparison after joining, in order
    double comparedAt_ = 0.0;        ///< the joining distance of that comparison
};

/// Lines divided where their curves meet, and joined.
struct JoinedLines {
    std::vector<SnapLine> lines;
    std::vector<CurveStretch> stretches; ///< per line
    std::vector<std::uint32_t> source;   ///< per line: the given line that it is part of; ascending
    std::vector<ChordMeeting> meetings;  ///< `chord` is the index of a given line
    std::vector<ChordCut> left;          ///< the same for cuts that a limit prevented or joining undid; one per line
    SnappedLines snapped;
};

/// Joins lines as snapLines() does, and chords of curves where the curves meet: nodes at crossings are on both curves
/// to rounding, and no crossing beyond which curves are farther apart than the tolerance is missed, except beside the
/// cuts that a limit leaves.
JoinedLines joinLines(std::span<const SnapLine> lines, std::span<const CurveStretch> stretches,
                      std::span<const Curve> curves, double tolerance, const std::stop_token &stop = {},
                      const DivisionLimits &limits = {});

} // namespace forefront
