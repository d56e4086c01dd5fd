#include "core/engine/geometry/path_curve.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace forefront;

TEST_CASE("joins: the ends of an arc are judged by its size, not by its distance from the origin") {
    const Vec2 centre{500000, 5000000};
    const Curve arc = Curve::arc(centre, {5, 0}, {0, 5}, 0.0, std::numbers::pi);
    CHECK(joins(arc, centre + Vec2{5, 0}, centre - Vec2{5, 0}));
    CHECK(joins(arc, centre + Vec2{5.000001, 0}, centre - Vec2{5, 0}));
    CHECK_FALSE(joins(arc, centre + Vec2{5.001, 0}, centre - Vec2{5, 0}));
    const Curve cubic = Curve::cubic(centre, centre + Vec2{1, 1}, centre + Vec2{2, 1}, centre + Vec2{3, 0});
    CHECK(joins(cubic, centre, centre + Vec2{3, 0}));
    CHECK_FALSE(joins(cubic, centre + Vec2{0.01, 0}, centre + Vec2{3, 0}));
}

TEST_CASE("arcOfRadius: a very large radius keeps its value") {
    for (const double radius : {1.0, 10.0, 1e4, 1e6}) {
        const Curve arc = arcOfRadius({0, 0}, {2, 0}, radius, {1, 0.1});
        REQUIRE(arc.kind() == CurveKind::Arc);
        CHECK(length({arc.numbers()[2], arc.numbers()[3]}) == doctest::Approx(radius).epsilon(1e-8));
    }
}
