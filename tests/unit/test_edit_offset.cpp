#include "core/drawing/commands/offset_shapes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

using std::numbers::pi;

/// Returns the offset shapes of a shape.
std::vector<Shape> offsetsOf(const Shape &shape, double d) {
    const Result<Document> document = addShape({}, shape);
    REQUIRE(document.ok());
    const Result<Document> result = offsetShapes(*document, {1}, d);
    REQUIRE(result.ok());
    std::vector<Shape> made;
    for (std::size_t k = 1; k < result->shapes.size(); ++k) {
        made.push_back(*result->shapes[k]);
    }
    return made;
}

/// Measures distances to an outline.
class OffsetRuler {
  public:
    explicit OffsetRuler(const Outline &outline) {
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            curves_.push_back(outline.curve(k));
            for (int i = 0; i <= kParts; ++i) {
                places_.push_back(curves_.back().point(i / double{kParts}));
            }
        }
    }

    double distanceTo(Vec2 p) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec2 place : places_) {
            least = std::min(least, distance(place, p));
        }
        double refined = least;
        for (std::size_t k = 0; k < curves_.size(); ++k) {
            for (int i = 0; i < kParts; ++i) {
                const std::size_t at = k * (kParts + 1) + static_cast<std::size_t>(i);
                if (std::min(distance(places_[at], p), distance(places_[at + 1], p)) < 1.01 * least) {
                    const double t = curves_[k].nearest(p, i / double{kParts}, (i + 1) / double{kParts});
                    refined = std::min(refined, distance(curves_[k].point(t), p));
                }
            }
        }
        return refined;
    }

  private:
    static constexpr int kParts = 128;
    std::vector<Curve> curves_;
    std::vector<Vec2> places_;
};

/// Returns the maximum distance of some outlines from the exact offset of a shape.
double worstMiss(const std::vector<Shape> &made, const Shape &shape, double d) {
    const OffsetRuler from(outlineOf(shape));
    double worst = 0.0;
    for (const Shape &piece : made) {
        const Outline outline = outlineOf(piece);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            for (const double t : {0.0, 0.3, 0.5, 0.8}) {
                worst = std::max(worst, std::fabs(from.distanceTo(outline.curve(k).point(t)) - std::fabs(d)));
            }
        }
    }
    return worst;
}

Shape ellipse(double a, double b) {
    return makeShape(ShapeKind::Ellipse, {{0, 0}, {a, 0}, {0, b}});
}

Shape openCubic(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    Shape path = makeShape(ShapeKind::Polyline, {a, d});
    path.path().curves = {Curve::cubic(a, b, c, d)};
    return path;
}

} // namespace

TEST_CASE("offsetShapes: parallels of slender ellipses are accurate outside and inside") {
    const struct {
        double a, b, d;
    } cases[] = {{3, 2, -1.5}, {1, 0.05, 0.5}, {1, 0.05, -0.03}, {1, 0.01, 0.5}, {1, 0.01, -0.008}};
    for (const auto &test : cases) {
        CAPTURE(test.b);
        CAPTURE(test.d);
        const Shape shape = ellipse(test.a, test.b);
        const std::vector<Shape> made = offsetsOf(shape, test.d);
        REQUIRE(made.size() == 1);
        CHECK(worstMiss(made, shape, test.d) < 1e-6 * (test.a + std::fabs(test.d)));
        CHECK(made[0].nodes.size() < 600);
        if (test.d > 0.0) {
            const double steiner = areaOf(shape) + test.d * lengthOf(shape) + pi * test.d * test.d;
            CHECK(areaOf(made[0]) == doctest::Approx(steiner).epsilon(1e-6));
        }
    }
}

TEST_CASE("offsetShapes: the band around a cubic is round at a cusp or near-cusp") {
    for (const double gap : {0.0, 1e-6, 0.1}) {
        CAPTURE(gap);
        const Shape path = openCubic({0, 0}, {1 + gap, 1}, {0, 1}, {1, 0});
        const std::vector<Shape> made = offsetsOf(path, 0.1);
        REQUIRE(made.size() == 1);
        CHECK(worstMiss(made, path, 0.1) < 1e-6);
        const Vec2 top = path.path().curves[0].point(0.5); // here it turns back
        CHECK(contains(made[0], top + Vec2{0, 0.099}));
        CHECK_FALSE(contains(made[0], top + Vec2{0, 0.101}));
    }
}

TEST_CASE("offsetShapes: coinciding nodes make no notches") {
    const std::vector<Vec2> corners = {{0, 0}, {4, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}, {0, 0}};
    const Shape plate = makeShape(ShapeKind::Polygon, corners);
    const std::vector<Shape> wide = offsetsOf(plate, 0.5);
    REQUIRE(wide.size() == 1);
    CHECK(areaOf(wide[0]) == doctest::Approx(16.0 + 16.0 * 0.5 + 0.25 * pi));
    const std::vector<Shape> narrow = offsetsOf(plate, -0.5);
    REQUIRE(narrow.size() == 1);
    CHECK(areaOf(narrow[0]) == doctest::Approx(9.0));
    const std::vector<Shape> band = offsetsOf(makeShape(ShapeKind::Polyline, corners), 0.5);
    CHECK(worstMiss(band, makeShape(ShapeKind::Polyline, corners), 0.5) < 1e-9);
}

TEST_CASE("offsetShapes: an outline may have either direction and may cross itself") {
    Shape lens = makeShape(ShapeKind::Polygon, {{0, 0}, {1, 0}}); // flat, and clockwise
    lens.path().curves = {arcThrough({0, 0}, {0.5, 5e-4}, {1, 0}), arcThrough({1, 0}, {0.5, -5e-4}, {0, 0})};
    const std::vector<Shape> wide = offsetsOf(lens, 0.1);
    REQUIRE(wide.size() == 1);
    CHECK(areaOf(wide[0]) == doctest::Approx(areaOf(lens) + 0.1 * lengthOf(lens) + 0.01 * pi));
    const std::vector<Shape> thin = offsetsOf(lens, -1e-4);
    REQUIRE(thin.size() == 1);
    CHECK(areaOf(thin[0]) < areaOf(lens));
    const Shape bow = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    const std::vector<Shape> around = offsetsOf(bow, 0.25);
    REQUIRE(around.size() == 1);
    CHECK(worstMiss(around, bow, 0.25) < 1e-9);
    CHECK(areaOf(around[0]) > 8.0);
    const std::vector<Shape> inside = offsetsOf(bow, -0.25);
    REQUIRE(inside.size() == 2);
    CHECK(worstMiss(inside, bow, 0.25) < 1e-9);
}

TEST_CASE("offsetShapes: only an inward offset that leaves nothing asks for a smaller number") {
    const Result<Document> plate = addShape({}, square({0, 0}, 4));
    const Result<Document> nothing = offsetShapes(*plate, {1}, -2.5);
    REQUIRE_FALSE(nothing.ok());
    CHECK(nothing.faults().front().message.starts_with("nothing is left of polygon 1"));
    const Result<Document> far = offsetShapes(*plate, {1}, 1e200);
    REQUIRE_FALSE(far.ok());
    CAPTURE(far.faults().front().message);
    CHECK_FALSE(far.faults().front().message.starts_with("nothing is left"));
}
