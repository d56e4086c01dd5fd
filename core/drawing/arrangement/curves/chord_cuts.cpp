#include "core/drawing/arrangement/curves/chord_cuts.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/curve_contacts.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <array>
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
        markTiny();
        const std::vector<Box2> boxes = boxesOfChords();
        const BoxTree tree(boxes);
        const auto fresh =
            std::count_if(chords_.begin(), chords_.end(), [](const Chord &chord) { return chord.fresh; });
        // Comparing all chords at once is several times as fast as one query for each.
        constexpr std::size_t kMany = 4;
        result_.finished = kMany * static_cast<std::size_t>(fresh) > chords_.size() ? compareAll(tree, boxes, stop)
                                                                                    : compareFresh(tree, boxes, stop);
        return std::move(result_);
    }

  private:
    /// Marks chords that no other marked one divides. There may be very many at one place: parts of curves that meet
    /// there within the tolerance, each of which is near all others.
    void markTiny() {
        tiny_.reserve(chords_.size());
        for (const Chord &chord : chords_) {
            tiny_.push_back(small(chord, tolerance_) && !bent(chord, tolerance_) ? 1 : 0);
        }
    }

    std::vector<Box2> boxesOfChords() const {
        std::vector<Box2> boxes;
        boxes.reserve(chords_.size());
        for (const Chord &chord : chords_) {
            Box2 box = boxOf(chord.a, chord.b);
            for (const Vec2 corner : chord.part.hull()) {
                box.add(corner);
            }
            boxes.push_back(box.grown(2.0 * std::max(tolerance_, chord.part.noise)));
        }
        return boxes;
    }

    /// Compares each fresh chord with all others. Returns false if asked to stop.
    bool compareFresh(const BoxTree &tree, std::span<const Box2> boxes, const std::stop_token &stop) {
        for (std::uint32_t i = 0; i < chords_.size(); ++i) {
            if (!chords_[i].fresh) {
                continue;
            }
            if (stop.stop_requested()) {
                return false;
            }
            checkLoop(i);
            tree.query(boxes[i], [&](std::uint32_t j) {
                const bool known = chords_[j].fresh && j < i; // a pair of fresh ones is compared once
                if (j != i && !known) {
                    compare(i, j);
                }
            });
        }
        return true;
    }

    /// Does the same, and returns the cuts in the same order.
    bool compareAll(const BoxTree &tree, std::span<const Box2> boxes, const std::stop_token &stop) {
        std::vector<std::uint32_t> place(chords_.size());
        for (std::uint32_t k = 0; k < place.size(); ++k) {
            place[tree.items()[k]] = k + 1;
        }
        std::vector<std::uint64_t> cutKeys, meetingKeys;
        const auto key = [&](std::uint32_t i, std::uint32_t behind) {
            cutKeys.resize(result_.cuts.size(), pairKey(i, behind));
            meetingKeys.resize(result_.meetings.size(), pairKey(i, behind));
        };
        for (std::uint32_t i = 0; i < chords_.size(); ++i) {
            if (chords_[i].fresh) {
                checkLoop(i);
                key(i, 0);
            }
        }
        const bool finished = joinChords(boxes, stop, [&](std::uint32_t m, std::uint32_t n) {
            const bool first = chords_[m].fresh && (m < n || !chords_[n].fresh);
            const std::uint32_t i = first ? m : n, j = first ? n : m;
            if (chords_[i].fresh) {
                compare(i, j);
                key(i, place[j]);
            }
        });
        sortByKeys(cutKeys, result_.cuts);
        sortByKeys(meetingKeys, result_.meetings);
        return finished;
    }

    /// Visits all pairs of chords whose boxes overlap, unless both are tiny. Returns false if asked to stop.
    template <class Visit>
    bool joinChords(std::span<const Box2> boxes, const std::stop_token &stop, const Visit &visit) const {
        std::array<std::vector<std::uint32_t>, 2> chords; // large ones and tiny ones
        std::array<std::vector<Box2>, 2> boxesOf;
        for (std::uint32_t i = 0; i < chords_.size(); ++i) {
            chords[tiny_[i]].push_back(i);
            boxesOf[tiny_[i]].push_back(boxes[i]);
        }
        std::size_t visits = 0;
        const auto visitAs = [&](std::size_t kind) {
            return [&, kind](std::uint32_t m, std::uint32_t n) {
                visit(chords[0][m], chords[kind][n]);
                return ++visits % 65536 != 0 || !stop.stop_requested();
            };
        };
        const BoxTree large(boxesOf[0]), tiny(boxesOf[1]);
        return large.joinSelf(0.0, visitAs(0)) && large.join(tiny, 0.0, visitAs(1)) && !stop.stop_requested();
    }

    template <class Item>
    static void sortByKeys(std::span<const std::uint64_t> keys, std::vector<Item> &items) {
        std::vector<Item> sorted;
        sorted.reserve(items.size());
        for (const std::uint32_t k : orderByKeys(keys)) {
            sorted.push_back(items[k]);
        }
        items = std::move(sorted);
    }

    static bool bent(const Chord &chord, double tolerance) {
        return chord.follows() && chord.part.sagitta > kFlat * tolerance;
    }
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
        if (tiny_[i] != 0 && tiny_[j] != 0) {
            return;
        }
        ++result_.comparisons;
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
        const bool bentFirst = bent(chords_[i], tolerance), bentSecond = bent(chords_[j], tolerance);
        const CurvePart &first = chords_[i].part, &second = chords_[j].part;
        if ((!bentFirst && !bentSecond) || (!strays(first, second, tolerance) && !strays(second, first, tolerance))) {
            return;
        }
        if (bentFirst) {
            halve(i);
        }
        if (bentSecond) {
            halve(j);
        }
    }

    /// Returns true if a place on the first part is farther from the second than the tolerance.
    static bool strays(const CurvePart &first, const CurvePart &second, double tolerance) {
        constexpr int kParts = 4;
        for (int k = 1; k < kParts; ++k) {
            const Vec2 p = first.curve.point(std::lerp(first.t0, first.t1, k / double{kParts}));
            const double t = second.curve.nearest(p, second.t0, second.t1);
            if (distance(p, second.curve.point(t)) > tolerance) {
                return true;
            }
        }
        return false;
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
        if (nearChord && !bent(chord, tolerance)) {
            return; // joining handles the node
        }
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
        if (bent(chord, tolerance) && (nearChord || between(node, chord))) {
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
    std::vector<std::uint8_t> tiny_; ///< per chord
    ChordCuts result_;
};

} // namespace

ChordCuts findChordCuts(std::span<const Chord> chords, double tolerance, const std::stop_token &stop) {
    return CutFinder(chords, tolerance).run(stop);
}

} // namespace forefront
