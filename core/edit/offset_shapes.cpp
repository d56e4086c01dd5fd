#include "core/edit/offset_shapes.hpp"

#include "core/edit/combine_shapes.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kStraight = 1e-9; ///< radians by which a path turns in a node that needs no wedge

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
    Bands(const Shape &shape, double offset) : shape_(shape), outline_(outlineOf(shape)), offset_(offset) {}

    std::vector<Shape> make() {
        const std::size_t count = outline_.segmentCount();
        for (std::size_t k = 0; k < count; ++k) {
            tag_ = segmentTag(shape_, outline_.part(k));
            addStrips(outline_.curve(k));
            if (outline_.closed || k + 1 < count) {
                addWedge(outline_.curve(k), outline_.curve((k + 1) % count));
            }
        }
        return std::move(bands_);
    }

  private:
    /// Returns the distance of the parallel at a parameter: it ends at the centre of curvature.
    double reach(const Curve &curve, double t) const {
        const Vec2 d = curve.derivative(t);
        const double speed = length(d);
        const double curvature = speed > 0.0 ? cross(d, curve.secondDerivative(t)) / (speed * speed * speed) : 0.0;
        return curvature * offset_ > 1.0 ? 1.0 / curvature : offset_;
    }

    Vec2 moved(const Curve &curve, double t) const {
        return curve.point(t) + reach(curve, t) * leftNormal(curve.tangent(t));
    }

    /// Returns the parallel of a part of a curve that turns little: exact for lines and circles.
    Curve parallel(const Curve &curve) const {
        const Vec2 from = moved(curve, 0.0), to = moved(curve, 1.0);
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
            const Vec2 d = curve.derivative(t);
            const double size = length(d);
            const double curvature = size > 0.0 ? cross(d, curve.secondDerivative(t)) / (size * size * size) : 0.0;
            return (1.0 - reach(curve, t) * curvature) / 3.0 * d;
        };
        return Curve::cubic(from, from + speed(0.0), to - speed(1.0), to);
    }

    void addStrips(const Curve &curve) {
        constexpr double kMostTurn = 0.125; // radians; the cubic is then within 1e-6 of the parallel
        const bool exact = curve.kind() == CurveKind::Line || isCircular(curve);
        const double most = exact ? 0.75 * std::numbers::pi : kMostTurn;
        const auto pieces = std::max(1.0, std::ceil(curve.turning() / most));
        for (double k = 0.0; k < pieces; ++k) {
            addStrip(pieces > 1.0 ? curve.part(k / pieces, (k + 1.0) / pieces) : curve);
        }
    }

    void addStrip(const Curve &curve) {
        const Vec2 a = curve.point(0.0), b = curve.point(1.0), c = moved(curve, 1.0), d = moved(curve, 0.0);
        Curve back = parallel(curve);
        back = back.kind() == CurveKind::Line ? back : back.part(1.0, 0.0);
        const Curve along = curve.kind() == CurveKind::Line ? Curve() : curve;
        const double size = std::fabs(offset_);
        distance(c, d) > 1e-9 * size ? add({a, b, c, d}, {along, Curve(), back, Curve()})
                                     : add({a, b, c}, {along, Curve(), Curve()});
    }

    /// Fills the gap between the strips of two segments where the path turns away from the side.
    void addWedge(const Curve &before, const Curve &after) {
        const Vec2 a = before.tangent(1.0), b = after.tangent(0.0);
        double turn = std::atan2(cross(a, b), dot(a, b));
        if (std::fabs(turn) > std::numbers::pi - kStraight) {
            turn = std::copysign(std::numbers::pi, -offset_); // a spike counts as turning away
        }
        if (turn * offset_ >= 0.0 || std::fabs(turn) <= kStraight) {
            return;
        }
        const Vec2 node = after.point(0.0), arm = offset_ * leftNormal(a);
        const Curve arc = Curve::arc(node, arm, leftNormal(arm), 0.0, turn);
        add({node, node + arm, arc.point(1.0)}, {Curve(), arc, Curve()});
    }

    void add(std::vector<Vec2> nodes, std::vector<Curve> curves) {
        Shape band;
        band.kind = ShapeKind::Polygon;
        band.tag = tag_;
        band.nodes = std::move(nodes);
        band.curves = std::move(curves);
        bands_.push_back(std::move(band));
    }

    const Shape &shape_;
    Outline outline_;
    double offset_;
    std::int32_t tag_ = 1;
    std::vector<Shape> bands_;
};

/// Returns +1 if a closed outline runs counter-clockwise, else -1.
double orientation(const Shape &shape) {
    const std::vector<Vec2> points = flattened(outlineOf(shape), 1e-3 * boundsOf(shape).diagonal());
    double sum = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        sum += cross(points[k] - points[0], points[(k + 1) % points.size()] - points[0]);
    }
    return sum < 0.0 ? -1.0 : 1.0;
}

/// The disc around the end of an open path, or a point.
Shape disc(Vec2 centre, double radius, std::int32_t tag) {
    Shape shape;
    shape.kind = ShapeKind::Circle;
    shape.tag = tag;
    shape.nodes = {centre, centre + Vec2{radius, 0.0}};
    return shape;
}

/// Returns the shapes whose union, or whose difference from the first, is the offset of a shape.
std::vector<Shape> parts(const Shape &shape, double distance) {
    if (isClosed(shape)) {
        std::vector<Shape> list = Bands(shape, -distance * orientation(shape)).make();
        list.insert(list.begin(), shape);
        return list;
    }
    std::vector<Shape> list = Bands(shape, std::fabs(distance)).make();
    std::vector<Shape> right = Bands(shape, -std::fabs(distance)).make();
    std::move(right.begin(), right.end(), std::back_inserter(list));
    list.push_back(disc(shape.nodes.front(), std::fabs(distance), shape.tag));
    list.push_back(disc(shape.nodes.back(), std::fabs(distance), shape.tag));
    return list;
}

Result<std::vector<Shape>> offsetOf(const Shape &shape, double distance, double tolerance) {
    if (shape.kind == ShapeKind::Point) {
        return error("not-possible", "a point has no outline", "select paths, rectangles, circles or ellipses");
    }
    if (shape.kind == ShapeKind::Circle && circleRadius(shape) + distance > 0.0) {
        Shape circle = shape;
        circle.nodes[1] = circle.nodes[0] +
                          ((circleRadius(shape) + distance) / circleRadius(shape)) * (shape.nodes[1] - shape.nodes[0]);
        return std::vector{circle};
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
    if (!result) {
        return error("not-possible", "nothing is left of " + displayName(shape) + " at this distance",
                     "enter a smaller number");
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
        return error("bad-number", "invalid distance; expected a number other than 0");
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
