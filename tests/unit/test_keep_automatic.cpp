#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A star, whose tips are narrow, so that its automatic spacing varies and has many sites.
Domain star() {
    Domain domain;
    constexpr std::uint32_t kCorners = 24;
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const double radius = k % 2 == 0 ? 5.0 : 3.0, angle = 2.0 * std::numbers::pi * k / kCorners;
        domain.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        domain.segments.push_back({k, (k + 1) % kCorners});
    }
    return domain;
}

SizeSource fine(Vec2 at) {
    SizeSource source;
    source.a = at;
    source.size = 0.01;
    return source;
}

} // namespace

TEST_CASE("SpacingField: sources that keep automatic spacing refine it, and leave it as it is elsewhere, bit for bit") {
    const auto automatic = fieldOf({}, star());
    for (const int sources : {1, 6, 9}) {
        SpacingSpec spec;
        spec.keepAutomatic = true;
        for (int k = 0; k < sources; ++k) {
            spec.sources.push_back(fine({0.1 * k, 0.5}));
        }
        const auto kept = fieldOf(spec, star());
        CHECK(kept->at({0, 0.5}) == doctest::Approx(0.01).epsilon(0.02));
        CHECK(kept->sample({0, 0.5}).describe == "source 0");
        std::size_t unchanged = 0, finer = 0;
        for (int i = 0; i < 1600; ++i) {
            const int row = i / 40;
            const Vec2 p{-4.0 + 0.2 * (i % 40), -4.0 + 0.2 * row};
            const double rho = kept->at(p);
            REQUIRE(rho <= automatic->at(p) * (sources > 6 ? 1.01 : 1.0));
            unchanged += rho == automatic->at(p) ? 1 : 0;
            finer += rho < automatic->at(p) ? 1 : 0;
        }
        CHECK(finer > 20);
        if (sources <= 6) {
            CHECK(unchanged > 1000);
            CHECK(unchanged + finer == 1600);
        }
    }
}

TEST_CASE("SpacingField: without keepAutomatic, sources alone set the spacing") {
    SpacingSpec spec;
    spec.sources = {fine({0, 0.5})};
    CHECK_FALSE(spec.usesAutomatic());
    CHECK(fieldOf(spec, star())->at({0, 3.5}) == doctest::Approx(0.61));
    spec.keepAutomatic = true;
    CHECK(spec.usesAutomatic());
    CHECK_FALSE(spec.automatic());
    spec.size = 0.5; // replaces automatic spacing in any case
    CHECK_FALSE(spec.usesAutomatic());
    CHECK(fieldOf(spec, star())->at({0, 3.5}) == 0.5);
}

TEST_CASE("addSource: a first source keeps automatic spacing, unless the user has switched that off before") {
    const Document first = *addSource({}, fine({0, 0}));
    CHECK(first.spacing.keepAutomatic == true);
    CHECK(addSource(first, fine({1, 0}))->spacing.keepAutomatic == true);
    const Document replacing = setKeepAutomatic(first, false);
    CHECK(addSource(replacing, fine({1, 0}))->spacing.keepAutomatic == false);
    const Document none = *removeSource(replacing, 0);
    CHECK(addSource(none, fine({1, 0}))->spacing.keepAutomatic == false);
    const Document reopened = *parseProject(projectText(none), "test");
    CHECK(addSource(reopened, fine({1, 0}))->spacing.keepAutomatic == false);
}

TEST_CASE("addSource: nobody has chosen in an older project, whose sources go on replacing automatic spacing") {
    Document older;
    older.spacing.sources = {fine({0, 0})};
    older = *parseProject(projectText(older), "test");
    CHECK_FALSE(older.spacing.usesAutomatic());
    const Document two = *addSource(older, fine({1, 0}));
    CHECK_FALSE(two.spacing.keepAutomatic.has_value());
    CHECK_FALSE(two.spacing.usesAutomatic());
    const Document none = *removeSource(*removeSource(two, 1), 0);
    CHECK(addSource(none, fine({1, 0}))->spacing.keepAutomatic == true);
}

TEST_CASE("insertCopied: pasted sources keep automatic spacing, unless the sources of the document replace it") {
    const Document copied = *addSource({}, fine({0, 0}));
    CHECK(insertCopied({}, copied, {1, 1}, nullptr)->spacing.keepAutomatic == true);
    CHECK(insertCopied(setKeepAutomatic(copied, false), copied, {1, 1}, nullptr)->spacing.keepAutomatic == false);
    CHECK_FALSE(insertCopied({}, {}, {1, 1}, nullptr)->spacing.keepAutomatic.has_value());
}

TEST_CASE("Project: keepAutomatic is written only where it was chosen, and older projects have no choice") {
    const Document kept = *addSource({}, fine({0, 0}));
    const std::string text = projectText(kept);
    CHECK(text.find("\"keepAutomatic\": true") != std::string::npos);
    CHECK(parseProject(text, "test")->spacing.keepAutomatic == true);
    CHECK(parseProject(projectText(setKeepAutomatic(kept, false)), "test")->spacing.keepAutomatic == false);
    Document older = kept;
    older.spacing.keepAutomatic.reset();
    CHECK(projectText(older).find("keepAutomatic") == std::string::npos);
    CHECK_FALSE(parseProject(projectText(older), "test")->spacing.keepAutomatic.has_value());
    const auto refused =
        parseProject(R"({"format": "forefront", "version": 2, "shapes": [], "spacing": {"keepAutomatic": 1}})", "test");
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().line == 1);
}
