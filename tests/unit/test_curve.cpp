#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/curved_bounds.hpp"
#include "core/engine/geometry/curve.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace forefront;
using forefront::testing::RandomSource;

namespace {

using std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 randomPoint(RandomSource &random) {
    return {random.between(-5, 5), random.between(-5, 5)};
}

Curve randomCurve(RandomSource &random, int kind) {
    switch (kind % 4) {
    case 0:
        return Curve::cubic(randomPoint(random), randomPoint(random), randomPoint(random), randomPoint(random));
    case 1:
        return Curve::arc(randomPoint(random), randomPoint(random), randomPoint(random), random.between(-4, 4),
                          random.between(-6.2, 6.2));
    case 2:
        return Curve::circle(randomPoint(random), randomPoint(random));
    default:
        return Curve::line(randomPoint(random), randomPoint(random));
    }
}

std::vector<Vec2> sampledPoints(const Curve &curve, double t0, double t1, int count) {
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i) {
        points.push_back(curve.point(std::lerp(t0, t1, static_cast<double>(i) / count)));
    }
    return points;
}

double polylineLength(const std::vector<Vec2> &points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        sum += distance(points[i - 1], points[i]);
    }
    return sum;
}

} // namespace

TEST_CASE("curve: points of a cubic are those of its Bernstein form") {
    const Vec2 a{0, 1}, b{4, 7}, c{-3, 5}, d{2, -1};
    const Curve cubic = Curve::cubic(a, b, c, d);
    for (int i = 0; i <= 16; ++i) {
        const double t = i / 16.0, s = 1.0 - t;
        const Vec2 p = s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
        CHECK(distance(cubic.point(t), p) < 1e-14);
    }
    CHECK(cubic.point(0.0) == a);
    CHECK(cubic.point(1.0) == d);
}

TEST_CASE("curve: a quadratic raised to a cubic has the points of the quadratic") {
    const Vec2 a{5, 5}, b{8, 9}, c{12, 5};
    const Curve raised = Curve::quadratic(a, b, c);
    for (const double t : {0.0, 0.1, 0.5, 0.75, 1.0}) {
        const double s = 1.0 - t;
        CHECK(distance(raised.point(t), s * s * a + 2.0 * s * t * b + t * t * c) < 1e-14);
    }
}

TEST_CASE("curve: points of an elliptical arc satisfy the equation of the ellipse") {
    const double phi = 0.4;
    const Vec2 axis{std::cos(phi), std::sin(phi)};
    const Curve arc = Curve::arc({3, -2}, 5.0 * axis, 2.0 * leftNormal(axis), 0.3, -4.0);
    for (int i = 0; i <= 20; ++i) {
        const Vec2 arm = arc.point(i / 20.0) - Vec2{3, -2};
        const double x = dot(arm, axis) / 5.0, y = dot(arm, leftNormal(axis)) / 2.0;
        CHECK(x * x + y * y == doctest::Approx(1.0).epsilon(1e-14));
    }
    CHECK(distance(Curve::circle({1, 1}, {4, 5}).point(0.25), {-3, 4}) < 1e-14);
}

TEST_CASE("curve: derivatives, tangent and curvature agree with finite differences") {
    RandomSource random(1);
    for (int i = 0; i < 400; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t = random.between(0.05, 0.95), h = 1e-4;
        const Vec2 before = curve.point(t - h), at = curve.point(t), after = curve.point(t + h);
        const Vec2 first = (0.5 / h) * (after - before);
        const Vec2 second = (1.0 / (h * h)) * (after - 2.0 * at + before);
        CHECK(distance(curve.derivative(t), first) < 1e-5);
        CHECK(distance(curve.secondDerivative(t), second) < 1e-4 * (1.0 + length(second)));
        if (length(first) > 0.5) {
            CHECK(distance(curve.tangent(t), (1.0 / length(first)) * first) < 1e-4);
        }
    }
}

TEST_CASE("curve: the tangent is defined where the derivative vanishes") {
    const Curve bothEnds = Curve::cubic({0, 0}, {0, 0}, {3, 4}, {3, 4}); // a line
    CHECK(distance(bothEnds.tangent(0.0), {0.6, 0.8}) < 1e-14);
    CHECK(distance(bothEnds.tangent(1.0), {0.6, 0.8}) < 1e-14);
    const Curve cusp = Curve::cubic({-1, 0}, {1, 1}, {-1, 1}, {1, 0}); // turns back at t = 1/2
    CHECK(length(cusp.derivative(0.5)) < 1e-14);
    CHECK(length(cusp.tangent(0.5)) == doctest::Approx(1.0));
    const Curve triple = Curve::cubic({0, 0}, {0, 0}, {0, 0}, {0, 2});
    CHECK(triple.tangent(0.0) == Vec2{0, 1});
    const Curve point = Curve::cubic({1, 1}, {1, 1}, {1, 1}, {1, 1});
    CHECK(point.tangent(0.5) == Vec2{0, 0});
}

TEST_CASE("curve: lengths agree with fine polylines and with closed forms") {
    RandomSource random(2);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit();
        // Chords are short by O(h²), so two of them can be extrapolated.
        const double coarse = polylineLength(sampledPoints(curve, t0, t1, 4000));
        const double fine = polylineLength(sampledPoints(curve, t0, t1, 8000));
        CHECK(curve.length(t0, t1) == doctest::Approx(fine + (fine - coarse) / 3.0).epsilon(1e-7));
    }
    CHECK(Curve::circle({1, 2}, {4, 6}).length() == doctest::Approx(10.0 * pi).epsilon(1e-14));
    CHECK(Curve::line({1, 2}, {4, 6}).length(0.2, 0.6) == doctest::Approx(2.0).epsilon(1e-15));
    // The parabola y = x² from 0 to 1: (2 √5 + asinh 2) / 4.
    const Curve parabola = Curve::quadratic({0, 0}, {0.5, 0}, {1, 1});
    CHECK(parabola.length() == doctest::Approx((2.0 * std::sqrt(5.0) + std::asinh(2.0)) / 4.0).epsilon(1e-13));
    // The circumference of an ellipse with the semi-axes 2 and 1 (complete elliptic integral of the second kind).
    CHECK(Curve::arc({0, 0}, {2, 0}, {0, 1}).length() == doctest::Approx(9.6884482205476761984).epsilon(1e-12));
    // A cubic that goes along the x axis to 1.25 and back.
    CHECK(Curve::cubic({0, 0}, {2, 0}, {2, 0}, {-0.5, 0}).length() > 1.5);
}

TEST_CASE("curve: lengths beside a cusp are found although the speed is nothing but rounding errors there") {
    // Without a bound for these errors, each length below takes millions of evaluations.
    RandomSource random(9);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 origin = randomPoint(random), x = randomPoint(random), y = randomPoint(random);
        const auto at = [&](double a, double b) { return origin + a * x + b * y; };
        const Curve cusp = Curve::cubic(at(-1, 0), at(1, 1), at(-1, 1), at(1, 0)); // at t = 1/2
        const double bend = length(cusp.secondDerivative(0.5));
        for (const double h : {1e-4, 1e-6, 1e-8, 1e-9, 1e-10}) {
            CHECK(std::fabs(cusp.length(0.5 - h, 0.5 + h) - bend * h * h) <= 1e-3 * bend * h * h + 1e-14 * bend * h);
        }
    }
}

TEST_CASE("curve: turning is the sum of the angles of a fine polyline") {
    RandomSource random(3);
    for (int i = 0; i < 80; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit();
        const std::vector<Vec2> points = sampledPoints(curve, t0, t1, 20000);
        double sum = 0.0;
        for (std::size_t k = 2; k < points.size(); ++k) {
            const Vec2 in = points[k - 1] - points[k - 2], out = points[k] - points[k - 1];
            sum += std::fabs(std::atan2(cross(in, out), dot(in, out)));
        }
        CHECK(curve.turning(t0, t1) == doctest::Approx(sum).epsilon(1e-3).scale(1.0));
    }
    CHECK(Curve::circle({0, 0}, {1, 0}).turning() == doctest::Approx(2.0 * pi));
    CHECK(Curve::cubic({-1, 0}, {1, 1}, {-1, 1}, {1, 0}).turning() > pi); // the cusp counts
}

TEST_CASE("curve: the box holds the curve and touches it on all sides") {
    RandomSource random(4);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit();
        Box2 sampled;
        for (const Vec2 p : sampledPoints(curve, t0, t1, 5000)) {
            sampled.add(p);
        }
        const Box2 box = curve.bounds(t0, t1);
        CHECK(box.grown(1e-12).contains(sampled.min));
        CHECK(box.grown(1e-12).contains(sampled.max));
        CHECK(distance(box.min, sampled.min) < 1e-5);
        CHECK(distance(box.max, sampled.max) < 1e-5);
    }
    const Box2 box = Curve::circle({1, 2}, {4, 6}).bounds();
    CHECK(distance(box.min, {-4, -3}) < 1e-14);
    CHECK(distance(box.max, {6, 7}) < 1e-14);
}

TEST_CASE("curve: the deviation is the maximum distance from the chord") {
    RandomSource random(5);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit();
        double maximum = 0.0;
        for (const Vec2 p : sampledPoints(curve, t0, t1, 5000)) {
            maximum = std::max(maximum, distanceToSegment(curve.point(t0), curve.point(t1), p));
        }
        const double least = curve.turning(t0, t1) < 0.5 * pi ? maximum - 1e-12 : 0.95 * maximum;
        CHECK(curve.deviation(t0, t1) >= least);
        CHECK(curve.deviation(t0, t1) <= maximum + 1e-4);
    }
    CHECK(Curve::circle({0, 0}, {2, 0}).deviation() == doctest::Approx(4.0)); // from the point it starts and ends in
}

TEST_CASE("curve: the nearest point of a curve is found") {
    RandomSource random(10);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit(), t = std::lerp(t0, t1, random.unit());
        const Vec2 on = curve.point(t), beside = on + 1e-3 * leftNormal(curve.tangent(t));
        CHECK(distance(curve.point(curve.nearest(on, t0, t1)), on) < 1e-7);
        CHECK(distance(curve.point(curve.nearest(beside, t0, t1)), beside) <= 1.001e-3);
        CHECK(curve.nearest(curve.point(t0), t0, t1) == doctest::Approx(t0).epsilon(1e-9).scale(1.0));
    }
}

TEST_CASE("curve: on a circle, the nearest point is at the angle of the point, or an end of the part") {
    RandomSource random(11);
    for (int i = 0; i < 500; ++i) {
        const Vec2 centre = randomPoint(random), radius = randomPoint(random);
        const Vec2 across = i % 2 == 0 ? leftNormal(radius) : Vec2{} - leftNormal(radius);
        const Curve arc = Curve::arc(centre, radius, across, 20.0 * random.unit() - 10.0, 12.0 * random.unit() - 6.0);
        const double t0 = random.unit(), t1 = random.unit();
        const Vec2 p = centre + 3.0 * randomPoint(random);
        const double found = arc.nearest(p, t0, t1), gap = distance(arc.point(found), p);
        CHECK((found >= std::min(t0, t1) && found <= std::max(t0, t1)));
        for (int k = 0; k <= 200; ++k) {
            CHECK(gap <= distance(arc.point(std::lerp(t0, t1, k / 200.0)), p) + 1e-13);
        }
    }
    CHECK(std::isfinite(Curve::circle({1, 2}, {3, 4}).nearest({1, 2})));
}

TEST_CASE("curve: a part has the points of the whole, a reversed curve runs back") {
    RandomSource random(6);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit();
        const Curve part = curve.part(t0, t1), back = curve.part(1.0, 0.0);
        for (const double s : {0.0, 0.3, 0.5, 0.9, 1.0}) {
            CHECK(distance(part.point(s), curve.point(std::lerp(t0, t1, s))) < 1e-13);
            CHECK(distance(back.point(s), curve.point(1.0 - s)) < 1e-13);
        }
        CHECK(part.kind() == curve.kind());
    }
}

TEST_CASE("curve: the affine image of a curve has the images of its points") {
    RandomSource random(7);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = randomCurve(random, i);
        const Vec2 x = randomPoint(random), y = randomPoint(random), shift = randomPoint(random);
        const auto map = [&](Vec2 p) { return p.x * x + p.y * y + shift; };
        const Curve image = curve.mapped(map);
        for (const double t : {0.0, 0.2, 0.5, 0.8, 1.0}) {
            CHECK(distance(image.point(t), map(curve.point(t))) < 1e-12);
        }
    }
}

TEST_CASE("curve: a flattened curve stays within the tolerance and ends exactly") {
    RandomSource random(8);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit();
        for (const double tolerance : {1.0, 0.03, 1e-4}) {
            const std::vector<double> ends = curve.flatten(tolerance, t0, t1);
            REQUIRE(ends.back() == t1);
            double from = t0;
            for (const double to : ends) {
                double worst = 0.0;
                for (const Vec2 p : sampledPoints(curve, from, to, 20)) {
                    worst = std::max(worst, distanceToSegment(curve.point(from), curve.point(to), p));
                }
                CHECK(worst <= tolerance * (1.0 + 1e-9));
                const double mostTurn = curve.kind() == CurveKind::Cubic ? 0.5 * pi + 1e-9 : pi;
                const bool tiny = curve.bounds(from, to).diagonal() <= 0.125 * tolerance; // at a cusp
                CHECK((tiny || curve.turning(from, to) < mostTurn));
                CHECK((to > from) == (t1 > t0));
                from = to;
            }
            CHECK(ends.size() < 24.0 + 12.0 / std::sqrt(tolerance)); // the sagitta falls with the square
        }
    }
    CHECK(Curve::circle({0, 0}, {1, 0}).flatten(1e-4).size() == 223); // pi / acos(1 - 1e-4) = 222.14
    CHECK(Curve::line({0, 0}, {1, 0}).flatten(1e-4).size() == 1);
}

TEST_CASE("curve: flattened within a box, it is fine there, and elsewhere its few pieces stay outside") {
    RandomSource random(10);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = randomCurve(random, i);
        const double t0 = random.unit(), t1 = random.unit(), size = std::pow(10.0, -6.0 * random.unit());
        const Box2 box = boxAround(curve.point(std::lerp(t0, t1, random.unit())), size);
        const double tolerance = 1e-3 * size;
        const std::vector<double> ends = curve.flattenWithin(box, tolerance, t0, t1);
        REQUIRE(ends.back() == t1);
        CHECK(ends.size() < 500);
        double from = t0;
        for (const double to : ends) {
            const Box2 piece = curve.bounds(from, to);
            CHECK((!piece.overlaps(box) || curve.deviation(from, to) <= tolerance * (1.0 + 1e-6)));
            CHECK((to > from) == (t1 > t0));
            from = to;
        }
    }
    const Curve circle = Curve::circle({0, 0}, {1, 0});
    CHECK(circle.flattenWithin(boxAround({0, 0}, 9), 1e-4) == circle.flatten(1e-4)); // all of it
    CHECK(circle.flattenWithin(boxAround({9, 9}, 1), 1e-4).size() == 1);
}

TEST_CASE("curve: data that is not finite and absurd tolerances give a bounded number of pieces") {
    for (const double bad : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_FALSE(Curve::cubic({0, 0}, {bad, 1}, {1, 1}, {2, 0}).finite());
        CHECK(Curve::cubic({0, 0}, {bad, 1}, {1, 1}, {2, 0}).flatten(0.1).size() == 1);
        CHECK(Curve::arc({0, 0}, {bad, 0}, {0, 1}).flatten(0.1).size() == 1);
    }
    for (const double size : {1e-300, 1.0, 1e150}) {
        CHECK(Curve::cubic({0, 0}, {size, size}, {size, -size}, {0, 1}).flatten(1e-30).size() <= Curve::kMaxPieces);
        CHECK(Curve::arc({0, 0}, {size, 0}, {0, size}).flatten(1e-30).size() <= Curve::kMaxPieces);
        const Curve far = Curve::arc({0, 0}, {size, 0}, {0, size}, 1.0, 1e-12); // the box is finer than its rounding
        CHECK(far.flattenWithin(boxAround(far.point(0.5), 1e-20 * size), 1e-30 * size).size() < 100000);
    }
}

TEST_CASE("curve: numbers give the same curve back") {
    RandomSource random(9);
    for (int i = 0; i < 8; ++i) {
        const Curve curve = randomCurve(random, i);
        CHECK(Curve::fromNumbers(curve.kind(), curve.numbers()) == curve);
    }
}

TEST_CASE("curvedBounds: curves reach beyond their chords, but only as far as segments follow them") {
    Domain domain;
    addLoop(domain, {{0, 0}, {2, 0}, {2, 1}, {0, 1}});
    CHECK(curvedBounds(domain) == domain.bounds());
    // The right side becomes a half circle about (2, 0.5); its whole circle would reach down to 0 and up to 1 as well.
    domain.curves.push_back(Curve::circle({2, 0.5}, {2, 0}));
    domain.segments[1].stretch = {0, 0.0, 0.5};
    const Box2 box = curvedBounds(domain);
    CHECK(box.max.x == doctest::Approx(2.5).epsilon(1e-12));
    CHECK(box.min.x == 0.0);
    CHECK(box.max.y == doctest::Approx(1.0).epsilon(1e-12));
    domain.segments[1].stretch = {0, 0.0, 0.125}; // an eighth of the circle
    CHECK(curvedBounds(domain).max.x == doctest::Approx(2.0 + 0.5 * std::sqrt(0.5)).epsilon(1e-12));
    // What no reader makes, but a caller may: the nodes count alone.
    domain.segments[1].stretch = {7, 0.0, 1.0};
    CHECK(curvedBounds(domain) == domain.bounds());
    domain.segments[1].stretch = {0, 0.0, std::numeric_limits<double>::quiet_NaN()};
    CHECK(curvedBounds(domain) == domain.bounds());
}
