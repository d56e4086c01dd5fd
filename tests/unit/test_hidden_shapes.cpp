#include "core/drawing/arrangement/cover/hidden_shapes.hpp"
#include "core/drawing/arrangement/cover/united.hpp"
#include "tests/unit/arrangement_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

using Rings = std::vector<std::vector<Vec2>>;

/// Returns whether a small square is hidden by a path.
bool hides(const Rings &path, FillRule rule, const std::vector<Vec2> &square) {
    ArrangementInput input;
    addPath(input, FillRule::NonZero, {square});
    addPath(input, rule, path);
    const std::vector<std::uint8_t> hidden = findHiddenShapes(input, 0.01);
    REQUIRE(hidden.size() == 2);
    CHECK(hidden[1] == 0);
    return hidden[0] != 0;
}

/// Returns a disc made of `chords` chords.
OutlinedArea disc(Vec2 centre, double radius, int chords = 8) {
    OutlinedArea area;
    area.curves = {Curve::arc(centre, {radius, 0.0}, {0.0, radius}, 0.0, 2.0 * std::numbers::pi)};
    OutlineRing &ring = area.rings.emplace_back();
    for (int k = 0; k < chords; ++k) {
        const double from = 1.0 * k / chords, to = (k + 1.0) / chords;
        ring.nodes.push_back(area.curves[0].point(from));
        ring.stretches.push_back({0, from, to});
        ring.labels.push_back(0);
    }
    return area;
}

ArrangementInput inputOfAreas(const std::vector<OutlinedArea> &areas, bool asOne) {
    ArrangementInput input;
    input.addFeature(1);
    for (const OutlinedArea &area : areas) {
        const std::uint32_t shape = asOne && !input.shapes.empty() ? 0 : input.addShape(0);
        addArea(input, shape, area);
    }
    return input;
}

std::vector<OutlinedArea> randomDiscs(std::mt19937 &random, int count, int chords = 8) {
    std::uniform_real_distribution<double> place(0.0, 10.0), radius(0.2, 2.0);
    std::vector<OutlinedArea> discs;
    for (int k = 0; k < count; ++k) {
        const Vec2 centre{place(random), place(random)};
        discs.push_back(disc(centre, radius(random), chords));
    }
    return discs;
}

} // namespace

TEST_CASE("findHiddenShapes: a shape within the area of another is hidden, one in or around its holes is not") {
    const std::vector<Vec2> square = rectangle(4, 4, 2, 2), whole = rectangle(0, 0, 10, 10);
    CHECK(hides({whole}, FillRule::NonZero, square));
    CHECK(hides({whole}, FillRule::EvenOdd, square));
    CHECK(hides({whole, rectangle(1, 1, 2, 2)}, FillRule::EvenOdd, square)); // beside a hole
    CHECK_FALSE(hides({whole, rectangle(3, 3, 4, 4)}, FillRule::EvenOdd, square));
    CHECK(hides({whole, rectangle(3, 3, 4, 4)}, FillRule::NonZero, square));
    CHECK_FALSE(hides({whole, rectangle(4.5, 4.5, 1, 1)}, FillRule::EvenOdd, square)); // it fills that hole
    CHECK_FALSE(hides({whole}, FillRule::NonZero, rectangle(0.005, 4, 2, 2)));         // within reach of the outline
    CHECK_FALSE(hides({whole}, FillRule::NonZero, rectangle(11, 4, 2, 2)));
    CHECK_FALSE(hides({{{0, 0}, {10, 0}, {0, 10}}}, FillRule::NonZero, rectangle(5.5, 5.5, 2, 2))); // in its box alone
}

TEST_CASE("findHiddenShapes: curves count, not their chords; so do clips and features") {
    ArrangementInput input;
    input.addFeature(1);
    const std::uint32_t bay = input.addContour(input.addShape(0));
    input.curves = {Curve::cubic({10, 0}, {2, 3}, {2, 7}, {10, 10})};
    const std::vector<Vec2> corners = rectangle(0, 0, 10, 10);
    const std::vector<CurveStretch> sides{{}, {0, 0.0, 1.0}, {}, {}};
    input.addRing(bay, corners, 1, sides);
    for (const double x : {0.5, 7.0}) { // left of the curve, and between it and its chord
        input.addRing(input.addContour(input.addShape(0)), rectangle(x, 4.5, 1, 1), 1);
    }
    CHECK(findHiddenShapes(input, 0.01) == std::vector<std::uint8_t>{0, 1, 0});

    ArrangementInput clipped;
    clipped.addFeature(1);
    const std::uint32_t clip = clipped.addClip();
    clipped.addRing(clipped.addContour(clipped.addClipPart(clip)), rectangle(0, 0, 5, 5), 7);
    clipped.addRing(clipped.addContour(clipped.addShape(0, {}, clip)), rectangle(0, 0, 10, 10), 1);
    clipped.addRing(clipped.addContour(clipped.addShape(0, {}, clip)), rectangle(1, 1, 2, 2), 1);
    clipped.addRing(clipped.addContour(clipped.addShape(0)), rectangle(6, 6, 2, 2),
                    1); // where the clip hides the other
    CHECK(findHiddenShapes(clipped, 0.01) == std::vector<std::uint8_t>{0, 0, 1, 0});

    ArrangementInput regions;
    addPolygon(regions, 1, {rectangle(0, 0, 10, 10)});
    addPolygon(regions, 2, {rectangle(4, 4, 2, 2)});
    CHECK(findHiddenShapes(regions, 0.01).empty());
}

TEST_CASE("arrange: what is hidden crosses nothing, counts as vanished, and does not depend on the order") {
    ArrangementInput input;
    addPath(input, FillRule::NonZero, {rectangle(1, 1, 3, 3)});
    input.shapes.back().name = "small";
    addPath(input, FillRule::NonZero, {rectangle(0, 0, 10, 10)});
    addPath(input, FillRule::NonZero, {rectangle(2, 2, 3, 3)});
    input.addChain(std::vector<Vec2>{{0.5, 2.5}, {6, 2.5}}, 5);
    const Arrangement result = arranged(input);
    CHECK(result.domain.segments.size() == 5);
    CHECK(find(result, ChangeKind::CrossingSegments) == nullptr);
    REQUIRE(find(result, ChangeKind::VanishedShapes) != nullptr);
    CHECK(find(result, ChangeKind::VanishedShapes)->count == 2);
    CHECK(find(result, ChangeKind::VanishedShapes)->piece == 0);
    CHECK(find(result, ChangeKind::VanishedShapes)->names == "small");
    CHECK(find(result, ChangeKind::InnerOutlines)->count == 8);
    std::rotate(input.pieces.begin(), input.pieces.begin() + 6, input.pieces.end());
    CHECK(segmentSet(arranged(input).domain) == segmentSet(result.domain));
}

TEST_CASE("findHiddenShapes: a hole of a polygon hides nothing, and very many crossings are not counted") {
    ArrangementInput holed;
    const std::uint32_t shape = holed.addShape(holed.addFeature(1));
    holed.addRing(holed.addContour(shape), rectangle(0, 0, 10, 10), 1);
    holed.addRing(holed.addContour(shape, FillRule::NonZero, true), rectangle(1, 1, 5, 5), 1);
    holed.addRing(holed.addContour(holed.addShape(0)), rectangle(2, 2, 1, 1), 1);
    holed.addRing(holed.addContour(holed.addShape(0)), rectangle(7, 7, 1, 1), 1);
    CHECK(findHiddenShapes(holed, 0.01) == std::vector<std::uint8_t>{0, 0, 1});

    std::vector<Vec2> comb{{-10, 0}, {-10, -5}, {3000, -5}};
    for (int tooth = 1499; tooth >= 0; --tooth) {
        comb.insert(comb.end(), {{2.0 * tooth + 1.5, 0.0}, {2.0 * tooth + 1.0, 10.0}, {2.0 * tooth + 0.5, 0.0}});
    }
    comb.insert(comb.end(), {{-5.0, 0.0}, {-5.0, 10.0}});
    comb.push_back({-10, 10});
    ArrangementInput input;
    addPath(input, FillRule::NonZero, {comb});
    addPath(input, FillRule::NonZero, {rectangle(-8, 4.6, 1, 1)});  // before all teeth
    addPath(input, FillRule::NonZero, {rectangle(2900, -4, 1, 1)}); // below them
    CHECK(findHiddenShapes(input, 0.01) == std::vector<std::uint8_t>{0, 0, 1});
}

TEST_CASE("arrange: random discs, some hidden, cover what they cover as one shape") {
    std::mt19937 random(5);
    std::size_t hidden = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<OutlinedArea> discs = randomDiscs(random, 12);
        for (double size = 0.05; size < 0.4; size += 0.05) {
            discs.push_back(disc(discs[round % 12].rings[0].nodes[0] - Vec2{0.5, 0.0}, size));
        }
        const ArrangementInput apart = inputOfAreas(discs, false), together = inputOfAreas(discs, true);
        const std::vector<std::uint8_t> found = findHiddenShapes(apart, 1e-6);
        hidden += static_cast<std::size_t>(std::count(found.begin(), found.end(), 1));
        CHECK(findHiddenShapes(together, 1e-6).empty()); // a single shape
        const Arrangement first = arranged(apart), second = arranged(together);
        CHECK(segmentSet(first.domain) == segmentSet(second.domain));
    }
    CHECK(hidden > 100);
}

TEST_CASE("uniteAreas: many areas become one that covers the same") {
    std::mt19937 random(9);
    for (const int count : {1, 2, 9, 40, 150}) {
        const std::vector<OutlinedArea> discs = randomDiscs(random, count, 256);
        const std::vector<OutlinedArea> united = uniteAreas(discs, 1e-9);
        REQUIRE(united.size() == 1);
        const Domain expected = arranged(inputOfAreas(discs, true)).domain,
                     found = arranged(inputOfAreas(united, true)).domain;
        CHECK(insideArea(found) == doctest::Approx(insideArea(expected)).epsilon(1e-4)); // the chords differ
        CHECK(found.segments.size() <= expected.segments.size() + 4); // nodes where inner outlines ended stay away
    }
    const std::vector<OutlinedArea> apart = uniteAreas({disc({0, 0}, 1.0), disc({5, 0}, 1.0), disc({9, 0}, 2.0)}, 1e-9);
    REQUIRE(apart.size() == 1);
    CHECK(apart[0].rings.size() == 3);
    CHECK(apart[0].curves.size() == 3);
    CHECK(apart[0].nodeCount() == 24);
    CHECK(uniteAreas({}, 1e-9).empty());
    const auto thin = uniteAreas({disc({0, 0}, 1e-12), disc({1e-12, 0}, 1e-12), disc({5, 0}, 1e-12)}, 1e-3);
    CHECK(thin.size() == 3); // nothing would be left of them
}
