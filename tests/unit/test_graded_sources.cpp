#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

SizeSource gradedLine(Vec2 a, Vec2 b, double size, double endSize, double growth, double radius = 0.0) {
    return {SourceShape::Line, a, b, radius, size, growth, "wake", endSize};
}

/// The rule without a limit: the size at the nearest point of the line, plus the growth times the distance.
double unlimited(const SizeSource &source, Vec2 p) {
    const Vec2 ab = source.b - source.a;
    const double t = std::clamp(dot(p - source.a, ab) / lengthSquared(ab), 0.0, 1.0);
    return source.size + t * (*source.endSize - source.size) +
           source.growth * std::max(0.0, distance(p, source.a + t * ab) - source.radius);
}

} // namespace

TEST_CASE("Graded sources: the size changes linearly along the line and grows with the distance from it") {
    SpacingSpec spec;
    spec.sources = {gradedLine({2, 3}, {8, 3}, 0.1, 0.7, 0.2)};
    const auto field = fieldOf(spec, squareDomain(10));
    CHECK(field->at({2, 3}) == doctest::Approx(0.1));
    CHECK(field->at({5, 3}) == doctest::Approx(0.4));
    CHECK(field->at({8, 3}) == doctest::Approx(0.7));
    CHECK(field->at({5, 4}) == doctest::Approx(0.6)); // beside
    CHECK(field->at({5, 2}) == doctest::Approx(0.6));
    CHECK(field->at({1, 3}) == doctest::Approx(0.3)); // beyond the first end
    CHECK(field->at({8, 5}) == doctest::Approx(1.1));
    CHECK(field->sample({5, 3}).describe == "source 'wake'");
    CHECK(field->sample({5, 3}).origin == SpacingOrigin::Source);
    // The same line the other way round.
    spec.sources = {gradedLine({8, 3}, {2, 3}, 0.7, 0.1, 0.2)};
    const auto reversed = fieldOf(spec, squareDomain(10));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    for (int i = 0; i < 500; ++i) {
        const Vec2 p{place(random), place(random)};
        REQUIRE(reversed->at(p) == doctest::Approx(field->at(p)));
    }
}

TEST_CASE("Graded sources: combine with other sources by minimum, within the bounds of the field") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 20; ++round) {
        SpacingSpec spec;
        spec.minimum = 0.05;
        for (int k = 0; k < 1 + round; ++k) {
            const Vec2 a{14 * share(random) - 2, 14 * share(random) - 2};
            spec.sources.push_back(gradedLine(a, a + Vec2{4 * share(random), 4 * share(random)}, 0.01 + share(random),
                                              0.01 + share(random), share(random), 0.5 * share(random)));
        }
        const auto field = fieldOf(spec, squareDomain(10));
        for (int i = 0; i < 300; ++i) {
            const Vec2 p{10 * share(random), 10 * share(random)};
            double expected = std::numeric_limits<double>::infinity();
            for (const SizeSource &source : spec.sources) {
                expected = std::min(expected, unlimited(source, p));
            }
            REQUIRE(field->at(p) == doctest::Approx(std::max(0.05, expected)));
            REQUIRE(field->at(p) >= field->minimum());
            REQUIRE(field->at(p) <= field->maximum());
            REQUIRE(field->sample(p).rho == field->at(p));
        }
    }
}

TEST_CASE("Graded sources: a gradation limits them to the largest function with that slope") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 40; ++round) {
        CAPTURE(round);
        SpacingSpec spec;
        const double g = spec.gradation.emplace(0.1 + 0.4 * share(random));
        // The line slopes by 0 to 0.8, and the growth is 0 to 0.8: below and above the gradation.
        const Vec2 a{3 + share(random), 4 + share(random)}, b = a + Vec2{1.5 + share(random), share(random)};
        SizeSource source = gradedLine(a, b, 0.1, 0.1 + 0.8 * share(random) * distance(a, b), 0.8 * share(random),
                                       round % 2 == 0 ? 0.0 : 0.3);
        spec.sources = {source};
        const auto field = fieldOf(spec, squareDomain(10));
        for (int i = 0; i < 20; ++i) {
            const Vec2 p{1 + 7 * share(random), 2 + 5 * share(random)};
            double expected = unlimited(source, p);
            constexpr int kSteps = 100; // per side of 10
            for (int k = 0; k < kSteps * kSteps; ++k) {
                const int row = k / kSteps;
                const Vec2 from{0.1 * (k % kSteps), 0.1 * row};
                expected = std::min(expected, unlimited(source, from) + g * distance(p, from));
            }
            // The samples are up to 0.071 from the best place.
            REQUIRE(field->at(p) <= expected + 1e-12);
            REQUIRE(field->at(p) >= expected - 0.071 * (g + 1.2));
            REQUIRE(field->at(p) >= field->minimum());
            REQUIRE(field->at(p) <= field->maximum());
            const Vec2 q{1 + 7 * share(random), 2 + 5 * share(random)};
            REQUIRE(std::fabs(field->at(p) - field->at(q)) <= g * distance(p, q) * (1 + 1e-9));
        }
    }
}

TEST_CASE("Graded sources: equal sizes, and a line that is a point, are as without an end size") {
    SpacingSpec spec;
    spec.size = 1.0;
    spec.sources = {{SourceShape::Line, {2, 3}, {8, 5}, 0.25, 0.1, 0.2, "wall"}};
    const auto plain = fieldOf(spec, squareDomain(10));
    spec.sources[0].endSize = 0.1;
    const auto same = fieldOf(spec, squareDomain(10));
    for (int i = 0; i < 400; ++i) {
        const int row = i / 20;
        const Vec2 p{0.5 * (i % 20), 0.5 * row};
        REQUIRE(same->at(p) == plain->at(p));
    }
    spec.sources = {gradedLine({2, 3}, {2, 3}, 0.3, 0.1, 0.2)};
    CHECK(fieldOf(spec, squareDomain(10))->at({2, 3}) == doctest::Approx(0.1));
    CHECK(fieldOf(spec, squareDomain(10))->at({4, 3}) == doctest::Approx(0.5));
}

TEST_CASE("Graded sources: an invalid end size is refused with the name of the source") {
    const auto added = addSource({}, gradedLine({0, 0}, {1, 0}, 0.1, -0.5, 0.2));
    REQUIRE_FALSE(added.ok());
    CHECK(added.faults().front().code == "bad-source");
    CHECK(added.faults().front().message ==
          "size source 0 'wake' has the size -0.5 at its second end; expected a number above 0");
    const auto disc = addSource({}, {SourceShape::Circle, {2, 3}, {}, 0.5, 0.3, 0.2, "disc", 0.1});
    REQUIRE_FALSE(disc.ok());
    CHECK(disc.faults().front().message ==
          "size source 0 'disc' has a size at a second end; expected a line, or no such size");
}

TEST_CASE("Graded sources: the end size is a number of the document, and survives transformations") {
    Document document = *addSource({}, gradedLine({0, 0}, {1, 0}, 0.1, 0.5, 0.2));
    document = *addSource(document, {SourceShape::Line, {0, 0}, {1, 0}, 0.0, 0.1, 0.2, ""});
    CHECK(readNumber(document, "source/0/endSize"_number) == 0.5);
    CHECK_FALSE(readNumber(document, "source/1/endSize"_number).has_value());
    Selection first;
    first.sources = {0};
    const Document turned = *transformSelection(document, first, PlaneMap::rotation(90.0, {0, 0}));
    CHECK(turned.spacing.sources[0].endSize == 0.5);
    CHECK(distance(turned.spacing.sources[0].b, {0, 1}) < 1e-12);
    Selection copies;
    const Document twice = *duplicateSelection(document, first, {1, 1}, &copies);
    REQUIRE(twice.spacing.sources.size() == 3);
    CHECK(twice.spacing.sources[2].endSize == 0.5);
}

TEST_CASE("Graded sources: the end size is written to projects and read back, and faults are located") {
    Document document = *addSource({}, gradedLine({0, 0}, {1, 0}, 0.1, 0.5, 0.2));
    document = *addSource(document, {SourceShape::Line, {0, 0}, {1, 0}, 0.0, 0.1, 0.2, ""});
    const std::string text = projectText(document);
    const auto read = parseProject(text, "test");
    REQUIRE(read.ok());
    CHECK(read->spacing.sources == document.spacing.sources);
    CHECK(text.find("endSize") == text.rfind("endSize")); // only where it is given
    const auto refused =
        parseProject("{\"format\": \"forefront\", \"version\": 2, \"shapes\": [], \"spacing\":\n"
                     "{\"sources\": [{\"shape\": \"line\", \"a\": [0, 0], \"b\": [1, 0], \"size\": 1,\n"
                     "\"endSize\": 0}]}}",
                     "test");
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "bad-number");
    CHECK(refused.faults().front().line == 3);
}
