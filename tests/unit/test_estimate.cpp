#include "core/engine/boundary/coverage_cell.hpp"
#include "core/engine/boundary/estimate.hpp"
#include "core/engine/pipeline/target_elements.hpp"
#include "core/engine/spacing/scaled_sizes.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

const double kPerArea = 4.0 / std::numbers::sqrt3;

DiscreteDomain asGiven(const Domain &domain) {
    const auto discrete = discretise(domain, constantSpacing(domain.bounds().diagonal()), true);
    REQUIRE(discrete.ok());
    return *discrete;
}

Domain polygon(const std::vector<Vec2> &nodes) {
    Domain domain;
    domain.nodes = nodes;
    const auto count = static_cast<std::uint32_t>(nodes.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        domain.segments.push_back({i, (i + 1) % count});
    }
    return domain;
}

bool crossingsAreOdd(const DiscreteDomain &domain, Vec2 p) {
    bool odd = false;
    for (const DiscreteSegment &s : domain.segments) {
        const Vec2 a = domain.nodes[s.a], b = domain.nodes[s.b];
        if ((s.leftRegion == kOutside) != (s.rightRegion == kOutside) && (a.y <= p.y) != (b.y <= p.y)) {
            odd ^= a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) > p.x;
        }
    }
    return odd;
}

/// The integral of `spacingAround(centre, minimum, growth)` in polar coordinates about the centre, logarithmic in the
/// radius.
double polarReference(const DiscreteDomain &domain, const SpacingField &spacing, Vec2 centre, double minimum) {
    constexpr int kRays = 500, kRings = 160;
    const double from = std::log(minimum * 1e-2), step = (std::log(domain.bounds().diagonal()) - from) / kRings;
    double sum = 0.0;
    for (int ray = 0; ray < kRays; ++ray) {
        const double angle = 2.0 * std::numbers::pi * (ray + 0.37) / kRays;
        for (int ring = 0; ring < kRings; ++ring) {
            const double radius = std::exp(from + (ring + 0.5) * step);
            const Vec2 p = centre + radius * Vec2{std::cos(angle), std::sin(angle)};
            if (domain.bounds().contains(p) && crossingsAreOdd(domain, p)) {
                sum += std::pow(radius / spacing.at(p), 2);
            }
        }
    }
    return kPerArea * sum * step * 2.0 * std::numbers::pi / kRays;
}

} // namespace

TEST_CASE("CoverageCell: covered areas of quarters agree with Monte Carlo sampling") {
    RandomSource random(5);
    for (int round = 0; round < 60; ++round) {
        // A triangle that reaches beyond the box, counter-clockwise.
        std::vector<BoundaryPiece> pieces(3);
        Vec2 t[3];
        do {
            for (Vec2 &corner : t) {
                corner = {random.between(-0.5, 1.5), random.between(-0.5, 1.5)};
            }
        } while (cross(t[1] - t[0], t[2] - t[0]) < 0.05);
        const auto covers = [&](Vec2 p) {
            return cross(t[1] - t[0], p - t[0]) > 0 && cross(t[2] - t[1], p - t[1]) > 0 &&
                   cross(t[0] - t[2], p - t[2]) > 0;
        };
        CoverageCell cell;
        cell.box = {{0, 0}, {1, 1}};
        cell.centreInside = covers({0.5, 0.5});
        for (std::uint32_t i = 0; i < 3; ++i) {
            pieces[i] = {t[i], t[(i + 1) % 3]};
            if (meetsBox(pieces[i], cell.box)) {
                cell.pieces.push_back(i);
            }
        }
        for (int level = 0; level < 4; ++level) {
            const Vec2 low = cell.box.min, size = cell.box.size();
            int found = 0;
            for (int i = 0; i < 10000; ++i) {
                const Vec2 p{low.x + (i % 100 + random.unit()) / 100 * size.x,
                             low.y + (i / 100 + random.unit()) / 100 * size.y};
                found += covers(p) ? 1 : 0;
            }
            REQUIRE(cell.centreInside == covers(cell.box.centre()));
            REQUIRE(std::fabs(cell.coveredArea(pieces) / (size.x * size.y) - found / 10000.0) < 0.01);
            double sum = 0.0;
            const std::array<CoverageCell, 4> quarters = cell.quarters(pieces);
            for (const CoverageCell &quarter : quarters) {
                sum += quarter.coveredArea(pieces);
            }
            REQUIRE(sum == doctest::Approx(cell.coveredArea(pieces)).epsilon(1e-9));
            cell = quarters[static_cast<std::size_t>(random.integer(0, 3))];
        }
    }
}

TEST_CASE("estimateElements: equilateral elements of the spacing's size fill the area") {
    const DiscreteDomain square = asGiven(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    CHECK(estimateElements(square, constantSpacing(0.01)) == doctest::Approx(kPerArea * 1e4));
    CHECK(estimateElements(square, constantSpacing(5.0)) == 1.0);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const DiscreteDomain domain = asGiven(randomDomain(seed));
        const double size = domain.bounds().diagonal();
        CAPTURE(seed);
        // The bounds of the field do not show that it is constant; the integral has to find that out.
        const SpacingFunction spacing([&](Vec2) { return 0.001 * size; }, 1e-6 * size, size);
        REQUIRE(estimateElements(domain, spacing) ==
                doctest::Approx(kPerArea * domain.area() / (1e-6 * size * size)).epsilon(1e-6));
    }
}

TEST_CASE(
    "estimateElements: within a tenth for spacing that grows from a node of random domains, however small there") {
    for (std::uint64_t seed = 0; seed < (kSanitized ? 8 : 30); ++seed) {
        const Domain domain = randomDomain(seed);
        const DiscreteDomain discrete = asGiven(domain);
        const double size = domain.bounds().diagonal();
        const Vec2 centre = domain.nodes[domain.segments[0].a];
        for (const double minimum : {3e-2 * size, 1e-3 * size, 1e-6 * size}) {
            CAPTURE(seed);
            CAPTURE(minimum);
            const SpacingFunction spacing = spacingAround(centre, minimum, 0.2);
            const double reference = polarReference(discrete, spacing, centre, minimum);
            REQUIRE(estimateElements(discrete, spacing) == doctest::Approx(reference).epsilon(0.1));
        }
    }
}

TEST_CASE("estimateElements: works for a long thin strip graded along its length") {
    const DiscreteDomain strip = asGiven(polygon({{0, 0}, {1000, 300}, {1000, 301}, {0, 1}}));
    const SpacingFunction spacing([](Vec2 p) { return 0.01 + 0.001 * p.x; }, 0.01, 1.01);
    // The integral of 1/ρ² over x from 0 to 1000, height 1.
    const double exact = kPerArea * (1.0 / 0.01 - 1.0 / 1.01) / 0.001;
    CHECK(estimateElements(strip, spacing) == doctest::Approx(exact).epsilon(0.1));
}

TEST_CASE("estimateElements: always a number from 1 to 1e18, for any spacing and size") {
    const DiscreteDomain square = asGiven(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    CHECK(estimateElements(square, constantSpacing(1e-200)) == 1e18);
    CHECK(estimateElements(square, constantSpacing(1e300)) == 1.0);
    CHECK(estimateElements(square, spacingAround({0.3, 0.4}, 1e-300, 1.0)) >= 1.0);
    CHECK(estimateElements(square, spacingAround({0.3, 0.4}, 1e-300, 1.0)) <= 1e18);
    const DiscreteDomain huge = asGiven(polygon({{0, 0}, {1e150, 0}, {1e150, 1e150}, {0, 1e150}}));
    CHECK(estimateElements(huge, constantSpacing(1e148)) == doctest::Approx(kPerArea * 1e4));
    CHECK(estimateElements(DiscreteDomain{}, constantSpacing(1.0)) == 1.0);
}

namespace target_elements_test {

MeshingJob squareJob() {
    MeshingJob job;
    job.domain = polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    return job;
}

Result<TargetSizes> reach(const MeshingJob &job, std::uint64_t target) {
    return sizesForElements(
        [&](double factor) {
            MeshingJob next = job;
            next.spacing = scaledSizes(job.spacing, factor, job.domain);
            return next;
        },
        target);
}

} // namespace target_elements_test

TEST_CASE("sizesForElements: every kind of size leads to the target, finer and coarser") {
    using namespace target_elements_test;
    MeshingJob size = squareJob(), formula = squareJob(), source = squareJob(), part = squareJob();
    size.spacing.size = 1.0;
    formula.spacing.expression = "0.2 + 0.1*x";
    source.spacing.sources = {{.a = {5, 5}, .b = {}, .size = 0.2, .name = {}}};
    source.spacing.keepAutomatic = true;
    part.spacing.partSizes = {{1, {0.3, 0.2}}};
    for (const MeshingJob &job : {squareJob(), size, formula, source, part}) {
        for (const std::uint64_t target : {400U, 1200U}) {
            const Result<TargetSizes> sizes = reach(job, target);
            REQUIRE(sizes.ok());
            INFO(sizes->elements, " of ", target, " after ", sizes->meshes);
            CHECK(sizes->reaches(target));
            CHECK(sizes->meshes <= 8);
            CHECK(missedTarget(*sizes, target, job).empty());
        }
    }
}

TEST_CASE("sizesForElements: limits hold, and are said") {
    using namespace target_elements_test;
    MeshingJob job = squareJob();
    job.spacing.size = 1.0;
    job.spacing.minimum = 0.9;
    const Result<TargetSizes> sizes = reach(job, 5000);
    REQUIRE(sizes.ok());
    CHECK_FALSE(sizes->reaches(5000));
    const Diagnostics missed = missedTarget(*sizes, 5000, job);
    REQUIRE(missed.size() == 1);
    CHECK(missed.front().advice.find("the minimum spacing 0.9") != std::string::npos);
    job.options.maxElements = 100;
    const Result<TargetSizes> tooMany = reach(job, 101);
    REQUIRE_FALSE(tooMany.ok());
    CHECK(tooMany.faults().front().code == "bad-target");
}

TEST_CASE("scaledSizes: limits and gradations stay; a factor takes up the next one") {
    using namespace target_elements_test;
    SpacingSpec spacing;
    spacing.size = 2.0;
    spacing.minimum = 0.5;
    spacing.gradation = 0.3;
    spacing.segmentsPerTurn = 20.0;
    spacing.expression = "max(0.1, x)";
    spacing.placed.regions = {{.at = {1, 1}, .maxArea = 3.0, .size = 1.0}};
    const SpacingSpec half = scaledSizes(scaledSizes(spacing, 0.25, {}), 2.0, {});
    CHECK(half.size == 1.0);
    CHECK(half.minimum == 0.5);
    CHECK(half.gradation == 0.3);
    CHECK(half.segmentsPerTurn == 40.0);
    CHECK(half.expression == "0.5*(max(0.1, x))");
    CHECK(half.placed.regions.front().maxArea == 0.75);
    CHECK(scaledExpression("2*(a)+(b)", 3.0) == "3*(2*(a)+(b))");
}
