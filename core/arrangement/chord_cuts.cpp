#include "core/arrangement/chord_cuts.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/curve_contacts.hpp"
#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

/// Shares of the tolerance below which chords and their curves are the same.
constexpr double kFlat = 0.25;
/// Chords smaller than this many tolerances are not divided.
constexpr double kSmall = 4.0;

class CutFinder {
  public:
    CutFinder(std::span<const Chord> chords, double tolerance) : chords_(chords), tolerance_(tolerance) {}

    ChordCuts run(const std::stop_token &stop) {
        std::vector<Box2> boxes;
        boxes.reserve(chords_.size());
        for (const Chord &chord : chords_) {
            Box2 box = boxOf(chord.a, chord.b);
            for (const Vec2 corner : chord.part.hull()) {
                box.add(corner);
            }
            boxes.push_back(box.grown(2.0 * std::max(tolerance_, chord.part.noise)));
        }
        const BoxTree tree(boxes);
        for (std::uint32_t i = 0; i < chords_.size(); ++i) {
            if (!chords_[i].fresh) {
                continue;
            }
            if (stop.stop_requested()) {
                result_.finished = false;
                break;
            }
            checkLoop(i);
            tree.query(boxes[i], [&](std::uint32_t j) {
                const bool known = chords_[j].fresh && j < i; // a pair of fresh ones is compared once
                if (j != i && !known) {
                    compare(i, j);
                }
            });
        }
        return std::move(result_);
    }

  private:
    bool small(const Chord &chord, double tolerance) const { return chord.part.size() <= kSmall * tolerance; }

    void cut(std::uint32_t chord, double t, Vec2 at) {
        const CurvePart &part = chords_[chord].part;
        if (t > part.t0 && t < part.t1) {
            result_.cuts.push_back({chord, t, at});
        }
    }
    void halve(std::uint32_t chord) {
        const CurvePart &part = chords_[chord].part;
        const double middle = std::midpoint(part.t0, part.t1);
        cut(chord, middle, part.curve.point(middle));
    }

    /// Halves a part that turns so far that it may cross itself.
    void checkLoop(std::uint32_t i) {
        const Chord &chord = chords_[i];
        if (chord.follows() && chord.part.turn > 0.5 * std::numbers::pi && !small(chord, tolerance_) &&
            chord.part.curve.turning(chord.part.t0, chord.part.t1) > std::numbers::pi) {
            halve(i);
        }
    }

    void compare(std::uint32_t i, std::uint32_t j) {
        const Chord &first = chords_[i], &second = chords_[j];
        const double tolerance = std::max({tolerance_, first.part.noise, second.part.noise});
        if ((!first.follows() && !second.follows()) || apart(first.part, second.part, 2.0 * tolerance) ||
            continues(first, second) || diverge(first, second, tolerance)) {
            return;
        }
        bool wide = false;
        for (const std::uint32_t k : {i, j}) {
            if (chords_[k].part.turn > kMaxContactTurn) {
                wide = true;
                if (!small(chords_[k], tolerance)) {
                    halve(k);
                }
            }
        }
        if (wide) {
            return;
        }
        if (sameEnds(first, second, tolerance)) {
            separate(i, j, tolerance);
            return;
        }
        addContacts(i, j, tolerance);
        for (const Vec2 node : {first.a, first.b}) {
            checkNode(node, i, j, tolerance);
        }
        for (const Vec2 node : {second.a, second.b}) {
            checkNode(node, j, i, tolerance);
        }
    }

    /// Returns true for neighbours on one curve that bend so little that they meet only at their common end.
    static bool continues(const Chord &first, const Chord &second) {
        constexpr double kMaxTurn = 0.8; // each from its chord
        return first.curve == second.curve && first.part.turn <= kMaxTurn && second.part.turn <= kMaxTurn &&
               (first.part.t1 == second.part.t0 || first.part.t0 == second.part.t1) && first.follows();
    }

    /// Returns true for chords with a common end from which they and their curves lead in different directions.
    static bool diverge(const Chord &first, const Chord &second, double tolerance) {
        constexpr double kClearAngle = 0.2;
        for (const bool fromStart : {true, false}) {
            for (const bool otherFromStart : {true, false}) {
                const Vec2 p = fromStart ? first.a : first.b, q = otherFromStart ? second.a : second.b;
                const Vec2 u = (fromStart ? first.b : first.a) - p, v = (otherFromStart ? second.b : second.a) - q;
                if (distance(p, q) <= tolerance &&
                    std::atan2(std::fabs(cross(u, v)), dot(u, v)) > first.part.turn + second.part.turn + kClearAngle) {
                    return true;
                }
            }
        }
        return false;
    }

    static bool sameEnds(const Chord &first, const Chord &second, double tolerance) {
        const auto near = [&](Vec2 p, Vec2 q) { return distance(p, q) <= tolerance; };
        return (near(first.a, second.a) && near(first.b, second.b)) ||
               (near(first.a, second.b) && near(first.b, second.a));
    }

    /// Halves curves that have the same ends, and so the same chord, although something lies between them.
    void separate(std::uint32_t i, std::uint32_t j, double tolerance) {
        constexpr int kParts = 4;
        const CurvePart &first = chords_[i].part, &second = chords_[j].part;
        for (int k = 1; k < kParts; ++k) {
            const Vec2 p = first.curve.point(std::lerp(first.t0, first.t1, k / double{kParts}));
            const double t = second.curve.nearest(p, second.t0, second.t1);
            if (distance(p, second.curve.point(t)) > tolerance) {
                for (const std::uint32_t chord : {i, j}) {
                    if (chords_[chord].follows() && chords_[chord].part.sagitta > kFlat * tolerance) {
                        halve(chord);
                    }
                }
                return;
            }
        }
    }

    void addContacts(std::uint32_t i, std::uint32_t j, double tolerance) {
        if (small(chords_[i], tolerance) || small(chords_[j], tolerance)) {
            return;
        }
        for (const CurveContact &contact : curveContacts(chords_[i].part, chords_[j].part, tolerance)) {
            cut(i, contact.first, contact.onFirst);
            cut(j, contact.second, contact.onSecond);
            const ChangeKind kind = contact.crossing ? ChangeKind::CrossingSegments : ChangeKind::TouchingCurves;
            result_.meetings.push_back(
                {kind, contact.onFirst, distance(contact.onFirst, contact.onSecond), std::min(i, j), std::max(i, j)});
        }
    }

    /// Divides chord `j` near an end of chord `i`.
    void checkNode(Vec2 node, std::uint32_t i, std::uint32_t j, double tolerance) {
        const Chord &chord = chords_[j];
        const CurvePart &part = chord.part;
        if (!chord.follows() || distance(node, chord.a) <= tolerance || distance(node, chord.b) <= tolerance ||
            small(chord, tolerance) || apart(part, CurvePart(Curve::line(node, node), 0.0, 1.0), 2.0 * tolerance)) {
            return;
        }
        const bool nearChord = distanceToSegment(chord.a, chord.b, node) <= tolerance;
        const double t = part.curve.nearest(node, part.t0, part.t1);
        const Vec2 foot = part.curve.point(t);
        const double gap = distance(node, foot);
        if (gap <= tolerance) {
            if (!nearChord) {
                cut(j, t, foot);
                const ChangeKind kind = gap <= part.noise ? ChangeKind::TouchingSegments : ChangeKind::BentSegments;
                result_.meetings.push_back({kind, node, kind == ChangeKind::BentSegments ? gap : 0.0, j, i});
            }
            return;
        }
        if (part.sagitta > kFlat * tolerance && (nearChord || between(node, chord))) {
            const bool nearEnd = distance(foot, chord.a) <= tolerance || distance(foot, chord.b) <= tolerance;
            nearEnd ? halve(j) : cut(j, t, foot);
        }
    }

    /// Returns true for a node between the chord and its curve.
    static bool between(Vec2 node, const Chord &chord) {
        const Vec2 ab = chord.b - chord.a;
        const double size = length(ab);
        if (!(size > 0.0)) {
            return false;
        }
        const Vec2 along = (1.0 / size) * ab;
        const CurveGraph graph(chord.part, chord.a, along);
        const double x = dot(along, node - chord.a), y = cross(along, node - chord.a);
        if (x < graph.low() || x > graph.high()) {
            return false;
        }
        return (y > 0.0) != (y > graph.at(x).y);
    }

    std::span<const Chord> chords_;
    double tolerance_;
    ChordCuts result_;
};

} // namespace

ChordCuts findChordCuts(std::span<const Chord> chords, double tolerance, const std::stop_token &stop) {
    return CutFinder(chords, tolerance).run(stop);
}

} // namespace forefront
