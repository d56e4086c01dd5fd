#include "core/drawing/arrangement/curves/joined_lines.hpp"

#include "core/drawing/arrangement/snapping/cluster.hpp"
#include "core/drawing/arrangement/snapping/stretch_part.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// Ends farther than this many tolerances from their curve mean that the line does not follow that curve.
constexpr double kReach = 4.0;
/// Minimum tolerance for curves, as a multiple of the one for lines: points on curves carry more rounding error.
constexpr double kResolutions = 8.0;

bool comesFirst(const ChordCut &s, const ChordCut &t) {
    return std::tie(s.chord, s.t, s.at.x, s.at.y) < std::tie(t.chord, t.t, t.at.x, t.at.y);
}

Chord straightChord(Vec2 p, Vec2 q) {
    const bool forward = !comesBefore(q, p);
    const Vec2 a = forward ? p : q, b = forward ? q : p;
    return {CurvePart(Curve::line(a, b), 0.0, 1.0), a, b};
}

} // namespace

LineDivision::LineDivision(std::span<const SnapLine> lines, std::span<const CurveStretch> stretches,
                           std::span<const Curve> curves, double tolerance, const DivisionLimits &limits)
    : lines_(lines), stretches_(stretches), curves_(curves), tolerance_(tolerance), limits_(limits) {
    if (std::none_of(stretches.begin(), stretches.end(), [](const CurveStretch &s) { return s.follows(); })) {
        return;
    }
    Box2 box;
    for (const SnapLine &line : lines) {
        box.add(line.a);
        box.add(line.b);
    }
    tolerance_ = std::max(tolerance, kResolutions * resolutionOf(box));
    chords_.reserve(lines.size());
    for (std::uint32_t line = 0; line < lines.size(); ++line) {
        chords_.push_back(chordOf(line));
        const Chord &chord = chords_.back();
        followsCurves_ = followsCurves_ || chord.follows();
        source_.push_back(line);
        const bool backward = chord.follows() ? stretches[line].t1 < stretches[line].t0 : lines[line].a != chord.a;
        backward_.push_back(backward ? 1 : 0);
    }
}

Chord LineDivision::chordOf(std::uint32_t line) const {
    const SnapLine &ends = lines_[line];
    const CurveStretch &stretch = stretches_[line];
    if (stretch.curve < curves_.size() && stretch.t0 != stretch.t1 && ends.a != ends.b) {
        const Curve &curve = curves_[stretch.curve];
        if (curve.kind() != CurveKind::Line && curve.finite()) {
            const bool forward = stretch.t0 < stretch.t1;
            Chord chord{CurvePart(curve, stretch.t0, stretch.t1), forward ? ends.a : ends.b, forward ? ends.b : ends.a,
                        stretch.curve};
            const double reach = kReach * std::max(tolerance_, chord.part.noise);
            if (distance(chord.a, chord.part.start) <= reach && distance(chord.b, chord.part.end) <= reach) {
                return chord;
            }
        }
    }
    return straightChord(ends.a, ends.b);
}

bool LineDivision::divide(const std::stop_token &stop) {
    for (int round = 0; followsCurves_; ++round) {
        ChordCuts found = findChordCuts(chords_, tolerance_, stop);
        if (!found.finished) {
            return false;
        }
        if (found.cuts.empty()) {
            break;
        }
        if (round >= limits_.rounds || atLimit()) {
            leave(found.cuts);
            break;
        }
        apply(std::move(found));
    }
    return true;
}

bool LineDivision::atLimit() const {
    return chords_.size() >= limits_.partsPerLine * lines_.size() + limits_.spareParts;
}

/// Records cuts of chords that are not made.
void LineDivision::leave(std::span<const ChordCut> cuts) {
    for (const ChordCut &cut : cuts) {
        left_.push_back({source_[cut.chord], cut.t, cut.at});
    }
}

/// Divides chords; afterwards only the new parts are fresh.
void LineDivision::apply(ChordCuts found) {
    for (ChordMeeting &meeting : found.meetings) {
        meeting.chord = source_[meeting.chord];
        meeting.other = source_[meeting.other];
        meetings_.push_back(meeting);
    }
    std::sort(found.cuts.begin(), found.cuts.end(), comesFirst);
    nextChords_.clear();
    nextSource_.clear();
    nextBackward_.clear();
    nextChords_.reserve(chords_.size() + found.cuts.size()); // Chords are large; to grow step by step takes twice that.
    std::size_t next = 0;
    for (std::uint32_t chord = 0; chord < chords_.size(); ++chord) {
        const std::size_t first = next;
        while (next < found.cuts.size() && found.cuts[next].chord == chord) {
            ++next;
        }
        addParts(chord, std::span(found.cuts).subspan(first, next - first));
    }
    chords_.swap(nextChords_);
    source_.swap(nextSource_);
    backward_.swap(nextBackward_);
}

/// Adds the parts of a chord between cuts, in the direction of its line.
void LineDivision::addParts(std::uint32_t chord, std::span<const ChordCut> cuts) {
    const Chord &whole = chords_[chord];
    const auto before = static_cast<std::ptrdiff_t>(nextChords_.size());
    Vec2 from = whole.a;
    double t0 = whole.part.t0;
    const auto add = [&](double t1, Vec2 to) {
        if (whole.follows()) {
            nextChords_.push_back({CurvePart(whole.part.curve, t0, t1), from, to, whole.curve});
        } else {
            nextChords_.push_back(straightChord(from, to));
        }
        // Rounding may put the next node of a steep line before the last one.
        const bool turned = nextChords_.back().a != from;
        nextBackward_.push_back(turned != (backward_[chord] != 0) ? 1 : 0);
        nextSource_.push_back(source_[chord]);
        from = to;
        t0 = t1;
    };
    if (cuts.empty()) {
        nextChords_.push_back(whole);
        nextChords_.back().fresh = false;
        nextBackward_.push_back(backward_[chord]);
        nextSource_.push_back(source_[chord]);
        return;
    }
    for (const ChordCut &cut : cuts) {
        if (cut.t > t0 && cut.at != from && cut.at != whole.b) {
            add(cut.t, cut.at);
        }
    }
    add(whole.part.t1, whole.b);
    if (backward_[chord] != 0) {
        std::reverse(nextChords_.begin() + before, nextChords_.end());
        std::reverse(nextBackward_.begin() + before, nextBackward_.end());
    }
    const bool divided = nextChords_.end() - nextChords_.begin() > before + 1;
    std::for_each(nextChords_.begin() + before, nextChords_.end(), [&](Chord &part) { part.fresh = divided; });
}

SnapLine LineDivision::partLine(std::uint32_t part) const {
    const Chord &chord = chords_[part];
    return backward_[part] != 0 ? SnapLine{chord.b, chord.a} : SnapLine{chord.a, chord.b};
}

CurveStretch LineDivision::partStretch(std::uint32_t part) const {
    const Chord &chord = chords_[part];
    if (chord.follows()) {
        const CurveStretch stretch{chord.curve, chord.part.t0, chord.part.t1};
        return backward_[part] != 0 ? stretch.reversed() : stretch;
    }
    const SnapLine line = partLine(part);
    return stretchAlong(stretches_[source_[part]], curves_, lines_[source_[part]], line.a, line.b);
}

std::vector<SnapLine> LineDivision::parts() const {
    std::vector<SnapLine> parts;
    parts.reserve(chords_.size());
    for (std::uint32_t part = 0; part < chords_.size(); ++part) {
        parts.push_back(partLine(part));
    }
    return parts;
}

std::vector<CurveStretch> LineDivision::partStretches() const {
    std::vector<CurveStretch> stretches;
    stretches.reserve(chords_.size());
    for (std::uint32_t part = 0; part < chords_.size(); ++part) {
        stretches.push_back(partStretch(part));
    }
    return stretches;
}

std::vector<ChordCut> LineDivision::left() const {
    std::vector<ChordCut> left = left_;
    std::sort(left.begin(), left.end(), comesFirst);
    const auto sameLine = [](const ChordCut &s, const ChordCut &t) { return s.chord == t.chord; };
    left.erase(std::unique(left.begin(), left.end(), sameLine), left.end());
    return left;
}

/// Returns the chord between two nodes on the path that a part has become.
Chord LineDivision::joinedChord(std::uint32_t part, Vec2 from, Vec2 to) const {
    const Chord &whole = chords_[part];
    if (whole.follows()) {
        const CurveStretch stretch = stretchAlong(partStretch(part), curves_, partLine(part), from, to);
        if (stretch.t0 != stretch.t1) {
            const bool forward = stretch.t0 < stretch.t1;
            return {CurvePart(whole.part.curve, stretch.t0, stretch.t1), forward ? from : to, forward ? to : from,
                    whole.curve};
        }
    }
    return straightChord(from, to);
}

LineDivision::Compared LineDivision::comparedOf(const Chord &chord) {
    return {chord.curve, {chord.part.t0, chord.part.t1, chord.a.x, chord.a.y, chord.b.x, chord.b.y}, {}};
}

/// Returns the chords along the paths of all parts and marks those as fresh that joining has changed, or that have not
/// been compared at its distance; `part` gives the part of each.
std::vector<Chord> LineDivision::joinedChords(const SnappedLines &snapped, std::vector<std::uint32_t> &part) {
    std::vector<Chord> joined;
    joined.reserve(snapped.ways.size());
    part.reserve(snapped.ways.size());
    const bool shrunk = snapped.radius < tolerance_; // what was near enough to join may no longer be
    const auto add = [&](std::uint32_t k, Chord chord, bool changed) {
        chord.fresh = changed || shrunk;
        joined.push_back(chord);
        part.push_back(k);
    };
    for (std::uint32_t k = 0; k < chords_.size(); ++k) {
        const SnapLine line = partLine(k);
        std::uint32_t node = snapped.first[k];
        if (line.a == line.b) {
            add(k, straightChord(snapped.nodes[node], snapped.nodes[node]), snapped.nodes[node] != line.a);
        }
        const std::uint32_t count = snapped.starts[k + 1] - snapped.starts[k];
        for (std::uint32_t w = snapped.starts[k]; w < snapped.starts[k + 1]; ++w) {
            const PlaneEdge &edge = snapped.edges[snapped.ways[w] / 2];
            const std::uint32_t next = edge.a == node ? edge.b : edge.a;
            const Vec2 from = snapped.nodes[node], to = snapped.nodes[next];
            const bool kept = count == 1 && from == line.a && to == line.b;
            add(k, kept ? chords_[k] : joinedChord(k, from, to), !kept);
            node = next;
        }
    }
    return joined;
}

/// Marks chords that were compared with each other the last time, at the same distance, as not fresh, and all others as
/// fresh: they may have been compared with parts that joining has bent since. Keeps the cuts found on the former.
void LineDivision::takeCompared(std::vector<Chord> &joined, double radius) {
    const bool again = radius == comparedAt_ && !compared_.empty();
    std::vector<Compared> compared;
    compared.reserve(joined.size());
    for (Chord &chord : joined) {
        compared.push_back(comparedOf(chord));
        if (again) {
            const auto last = std::lower_bound(compared_.begin(), compared_.end(), compared.back());
            const bool known = last != compared_.end() && *last == compared.back();
            chord.fresh = !known;
            compared.back().cut = known ? last->cut : std::nullopt;
        }
    }
    compared_ = std::move(compared);
    comparedAt_ = radius;
}

bool LineDivision::divideAfter(const SnappedLines &snapped, const std::stop_token &stop) {
    std::vector<std::uint32_t> part;
    std::vector<Chord> joined = joinedChords(snapped, part);
    takeCompared(joined, snapped.radius);
    ChordCuts found = findChordCuts(joined, snapped.radius, stop);
    if (!found.finished) {
        return false;
    }
    std::erase_if(found.cuts, [&](const ChordCut &cut) { return !joined[cut.chord].follows(); });
    for (const ChordCut &cut : found.cuts) {
        compared_[cut.chord].cut = cut;
    }
    std::vector<ChordCut> open; // those found now, and those that joining undid
    for (std::size_t i = 0; i < joined.size(); ++i) {
        if (const auto &cut = compared_[i].cut) {
            open.push_back({source_[part[i]], cut->t, cut->at});
        }
    }
    std::sort(compared_.begin(), compared_.end());
    if (found.cuts.empty() || repeats_ >= limits_.repeats || atLimit()) {
        left_.insert(left_.end(), open.begin(), open.end());
        return false;
    }
    ++repeats_;
    for (ChordCut &cut : found.cuts) {
        cut.chord = part[cut.chord];
    }
    for (ChordMeeting &meeting : found.meetings) {
        meeting.chord = part[meeting.chord];
        meeting.other = part[meeting.other];
    }
    const std::size_t before = chords_.size();
    apply(std::move(found));
    const bool divided = chords_.size() > before;
    left_ = divided ? std::vector<ChordCut>() : std::move(open); // those left before are looked for again
    return divided;
}

JoinedLines joinLines(std::span<const SnapLine> lines, std::span<const CurveStretch> stretches,
                      std::span<const Curve> curves, double tolerance, const std::stop_token &stop,
                      const DivisionLimits &limits) {
    JoinedLines joined;
    LineDivision division(lines, stretches, curves, tolerance, limits);
    if (!division.followsCurves()) {
        joined.lines.assign(lines.begin(), lines.end());
        joined.stretches.assign(stretches.begin(), stretches.end());
        joined.source.resize(lines.size());
        std::iota(joined.source.begin(), joined.source.end(), 0U);
        joined.snapped = snapLines(lines, tolerance, stop);
        return joined;
    }
    for (;;) {
        const bool finished = division.divide(stop);
        joined.lines = division.parts();
        joined.snapped = snapLines(joined.lines, division.tolerance(), joined.snapped, stop);
        joined.snapped.finished = joined.snapped.finished && finished;
        if (!joined.snapped.finished || !division.divideAfter(joined.snapped, stop)) {
            break;
        }
    }
    joined.stretches = division.partStretches();
    joined.source = division.sources();
    joined.meetings = division.meetings();
    joined.left = division.left();
    return joined;
}

} // namespace forefront
