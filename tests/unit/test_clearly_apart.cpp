#include "core/engine/boundary/clearly_apart.hpp"
#include "core/engine/boundary/meeting_parts.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/discrete_checks.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using namespace forefront::testing;

namespace {

bool areApart(const Domain &domain, double rho) {
    const auto discrete = discretise(domain, constantSpacing(rho), false);
    REQUIRE(discrete.ok());
    return areClearlyApart(domain, *discrete);
}

/// A square of side 1 with a slit of two lines that leave its lower left corner at an angle.
Domain squareWithFork(double angle) {
    DomainBuilder builder;
    const auto corners = builder.loop({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
    for (const double direction : {0.5, 0.5 + angle}) {
        builder.segment(corners[0], builder.node(polar({}, 0.5, direction)), 2, SegmentRole::Constraint);
    }
    return builder.domain;
}

/// A square of side 1 with a line and, `gap` beside its middle, another line or a point.
Domain squareWithLine(double gap, bool point) {
    DomainBuilder builder;
    builder.loop({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
    builder.segment(builder.node({0.2, 0.3}), builder.node({0.8, 0.3}), 2, SegmentRole::Constraint);
    const std::uint32_t beside = builder.node({0.5, 0.3 + gap});
    if (point) {
        builder.domain.points.push_back({beside});
    } else {
        builder.segment(beside, builder.node({0.5, 0.7}), 3, SegmentRole::Constraint);
    }
    return builder.domain;
}

} // namespace

TEST_CASE("areClearlyApart: lines are, unless they or their cuts are within rounding of each other") {
    CHECK(areApart(squareWithFork(1e-3), 0.1));
    CHECK(areApart(squareWithFork(1e-11), 0.1));
    CHECK_FALSE(areApart(squareWithFork(1e-14), 0.1));
    for (const bool point : {false, true}) {
        CHECK(areApart(squareWithLine(1e-3, point), 0.1));
        CHECK(areApart(squareWithLine(1e-11, point), 0.1));
        CHECK_FALSE(areApart(squareWithLine(1e-15, point), 0.1));
    }
}

TEST_CASE("areClearlyApart: a line that is not divided is as given, but others may come close to it") {
    // 0.07 long, at right angles to the line 1e-15 beside it.
    DomainBuilder builder;
    builder.domain = squareWithLine(1e-15, false);
    builder.domain.nodes.back() = {0.5, 0.37};
    CHECK_FALSE(areApart(builder.domain, 0.1));
    CHECK(areApart(builder.domain, 2.0)); // nothing is divided
}

TEST_CASE("areClearlyApart: a short line beside a longer one from the same node") {
    // The cuts of the side from the second node lie beyond the end of the line, which is within rounding of the side.
    for (const Vec2 corner : {Vec2{-1.0, -0.6737410169338212}, Vec2{-1.0, -0.44277877625513484}}) {
        for (const Vec2 end : {Vec2{-0.05000000000000013, 0.05000000000000013 * corner.y}, Vec2{-0.05, 0.05 * corner.y},
                               0.05 * corner}) {
            DomainBuilder builder;
            const auto nodes =
                builder.loop({corner, {0.0, 0.0}, {corner.y < -0.5 ? -1.3 : 0.3, corner.y < -0.5 ? 1.0 : -2.0}}, 1);
            builder.segment(nodes[1], builder.node(end), 3, SegmentRole::Constraint);
            if (hasErrors(validate(builder.domain))) {
                continue;
            }
            const auto discrete = discretise(builder.domain, constantSpacing(0.25), false);
            REQUIRE(discrete.ok());
            CHECK_FALSE(areClearlyApart(builder.domain, *discrete));
            checkRegions(builder.domain, *discrete);
        }
    }
}

TEST_CASE("areClearlyApart: if so, the exact check agrees, and otherwise the result is right, too") {
    int apart = 0, close = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        CAPTURE(seed);
        RandomSource random(seed);
        DomainBuilder builder;
        const double side = random.between(-3.0, 3.0), angle = std::pow(10.0, random.between(-18.0, -8.0));
        const auto nodes = builder.loop({{}, polar({}, 1.0, side), polar({}, random.between(0.5, 2.0), side + 1.0)}, 1);
        const double length = random.between(0.01, 0.9);
        builder.segment(nodes[0], builder.node(polar({}, length, side + angle)), 2, SegmentRole::Constraint);
        if (hasErrors(validate(builder.domain))) {
            continue;
        }
        const auto discrete = discretise(builder.domain, constantSpacing(random.between(0.02, 0.6)), false);
        REQUIRE(discrete.ok());
        const bool clear = areClearlyApart(builder.domain, *discrete);
        ++(clear ? apart : close);
        if (clear) {
            REQUIRE(findMeetingParts({*discrete, nullptr, {}, {}, {}}, {}).none());
        }
        checkRegions(builder.domain, *discrete);
    }
    CHECK(apart > 200);
    CHECK(close > 200);
}

TEST_CASE("areClearlyApart: leaves many long lines close together to the exact check") {
    DomainBuilder builder;
    builder.loop({{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}, 1);
    for (int i = 0; i < 100; ++i) {
        const double shift = 1e-3 * i;
        builder.segment(builder.node({shift, 0}), builder.node({1 + shift, 1}), 2, SegmentRole::Constraint);
    }
    CHECK_FALSE(areApart(builder.domain, 0.1));
}

TEST_CASE("areClearlyApart: nearly all random domains are, so that few need the exact check") {
    int apart = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        apart += areApart(domain, 0.01 * domain.bounds().diagonal()) ? 1 : 0;
    }
    CHECK(apart > 290);
}
