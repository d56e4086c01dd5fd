#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/parts/paint/paint.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A square of side 10 with a narrow notch at the left, which makes automatic spacing fine there.
Domain notched() {
    Domain domain;
    domain.nodes = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5.1}, {3, 5.1}, {3, 4.9}, {0, 4.9}};
    for (std::uint32_t i = 0; i < 8; ++i) {
        domain.segments.push_back({i, (i + 1) % 8, 1, SegmentRole::Boundary});
    }
    return domain;
}

PaintedSpacing canvas() {
    PaintedSpacing paint = emptyPaint({{0, 0}, {10, 10}});
    paint.replaces = true;
    return paint;
}

/// Strokes a place `times` times with dabs that start from a field.
PaintedSpacing stroked(PaintedSpacing paint, Vec2 at, double radius, DabMode mode, int times,
                       const SpacingField &around) {
    Dab dab{at, radius, 0.1, 0.5};
    dab.mode = mode;
    dab.around = [&](Vec2 place) { return around.at(place); };
    for (int k = 0; k < times; ++k) {
        paint = forefront::paint(paint, dab);
    }
    return paint;
}

} // namespace

TEST_CASE("Replacing paint: coarser doubles automatic spacing in eight dabs and fades into it") {
    const Domain domain = notched();
    SpacingSpec spec;
    const auto before = fieldOf(spec, domain);
    spec.gradation = 2.0; // or the spacing could not double within the brush
    const auto steep = fieldOf(spec, domain);
    const Vec2 at{6, 5};
    spec.paint = stroked(canvas(), at, 2.0, DabMode::Coarser, 8, *before);
    const auto after = fieldOf(spec, domain);
    CHECK(after->at(at) == doctest::Approx(2.0 * before->at(at)).epsilon(0.02));
    CHECK(after->sample(at).origin == SpacingOrigin::Paint);
    for (const Vec2 outside : {Vec2{6, 7.2}, Vec2{8.3, 5}, Vec2{1, 1}}) {
        CHECK(after->at(outside) <= steep->at(outside) * 1.001);
    }
    // Paint of older versions only refines.
    spec.paint.replaces = false;
    CHECK(fieldOf(spec, domain)->at(at) <= steep->at(at) * 1.001);
    // Over a constant size, too.
    SpacingSpec constant;
    constant.size = 0.5;
    constant.paint = stroked(canvas(), at, 2.0, DabMode::Coarser, 8, *fieldOf(constant, domain));
    CHECK(fieldOf(constant, domain)->at(at) == doctest::Approx(0.75).epsilon(0.2)); // limited by gradation
    CHECK(fieldOf(constant, domain)->at(at) > 0.6);
    CHECK(fieldOf(constant, domain)->at({1, 1}) == 0.5);
}

TEST_CASE("Replacing paint: smooth evens out automatic spacing where nothing was painted") {
    const Domain domain = notched();
    const auto before = fieldOf({}, domain);
    const Vec2 at{3, 5};
    const PaintedSpacing paint = stroked(canvas(), at, 1.5, DabMode::Smooth, 10, *before);
    CHECK_FALSE(paint.tiles.empty());
    SpacingSpec spec;
    spec.paint = paint;
    const auto after = fieldOf(spec, domain);
    CHECK(after->at(at) > 1.15 * before->at(at)); // the finest place becomes coarser
    CHECK(after->at({3, 6.8}) == doctest::Approx(before->at({3, 6.8})).epsilon(0.02));
}

TEST_CASE("Replacing paint: sizes of boundary parts and limits stay in force, and the inspector names them") {
    Domain domain = notched();
    domain.segments[1].tag = 4;
    domain.boundaryNames[4] = "outlet";
    SpacingSpec spec;
    spec.size = 1.0;
    spec.partSizes[4] = {0.1, 0.1};
    spec.paint = fill(canvas(), {{7, 3}, {10, 7}}, [](Vec2) { return 2.0; });
    const auto field = fieldOf(spec, domain);
    CHECK(field->at({10, 5}) == doctest::Approx(0.1));
    CHECK(field->sample({10, 5}).describe.find("outlet") != std::string::npos);
    CHECK(field->sample({10, 5}).runnerUp->describe == "painted");
    spec.partSizes.clear();
    CHECK(fieldOf(spec, domain)->at({8.5, 5}) == doctest::Approx(1.0 + 0.25 * 1.5).epsilon(0.02));
    CHECK(fieldOf(spec, domain)->sample({8.5, 5}).origin == SpacingOrigin::Gradation);
    spec.maximum = 1.1;
    CHECK(fieldOf(spec, domain)->at({8.5, 5}) == 1.1);
}

TEST_CASE("Replacing paint: random paint keeps the gradation, and the bounds hold") {
    const Domain domain = notched();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 10.0), size(0.05, 3.0), radius(0.2, 3.0);
    SpacingSpec spec;
    spec.gradation = 0.3;
    spec.paint = canvas();
    for (int k = 0; k < 12; ++k) {
        spec.paint = forefront::paint(spec.paint, {{place(random), place(random)}, radius(random), size(random), 0.6});
    }
    const auto field = fieldOf(spec, domain);
    const double pitch = spec.paint.pitch;
    for (int k = 0; k < 20'000; ++k) {
        const Vec2 p{place(random), place(random)};
        const Vec2 q = p + Vec2{0.4, 0.1} * (place(random) - 5.0);
        if (q.x < 0 || q.y < 0 || q.x > 10 || q.y > 10) {
            continue;
        }
        CHECK(std::fabs(field->at(p) - field->at(q)) <=
              0.3 * (1.03 * distance(p, q) + 2.0 * pitch) + 0.01 * field->at(p));
        CHECK(field->at(p) >= field->minimum());
        CHECK(field->at(p) <= field->maximum());
        CHECK(field->sample(p).rho == field->at(p));
    }
}

TEST_CASE("Replacing paint: older paint becomes replacing without a change of the spacing") {
    const Domain domain = notched();
    SpacingSpec old;
    old.paint = forefront::paint(emptyPaint({{0, 0}, {10, 10}}), {{3, 5}, 2.0, 0.15, 0.6, 0.5});
    const auto before = fieldOf(old, domain);
    SpacingSpec now;
    now.paint = replacing(old.paint, [&](Vec2 p) { return before->at(p); });
    CHECK(now.paint.replaces);
    CHECK_FALSE(sameContent(old, now));
    const auto after = fieldOf(now, domain);
    for (double x = 0.1; x < 10.0; x += 0.37) {
        for (double y = 0.1; y < 10.0; y += 0.37) {
            CHECK(after->at({x, y}) == doctest::Approx(before->at({x, y})).epsilon(0.05));
        }
    }
}

TEST_CASE("Replacing paint: project files keep it, and files without the word only refine") {
    Document document;
    document.spacing.paint = fill(canvas(), {{1, 1}, {2, 2}}, [](Vec2) { return 0.5; });
    const std::string text = projectText(document);
    CHECK(text.find("\"replaces\": true") != std::string::npos);
    const auto read = parseProject(text, "test");
    REQUIRE(read.ok());
    CHECK(read->spacing.paint.replaces);
    document.spacing.paint.replaces = false;
    CHECK(projectText(document).find("replaces") == std::string::npos);
    CHECK_FALSE(parseProject(projectText(document), "test")->spacing.paint.replaces);
}

TEST_CASE("Replacing paint: a dab asks for the spacing at a node at most twice, also one that smooths") {
    std::map<std::pair<double, double>, int> asked;
    Dab dab{{5, 5}, 1.0, 0.1, 0.5};
    dab.around = [&](Vec2 place) {
        ++asked[{place.x, place.y}];
        return 0.1 + 0.01 * place.x;
    };
    for (const DabMode mode : {DabMode::Set, DabMode::Coarser, DabMode::Smooth}) {
        asked.clear();
        dab.mode = mode;
        forefront::paint(canvas(), dab);
        REQUIRE(asked.size() > 1000);
        CHECK(std::all_of(asked.begin(), asked.end(), [](const auto &entry) { return entry.second <= 2; }));
    }
}
