#include "core/engine/boundary/spacing_integral.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stop_token>
#include <vector>

using namespace forefront;
using forefront::testing::constantSpacing;
using forefront::testing::spacingAround;
using forefront::testing::SpacingFunction;

namespace {

using Outcome = SpacingIntegral::Outcome;
constexpr double kNoLimit = 1e12;

Outcome integrate(SpacingIntegral &integral, const SpacingField &spacing, Vec2 a, Vec2 b, double limit = kNoLimit,
                  const Progress &progress = {}) {
    return integral.integrate(spacing, a, b, spacing.at(a), spacing.at(b), distance(a, b), limit, progress);
}

} // namespace

TEST_CASE("SpacingIntegral: a constant spacing gives length / spacing, and equal pieces") {
    SpacingIntegral integral;
    REQUIRE(integrate(integral, constantSpacing(0.25), {1, 1}, {4, 5}) == Outcome::Done);
    CHECK(integral.total() == doctest::Approx(20.0));
    CHECK(integral.pieces() == 20.0);
    std::vector<double> fractions{7.0}; // replaced
    integral.cut(4, fractions);
    REQUIRE(fractions.size() == 3);
    CHECK(fractions[0] == doctest::Approx(0.25));
    CHECK(fractions[1] == doctest::Approx(0.5));
    CHECK(fractions[2] == doctest::Approx(0.75));
    integral.cut(1, fractions);
    CHECK(fractions.empty());
}

TEST_CASE("SpacingIntegral: a linear spacing gives a logarithm, and pieces in geometric progression") {
    // rho = 0.1 + 0.2 x over [0, 2]: the integral is ln(0.5 / 0.1) / 0.2.
    const SpacingFunction linear{[](Vec2 p) { return 0.1 + 0.2 * p.x; }, 0.1, 0.5};
    SpacingIntegral integral;
    REQUIRE(integrate(integral, linear, {0, 0}, {2, 0}) == Outcome::Done);
    CHECK(integral.total() == doctest::Approx(std::log(5.0) / 0.2).epsilon(0.003));
    std::vector<double> fractions;
    integral.cut(8, fractions);
    REQUIRE(fractions.size() == 7);
    for (int k = 1; k < 8; ++k) {
        const double x = 0.5 * (std::pow(5.0, k / 8.0) - 1.0);
        CHECK(2.0 * fractions[static_cast<std::size_t>(k - 1)] == doctest::Approx(x).epsilon(0.003));
    }
}

TEST_CASE("SpacingIntegral: a spacing that varies a thousandfold is integrated to within a few tenths of a percent") {
    // rho = max(0.001, 0.3 |x - 0.7|): 0.002/0.3 / 0.001 in the valley, logarithms on both sides.
    const SpacingFunction steep = spacingAround({0.7, 0}, 0.001, 0.3);
    const double valley = 0.001 / 0.3;
    const double exact = 2.0 * valley / 0.001 + (std::log(0.7 / valley) + std::log(0.3 / valley)) / 0.3;
    SpacingIntegral integral;
    REQUIRE(integrate(integral, steep, {0, 0}, {1, 0}) == Outcome::Done);
    CHECK(integral.total() == doctest::Approx(exact).epsilon(0.01));
    CHECK(roughSpacingIntegral(steep, {0, 0}, {1, 0}, steep.at({0, 0}), steep.at({1, 0})) ==
          doctest::Approx(exact).epsilon(0.1));
}

TEST_CASE("SpacingIntegral: a dip narrower than the longest interval may be missed, but a wider one is found") {
    const SpacingFunction dip{[](Vec2 p) { return std::fabs(p.x - 0.3) < 0.02 ? 0.001 : 10.0; }, 0.001, 10.0};
    SpacingIntegral integral;
    REQUIRE(integral.integrate(dip, {0, 0}, {1, 0}, 10.0, 10.0, 0.01, kNoLimit, {}) == Outcome::Done);
    CHECK(integral.total() == doctest::Approx(40.0).epsilon(0.05));
}

TEST_CASE("SpacingIntegral: the number of pieces is the closest in ratio, and at least one") {
    SpacingIntegral integral;
    const auto piecesFor = [&](double total) {
        REQUIRE(integrate(integral, constantSpacing(1.0 / total), {0, 0}, {1, 0}) == Outcome::Done);
        return integral.pieces();
    };
    CHECK(piecesFor(0.01) == 1.0);
    CHECK(piecesFor(1.41) == 1.0); // sqrt(1 * 2) = 1.414
    CHECK(piecesFor(1.42) == 2.0);
    CHECK(piecesFor(2.44) == 2.0); // sqrt(2 * 3) = 2.449
    CHECK(piecesFor(2.46) == 3.0);
}

TEST_CASE("SpacingIntegral: invalid spacings are reported with their place") {
    SpacingIntegral integral;
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, std::nan(""), infinity}) {
        const SpacingFunction middle{[=](Vec2 p) { return p.x == 0.5 ? bad : 0.1; }, 0.1, 0.1};
        REQUIRE(integrate(integral, middle, {0, 0}, {1, 0}) == Outcome::BadSpacing);
        CHECK(integral.badPlace() == Vec2{0.5, 0});
        const SpacingFunction end{[=](Vec2 p) { return p.x == 1.0 ? bad : 0.1; }, 0.1, 0.1};
        REQUIRE(integrate(integral, end, {0, 0}, {1, 0}) == Outcome::BadSpacing);
        CHECK(integral.badPlace() == Vec2{1, 0});
    }
}

TEST_CASE("SpacingIntegral: the rough integral is not finite where the spacing is 0 or not a number") {
    for (const double bad : {0.0, std::nan("")}) {
        const SpacingFunction middle{[=](Vec2 p) { return p.x == 0.5 ? bad : 0.1; }, 0.1, 0.1};
        CHECK_FALSE(std::isfinite(roughSpacingIntegral(middle, {0, 0}, {1, 0}, 0.1, 0.1)));
        CHECK_FALSE(std::isfinite(roughSpacingIntegral(constantSpacing(0.1), {0, 0}, {1, 0}, bad, 0.1)));
    }
}

TEST_CASE("SpacingIntegral: stops at the limit, and when cancelled") {
    SpacingIntegral integral;
    CHECK(integrate(integral, constantSpacing(1e-3), {0, 0}, {1, 0}, 999.0) == Outcome::TooMany);
    CHECK(integrate(integral, constantSpacing(1e-3), {0, 0}, {1, 0}, 1001.0) == Outcome::Done);
    std::stop_source source;
    source.request_stop();
    CHECK(integrate(integral, constantSpacing(1e-6), {0, 0}, {1, 0}, kNoLimit, {{}, source.get_token()}) ==
          Outcome::Cancelled);
}
