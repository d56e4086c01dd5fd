#include "core/drawing/commands/offset_shapes.hpp"

#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_bands.hpp"

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

/// Returns shapes that cover the band within a distance of an outline, to its left, or to its right if it is negative.
std::vector<Shape> bandsOf(const Shape &shape, double offset) {
    const Outline outline = outlineOf(shape);
    std::vector<Curve> path;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        path.push_back(outline.curve(k));
    }
    std::vector<Shape> bands;
    for (BandPart &part : bandsBeside(path, outline.closed, std::array{offset})) {
        Shape band;
        band.tag = segmentTag(shape, outline.part(part.segment));
        band.nodes = std::move(part.nodes);
        band.form = PathForm{.closed = true, .curves = std::move(part.curves)};
        bands.push_back(std::move(band));
    }
    return bands;
}

/// The disc around the end of an open path, or a point.
Shape disc(Vec2 centre, double radius, std::int32_t tag) {
    Shape shape;
    shape.form = CircleForm{};
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
    std::vector<Shape> list = bandsOf(shape, oneSide ? -distance * rotation : reach);
    if (!oneSide) {
        std::vector<Shape> right = bandsOf(shape, -reach);
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
    if (shape.is<PointForm>()) {
        return error("not-possible", "a point has no outline", "select paths, rectangles, circles, ellipses or slots");
    }
    if (shape.is<CircleForm>() && circleRadius(shape) + distance > 0.0) {
        Shape circle = shape;
        circle.nodes[1] = circle.nodes[0] +
                          ((circleRadius(shape) + distance) / circleRadius(shape)) * (shape.nodes[1] - shape.nodes[0]);
        return std::vector{circle};
    }
    if (shape.is<SlotForm>() && shape.as<SlotForm>().radius + distance > 0.0) {
        Shape slot = shape;
        slot.as<SlotForm>().radius += distance;
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
