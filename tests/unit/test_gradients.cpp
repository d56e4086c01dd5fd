#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

SizeSource gradient(Vec2 a, Vec2 b, double size, double endSize, bool geometric = false) {
    SizeSource source{SourceShape::Line, a, b, 0.0, size, 0.2, "ramp", endSize};
    source.plane = true;
    source.geometric = geometric;
    return source;
}

} // namespace

TEST_CASE("Gradients: linear between the ends, constant beyond them, and the same beside the line") {
    SpacingSpec spec;
    spec.sources = {gradient({2, 3}, {8, 3}, 0.1, 0.7)};
    const auto field = fieldOf(spec, squareDomain(10));
    for (const double y : {0.0, 3.0, 9.5}) {
        CHECK(field->at({0.5, y}) == doctest::Approx(0.1));
        CHECK(field->at({5, y}) == doctest::Approx(0.4));
        CHECK(field->at({9.5, y}) == doctest::Approx(0.7));
    }
    CHECK(field->sample({5, 9}).describe == "source 'ramp'");
    CHECK(field->minimum() == doctest::Approx(0.1));
    CHECK(field->maximum() == doctest::Approx(0.7));
    // It covers the plane, so there is no automatic spacing, even if other sources keep it.
    spec.keepAutomatic = true;
    CHECK_FALSE(spec.usesAutomatic());
    CHECK(fieldOf(spec, squareDomain(10))->at({5, 9}) == doctest::Approx(0.4));
    // The same from the other end.
    SpacingSpec turned;
    turned.sources = {gradient({8, 3}, {2, 3}, 0.7, 0.1)};
    CHECK(fieldOf(turned, squareDomain(10))->at({3.3, 8}) == doctest::Approx(field->at({3.3, 8})));
}

TEST_CASE("Gradients: geometric ones change by equal factors") {
    SpacingSpec spec;
    spec.sources = {gradient({0, 1}, {0, 9}, 0.05, 0.8, true)};
    const auto field = fieldOf(spec, squareDomain(10));
    CHECK(field->at({3, 1}) == doctest::Approx(0.05));
    CHECK(field->at({7, 3}) == doctest::Approx(0.1));
    CHECK(field->at({7, 5}) == doctest::Approx(0.2));
    CHECK(field->at({7, 9}) == doctest::Approx(0.8));
    CHECK(field->at({7, 9.9}) == doctest::Approx(0.8));
}

TEST_CASE("Gradients: steep ones are limited by the gradation, exactly") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    for (const bool geometric : {false, true}) {
        SpacingSpec spec;
        spec.gradation = 0.2;
        spec.sources = {gradient({4, 5}, {6, 6}, 0.1, 2.0, geometric)};
        const auto field = fieldOf(spec, squareDomain(10));
        CHECK(field->at({4, 5}) == doctest::Approx(0.1));
        const Vec2 along = (1.0 / std::sqrt(5.0)) * Vec2{2, 1};
        // The largest function with this slope: the minimum over all positions of the free one, plus the distance.
        const auto limited = [&](double x) {
            double least = 2.0;
            for (int k = 0; k <= 4000; ++k) {
                const double at = std::sqrt(5.0) * k / 4000, t = k / 4000.0;
                const double rho = geometric ? 0.1 * std::pow(20.0, t) : 0.1 + 1.9 * t;
                least = std::min(least, rho + 0.2 * std::fabs(x - at));
            }
            return least;
        };
        for (int k = 0; k < 300; ++k) {
            const Vec2 p{place(random), place(random)};
            CHECK(field->at(p) == doctest::Approx(limited(std::max(0.0, dot(p - Vec2{4, 5}, along)))).epsilon(1e-3));
        }
    }
}

TEST_CASE("Gradients: projects keep them, and only lines can be gradients") {
    const Document document = *addSource({}, gradient({0, 0}, {1, 0}, 0.1, 0.5, true));
    const auto read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(read->spacing.sources == document.spacing.sources);
    SizeSource point = gradient({0, 0}, {1, 0}, 0.1, 0.5);
    point.shape = SourceShape::Point;
    point.endSize.reset();
    const auto refused = addSource({}, point);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "bad-source");
}

TEST_CASE("Gradients: one whose ends coincide is refused") {
    const auto refused = addSource({}, gradient({1, 1}, {1, 1}, 0.1, 0.5));
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().message ==
          "size source 0 'ramp' has a gradient whose ends coincide; expected two different places");
    SpacingSpec spec;
    spec.sources = {gradient({1, 1}, {1, 1}, 0.1, 0.5)};
    CHECK_FALSE(SpacingField::build(spec, squareDomain(10)).ok());
}
