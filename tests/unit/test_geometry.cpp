#include "core/geometry/curves.hpp"
#include "core/geometry/polygon.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

using namespace forefront;

namespace {

double greatestDistance(const std::vector<Vec2> &polyline, const std::vector<Vec2> &points) {
    double maximum = 0.0;
    for (const Vec2 p : points) {
        double minimum = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
            minimum = std::min(minimum, distanceToSegment(polyline[i], polyline[i + 1], p));
        }
        maximum = std::max(maximum, minimum);
    }
    return maximum;
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

TEST_CASE("curves: a flattened cubic stays within the tolerance and ends exactly") {
    const Vec2 a{0, 0}, b{3, 7}, c{-2, 7}, d{1.1, 0.3};
    std::vector<Vec2> exact;
    for (int i = 0; i <= 1000; ++i) {
        const double t = i / 1000.0, s = 1.0 - t;
        exact.push_back(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
    }
    for (const double tolerance : {1.0, 0.1, 1e-3, 1e-5}) {
        std::vector<Vec2> nodes{a};
        flattenCubic(a, b, c, d, tolerance, nodes);
        CHECK(greatestDistance(nodes, exact) <= tolerance);
        CHECK(nodes.back() == d);
        CHECK(nodes.size() < 8 + 10 / std::sqrt(tolerance));
    }
}

TEST_CASE("curves: a flattened quadratic stays within the tolerance; a straight one is one segment") {
    const Vec2 a{5, 5}, b{8, 9}, c{12, 5};
    std::vector<Vec2> exact;
    for (int i = 0; i <= 1000; ++i) {
        const double t = i / 1000.0, s = 1.0 - t;
        exact.push_back(s * s * a + 2.0 * s * t * b + t * t * c);
    }
    std::vector<Vec2> nodes{a};
    flattenQuadratic(a, b, c, 1e-3, nodes);
    CHECK(greatestDistance(nodes, exact) <= 1e-3);
    std::vector<Vec2> straight{a};
    flattenQuadratic(a, {6, 5}, {7, 5}, 1e-3, straight);
    CHECK(straight == std::vector<Vec2>{a, {7, 5}});
}

TEST_CASE("curves: the four arcs between two points have the right centre, side and length") {
    const double r = 5.0;
    const Vec2 start{0, 3}, end{0, -3}; // half chord 3, so the centres are at (-4, 0) and (4, 0)
    for (const bool large : {false, true}) {
        for (const bool sweep : {false, true}) {
            std::vector<Vec2> nodes{start};
            flattenArc(start, {r, r, 30.0, large, sweep}, end, 1e-4, nodes);
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
            CHECK(nodes.back() == end);
        }
    }
}

TEST_CASE("curves: radii that are too small are enlarged; an arc without radius is a line") {
    std::vector<Vec2> nodes{{0, 0}};
    flattenArc({0, 0}, {1, 2, 0, false, true}, {8, 0}, 1e-3, nodes);
    for (const Vec2 p : nodes) { // radii 4 and 8 about (4, 0)
        CHECK(std::hypot((p.x - 4.0) / 4.0, p.y / 8.0) == doctest::Approx(1.0));
    }
    std::vector<Vec2> line{{0, 0}};
    flattenArc({0, 0}, {0, 2, 0, false, true}, {8, 0}, 1e-3, line);
    CHECK(line == std::vector<Vec2>{{0, 0}, {8, 0}});
    flattenArc({8, 0}, {3, 2, 0, true, true}, {8, 0}, 1e-3, line);
    CHECK(line.size() == 2);
}

TEST_CASE("curves: extreme input neither hangs nor makes too many nodes") {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {infinity, nan, 1e308, -1e308, 0.0, 5e-324}) {
        for (const double tolerance : {1e-300, 0.0, 1.0, nan}) {
            std::vector<Vec2> nodes;
            flattenCubic({0, 0}, {bad, 1}, {1, -bad}, {1, 1}, tolerance, nodes);
            flattenQuadratic({1, 1}, {bad, bad}, {0, 1}, tolerance, nodes);
            flattenArc({0, 1}, {bad, 1, 20, true, true}, {2, 2}, tolerance, nodes);
            flattenArc({0, 1}, {1, 1, bad, true, true}, {2, 2}, tolerance, nodes);
            CHECK(nodes.size() <= 4U * kMaxCurveSegments);
            CHECK(nodes.back() == Vec2{2, 2});
            CHECK(circlePolygon({0, 0}, {bad, 0}, tolerance).size() <= kMaxCurveSegments);
        }
    }
}

TEST_CASE("curves: the polygon of a circle stays within the tolerance") {
    for (const double tolerance : {0.5, 0.01, 1e-4}) {
        const auto polygon = circlePolygon({1, 2}, {4, 6}, tolerance);
        CHECK(polygon.front() == Vec2{4, 6});
        CHECK(signedArea(polygon) > 0.0);
        CHECK(polygon.size() >= 8);
        const Vec2 middle = midpoint(polygon[0], polygon[1]);
        CHECK(5.0 - distance(middle, {1, 2}) <= tolerance);
    }
    CHECK(circlePolygon({0, 0}, {1, 0}, 1e-4).size() == 223); // pi / acos(1 - 1e-4) = 222.14
}
