#include "core/engine/geometry/elliptical_arc.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace forefront;

namespace {

std::vector<Vec2> flattened(const Curve &curve, double tolerance) {
    std::vector<Vec2> nodes{curve.point(0.0)};
    for (const double t : curve.flatten(tolerance)) {
        nodes.push_back(curve.point(t));
    }
    return nodes;
}

} // namespace

TEST_CASE("polygon: the area of a small square far from the origin keeps its digits") {
    const double o = 1e9;
    const std::vector<Vec2> square{{o, o}, {o + 0.5, o}, {o + 0.5, o + 0.5}, {o, o + 0.5}};
    CHECK(signedArea(square) == 0.25);
    CHECK(perimeter(square) == 2.0);
    CHECK(signedArea(std::vector<Vec2>{square.rbegin(), square.rend()}) == -0.25);
    CHECK(signedArea(std::vector<Vec2>{{0, 0}, {1, 1}}) == 0.0);
}

TEST_CASE("polygon: a point is located inside, outside or on the boundary exactly") {
    const std::vector<Vec2> diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    CHECK(locate(diamond, {0, 0}) == PointPlace::Inside);
    CHECK(locate(diamond, {-2, 0}) == PointPlace::Outside); // the ray runs through two corners
    CHECK(locate(diamond, {-2, 1}) == PointPlace::Outside);
    CHECK(locate(diamond, {1, 0}) == PointPlace::OnBoundary);
    CHECK(locate(diamond, {0, 1}) == PointPlace::OnBoundary);
    CHECK(locate(diamond, {0.5, 0.5}) == PointPlace::OnBoundary);
    CHECK(locate(diamond, {std::nextafter(0.5, 0.0), 0.5}) == PointPlace::Inside);
    CHECK(locate(diamond, {std::nextafter(0.5, 1.0), 0.5}) == PointPlace::Outside);
    const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    CHECK(locate(square, {1, 0}) == PointPlace::OnBoundary);
    CHECK(locate(square, {3, 0}) == PointPlace::Outside);
    CHECK(locate(square, {-1, 2}) == PointPlace::Outside);
}

TEST_CASE("polygon: a compensated sum keeps what a plain sum loses") {
    CompensatedSum sum;
    for (const double value : {1.0, 1e100, 1.0, -1e100}) {
        sum.add(value);
    }
    CHECK(sum.value() == 2.0);
}

TEST_CASE("elliptical arc: the four arcs between two points have the right centre, side and length") {
    const double r = 5.0;
    const Vec2 start{0, 3}, end{0, -3}; // half chord 3, so the centres are at (-4, 0) and (4, 0)
    for (const bool large : {false, true}) {
        for (const bool sweep : {false, true}) {
            const Curve arc = curveOf(start, {r, r, 30.0, large, sweep}, end);
            const std::vector<Vec2> nodes = flattened(arc, 1e-4);
            // With increasing angle from (0, 3) down to (0, -3) the short arc bulges to the left, about (4, 0).
            const Vec2 centre{large == sweep ? -4.0 : 4.0, 0.0};
            double way = 0.0;
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                CHECK(std::fabs(distance(nodes[i], centre) - r) < 1e-12);
                way += distance(nodes[i], nodes[i + 1]);
            }
            const double half = std::asin(3.0 / 5.0);
            CHECK(way == doctest::Approx(r * (large ? 2.0 * std::numbers::pi - 2.0 * half : 2.0 * half)).epsilon(1e-3));
            CHECK(cross(nodes[0] - centre, nodes[1] - centre) * (sweep ? 1.0 : -1.0) > 0.0);
            CHECK(distance(nodes.front(), start) < 1e-14);
            CHECK(distance(nodes.back(), end) < 1e-14);
        }
    }
}

TEST_CASE("elliptical arc: radii that are too small are enlarged; an arc without radius is a line") {
    for (const Vec2 p : flattened(curveOf({0, 0}, {1, 2, 0, false, true}, {8, 0}), 1e-3)) { // 4 and 8 about (4, 0)
        CHECK(std::hypot((p.x - 4.0) / 4.0, p.y / 8.0) == doctest::Approx(1.0));
    }
    CHECK(curveOf({0, 0}, {0, 2, 0, false, true}, {8, 0}) == Curve::line({0, 0}, {8, 0}));
    CHECK(curveOf({8, 0}, {3, 2, 0, true, true}, {8, 0}) == Curve::line({8, 0}, {8, 0}));
}

TEST_CASE("elliptical arc: extreme input gives a curve with finite numbers") {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {infinity, nan, 1e308, -1e308, 0.0, 5e-324}) {
        for (const double tolerance : {1e-300, 0.0, 1.0, nan}) {
            for (const Curve &curve : {curveOf({0, 1}, {bad, 1, 20, true, true}, {2, 2}),
                                       curveOf({0, 1}, {1, 1, bad, true, true}, {2, 2})}) {
                CHECK(curve.finite());
                CHECK(curve.flatten(tolerance).size() <= Curve::kMaxPieces);
            }
        }
    }
}
