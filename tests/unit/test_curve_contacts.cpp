#include "core/drawing/shapes/curve_crossings.hpp"
#include "core/engine/geometry/curve_contacts.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns a line of length 1 through a point of a curve, at an angle to the tangent.
Curve lineThrough(const Curve &curve, double t, double angle, double share) {
    const Vec2 tangent = curve.tangent(t), at = curve.point(t);
    const Vec2 along = std::cos(angle) * tangent + std::sin(angle) * leftNormal(tangent);
    return Curve::line(at - share * along, at + (1.0 - share) * along);
}

} // namespace

TEST_CASE("curve contacts: a line through a point of a curve crosses it there, even where the speed nearly vanishes") {
    RandomSource random(7);
    for (int repeat = 0; repeat < 2000; ++repeat) {
        CAPTURE(repeat);
        const Vec2 a{random.between(-1, 1), random.between(-1, 1)};
        const Vec2 end = a + Vec2{1.0, 0.0};
        // The first two control points coincide: the speed vanishes at the start.
        const Curve curve = Curve::cubic(a, a, a + Vec2{0.5, random.between(-0.1, 0.1)}, end);
        const double t = std::pow(10.0, random.between(-2.0, -0.05));
        const double angle = random.between(0.45, std::numbers::pi - 0.45);
        const CurvePart part(curve, 0.0, 1.0);
        REQUIRE(part.turn <= kMaxContactTurn);
        const Curve line = lineThrough(curve, t, angle, random.between(0.2, 0.8));
        const auto contacts = curveContacts(part, CurvePart(line, 0.0, 1.0), 1e-12);
        REQUIRE(contacts.size() == 1);
        CHECK(contacts[0].crossing);
        CHECK(std::fabs(contacts[0].first - t) < 1e-9);
        CHECK(distance(contacts[0].onFirst, curve.point(t)) < 1e-13);
        CHECK(contacts[0].onFirst == contacts[0].onSecond);
    }
}

TEST_CASE("curve contacts: a line that just misses or just crosses an arc") {
    const Curve arc = Curve::arc({0, 0}, {1, 0}, {0, 1}, 1.5, 0.14);
    const CurvePart part(arc, 0.0, 1.0);
    const auto contactsAt = [&](double height, double tolerance) {
        return curveContacts(part, CurvePart(Curve::line({-1, height}, {1, height}), 0.0, 1.0), tolerance);
    };
    CHECK(contactsAt(1.0 + 1e-6, 1e-9).empty());
    const auto touching = contactsAt(1.0 + 1e-10, 1e-9);
    REQUIRE(touching.size() == 1);
    CHECK_FALSE(touching[0].crossing);
    CHECK(distance(touching[0].onFirst, {0, 1}) < 1e-4);
    const auto crossing = contactsAt(1.0 - 1e-6, 1e-9);
    REQUIRE(crossing.size() == 2);
    const double half = std::sqrt(1.0 - (1.0 - 1e-6) * (1.0 - 1e-6));
    for (const CurveContact &contact : crossing) {
        CHECK(contact.crossing);
        CHECK(std::fabs(std::fabs(contact.onFirst.x) - half) < 1e-10);
    }
}

TEST_CASE("curve contacts: a piece as short as the rounding of its coordinates takes no more than a few samples") {
    // The second control point of the cubic, rounded, is just beyond its end: a cusp.
    const Vec2 end{2.6356478118823627, -999999999999914};
    const Curve cubic =
        Curve::cubic({8.9999999648563698, -4e16}, {9.3041712856720302, -21735105435802704}, end + Vec2{0.0, 2.0}, end);
    for (const double tolerance : {5e5, 2.7e8}) {
        for (const CurveCrossing &crossing : crossingsOf(Curve::line({0, -5e14}, {0, -1e15}), cubic, tolerance)) {
            CHECK(distance(crossing.at, end) < 1e9);
        }
    }
}
