#include "core/engine/geometry/stroke_fit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace forefront;

namespace {

constexpr double kTolerance = 2.0; // pixels, as in the editor

/// Returns the whole pixels that a pointer passes along a curve.
std::vector<Vec2> pixelsAlong(const Curve &curve, double step = 3.0) {
    std::vector<Vec2> result;
    const int count = static_cast<int>(curve.length() / step);
    for (int k = 0; k <= count; ++k) {
        const Vec2 at = curve.point(static_cast<double>(k) / count);
        result.push_back({std::round(at.x), std::round(at.y)});
    }
    return result;
}

void append(std::vector<Vec2> &stroke, const std::vector<Vec2> &more) {
    stroke.insert(stroke.end(), more.begin(), more.end());
}

/// Checks that the curves join and pass within the tolerance of all points, and returns the number of corners between
/// them.
int checkFit(const std::vector<Curve> &curves, const std::vector<Vec2> &stroke, double tolerance, bool closed) {
    REQUIRE_FALSE(curves.empty());
    for (const Vec2 point : stroke) {
        double away = 1e300;
        for (const Curve &curve : curves) {
            away = std::min(away, distance(curve.point(curve.nearest(point)), point));
        }
        CHECK(away <= tolerance * (1.0 + 1e-9));
    }
    int corners = 0;
    for (std::size_t k = closed ? 0 : 1; k < curves.size(); ++k) {
        const Curve &before = curves[(k + curves.size() - 1) % curves.size()];
        CHECK(before.point(1.0) == curves[k].point(0.0));
        corners += dot(before.tangent(1.0), curves[k].tangent(0.0)) < 1.0 - 1e-9 ? 1 : 0;
    }
    return corners;
}

} // namespace

TEST_CASE("fitStroke: a circle of pixels becomes a few cubics that join smoothly, near the circle") {
    for (const double radius : {25.0, 80.0, 300.0}) {
        CAPTURE(radius);
        const std::vector<Vec2> stroke = pixelsAlong(Curve::circle({400, 300}, {400 + radius, 300}));
        const std::vector<Curve> curves = fitStroke(stroke, kTolerance, true);
        CHECK(checkFit(curves, stroke, kTolerance, true) == 0);
        CHECK(curves.size() >= 2);
        CHECK(curves.size() <= 8);
        for (const Curve &curve : curves) {
            for (double t = 0.0; t <= 1.0; t += 0.125) {
                CHECK(std::fabs(distance(curve.point(t), {400, 300}) - radius) < kTolerance + 1.0);
            }
        }
    }
}

TEST_CASE("fitStroke: a wave becomes smooth cubics, fewer with a greater tolerance") {
    std::vector<Vec2> stroke;
    for (int x = 0; x <= 600; x += 2) {
        stroke.push_back({static_cast<double>(x), std::round(60.0 * std::sin(0.02 * x))});
    }
    const std::vector<Curve> fine = fitStroke(stroke, 1.5, false), coarse = fitStroke(stroke, 6.0, false);
    CHECK(checkFit(fine, stroke, 1.5, false) == 0);
    CHECK(checkFit(coarse, stroke, 6.0, false) == 0);
    CHECK(fine.size() <= 14);
    CHECK(coarse.size() <= fine.size());
    CHECK(fine.front().point(0.0) == stroke.front());
    CHECK(fine.back().point(1.0) == stroke.back());
}

TEST_CASE("fitStroke: sharp turns stay corners, and straight stretches become lines") {
    std::vector<Vec2> square;
    const std::vector<Vec2> corners{{103, 50}, {400, 50}, {400, 300}, {103, 300}};
    for (std::size_t k = 0; k < 4; ++k) {
        append(square, pixelsAlong(Curve::line(corners[k], corners[(k + 1) % 4])));
    }
    const std::vector<Curve> sides = fitStroke(square, kTolerance, true);
    CHECK(sides.size() == 4);
    CHECK(checkFit(sides, square, kTolerance, true) == 4);
    for (const Curve &side : sides) {
        CHECK(side.kind() == CurveKind::Line);
        CHECK(std::count(corners.begin(), corners.end(), side.point(0.0)) == 1);
    }
    std::vector<Vec2> half = pixelsAlong(Curve::arc({300, 300}, {150, 0}, {0, 150}, 0.0, std::numbers::pi));
    append(half, pixelsAlong(Curve::line({150, 300}, {450, 300})));
    const std::vector<Curve> outline = fitStroke(half, kTolerance, true);
    CHECK(checkFit(outline, half, kTolerance, true) == 2);
    CHECK(std::count_if(outline.begin(), outline.end(), [](const Curve &c) { return c.kind() == CurveKind::Line; }) ==
          1);
    CHECK(outline.size() <= 5);
    std::vector<Vec2> hairpin = pixelsAlong(Curve::line({0, 0}, {200, 0}));
    append(hairpin, pixelsAlong(Curve::line({200, 0}, {0, 20})));
    CHECK(checkFit(fitStroke(hairpin, kTolerance, false), hairpin, kTolerance, false) == 1);
}

TEST_CASE("fitStroke: few, repeated and scattered points keep the tolerance") {
    CHECK(fitStroke({}, 1.0, false).empty());
    CHECK(fitStroke(std::vector<Vec2>{{1, 2}, {1, 2}}, 1.0, true).empty());
    const std::vector<Curve> line = fitStroke(std::vector<Vec2>{{1, 2}, {1, 2}, {5, 2}}, 1.0, false);
    REQUIRE(line.size() == 1);
    CHECK(line[0] == Curve::line({1, 2}, {5, 2}));
    std::vector<Vec2> scattered;
    std::uint32_t state = 7;
    const auto next = [&] { return static_cast<double>((state = state * 1664525U + 1013904223U) >> 22U); };
    for (int k = 0; k < 300; ++k) {
        const double x = next(), y = next();
        scattered.push_back({x, y});
    }
    for (const bool closed : {false, true}) {
        for (const double tolerance : {0.5, 5.0, 50.0}) {
            CAPTURE(closed);
            CAPTURE(tolerance);
            checkFit(fitStroke(scattered, tolerance, closed), scattered, tolerance, closed);
        }
    }
}
