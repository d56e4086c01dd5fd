#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/measure.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/tag_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace forefront;

TEST_CASE("Measure: lines, arcs and circles") {
    const auto line = measureCurve(Curve::line({1, 1}, {4, 5}));
    CHECK(line[0].name == "length");
    CHECK(line[0].value == doctest::Approx(5.0));
    CHECK(line[3].value == doctest::Approx(53.130102));
    const auto circle = measureCurve(Curve::circle({0, 0}, {2, 0}));
    CHECK(circle[0].value == doctest::Approx(2.0));
    CHECK(circle[1].value == doctest::Approx(4.0));
    CHECK(circle[2].name == "circumference");
    CHECK(circle[2].value == doctest::Approx(4.0 * std::numbers::pi));
    CHECK(circle[3].value == doctest::Approx(4.0 * std::numbers::pi));
    const auto quarter = measureCurve(Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.0, 0.5 * std::numbers::pi));
    CHECK(quarter[2].name == "arc length");
    CHECK(quarter[2].value == doctest::Approx(std::numbers::pi));
    CHECK(quarter[3].value == doctest::Approx(90.0));
    CHECK(angleBetween({1, 0}, {-1, 1}) == doctest::Approx(135.0));
}

TEST_CASE("Measure: the semi-axes of an ellipse, whichever conjugate ones it is drawn with") {
    // The ellipse with semi-axes 3 and 1, turned by 30 degrees, by the ends of two conjugate ones.
    const double c = std::cos(std::numbers::pi / 6.0), s = std::sin(std::numbers::pi / 6.0);
    const auto place = [&](double t) {
        const Vec2 p{3.0 * std::cos(t), std::sin(t)};
        return Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
    };
    for (const double t : {0.0, 0.4, 1.0}) {
        const Vec2 u = place(t), v = place(t + 0.5 * std::numbers::pi);
        for (const Curve &curve : {Curve::arc({1, 1}, u, v), Curve::arc({1, 1}, v, u)}) {
            const auto found = measureCurve(curve);
            REQUIRE(found.size() == 4);
            CHECK(found[0].value == doctest::Approx(3.0));
            CHECK(found[1].value == doctest::Approx(1.0));
            CHECK(found[3].value == doctest::Approx(3.0 * std::numbers::pi));
        }
        // The angle of its parameter is none of the arc.
        CHECK(measureCurve(Curve::arc({1, 1}, u, v, 0.0, 1.0)).size() == 3);
    }
}

TEST_CASE("Measure: a face has the area between its curves, and the perimeter of its outline and holes") {
    Shape square;
    square.form = RectangleForm{};
    square.nodes = {{0, 0}, {10, 6}};
    Shape hole;
    hole.form = CircleForm{};
    hole.nodes = {{3, 3}, {4, 3}};
    const Document document = *addShapes(Document(), {square, hole});
    const Domain domain = toDomain(document);
    const auto around = measureFace(domain, {8, 3});
    REQUIRE(around);
    CHECK(around->area == doctest::Approx(60.0 - std::numbers::pi).epsilon(1e-10));
    CHECK(around->perimeter == doctest::Approx(32.0 + 2.0 * std::numbers::pi).epsilon(1e-10));
    const auto inside = measureFace(domain, {3, 3});
    REQUIRE(inside);
    CHECK(inside->area == doctest::Approx(std::numbers::pi).epsilon(1e-10));
    CHECK_FALSE(measureFace(domain, {20, 3}));
    CHECK_FALSE(measureFace(domain, {0, 3}));
}

TEST_CASE("Tag runs: a run goes on over the first node of a closed shape; a circle has one") {
    Shape square;
    square.form = RectangleForm{};
    square.nodes = {{0, 0}, {10, 6}};
    square.segmentTags = {1, 3, 3, 1};
    const auto runs = tagRuns(square, outlineOf(square));
    REQUIRE(runs.size() == 2);
    CHECK(runs[0].tag == 3);
    CHECK(runs[0].first == 1);
    CHECK(runs[0].count == 2);
    CHECK(runs[1].first == 3);
    CHECK(runs[1].count == 2);
    square.segmentTags.clear();
    CHECK(tagRuns(square, outlineOf(square)).size() == 1);
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{3, 3}, {4, 3}};
    CHECK(tagRuns(circle, outlineOf(circle)).size() == 1);
}
