#include "core/engine/geometry/path_bands.hpp"

#include "core/engine/geometry/curve_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace forefront {
namespace {

constexpr double kStraight = 1e-9; ///< maximum turn, in radians, of a path at a node that needs no wedge
constexpr double kTiny = 1e-9;     ///< fraction of the size below which lengths count as none

bool isCircular(const Curve &curve) {
    if (curve.kind() != CurveKind::Arc) {
        return false;
    }
    const auto n = curve.numbers();
    const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
    const double size = lengthSquared(u);
    return std::fabs(dot(u, v)) <= 1e-12 * size && std::fabs(lengthSquared(v) - size) <= 1e-12 * size;
}

/// Makes the parts of bands along a path.
class BandMaker {
  public:
    BandMaker(std::span<const Curve> path, bool closed, std::span<const double> offsets, const BandStyle &style)
        : offsets_(offsets), style_(style) {
        Box2 box;
        for (const Curve &curve : path) {
            box.add(curve.bounds());
        }
        for (const double offset : offsets) {
            reach_ = std::max(reach_, std::fabs(offset));
        }
        size_ = box.diagonal() + reach_;
        for (std::uint32_t k = 0; k < path.size(); ++k) {
            divide(path[k], k);
        }
        for (std::size_t k = 0; k + (closed ? 0 : 1) < pieces_.size(); ++k) {
            Piece &before = pieces_[k], &after = pieces_[(k + 1) % pieces_.size()];
            const bool smooth = isSmooth(before, after);
            const bool within = k + 1 < pieces_.size() && before.segment == after.segment; // at a cusp
            for (std::size_t side = 0; side < offsets_.size(); ++side) {
                if (!smooth || !joinSides(before, after, side)) {
                    addWedge(before, after, side, within ? BandCorner::Round : style_.corner);
                }
            }
        }
        std::for_each(pieces_.begin(), pieces_.end(), [&](const Piece &piece) { addStrips(piece); });
    }

    std::vector<BandPart> take() { return std::move(parts_); }

  private:
    /// A part of a segment that turns little, so that its strip does not overlap itself.
    struct Piece {
        Curve curve;
        std::uint32_t segment = 0;
        /// Per offset: where its sides begin and end, if not at a right angle to its ends; such as at the tips of
        /// miters, so that there is no node before them.
        std::array<std::optional<Vec2>, 2> startTips = {}, endTips = {};

        bool isStraight() const { return curve.kind() == CurveKind::Line; }
    };

    /// Divides a segment into pieces. Pieces of zero length are skipped: a wedge fills the gap if the path turns there.
    void divide(const Curve &curve, std::uint32_t segment) {
        if (curve.kind() == CurveKind::Line || isCircular(curve)) {
            const auto count = static_cast<int>(std::max(1.0, std::ceil(curve.turning() / (0.75 * std::numbers::pi))));
            for (int k = 0; k < count; ++k) {
                keep(count > 1 ? curve.part(1.0 * k / count, (k + 1.0) / count) : curve, segment);
            }
            return;
        }
        constexpr int kParts = 4; // minimum: the ends of a loop coincide, so it would seem to have no length
        for (int k = 0; k < kParts; ++k) {
            bisect(curve, 1.0 * k / kParts, (k + 1.0) / kParts, segment);
        }
    }

    void bisect(const Curve &curve, double t0, double t1, std::uint32_t segment) {
        constexpr double kCusp = 1e-12; // minimum step of the parameter; a piece that still turns within it is a cusp
        constexpr int kMaxPieces = 100000; // limits the work where rounding errors exceed the accuracy
        const Curve piece = curve.part(t0, t1);
        if (t1 - t0 <= kCusp || ++checks_ > kMaxPieces) {
            keep(piece, segment);
            return;
        }
        const double corner = cornerOf(piece);
        if (corner == 0.0 && isFine(piece)) {
            keep(piece, segment);
            return;
        }
        constexpr double kMinShare = 1.0 / 16.0; // limits the depth
        const double share = corner > kMinShare && corner < 1.0 - kMinShare ? corner : 0.5;
        const double cut = t0 + (t1 - t0) * share;
        bisect(curve, t0, cut, segment);
        bisect(curve, cut, t1, segment);
    }

    /// Returns the parameter of a corner of a parallel, where it begins or ceases to follow the centres of curvature; 0
    /// if there is none.
    double cornerOf(const Curve &piece) const {
        for (const double offset : offsets_) {
            const int first = pastCentre(piece, 0.0, offset);
            if (first * pastCentre(piece, 1.0, offset) >= 0) {
                continue;
            }
            double low = 0.0, high = 1.0;
            constexpr int kSteps = 53; // the bits of a double
            for (int step = 0; step < kSteps; ++step) {
                const double middle = 0.5 * (low + high);
                ((curvature(piece, middle) * offset > 1.0) == (first > 0) ? low : high) = middle;
            }
            return high;
        }
        return 0.0;
    }

    void keep(const Curve &piece, std::uint32_t segment) {
        if (piece.bounds().diagonal() > kTiny * size_) {
            pieces_.push_back({piece, segment, {}, {}});
        }
    }

    /// Returns the curvature at a parameter of a piece; at a cusp, the curvature just beside it.
    double curvature(const Curve &piece, double t) const {
        const bool isCusp = length(piece.derivative(t)) <= 1e-12 * size_;
        return curvatureOf(piece, isCusp ? std::lerp(t, 0.5, 1e-3) : t);
    }

    /// Returns 1 where an offset reaches past the centre of curvature, -1 where it does not, and 0 where it ends there
    /// to within the accuracy: on a curve that is nearly a circle with the offset as radius, rounding errors decide.
    int pastCentre(const Curve &piece, double t, double offset) const {
        const double excess = curvature(piece, t) * offset - 1.0;
        return excess > style_.accuracy ? 1 : excess < -style_.accuracy ? -1 : 0;
    }

    /// The parallel stops at the centres of curvature, since beyond them other points of the curve are nearer.
    bool endsAtCentre(const Curve &piece, double t, double offset) const { return pastCentre(piece, t, offset) > 0; }

    /// Returns true if the strips of a piece are accurate enough.
    bool isFine(const Curve &piece) const {
        return std::all_of(offsets_.begin(), offsets_.end(), [&](double offset) { return isFine(piece, offset); });
    }

    bool isFine(const Curve &piece, double offset) const {
        constexpr double kMaxTurn = 0.5, kMaxTurnAtCentres = 0.125; // radians
        const double turn = piece.turning();
        std::array<int, kSamples.size()> sides{};
        std::transform(kSamples.begin(), kSamples.end(), sides.begin(),
                       [&](double t) { return pastCentre(piece, t, offset); });
        const auto past = std::count(sides.begin(), sides.end(), 1),
                   before = std::count(sides.begin(), sides.end(), -1);
        if (past > 0) { // covers slightly too much, but other strips cover that too
            return before == 0 && !(turn > kMaxTurnAtCentres);
        }
        const Curve back = parallel(piece, offset);
        return !(turn > kMaxTurn) && std::all_of(kSamples.begin(), kSamples.end(), [&](double t) {
            return distance(back.point(t), moved(piece, t, offset)) <= style_.accuracy * size_;
        });
    }

    /// Returns the distance of a parallel at a parameter: it ends at the centre of curvature, without regard to the
    /// accuracy, so that it is continuous.
    double reach(const Curve &curve, double t, double offset) const {
        const double bend = curvature(curve, t);
        return bend * offset > 1.0 ? 1.0 / bend : offset;
    }

    Vec2 moved(const Curve &curve, double t, double offset) const {
        return curve.point(t) + reach(curve, t, offset) * leftNormal(curve.tangent(t));
    }

    /// Returns the parallel of a piece: exact for lines and circles.
    Curve parallel(const Curve &curve, double offset) const {
        if (curve.kind() == CurveKind::Line) {
            return Curve();
        }
        if (isCircular(curve)) {
            const auto n = curve.numbers();
            const Vec2 u{n[2], n[3]};
            const double turn = n[7] * cross(u, {n[4], n[5]}) > 0.0 ? 1.0 : -1.0;
            const double scale = 1.0 - turn * reach(curve, 0.0, offset) / length(u);
            return Curve::arc({n[0], n[1]}, scale * u, scale * Vec2{n[4], n[5]}, n[6], n[7]);
        }
        const auto speed = [&](double t) {
            return (1.0 - reach(curve, t, offset) * curvature(curve, t)) / 3.0 * curve.derivative(t);
        };
        const Vec2 from = moved(curve, 0.0, offset), to = moved(curve, 1.0, offset);
        return Curve::cubic(from, from + speed(0.0), to - speed(1.0), to);
    }

    /// Adds one strip between the parallels on both sides; where one of them ends at centres of curvature, or there is
    /// only one, strips between the path and each.
    void addStrips(const Piece &piece) {
        const bool whole = std::none_of(offsets_.begin(), offsets_.end(), [&](double offset) {
            return std::any_of(kSamples.begin(), kSamples.end(),
                               [&](double t) { return endsAtCentre(piece.curve, t, offset); });
        });
        if (whole && offsets_.size() == 2) {
            addWholeStrip(piece);
            return;
        }
        for (std::size_t side = 0; side < offsets_.size(); ++side) {
            addHalfStrip(piece, side);
            if (style_.swept && endsAtCentre(piece.curve, 0.5, offsets_[side])) {
                addBeyondCentres(piece, offsets_[side]);
            }
        }
    }

    /// Adds the area that the line across a piece sweeps beyond the centres of curvature.
    void addBeyondCentres(const Piece &piece, double offset) {
        const Curve &curve = piece.curve;
        const auto full = [&](double t) { return curve.point(t) + offset * leftNormal(curve.tangent(t)); };
        const Vec2 a = moved(curve, 0.0, offset), b = moved(curve, 1.0, offset), c = full(1.0), d = full(0.0);
        Curve back; // the pieces of other curves turn little
        if (isCircular(curve)) {
            const auto n = curve.numbers();
            const double scale = -distance(a, d) / length({n[2], n[3]});
            back =
                Curve::arc({n[0], n[1]}, scale * Vec2{n[2], n[3]}, scale * Vec2{n[4], n[5]}, n[6], n[7]).part(1.0, 0.0);
        }
        if (distance(a, b) > kTiny * reach_) {
            add({a, b, c, d}, {Curve(), Curve(), back, Curve()}, piece.segment);
        } else {
            add({a, c, d}, {Curve(), back, Curve()}, piece.segment);
        }
    }

    Vec2 sideStart(const Piece &piece, std::size_t side) const {
        return piece.startTips[side].value_or(moved(piece.curve, 0.0, offsets_[side]));
    }
    Vec2 sideEnd(const Piece &piece, std::size_t side) const {
        return piece.endTips[side].value_or(moved(piece.curve, 1.0, offsets_[side]));
    }

    /// Returns a side of a piece, between its tips; a line for a straight piece.
    Curve sideOf(const Piece &piece, std::size_t side) const {
        const Curve exact = parallel(piece.curve, offsets_[side]);
        if (piece.isStraight() || !(piece.startTips[side] || piece.endTips[side])) {
            return exact;
        }
        const Vec2 start = sideStart(piece, side), end = sideEnd(piece, side);
        const auto n = exact.numbers();
        if (exact.kind() == CurveKind::Arc) { // pieces turn by less than half a turn
            const bool left = n[7] * cross({n[2], n[3]}, {n[4], n[5]}) > 0.0;
            return arcBetween(start, end, length({n[2], n[3]}), left);
        }
        return Curve::cubic(start, start + (Vec2{n[2], n[3]} - Vec2{n[0], n[1]}),
                            end + (Vec2{n[4], n[5]} - Vec2{n[6], n[7]}), end);
    }

    /// Returns the arc of a circle of less than half a turn between two points, which turns to the left or right.
    static Curve arcBetween(Vec2 start, Vec2 end, double radius, bool left) {
        const double half = std::min(0.5 * distance(start, end), radius), side = left ? 1.0 : -1.0;
        const Vec2 across = (side / (2.0 * half)) * leftNormal(end - start);
        const Vec2 centre = midpoint(start, end) + std::sqrt(radius * radius - half * half) * across;
        const Vec2 u = start - centre;
        return Curve::arc(centre, u, leftNormal(u), 0.0, side * 2.0 * std::asin(half / radius));
    }

    void addWholeStrip(const Piece &piece) {
        std::vector<Vec2> nodes{sideStart(piece, 0), sideEnd(piece, 0)};
        std::vector<Curve> curves{sideOf(piece, 0), Curve()};
        if (piece.endTips[0] || piece.endTips[1]) {
            nodes.push_back(piece.curve.point(1.0));
            curves.emplace_back();
        }
        nodes.insert(nodes.end(), {sideEnd(piece, 1), sideStart(piece, 1)});
        curves.insert(curves.end(), {sideOf(piece, 1).part(1.0, 0.0), Curve()});
        if (piece.startTips[0] || piece.startTips[1]) {
            nodes.push_back(piece.curve.point(0.0));
            curves.emplace_back();
        }
        add(std::move(nodes), std::move(curves), piece.segment);
    }

    /// Adds the strip between a piece and one of its sides.
    void addHalfStrip(const Piece &piece, std::size_t side) {
        const Vec2 a = piece.curve.point(0.0), b = piece.curve.point(1.0);
        const Vec2 c = sideEnd(piece, side), d = sideStart(piece, side);
        if (distance(c, d) > kTiny * reach_) {
            add({a, b, c, d}, {piece.curve, Curve(), sideOf(piece, side).part(1.0, 0.0), Curve()}, piece.segment);
        } else {
            add({a, b, c}, {piece.curve, Curve(), Curve()}, piece.segment);
        }
    }

    /// Returns true if the path turns so little between two pieces, usually because a file has rounded its coordinates,
    /// that their sides can be joined without a wedge, which would be tiny. The error is of second order in the turn.
    bool isSmooth(const Piece &before, const Piece &after) const {
        constexpr double kMaxTurn = 0.02; // radians
        const Vec2 a = before.curve.tangent(1.0), b = after.curve.tangent(0.0);
        const double turn = std::fabs(cross(a, b));
        return offsets_.size() == 2 && dot(a, b) > 0.0 && turn <= kMaxTurn &&
               turn * turn * reach_ <= 8.0 * style_.accuracy * size_;
    }

    /// Lets two pieces share the node between their sides at an offset: that of a curve beside a line, that of an arc
    /// beside another curve, otherwise one in the middle. Returns false, and changes nothing, if a side is too short.
    bool joinSides(Piece &before, Piece &after, std::size_t side) const {
        const double offset = offsets_[side];
        if (endsAtCentre(before.curve, 1.0, offset) || endsAtCentre(after.curve, 0.0, offset)) {
            return false;
        }
        const auto rank = [](const Piece &piece) { return piece.isStraight() ? 0 : isCircular(piece.curve) ? 2 : 1; };
        const Vec2 normals = leftNormal(before.curve.tangent(1.0) + after.curve.tangent(0.0));
        const Vec2 node = rank(before) > rank(after)   ? moved(before.curve, 1.0, offset)
                          : rank(before) < rank(after) ? moved(after.curve, 0.0, offset)
                                                       : after.curve.point(0.0) + (offset / length(normals)) * normals;
        const auto reaches = [&](const Piece &piece, Vec2 end) {
            constexpr double kMaxShift = 0.25; // fraction of the side
            const double size = distance(moved(piece.curve, 0.0, offset), moved(piece.curve, 1.0, offset));
            return distance(node, end) <= kMaxShift * size;
        };
        if (!reaches(before, moved(before.curve, 1.0, offset)) || !reaches(after, moved(after.curve, 0.0, offset))) {
            return false;
        }
        before.endTips[side] = after.startTips[side] = node;
        return true;
    }

    /// Fills the gap between the strips of two pieces where the path turns away from the offset side.
    void addWedge(Piece &before, Piece &after, std::size_t side, BandCorner corner) {
        const double offset = offsets_[side];
        const Vec2 a = before.curve.tangent(1.0), b = after.curve.tangent(0.0);
        double turn = std::atan2(cross(a, b), dot(a, b));
        if (std::fabs(turn) > std::numbers::pi - kStraight) {
            turn = std::copysign(std::numbers::pi, -offset); // a spike counts as turning away
        }
        if (turn * offset >= 0.0 || std::fabs(turn) <= kStraight) {
            return;
        }
        const Vec2 node = after.curve.point(0.0), arm = offset * leftNormal(a), next = offset * leftNormal(b);
        const double cosine = std::cos(0.5 * turn);
        if (corner == BandCorner::Round) {
            const Curve arc = Curve::arc(node, arm, leftNormal(arm), 0.0, turn);
            add({node, node + arm, arc.point(1.0)}, {Curve(), arc, Curve()}, before.segment);
        } else if (corner == BandCorner::Miter && cosine * style_.miterLimit >= 1.0) {
            const Vec2 tip = node + (0.5 / (cosine * cosine)) * (arm + next);
            addMiter(before, before.endTips[side], node, arm, tip);
            addMiter(after, after.startTips[side], node, next, tip);
        } else if (cosine > kStraight) {
            add({node, node + arm, node + next}, {Curve(), Curve(), Curve()}, before.segment);
        }
    }

    /// Adds the half of a miter that belongs to a piece.
    void addMiter(const Piece &piece, std::optional<Vec2> &tipOfPiece, Vec2 node, Vec2 arm, Vec2 tip) {
        if (piece.isStraight() && offsets_.size() == 2) {
            tipOfPiece = tip;
        } else {
            add({node, node + arm, tip}, {Curve(), Curve(), Curve()}, piece.segment);
        }
    }

    void add(std::vector<Vec2> nodes, std::vector<Curve> curves, std::uint32_t segment) {
        parts_.push_back({std::move(nodes), std::move(curves), segment});
    }

    static constexpr std::array kSamples = {0.25, 0.5, 0.75};

    std::span<const double> offsets_;
    BandStyle style_;
    double reach_ = 0.0; ///< maximum distance from the path
    double size_ = 0.0;  ///< of the result, about
    int checks_ = 0;     ///< number of pieces tested so far
    std::vector<Piece> pieces_;
    std::vector<BandPart> parts_;
};

} // namespace

std::vector<BandPart> bandsBeside(std::span<const Curve> path, bool closed, std::span<const double> offsets,
                                  const BandStyle &style) {
    return BandMaker(path, closed, offsets, style).take();
}

BandPart roundEnd(Vec2 end, Vec2 arm, bool forward) {
    const Curve arc = Curve::arc(end, arm, leftNormal(arm), 0.0, forward ? -std::numbers::pi : std::numbers::pi);
    return {{end + arm, end - arm}, {arc, Curve()}, 0};
}

} // namespace forefront
