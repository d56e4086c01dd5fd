#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_figures.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {
namespace dimension_places {

/// A driver that adds constraints and knows where their texts are.
class Dimensioner : public Draughtsman {
  public:
    explicit Dimensioner(std::vector<Shape> shapes) {
        context().document.apply(addShapes({}, std::move(shapes)).value(), "Draw");
        context().view.fit(boundsOf(document()));
        key('V');
        moveToPlace(context().view.camera.visible().max);
        settle();
    }
    void add(ConstraintKind kind, std::vector<SketchPart> parts) {
        CHECK(context().applyCommand(addConstraint(document(), kind, std::move(parts)), "Add"));
    }
    PixelRect rectOf(std::uint32_t id) {
        const std::string name = "sketch/" + std::to_string(id) + "/0";
        REQUIRE_MESSAGE(has(name), name);
        return context().widgets.find(name)->rect;
    }
    /// Returns where the texts of all dimensions are, in pixels.
    std::vector<PixelRect> texts() {
        std::vector<PixelRect> rects;
        for (const auto &constraint : document().constraints) {
            if (isDimension(constraint->kind)) {
                rects.push_back(rectOf(constraint->id));
            }
        }
        return rects;
    }
};

SketchPart side(std::uint32_t shape, std::uint32_t k = 0) {
    return {shape, SketchPartKind::Segment, k};
}

Shape formed(std::vector<Vec2> nodes, ShapeForm form) {
    Shape shape;
    shape.nodes = std::move(nodes);
    shape.form = std::move(form);
    return shape;
}

} // namespace dimension_places

using dimension_places::Dimensioner;
using dimension_places::formed;
using dimension_places::side;

TEST_CASE("Places of dimensions: outside of their shapes, on no other one, each next one further out") {
    Dimensioner driver({formed({{0, 0}, {120, 80}}, RectangleForm{10.0}), formed({{25, 40}, {33, 40}}, CircleForm{}),
                        formed({{95, 40}, {103, 40}}, CircleForm{})});
    driver.add(ConstraintKind::Distance, {side(2), side(1, 3)});
    driver.add(ConstraintKind::Distance, {side(2), side(1, 0)});
    driver.add(ConstraintKind::Distance, {side(3), side(1, 3)});
    driver.add(ConstraintKind::Distance, {side(2), side(3)});
    driver.add(ConstraintKind::Distance, {side(1, 1), side(1, 3)});
    driver.add(ConstraintKind::Distance, {side(1, 0), side(1, 2)});
    driver.settle();
    const Pixel low = driver.pixel({0, 0}), high = driver.pixel({120, 80});
    const PixelRect plate{low.x, high.y, high.x - low.x, low.y - high.y};
    const std::vector<PixelRect> texts = driver.texts();
    REQUIRE(texts.size() == 6);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        CAPTURE(i);
        const bool between = i == 3; // the two holes, of which it is outside
        CHECK(texts[i].overlaps(plate) == between);
        for (std::size_t k = i + 1; k < texts.size(); ++k) {
            CHECK_FALSE(texts[i].overlaps(texts[k]));
        }
    }
    // Lines that measure along x over the same stretch lie below one another.
    for (const auto &[first, second] : {std::pair(0, 2), std::pair(2, 4), std::pair(0, 4), std::pair(2, 3)}) {
        const double apart =
            texts[static_cast<std::size_t>(first)].centre().y - texts[static_cast<std::size_t>(second)].centre().y;
        CHECK(std::fabs(apart) >= 17.0);
    }
}

TEST_CASE("Places of dimensions: a radius points to its arc at every zoom, also after the arc has changed") {
    // Two straight sides with a half circle between them, and a slot.
    Shape path;
    path.nodes = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
    path.path().closed = true;
    path.path().curves = {Curve(), tangentArc({10, 0}, {1, 0}, {10, 6}), Curve(), Curve()};
    Dimensioner driver({path, formed({{2, 12}, {9, 12}}, SlotForm{2.0})});
    const std::array<std::pair<SketchPart, Vec2>, 3> arcs = {
        {{side(1, 1), {1, 0}}, {side(2, 1), {1, 0}}, {side(2, 3), {-1, 0}}}};
    for (const auto &[part, way] : arcs) { // one radius at a time, since the second of a slot follows from the first
        const std::shared_ptr<const Document> before = driver.context().document.current();
        driver.add(ConstraintKind::Radius, {part});
        driver.settle();
        for (const double factor : {1.0, 2.5, 0.2, 0.8}) {
            driver.context().view.camera.zoom *= factor;
            driver.settle();
            const auto figure = dimensionFigure(driver.document(), *driver.document().constraints.back());
            REQUIRE(figure);
            const std::string name = "sketch/" + std::to_string(driver.document().constraints.back()->id) + "/0";
            if (driver.has(name)) {
                const Vec2 text =
                    driver.context().view.camera.toPlane(driver.context().widgets.find(name)->rect.centre());
                CHECK(dot(text - figure->from, way) > 0.0);
            }
        }
        driver.context().view.fit(boundsOf(driver.document()));
        driver.context().document.apply(*before, "Back");
    }
}

TEST_CASE("Places of dimensions: the tip of a radius lies on its arc wherever the text is put") {
    Shape path;
    path.nodes = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
    path.path().closed = true;
    path.path().curves = {Curve(), tangentArc({10, 0}, {1, 0}, {10, 6}), Curve(), Curve()};
    const Document document =
        addShapes({}, {path, formed({{2, 12}, {9, 12}}, SlotForm{2.0}), formed({{20, 0}, {23, 0}}, CircleForm{}),
                       formed({{30, 0}, {40, 8}}, RectangleForm{2.0})})
            .value();
    for (const SketchPart part : {side(1, 1), side(2, 1), side(2, 3), side(3), side(4, 4), side(4, 6)}) {
        CAPTURE(part.shape);
        CAPTURE(part.index);
        const Document with = addConstraint(document, ConstraintKind::Radius, {part}).value();
        const auto figure = dimensionFigure(with, *with.constraints.back());
        REQUIRE(figure);
        const Outline outline = outlineOf(*findShape(document, part.shape));
        for (int k = 0; k < 24; ++k) {
            const double angle = 0.27 * k;
            const Vec2 way = figure->wayOnArc({std::cos(angle), std::sin(angle)});
            const Vec2 tip = figure->from + distance(figure->from, figure->to) * way;
            double nearest = 1e9;
            for (std::size_t s = 0; s < outline.segmentCount(); ++s) {
                if (outline.part(s) == part.index) {
                    const Curve curve = outline.curve(s);
                    nearest = std::min(nearest, distance(curve.point(curve.nearest(tip)), tip));
                }
            }
            CHECK(nearest < 1e-6);
        }
    }
}

} // namespace forefront::test
