#include "core/edit/offset_shapes.hpp"

#include "core/base/number_text.hpp"
#include "core/edit/combine_shapes.hpp"
#include "core/edit/path_curve.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kStraight = 1e-9; ///< maximum turn, in radians, of a path at a node that needs no wedge

bool isCircular(const Curve &curve) {
    if (curve.kind() != CurveKind::Arc) {
        return false;
    }
    const auto n = curve.numbers();
    const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
    const double size = lengthSquared(u);
    return std::fabs(dot(u, v)) <= 1e-12 * size && std::fabs(lengthSquared(v) - size) <= 1e-12 * size;
}

/// Makes shapes that cover what lies within a distance of an outline, on one side of it.
class Bands {
  public:
    /// `offset` is the distance to the left of the outline, negative to the right.
    Bands(const Shape &shape, double offset) : offset_(offset) {
        const Outline outline = outlineOf(shape);
        size_ = boundsOf(shape).diagonal() + std::fabs(offset);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            divide(outline.curve(k), segmentTag(shape, outline.part(k)));
        }
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            addStrip(pieces_[k]);
            if (outline.closed || k + 1 < pieces_.size()) {
                addWedge(pieces_[k], pieces_[(k + 1) % pieces_.size()]);
            }
        }
    }

    std::vector<Shape> take() { return std::move(bands_); }

  private:
    /// A part of a segment that turns little, so that its strip does not overlap itself.
    struct Piece {
        Curve curve;
        std::int32_t tag = 1;
    };

    /// Divides a segment into pieces. Pieces of zero length are skipped: a wedge fills the gap if the path turns there.
    void divide(const Curve &curve, std::int32_t tag) {
        if (curve.kind() == CurveKind::Line || isCircular(curve)) {
            const auto count = static_cast<int>(std::max(1.0, std::ceil(curve.turning() / (0.75 * std::numbers::pi))));
            for (int k = 0; k < count; ++k) {
                keep(count > 1 ? curve.part(1.0 * k / count, (k + 1.0) / count) : curve, tag);
            }
            return;
        }
        constexpr int kParts = 4; // minimum: the ends of a loop coincide, so it would seem to have no length
        for (int k = 0; k < kParts; ++k) {
            bisect(curve, 1.0 * k / kParts, (k + 1.0) / kParts, tag);
        }
    }

    void bisect(const Curve &curve, double t0, double t1, std::int32_t tag) {
        constexpr double kCusp = 1e-12; // minimum step of the parameter; a piece that still turns within it is a cusp
        const Curve piece = curve.part(t0, t1);
        const double corner = t0 + (t1 - t0) * cornerOf(piece);
        const bool cut = corner - t0 > kCusp && t1 - corner > kCusp;
        if (!cut && (t1 - t0 <= kCusp || isFine(piece))) {
            keep(piece, tag);
            return;
        }
        const double middle = cut ? corner : 0.5 * (t0 + t1);
        bisect(curve, t0, middle, tag);
        bisect(curve, middle, t1, tag);
    }

    /// Returns the parameter of a corner of the parallel, where it begins or ceases to follow the centres of curvature;
    /// 0 if there is none.
    double cornerOf(const Curve &piece) const {
        const bool first = endsAtCentre(piece, 0.0);
        if (first == endsAtCentre(piece, 1.0)) {
            return 0.0;
        }
        double low = 0.0, high = 1.0;
        constexpr int kSteps = 53; // the bits of a double
        for (int step = 0; step < kSteps; ++step) {
            const double middle = 0.5 * (low + high);
            (endsAtCentre(piece, middle) == first ? low : high) = middle;
        }
        return high;
    }

    void keep(const Curve &piece, std::int32_t tag) {
        if (piece.bounds().diagonal() > 1e-9 * size_) {
            pieces_.push_back({piece, tag});
        }
    }

    /// Returns the curvature at a parameter of a piece; at a cusp, the curvature just beside it.
    double curvature(const Curve &piece, double t) const {
        const bool stands = length(piece.derivative(t)) <= 1e-12 * size_;
        return curvatureOf(piece, stands ? std::lerp(t, 0.5, 1e-3) : t);
    }

    /// Returns true where the offset reaches past the centre of curvature; the parallel stops there, since beyond it
    /// other points of the curve are nearer.
    bool endsAtCentre(const Curve &piece, double t) const { return curvature(piece, t) * offset_ > 1.0; }

    /// Returns true if the strip of a piece is accurate enough.
    bool isFine(const Curve &piece) {
        constexpr double kMaxTurn = 0.5, kMaxTurnAtCentres = 0.125; // radians
        constexpr double kAccuracy = 1e-7;                          // relative
        constexpr int kMaxQuestions = 50000; // limits the work where rounding errors exceed the accuracy
        constexpr std::array kSamples = {0.25, 0.5, 0.75};
        const auto atCentres =
            std::count_if(kSamples.begin(), kSamples.end(), [&](double t) { return endsAtCentre(piece, t); });
        const double turn = piece.turning();
        if (atCentres > 0) { // covers slightly too much, but other strips cover that too
            return atCentres == std::ssize(kSamples) && !(turn > kMaxTurnAtCentres);
        }
        const Curve back = parallel(piece);
        return !(turn > kMaxTurn) &&
               (++questions_ > kMaxQuestions || std::all_of(kSamples.begin(), kSamples.end(), [&](double t) {
                   return distance(back.point(t), moved(piece, t)) <= kAccuracy * size_;
               }));
    }

    /// Returns the distance of the parallel at a parameter: it ends at the centre of curvature.
    double reach(const Curve &curve, double t) const {
        return endsAtCentre(curve, t) ? 1.0 / curvature(curve, t) : offset_;
    }

    Vec2 moved(const Curve &curve, double t) const {
        return curve.point(t) + reach(curve, t) * leftNormal(curve.tangent(t));
    }

    /// Returns the parallel of a piece: exact for lines and circles.
    Curve parallel(const Curve &curve) const {
        if (curve.kind() == CurveKind::Line) {
            return Curve();
        }
        if (isCircular(curve)) {
            const auto n = curve.numbers();
            const Vec2 u{n[2], n[3]};
            const double turn = n[7] * cross(u, {n[4], n[5]}) > 0.0 ? 1.0 : -1.0;
            const double scale = 1.0 - turn * reach(curve, 0.0) / length(u);
            return Curve::arc({n[0], n[1]}, scale * u, scale * Vec2{n[4], n[5]}, n[6], n[7]);
        }
        const auto speed = [&](double t) {
            return (1.0 - reach(curve, t) * curvature(curve, t)) / 3.0 * curve.derivative(t);
        };
        const Vec2 from = moved(curve, 0.0), to = moved(curve, 1.0);
        return Curve::cubic(from, from + speed(0.0), to - speed(1.0), to);
    }

    void addStrip(const Piece &piece) {
        const Curve &curve = piece.curve;
        const Vec2 a = curve.point(0.0), b = curve.point(1.0), c = moved(curve, 1.0), d = moved(curve, 0.0);
        Curve back = parallel(curve);
        back = back.kind() == CurveKind::Line ? back : back.part(1.0, 0.0);
        const Curve along = curve.kind() == CurveKind::Line ? Curve() : curve;
        const double size = std::fabs(offset_);
        distance(c, d) > 1e-9 * size ? add({a, b, c, d}, {along, Curve(), back, Curve()}, piece.tag)
                                     : add({a, b, c}, {along, Curve(), Curve()}, piece.tag);
    }

    /// Fills the gap between the strips of two pieces where the path turns away from the offset side.
    void addWedge(const Piece &before, const Piece &after) {
        const Vec2 a = before.curve.tangent(1.0), b = after.curve.tangent(0.0);
        double turn = std::atan2(cross(a, b), dot(a, b));
        if (std::fabs(turn) > std::numbers::pi - kStraight) {
            turn = std::copysign(std::numbers::pi, -offset_); // a spike counts as turning away
        }
        if (turn * offset_ >= 0.0 || std::fabs(turn) <= kStraight) {
            return;
        }
        const Vec2 node = after.curve.point(0.0), arm = offset_ * leftNormal(a);
        const Curve arc = Curve::arc(node, arm, leftNormal(arm), 0.0, turn);
        add({node, node + arm, arc.point(1.0)}, {Curve(), arc, Curve()}, before.tag);
    }

    void add(std::vector<Vec2> nodes, std::vector<Curve> curves, std::int32_t tag) {
        Shape band;
        band.kind = ShapeKind::Polygon;
        band.tag = tag;
        band.nodes = std::move(nodes);
        band.curves = std::move(curves);
        bands_.push_back(std::move(band));
    }

    double offset_;
    double size_ = 0.0; ///< of the result, about
    int questions_ = 0;
    std::vector<Piece> pieces_;
    std::vector<Shape> bands_;
};

/// The disc around the end of an open path, or a point.
Shape disc(Vec2 centre, double radius, std::int32_t tag) {
    Shape shape;
    shape.kind = ShapeKind::Circle;
    shape.tag = tag;
    shape.nodes = {centre, centre + Vec2{radius, 0.0}};
    return shape;
}

/// Returns how many times a closed outline turns counter-clockwise: 1 or -1 if it does not cross itself, 0 if it turns
/// back on itself at a node.
int rotationOf(const Outline &outline) {
    constexpr int kParts = 32;
    std::vector<Vec2> directions;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        const int parts = outline.isCurved(k) ? kParts : 1;
        const Curve curve = outline.curve(k);
        for (int i = 0; i <= parts; ++i) {
            if (const Vec2 direction = curve.tangent(i / static_cast<double>(parts)); direction != Vec2{}) {
                directions.push_back(direction);
            }
        }
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const Vec2 a = directions[k], b = directions[(k + 1) % directions.size()];
        const double turn = std::atan2(cross(a, b), dot(a, b));
        if (std::fabs(turn) > std::numbers::pi - kStraight) {
            return 0;
        }
        sum += turn;
    }
    return static_cast<int>(std::lround(sum / (2.0 * std::numbers::pi)));
}

/// Returns the shapes whose union, or whose difference from the first, is the offset of a shape. They cover one side of
/// the outline, or both if it is unknown which one is outside; the excess lies within the shape when they are added,
/// and beyond it when they are subtracted.
std::vector<Shape> parts(const Shape &shape, double distance) {
    const double reach = std::fabs(distance);
    const int rotation = isClosed(shape) ? rotationOf(outlineOf(shape)) : 0;
    const bool oneSide = rotation == 1 || rotation == -1;
    std::vector<Shape> list = Bands(shape, oneSide ? -distance * rotation : reach).take();
    if (!oneSide) {
        std::vector<Shape> right = Bands(shape, -reach).take();
        std::move(right.begin(), right.end(), std::back_inserter(list));
    }
    if (isClosed(shape)) {
        list.insert(list.begin(), shape);
        return list;
    }
    list.push_back(disc(shape.nodes.front(), reach, shape.tag));
    list.push_back(disc(shape.nodes.back(), reach, shape.tag));
    return list;
}

Result<std::vector<Shape>> offsetOf(const Shape &shape, double distance, double tolerance) {
    if (shape.kind == ShapeKind::Point) {
        return error("not-possible", "a point has no outline", "select paths, rectangles, circles, ellipses or slots");
    }
    if (shape.kind == ShapeKind::Circle && circleRadius(shape) + distance > 0.0) {
        Shape circle = shape;
        circle.nodes[1] = circle.nodes[0] +
                          ((circleRadius(shape) + distance) / circleRadius(shape)) * (shape.nodes[1] - shape.nodes[0]);
        return std::vector{circle};
    }
    if (shape.kind == ShapeKind::Slot && shape.radius + distance > 0.0) {
        Shape slot = shape;
        slot.radius += distance;
        slot.cuts.clear();
        return std::vector{slot};
    }
    Document sketch;
    sketch.circleTolerance = tolerance;
    Result<Document> drawn = addShapes(sketch, parts(shape, distance));
    if (!drawn) {
        return drawn.faults();
    }
    const bool inside = isClosed(shape) && distance < 0.0;
    Result<Document> result =
        combineShapes(*drawn, selectAll(*drawn).shapes, inside ? ShapeOperation::Difference : ShapeOperation::Union);
    if (!result && inside && result.faults().front().code == "not-possible") {
        return error("not-possible", "nothing is left of " + displayName(shape) + " at this distance",
                     "enter a smaller number");
    }
    if (!result) {
        return result.faults();
    }
    std::vector<Shape> made;
    for (const auto &piece : result->shapes) {
        made.push_back(*piece);
        made.back().name = shape.name;
        made.back().use = shape.use;
    }
    return made;
}

} // namespace

Result<Document> offsetShapes(const Document &document, const std::set<std::uint32_t> &ids, double distance,
                              Selection *made) {
    if (!std::isfinite(distance) || distance == 0.0) {
        return error("bad-number",
                     "invalid distance " + numberText(distance, 6) + "; expected a finite number other than 0",
                     "enter a number such as 0.5; a negative one offsets inwards");
    }
    std::vector<Shape> all;
    for (const std::uint32_t id : ids) {
        const Shape *shape = findShape(document, id);
        if (shape == nullptr) {
            return error("no-such-shape", "shape not found");
        }
        Result<std::vector<Shape>> some = offsetOf(*shape, distance, document.circleTolerance);
        if (!some) {
            return some.faults();
        }
        std::move(some->begin(), some->end(), std::back_inserter(all));
    }
    if (made != nullptr) {
        made->clear();
        for (std::uint32_t k = 0; k < all.size(); ++k) {
            made->shapes.insert(document.nextId + k);
        }
    }
    return addShapes(document, std::move(all));
}

} // namespace forefront
