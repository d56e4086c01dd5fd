// Fixes of violated limits.
#include "core/drawing/commands/limit_fix.hpp"
#include "core/drawing/commands/mesh_within_limits.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/airfoil.hpp"
#include "tests/support/domain_builder.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace forefront;

namespace {

LimitVerdict verdictOn(MeshLimit limit, double bound, double worst, std::size_t broken = 3) {
    return {.limit = limit, .bound = bound, .judged = 100, .broken = broken, .worst = worst, .places = {}};
}

std::optional<LimitFix> fixOfGrowth(const SpacingSpec &spec, const Domain &domain) {
    const Result<std::shared_ptr<const SpacingField>> field = SpacingField::build(spec, domain);
    REQUIRE(field);
    Document document;
    document.spacing = spec;
    return fixOf(document, verdictOn(MeshLimit::MaxGrowth, 2.0, 2.6), field->get());
}

} // namespace

TEST_CASE("fixOf: a broken limit has a command that says what it changes, until its setting is at its end") {
    Document document;
    LimitVerdict growth = verdictOn(MeshLimit::MaxGrowth, 2.0, 2.6);
    const std::optional<LimitFix> gentler = fixOf(document, growth, nullptr);
    REQUIRE(gentler);
    CHECK(gentler->change == "gradation auto \xe2\x86\x92 0.16");
    CHECK(gentler->document.spacing.gradation == 0.16);
    document.spacing.gradation = 0.02;
    CHECK_FALSE(fixOf(document, growth, nullptr));
    growth.broken = 0;
    CHECK_FALSE(fixOf(Document(), growth, nullptr));

    const auto fixed = [](const Document &from, MeshLimit limit, double bound, double worst) {
        return fixOf(from, verdictOn(limit, bound, worst, 1), nullptr);
    };
    CHECK(fixed({}, MeshLimit::MinAcross, 3.5, 1.0)->document.spacing.elementsAcross == 4.0);
    CHECK(fixed({}, MeshLimit::MinLength, 1.0, 0.5)->document.spacing.minimum == 1.2);
    CHECK(fixed({}, MeshLimit::MaxLength, 1.0, 2.0)->document.spacing.maximum == 0.9);
    CHECK(fixed({}, MeshLimit::MinAngle, 25.0, 20.0)->document.options.leastAngle == 25.0);
    CHECK(fixed({}, MeshLimit::MaxAngle, 130.0, 140.0)->document.options.leastAngle == 25.0);
    CHECK(fixed({}, MeshLimit::MinAlpha, 0.6, 0.5)->document.options.improve == ImproveLevel::Best);
    Document best;
    best.options.improve = ImproveLevel::Best;
    CHECK_FALSE(fixed(best, MeshLimit::MaxValence, 7.0, 8.0));
    Document bounded;
    bounded.spacing.maximum = 1.0;
    CHECK_FALSE(fixed(bounded, MeshLimit::MinLength, 1.0, 0.5)); // a minimum above the maximum
}

TEST_CASE("fixOf: the gradation of a fix is below the one in force, whatever set it") {
    const Domain square = testing::squareDomain(4.0);
    CHECK(fixOfGrowth({}, square)->document.spacing.gradation == 0.16);                // of 0.25
    CHECK(fixOfGrowth({}, testing::discDomain())->document.spacing.gradation == 0.11); // of 0.18
    SpacingSpec expression;
    expression.expression = "0.1 + 0.9*x";
    CHECK(fixOfGrowth(expression, square)->document.spacing.gradation == 0.31); // of 0.5
    SpacingSpec given;
    given.gradation = 0.3;
    CHECK(fixOfGrowth(given, square)->document.spacing.gradation == 0.19);
    CHECK(fixOfGrowth(given, testing::discDomain())->document.spacing.gradation == 0.11); // curves take 0.18
}

TEST_CASE("fixOf: the aspect ratio of layers is given, so that no better improvement is tried") {
    Document document;
    const LimitVerdict flat = verdictOn(MeshLimit::MaxAspect, 10.0, 20.0);
    CHECK(fixOf(document, flat, nullptr));
    document.layers.emplace_back();
    CHECK_FALSE(fixOf(document, flat, nullptr));
}

TEST_CASE("whyNoBetter: a worst place far beyond the one before counts more than fewer violations") {
    const auto why = [](double worstBefore, std::size_t broken, double worst) {
        const std::vector<LimitVerdict> before{verdictOn(MeshLimit::MinAngle, 33.0, worstBefore, 30)};
        return whyNoBetter(before, std::vector{verdictOn(MeshLimit::MinAngle, 33.0, worst, broken)});
    };
    CHECK(why(28.2, 12, 0.16) == "the minimum angle became 0.16\xc2\xb0 instead of 28.2\xc2\xb0");
    CHECK(why(28.2, 12, 28.2).empty());
    CHECK(why(28.2, 12, 27.0).empty()); // hardly worse, but fewer
    CHECK(why(28.2, 0, 33.5).empty());
    CHECK(why(28.2, 30, 28.2) == "30 places violate a limit, as before");
    CHECK(why(28.2, 31, 28.2) == "31 places violate a limit instead of 30");
}

TEST_CASE("whyNoBetter: all limits count") {
    const std::vector<LimitVerdict> before{verdictOn(MeshLimit::MaxGrowth, 2.0, 2.6, 5),
                                           verdictOn(MeshLimit::MinAngle, 33.0, 32.0, 1)};
    std::vector<LimitVerdict> after = before;
    after[0].broken = 2;
    CHECK(whyNoBetter(before, after).empty());
    after[1].broken = 9;
    CHECK(whyNoBetter(before, after) == "11 places violate a limit instead of 6");
    after[1] = verdictOn(MeshLimit::MinAngle, 33.0, 20.0, 1);
    CHECK(whyNoBetter(before, after).starts_with("the minimum angle became 20"));
}

TEST_CASE("meshWithinLimits: a fix of growth keeps the mesh as coarse as the limit allows") {
    MeshingJob job;
    job.domain = testing::squareDomain(4.0);
    job.spacing.expression = "max(0.02, 0.9*sqrt((x-2)^2 + (y-1)^2))";
    MeshLimits limits;
    limits[MeshLimit::MaxGrowth] = 2.2;
    const Result<FixedMesh> fixed = meshWithinLimits(job, limits, {});
    REQUIRE(fixed);
    CHECK(checkLimits(fixed->outcome.mesh, limits, fixed->outcome.spacing.get(), 1).front().broken == 0);
    CHECK(*fixed->job.spacing.gradation > 0.2); // from 0.25 on it would be 0.17, with twice as many elements
}
