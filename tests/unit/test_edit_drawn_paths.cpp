#include "core/drawing/commands/drawn_paths.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace forefront;

TEST_CASE("splineThrough: passes through the points with one tangent on both sides, open or closed") {
    const std::vector<Vec2> points{{0, 0}, {2, 1}, {3, 4}, {-1, 5}, {-2, 2}};
    for (const bool closed : {false, true}) {
        CAPTURE(closed);
        const std::vector<Curve> curves = splineThrough(points, closed);
        REQUIRE(curves.size() == (closed ? 5 : 4));
        for (std::size_t k = 0; k < curves.size(); ++k) {
            CHECK(curves[k].point(0.0) == points[k]);
            CHECK(curves[k].point(1.0) == points[(k + 1) % points.size()]);
            if (closed || k + 1 < curves.size()) {
                const Vec2 a = curves[k].tangent(1.0), b = curves[(k + 1) % curves.size()].tangent(0.0);
                CHECK(distance(a, b) < 1e-12);
            }
        }
    }
    CHECK(splineThrough({}, false).empty());
    CHECK(splineThrough(std::vector<Vec2>{{0, 0}, {1, 1}}, false) == std::vector<Curve>{Curve()});
    for (const Curve &straight : splineThrough(std::vector<Vec2>{{0, 0}, {1, 0}, {5, 0}}, false)) {
        CHECK(straight.deviation() < 1e-12);
    }
}

TEST_CASE("simplified: a line drawn by hand keeps few points, none of them farther away than the tolerance") {
    std::vector<Vec2> hand;
    for (int k = 0; k <= 400; ++k) {
        const double t = 0.01 * k;
        hand.push_back({t, std::sin(2.0 * t) + 0.002 * std::sin(97.0 * t)});
    }
    const std::vector<Vec2> few = simplified(hand, 0.02);
    CHECK(few.size() < 30);
    CHECK(few.front() == hand.front());
    CHECK(few.back() == hand.back());
    for (const Vec2 point : hand) {
        double nearest = 1.0;
        for (std::size_t k = 0; k + 1 < few.size(); ++k) {
            nearest = std::min(nearest, distanceToSegment(few[k], few[k + 1], point));
        }
        CHECK(nearest <= 0.02);
    }
    CHECK(simplified(std::vector<Vec2>{{1, 2}}, 0.1).size() == 1);
}
