#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/parts/paint/paint.hpp"
#include "core/engine/spacing/parts/paint/painted_part.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

PaintedSpacing canvas(double side) {
    return emptyPaint({{0, 0}, {side, side}});
}

std::size_t sharedTiles(const PaintedSpacing &a, const PaintedSpacing &b) {
    std::size_t shared = 0;
    for (const auto &[key, tile] : a.tiles) {
        const auto found = b.tiles.find(key);
        shared += found != b.tiles.end() && found->second == tile ? 1 : 0;
    }
    return shared;
}

} // namespace

TEST_CASE("Paint: the pitch suits the domain and is a power of two") {
    const PaintedSpacing paint = emptyPaint({{0, 0}, {30, 40}});
    CHECK(paint.pitch <= 50.0 / 512.0);
    CHECK(paint.pitch > 50.0 / 1024.0);
    CHECK(std::exp2(std::nearbyint(std::log2(paint.pitch))) == paint.pitch);
    CHECK(paint.tiles.empty());
}

TEST_CASE("Paint: a hard dab paints the nodes of its disc and nothing else") {
    const PaintedSpacing paint = forefront::paint(canvas(10), {{5, 4}, 1.0, 0.05, 1.0, 0.0});
    REQUIRE(!paint.tiles.empty());
    for (std::int32_t j = 0; j * paint.pitch < 10; ++j) {
        for (std::int32_t i = 0; i * paint.pitch < 10; ++i) {
            const bool inside = distance({i * paint.pitch, j * paint.pitch}, {5, 4}) <= 1.0;
            REQUIRE(paintedNode(paint, i, j) == (inside ? 0.05F : 0.0F));
        }
    }
}

TEST_CASE("Paint: a dab at negative coordinates lands where it should") {
    PaintedSpacing paint = emptyPaint({{-5, -5}, {5, 5}});
    paint = forefront::paint(paint, {{-3.2, -1.1}, 0.5, 0.1, 1.0, 0.0});
    const auto i = static_cast<std::int32_t>(std::nearbyint((-3.2 - paint.origin.x) / paint.pitch));
    const auto j = static_cast<std::int32_t>(std::nearbyint((-1.1 - paint.origin.y) / paint.pitch));
    CHECK(paintedNode(paint, i, j) == 0.1F);
    CHECK(paintedNode(paint, i + static_cast<std::int32_t>(0.6 / paint.pitch), j) == 0.0F);
}

TEST_CASE("Paint: a brush smaller than the pitch still paints the nearest node") {
    const PaintedSpacing paint = forefront::paint(canvas(10), {{5.003, 4.004}, 1e-6, 0.05, 1.0, 0.0});
    CHECK(paintedNode(paint, static_cast<std::int32_t>(std::nearbyint(5.003 / paint.pitch)),
                      static_cast<std::int32_t>(std::nearbyint(4.004 / paint.pitch))) == 0.05F);
}

TEST_CASE("Paint: a dab shares the tiles it does not change, and changing nothing shares all") {
    const PaintedSpacing first = forefront::paint(canvas(10), {{2, 2}, 1.5, 0.05, 1.0, 0.0});
    const PaintedSpacing second = forefront::paint(first, {{8, 8}, 1.0, 0.1, 0.5, 0.0});
    CHECK(sharedTiles(first, second) == first.tiles.size());
    const PaintedSpacing third = forefront::paint(second, {{2, 2}, 0.5, 0.05, 1.0, 0.0});
    CHECK(sharedTiles(second, third) == second.tiles.size());
    CHECK(first.tiles.size() < second.tiles.size());
}

TEST_CASE("Paint: erasing everything leaves no tile, erasing a part keeps the rest") {
    const PaintedSpacing painted = forefront::paint(canvas(10), {{5, 5}, 2.0, 0.05, 0.3, 1.0});
    CHECK(erase(painted, {5, 5}, 2.1).tiles.empty());
    const PaintedSpacing part = erase(painted, {5, 5}, 0.5);
    const auto middle = static_cast<std::int32_t>(5 / painted.pitch);
    CHECK(paintedNode(part, middle, middle) == 0.0F);
    const auto off = static_cast<std::int32_t>(5.6 / painted.pitch);
    CHECK(paintedNode(part, off, middle) == paintedNode(painted, off, middle));
    CHECK(erase(part, {100, 100}, 1.0).tiles == part.tiles);
}

TEST_CASE("Paint: the rim fades geometrically from the target to the ambient spacing") {
    const PaintedSpacing paint = forefront::paint(canvas(16), {{8, 8}, 4.0, 0.01, 0.5, 1.0});
    const auto at = [&](double r) {
        return paintedNode(paint, static_cast<std::int32_t>(std::nearbyint((8 + r) / paint.pitch)),
                           static_cast<std::int32_t>(std::nearbyint(8 / paint.pitch)));
    };
    CHECK(at(0) == 0.01F);
    CHECK(at(1.9) == 0.01F);
    CHECK(at(3.0) == doctest::Approx(0.1).epsilon(1e-5));
    CHECK(at(3.99) == doctest::Approx(1.0).epsilon(0.01));
    for (double r = 0.1; r < 4.0; r += 0.1) {
        CHECK(at(r) >= at(r - 0.1));
    }
}

TEST_CASE("Paint: invalid numbers change nothing") {
    const PaintedSpacing before = forefront::paint(canvas(10), {{5, 5}, 1.0, 0.05, 1.0, 0.0});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const Dab &dab : {Dab{{nan, 5}, 1.0, 0.1}, Dab{{5, 5}, 0.0, 0.1}, Dab{{5, 5}, inf, 0.1},
                           Dab{{5, 5}, 1.0, -1.0}, Dab{{5, 5}, 1.0, nan}, Dab{{1e300, 5}, 1.0, 0.1}}) {
        CHECK(forefront::paint(before, dab).tiles == before.tiles);
    }
}

TEST_CASE("Paint: a dab of any radius keeps within its tiles") {
    const PaintedSpacing paint = forefront::paint(canvas(10), {{5, 5}, 1e6, 0.05, 1.0, 0.0});
    CHECK(paint.tiles.size() <= 34U * 34U);
}

TEST_CASE("SpacingField: a painted patch holds its value and blends outwards by gradation") {
    SpacingSpec spec;
    spec.size = 1.0;
    spec.paint = forefront::paint(canvas(10), {{5, 5}, 1.0, 0.05, 1.0, 0.0});
    const auto field = fieldOf(spec, squareDomain(10));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    const double pitch = spec.paint.pitch;
    for (int i = 0; i < 5000; ++i) {
        const Vec2 p{place(random), place(random)};
        const double r = distance(p, {5, 5});
        if (r < 1.0 - pitch) {
            CHECK(field->at(p) == doctest::Approx(0.05).epsilon(1e-6));
        } else if (r > 1.0 + 2 * pitch) {
            // the paint ends within a cell of the circle
            CHECK(field->at(p) <= std::min(1.0, 0.05 + 0.25 * (r - 1.0 + pitch)) * 1.006);
            CHECK(field->at(p) >= std::min(1.0, 0.05 + 0.25 * (r - 1.0 - 1.5 * pitch)) * 0.994);
        }
        CHECK(field->at(p) >= field->minimum());
        CHECK(field->at(p) <= field->maximum());
    }
    CHECK(field->sample({5, 5}).origin == SpacingOrigin::Paint);
    CHECK(field->sample({5, 6.5}).origin == SpacingOrigin::Gradation);
    CHECK(field->sample({0, 0}).origin == SpacingOrigin::Constant);
}

TEST_CASE("SpacingField: painted values are bilinear between four painted nodes, and the minimum at the edge") {
    SpacingSpec spec;
    spec.size = 100.0;
    spec.gradation = 1e6; // no limit worth the name
    spec.paint.pitch = 1.0;
    auto tile = std::make_shared<PaintedSpacing::Tile>();
    (*tile)[0] = 1.0F;
    (*tile)[1] = 2.0F;
    (*tile)[16] = 3.0F;
    (*tile)[17] = 4.0F;
    (*tile)[2] = 5.0F;
    spec.paint.tiles[{0, 0}] = tile;
    const auto field = fieldOf(spec, squareDomain(10));
    CHECK(field->at({0.5, 0.5}) == doctest::Approx(2.5));
    CHECK(field->at({0.25, 0.75}) == doctest::Approx(1.0 + 0.25 + 0.75 * 2.0));
    CHECK(field->at({1.5, 0.5}) == doctest::Approx(2.0)); // nodes 2, 5, 4 and an unpainted one
    CHECK(field->at({0.5, 1.5}) == doctest::Approx(3.0));
    CHECK(field->at({5.5, 5.5}) == doctest::Approx(100.0));
}

TEST_CASE("SpacingField: random paint keeps the gradation within 2 %") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int round = 0; round < 5; ++round) {
        SpacingSpec spec;
        spec.size = 1.0;
        spec.gradation = 0.2;
        spec.paint = canvas(10);
        for (int n = 0; n < 12; ++n) {
            spec.paint = forefront::paint(spec.paint, {{10 * place(random), 10 * place(random)},
                                                       0.2 + place(random),
                                                       0.1 * std::exp2(3 * place(random)),
                                                       place(random),
                                                       n % 2 == 0 ? 1.0 : 0.0});
        }
        const auto field = fieldOf(spec, squareDomain(10));
        for (int i = 0; i < 4000; ++i) {
            const Vec2 p{10 * place(random), 10 * place(random)};
            const double reach = i % 2 == 0 ? 10.0 : 0.2;
            const Vec2 q{std::clamp(p.x + reach * (place(random) - 0.5), 0.0, 10.0),
                         std::clamp(p.y + reach * (place(random) - 0.5), 0.0, 10.0)};
            CHECK(std::fabs(field->at(p) - field->at(q)) <=
                  0.2 * distance(p, q) + 0.02 * std::max(field->at(p), field->at(q)));
        }
    }
}

TEST_CASE("SpacingField: a size source beside a long stroke keeps its exact values") {
    SpacingSpec spec;
    spec.size = 1.0;
    spec.gradation = 0.2;
    spec.paint = canvas(10);
    for (int n = 0; n <= 100; ++n) {
        const Vec2 centre{1.0 + 0.08 * n, 2.0 + std::sin(0.3 * n)};
        spec.paint = forefront::paint(spec.paint, {centre, 0.5, 0.1, 0.7, 0.8});
    }
    SiteSet edges;
    PaintedPart::addSites(spec.paint, 0.0, 0.2, edges);
    REQUIRE(edges.sites.size() > 1000); // too many to be met exactly
    SizeSource source;
    source.a = {5, 8};
    source.size = 0.05;
    source.growth = 0.2;
    const auto strokeAlone = fieldOf(spec, squareDomain(10));
    spec.sources = {source};
    const auto field = fieldOf(spec, squareDomain(10));
    for (int n = 0; n <= 100; ++n) {
        const Vec2 p{0.1 * n, 7.0}; // nearer to the source in the middle
        const double expected = std::min(strokeAlone->at(p), 0.05 + 0.2 * distance(p, source.a));
        CHECK(field->at(p) == doctest::Approx(std::min(1.0, expected)).epsilon(1e-12));
    }
    CHECK(field->sample({5, 8}).origin == SpacingOrigin::Source);
    CHECK(field->sample({5, 2}).origin == SpacingOrigin::Paint);
}

TEST_CASE("SpacingField: refuses invalid paint") {
    SpacingSpec spec;
    spec.paint.pitch = 0.0;
    spec.paint.tiles[{0, 0}] = std::make_shared<PaintedSpacing::Tile>();
    CHECK(SpacingField::build(spec, squareDomain(1)).faults().front().code == "bad-paint");
    spec.paint.pitch = 1e-12;
    CHECK(SpacingField::build(spec, squareDomain(1)).faults().front().code == "bad-paint");
    spec.paint.pitch = 0.1;
    auto tile = std::make_shared<PaintedSpacing::Tile>();
    (*tile)[17] = -1.0F;
    spec.paint.tiles[{2, 0}] = tile;
    const auto refused = SpacingField::build(spec, squareDomain(1));
    REQUIRE(!refused.ok());
    CHECK(refused.faults().front().at->x == doctest::Approx(3.3));
}

TEST_CASE("Brush modes: finer and coarser scale the current spacing by octaves, smooth evens it out") {
    const PaintedSpacing base = forefront::paint(canvas(10), {{5, 5}, 4.0, 0.1, 1.0, 0.0});
    const auto value = [&](const PaintedSpacing &paint, Vec2 at) {
        const Vec2 node = (1.0 / paint.pitch) * (at - paint.origin);
        return static_cast<double>(paintedNode(paint, static_cast<std::int32_t>(std::lround(node.x)),
                                               static_cast<std::int32_t>(std::lround(node.y))));
    };
    Dab dab{{5, 5}, 1.0, 0.1, 0.5, 0.0};
    dab.mode = DabMode::Finer;
    PaintedSpacing finer = base;
    for (int k = 0; k < 8; ++k) {
        finer = forefront::paint(finer, dab);
    }
    CHECK(value(finer, {5, 5}) == doctest::Approx(0.05).epsilon(1e-5));
    CHECK(value(finer, {5.75, 5}) > 0.05);
    CHECK(value(finer, {5.75, 5}) < 0.1);
    CHECK(value(finer, {6.5, 5}) == doctest::Approx(0.1));
    dab.mode = DabMode::Coarser;
    dab.strength = 0.5;
    CHECK(value(forefront::paint(base, dab), {5, 5}) == doctest::Approx(0.1 * std::exp2(0.0625)).epsilon(1e-5));
    dab.ambient = 0.4;
    CHECK(forefront::paint(canvas(10), dab).tiles.empty()); // nothing is painted there
    dab.mode = DabMode::Finer;
    CHECK(value(forefront::paint(canvas(10), dab), {5, 5}) == doctest::Approx(0.4 * std::exp2(-0.0625)).epsilon(1e-5));
    dab.ambient = 0.0;
    CHECK(forefront::paint(canvas(10), dab).tiles.empty());
    dab.mode = DabMode::Erase;
    CHECK(value(forefront::paint(base, dab), {5, 5}) == 0.0);
    CHECK(value(forefront::paint(base, dab), {6.5, 5}) == doctest::Approx(0.1));

    PaintedSpacing step = forefront::paint(base, {{5, 5}, 0.5, 0.02, 1.0, 0.0});
    const double before = value(step, {5, 5.52}) / value(step, {5, 5.48});
    Dab smooth{{5, 5.5}, 0.5, 0.1, 1.0, 0.0};
    smooth.mode = DabMode::Smooth;
    for (int k = 0; k < 10; ++k) {
        step = forefront::paint(step, smooth);
    }
    CHECK(before > 4.0);
    CHECK(value(step, {5, 5.52}) / value(step, {5, 5.48}) < 0.5 * before);
}

TEST_CASE("Brush strength: a weak dab goes part of the way to its target") {
    const PaintedSpacing base = forefront::paint(canvas(10), {{5, 5}, 4.0, 0.1, 1.0, 0.0});
    Dab dab{{5, 5}, 1.0, 0.025, 1.0, 0.0};
    dab.strength = 0.5;
    const PaintedSpacing weak = forefront::paint(base, dab);
    const auto node = static_cast<std::int32_t>(std::lround(5.0 / weak.pitch));
    CHECK(static_cast<double>(paintedNode(weak, node, node)) == doctest::Approx(0.05).epsilon(1e-5));
}

TEST_CASE("Brush strength: unpainted ground starts from the ambient spacing; strength 0 changes nothing") {
    Dab dab{{5, 5}, 1.0, 0.1, 1.0, 0.4};
    dab.strength = 0.5;
    const PaintedSpacing weak = forefront::paint(canvas(10), dab);
    const auto node = static_cast<std::int32_t>(std::lround(5.0 / weak.pitch));
    CHECK(static_cast<double>(paintedNode(weak, node, node)) == doctest::Approx(0.2).epsilon(1e-5));
    dab.strength = 0.0;
    CHECK(forefront::paint(canvas(10), dab).tiles.empty());
    CHECK(forefront::paint(weak, dab).tiles == weak.tiles);
    dab.ambient = 0.0;
    CHECK(forefront::paint(canvas(10), dab).tiles.empty());
}

TEST_CASE("paint: what was painted and erased again is as if it had never been") {
    SpacingSpec never, erased;
    erased.paint.origin = {3.0, 4.0};
    erased.paint.pitch = 0.25;
    erased.paint.replaces = true;
    CHECK(sameContent(never, erased));
    erased.paint.tiles[{0, 0}] = std::make_shared<const PaintedSpacing::Tile>();
    CHECK_FALSE(sameContent(never, erased));
}
