#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("SpacingField: an expression has to be positive only inside the domain") {
    Domain ring; // a square of side 4 with a square hole of side 2 about the origin
    addLoop(ring, std::vector<Vec2>{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    addLoop(ring, std::vector<Vec2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    Domain disc;
    std::vector<Vec2> circle;
    for (int k = 0; k < 60; ++k) {
        circle.push_back({std::cos(0.10471975511965977 * k), std::sin(0.10471975511965977 * k)});
    }
    addLoop(disc, circle);
    SpacingSpec spec;
    for (const char *const text :
         {"0.2*dist(0, 0)", "0.3*max(abs(x), abs(y)) - 0.29", "sqrt(max(abs(x), abs(y)) - 1)+0.1"}) {
        CAPTURE(text);
        spec.expression = text;
        const auto field = fieldOf(spec, ring);
        CHECK(field->at({0, 0}) > 0.0); // whatever it is there
        CHECK(field->minimum() > 1e-3);
    }
    spec.expression = "1.2 - x^2 - y^2"; // negative in the corners of the box
    CHECK(fieldOf(spec, disc)->at({0, 1}) == doctest::Approx(0.2));
    const auto refusedAt = [&](const char *text, const Domain &domain) {
        spec.expression = text;
        const auto field = SpacingField::build(spec, domain);
        REQUIRE_FALSE(field.ok());
        CHECK(field.faults().front().code == "expression-value");
        REQUIRE(field.faults().front().at);
        return *field.faults().front().at;
    };
    CHECK(refusedAt("max(abs(x), abs(y)) - 1", ring).x == doctest::Approx(-1.0)); // zero on the boundary
    CHECK(length(refusedAt("0.9 - x^2 - y^2", disc)) > 0.9);
    CHECK(length(refusedAt("dist(0, 0)", disc)) < 0.05);
    CHECK(refusedAt("x < 1.5 ? 1 : -1", ring).x >= 1.5);
    CHECK(refusedAt("sqrt(1.5 - x)", ring).x > 1.5);
}

TEST_CASE("SpacingField: sizes outside the domain do not limit an expression inside") {
    Domain ring;
    addLoop(ring, std::vector<Vec2>{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    addLoop(ring, std::vector<Vec2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    SpacingSpec spec;
    spec.expression = "0.3*max(abs(x), abs(y)) - (max(abs(x), abs(y)) < 0.999 ? 0.299 : 0)"; // a step down in the hole
    const auto field = fieldOf(spec, ring);
    CHECK(field->notes().empty());
    CHECK(field->at({1.5, 0.2}) == doctest::Approx(0.45));
    CHECK(field->at({1, 0.2}) == doctest::Approx(0.3));
    spec.expression = "0.1 + 5*(max(abs(x), abs(y)) - 1)"; // steep from the hole on
    CHECK(fieldOf(spec, ring)->at({1.5, 0}) == doctest::Approx(0.1 + 0.5 * 0.5).epsilon(0.03));
}
