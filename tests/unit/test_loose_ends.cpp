#include "core/domain/validate.hpp"
#include "core/edit/document.hpp"
#include "core/io/svg/svg.hpp"
#include "tests/support/curved_area.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A circle of radius 5 that is open by `gap` on the right, and a triangle whose corner is `off` beside its start, so
/// that they are joined.
Domain nearlyClosed(double gap, double off) {
    const std::string text =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 13 12'><path d='M 11 6 A 5 5 0 1 1 11 " +
        std::to_string(6.0 - gap) + " Z'/><path d='M " + std::to_string(11.0 - off) + " 6 L 12 6.5 L 12 5.5 Z'/></svg>";
    const Result<Domain> domain = readSvg(sourceOf(text));
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return *domain;
}

} // namespace

TEST_CASE("Loose ends: an arc that is nearly closed keeps its size when joining has moved an end") {
    constexpr double kOff = 6e-6;
    for (const double gap : {3e-4, 1e-3, 1e-2, 0.1, 1.0}) {
        CAPTURE(gap);
        const Domain drawn = toDomain(fromDomain(nearlyClosed(gap, kOff)));
        CHECK(validate(drawn).empty());
        double area = 0.0;
        for (const auto &[tag, own] : curvedAreas(drawn)) {
            area += own;
        }
        const double half = std::asin(gap / 10.0); // of the angle of the gap, whose ends the circle is turned to
        const double circle = 25.0 * (std::numbers::pi - half) + 25.0 * std::sin(half) * std::cos(half);
        CHECK(std::fabs(area - (circle + 0.5)) <= 1e-4);
        for (const Vec2 node : drawn.nodes) {
            CHECK(node.x > 1.0 - 1e-3);
        }
    }
}

TEST_CASE("Loose ends: a curve with moved ends does not cross what it was apart from") {
    Domain domain;
    domain.curves = {Curve::cubic({0, 0}, {3, 1}, {7, 1}, {10, 0})};
    const Vec2 below{0.0, -0.009};
    // The curve is higher by that at its ends; a line ends just under its highest point.
    domain.nodes = {below,
                    domain.curves[0].point(0.25),
                    domain.curves[0].point(0.5),
                    domain.curves[0].point(0.75),
                    Vec2{10.0, 0.0} + below,
                    {10.0, -5.0},
                    {0.0, -5.0}};
    const auto add = [&](std::uint32_t a, std::uint32_t b, SegmentRole role, CurveStretch stretch = {}) {
        domain.segments.push_back({a, b, 1, role, stretch});
    };
    add(4, 3, SegmentRole::Boundary, {0, 1.0, 0.75});
    add(3, 2, SegmentRole::Boundary, {0, 0.75, 0.5});
    add(2, 1, SegmentRole::Boundary, {0, 0.5, 0.25});
    add(1, 0, SegmentRole::Boundary, {0, 0.25, 0.0});
    add(0, 6, SegmentRole::Boundary);
    add(6, 5, SegmentRole::Boundary);
    add(5, 4, SegmentRole::Boundary);
    REQUIRE(validate(domain).empty());
    SUBCASE("nothing nearby: the whole curve is moved") {
        const Document document = fromDomain(domain);
        REQUIRE(document.shapes.size() == 1);
        CHECK(document.shapes[0]->nodes.size() == 4);
        CHECK(validate(toDomain(document)).empty());
    }
    SUBCASE("a line nearby: the outer chords are moved") {
        domain.nodes.insert(domain.nodes.end(), {{5.0, 0.745}, {5.0, 0.5}});
        add(7, 8, SegmentRole::Constraint);
        REQUIRE(validate(domain).empty());
        const Document document = fromDomain(domain);
        REQUIRE(document.shapes.size() == 2);
        CHECK(document.shapes[0]->nodes.size() == 6);
        const Domain drawn = toDomain(document);
        CHECK(validate(drawn).empty());
        CHECK(drawn.segments.size() == domain.segments.size());
        CHECK(validate(toDomain(fromDomain(drawn))).empty());
    }
}
