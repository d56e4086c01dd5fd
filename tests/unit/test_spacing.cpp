#include "core/domain/domain.hpp"
#include "core/spacing/spacing_field.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace forefront;

namespace {

Domain rectangle(double width, double height, int piecesX, int piecesY) {
    Domain domain;
    const auto side = [&](Vec2 from, Vec2 to, int pieces) {
        for (int i = 0; i < pieces; ++i) {
            domain.nodes.push_back(lerp(from, to, static_cast<double>(i) / pieces));
        }
    };
    side({0, 0}, {width, 0}, piecesX);
    side({width, 0}, {width, height}, piecesY);
    side({width, height}, {0, height}, piecesX);
    side({0, height}, {0, 0}, piecesY);
    const auto n = static_cast<std::uint32_t>(domain.nodes.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        domain.segments.push_back({i, (i + 1) % n, 1, SegmentRole::Boundary});
    }
    return domain;
}

std::shared_ptr<const SpacingField> built(const SpacingSpec &spec, const Domain &domain) {
    auto field = SpacingField::build(spec, domain);
    REQUIRE_MESSAGE(field.ok(), toString(field.ok() ? Diagnostic{} : field.faults().front()));
    return *field;
}

} // namespace

TEST_CASE("SpacingField: a constant is the same everywhere and says so") {
    SpacingSpec spec;
    spec.size = 0.3;
    const auto field = built(spec, rectangle(2, 1, 4, 2));
    CHECK(field->at({0.1, 0.2}) == 0.3);
    CHECK(field->least() == 0.3);
    CHECK(field->greatest() == 0.3);
    CHECK(field->sample({1, 1}).origin == SpacingOrigin::Constant);
}

TEST_CASE("SpacingField: sources, constant and expression combine by minimum and are clamped") {
    SpacingSpec spec;
    spec.size = 1.0;
    spec.expression = "0.5 + 0.1*x";
    spec.minimum = 0.08;
    spec.sources.push_back({SourceShape::Point, {3, 3}, {}, 0.0, 0.05, 0.2, "pier head"});
    spec.sources.push_back({SourceShape::Line, {0, 9}, {10, 9}, 0.5, 0.2, 0.3, ""});
    spec.sources.push_back({SourceShape::Circle, {8, 2}, {}, 1.0, 0.1, 0.5, "tank"});
    const auto field = built(spec, rectangle(10, 10, 4, 4));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p{place(random), place(random)};
        const double point = 0.05 + 0.2 * distance(p, {3, 3});
        const double line = 0.2 + 0.3 * std::max(0.0, std::fabs(p.y - 9) - 0.5);
        const double circle = 0.1 + 0.5 * std::max(0.0, distance(p, {8, 2}) - 1.0);
        const double expected = std::max(0.08, std::min({1.0, 0.5 + 0.1 * p.x, point, line, circle}));
        CHECK(field->at(p) == doctest::Approx(expected).epsilon(1e-12));
        CHECK(field->at(p) >= field->least());
        CHECK(field->at(p) <= field->greatest());
        CHECK(field->sample(p).rho == field->at(p));
    }
    CHECK(field->sample({3, 3}).describe == "least spacing");
    CHECK(field->sample({3.5, 3}).describe == "source 'pier head'");
    CHECK(field->sample({5, 9.6}).describe == "source 1");
    CHECK(field->sample({0.5, 6}).describe == "expression 0.5 + 0.1*x");
}

TEST_CASE("SpacingField: automatic spacing respects short segments and is graded") {
    const Domain domain = rectangle(10, 5, 200, 5);
    const auto field = built({}, domain);
    CHECK(field->at({5, 0}) == doctest::Approx(0.05).epsilon(0.01));
    CHECK(field->greatest() <= 0.5);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p{10 * place(random), 5 * place(random)};
        const double reach = i % 2 == 0 ? 10.0 : 0.1;
        const Vec2 q{std::clamp(p.x + reach * (place(random) - 0.5), 0.0, 10.0),
                     std::clamp(p.y + reach * (place(random) - 0.5), 0.0, 5.0)};
        CHECK(std::fabs(field->at(p) - field->at(q)) <= 0.25 * distance(p, q) + 0.012 * field->at(p));
    }
}

TEST_CASE("SpacingField: a faulty expression is refused with its column") {
    SpacingSpec spec;
    spec.expression = "0.1 + * x";
    const auto field = SpacingField::build(spec, rectangle(1, 1, 1, 1));
    REQUIRE(!field.ok());
    CHECK(field.faults().front().code == "expression-syntax");
    CHECK(field.faults().front().column == 7);
}

TEST_CASE("SpacingField: an expression without a positive value somewhere is refused with the place") {
    SpacingSpec spec;
    spec.expression = "x - 0.25";
    const auto field = SpacingField::build(spec, rectangle(1, 1, 1, 1));
    REQUIRE(!field.ok());
    CHECK(field.faults().front().code == "expression-value");
    REQUIRE(field.faults().front().at.has_value());
    CHECK(field.faults().front().at->x <= 0.25);
}
