#include "core/drawing/arrangement/arrangement.hpp"
#include "core/engine/geometry/curve.hpp"
#include "tests/unit/arrangement_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

void addPart(ArrangementInput &input, std::uint32_t clip, const std::vector<Vec2> &ring, bool removes = false,
             std::uint32_t limit = kNoClip) {
    input.addRing(input.addContour(input.addClipPart(clip, limit, removes)), ring, 7);
}

void addClipped(ArrangementInput &input, std::uint32_t clip, const std::vector<Vec2> &ring) {
    if (input.features.empty()) {
        input.addFeature(1);
    }
    input.addRing(input.addContour(input.addShape(0, {}, clip)), ring, 1);
}

double areaOf(const ArrangementInput &input) {
    return areas(arranged(input).domain).at(1);
}

} // namespace

TEST_CASE("arrange: a clip limits shapes to the union of its parts, and those within it to both") {
    ArrangementInput input;
    const std::uint32_t outer = input.addClip(), inner = input.addClip(outer);
    addPart(input, outer, rectangle(0, 0, 4, 2));
    addPart(input, outer, rectangle(3, 0, 3, 2));
    addPart(input, inner, rectangle(1, 1, 9, 9));
    addClipped(input, outer, rectangle(2, -5, 2, 20));
    CHECK(areaOf(input) == doctest::Approx(4));
    addClipped(input, inner, rectangle(4, -5, 20, 20));
    CHECK(areaOf(input) == doctest::Approx(4 + 2));
    addClipped(input, kNoClip, rectangle(20, 0, 1, 1));
    CHECK(areaOf(input) == doctest::Approx(4 + 2 + 1));
}

TEST_CASE("arrange: the last part of a clip that covers a place decides whether the clip shows it") {
    ArrangementInput input;
    const std::uint32_t mask = input.addClip(), half = input.addClip();
    addPart(input, half, rectangle(0, 0, 5, 10));
    addPart(input, mask, rectangle(0, 0, 10, 10));
    addPart(input, mask, rectangle(2, 2, 6, 6), true);
    addPart(input, mask, rectangle(4, 4, 2, 2));
    addPart(input, mask, rectangle(0, 9, 10, 1), true, half);
    addClipped(input, mask, rectangle(-5, -5, 20, 20));
    CHECK(areaOf(input) == doctest::Approx(100 - 36 + 4 - 5));
}

TEST_CASE("arrange: a clip without parts shows nothing, and one that contains its shapes changes nothing") {
    ArrangementInput input;
    addClipped(input, input.addClip(), rectangle(0, 0, 2, 2));
    const Result<Arrangement> hidden = arrange(input);
    REQUIRE(hidden.ok());
    CHECK(hidden->domain.segments.empty());
    CHECK(find(*hidden, ChangeKind::ClippedSegments)->count == 4);
    CHECK(find(*hidden, ChangeKind::VanishedShapes)->count == 1);

    ArrangementInput wide;
    const std::uint32_t clip = wide.addClip();
    addPart(wide, clip, rectangle(-5, -5, 20, 20));
    addClipped(wide, clip, rectangle(0, 0, 2, 2));
    const Arrangement whole = arranged(wide);
    CHECK(whole.domain.nodes == rectangle(0, 0, 2, 2));
    CHECK(whole.changes.empty());
}

TEST_CASE("arrange: outlines of clips bound what they cut, with their own tags, and are not reported") {
    ArrangementInput input;
    const std::uint32_t clip = input.addClip();
    addPart(input, clip, rectangle(1, -1, 2, 6));
    addPart(input, clip, rectangle(2, -2, 6, 3));
    addClipped(input, clip, rectangle(0, 0, 4, 4));       // vanishes in the next one
    addClipped(input, clip, rectangle(-10, -10, 40, 40)); // no outline of its own is left, but it has not vanished
    const Arrangement result = arranged(input);
    std::set<std::int32_t> tags;
    for (const DomainSegment &segment : result.domain.segments) {
        tags.insert(segment.tag);
    }
    CHECK(tags == std::set<std::int32_t>{7});
    CHECK(areas(result.domain).at(1) == doctest::Approx(12 + 18 - 2));
    CHECK(find(result, ChangeKind::CrossingSegments) == nullptr);
    CHECK(find(result, ChangeKind::TouchingSegments) == nullptr);
    CHECK(find(result, ChangeKind::VanishedShapes)->count == 1);
}

TEST_CASE("arrange: a curve of a clip bounds what it cuts exactly") {
    ArrangementInput input;
    const std::uint32_t clip = input.addClip();
    const Curve circle = Curve::circle({0, 0}, {1, 0});
    input.curves.push_back(circle);
    std::vector<Vec2> nodes;
    std::vector<CurveStretch> stretches;
    constexpr int kParts = 8;
    for (int k = 0; k < kParts; ++k) {
        nodes.push_back(circle.point(k / double{kParts}));
        stretches.push_back({0, k / double{kParts}, (k + 1) / double{kParts}});
    }
    input.addRing(input.addContour(input.addClipPart(clip)), nodes, 7, stretches);
    addClipped(input, clip, rectangle(0.3, -5, 10, 10));
    const Arrangement result = arranged(input);
    std::size_t onCircle = 0;
    for (const DomainSegment &segment : result.domain.segments) {
        if (segment.stretch.follows()) {
            ++onCircle;
            for (const std::uint32_t node : {segment.a, segment.b}) {
                CHECK(std::fabs(length(result.domain.nodes[node]) - 1.0) < 1e-14);
            }
        }
    }
    CHECK(onCircle >= 4);
    CHECK(result.domain.segments.size() == onCircle + 1);
}

TEST_CASE("arrange: lines are cut at their clip, and other lines are not") {
    ArrangementInput input;
    const std::uint32_t clip = input.addClip();
    addPart(input, clip, rectangle(2, 0, 2, 10));
    addClipped(input, kNoClip, rectangle(0, 0, 10, 10));
    input.addChain(std::vector<Vec2>{{1, 3}, {9, 3}}, 2, {}, clip);
    input.addChain(std::vector<Vec2>{{1, 6}, {9, 6}}, 3);
    const Arrangement result = arranged(input);
    double clipped = 0.0, whole = 0.0;
    for (const DomainSegment &segment : result.domain.segments) {
        const double own = distance(result.domain.nodes[segment.a], result.domain.nodes[segment.b]);
        clipped += segment.tag == 2 ? own : 0.0;
        whole += segment.tag == 3 ? own : 0.0;
    }
    CHECK(clipped == doctest::Approx(2));
    CHECK(whole == doctest::Approx(8));
    CHECK(find(result, ChangeKind::ClippedSegments)->count == 2);
}

TEST_CASE("arrange: a clip of many shapes and a deep nest of clips cost no more than they have to") {
    ArrangementInput input;
    const std::uint32_t clip = input.addClip();
    constexpr int kShapes = 2000;
    addPart(input, clip, rectangle(0, 0, 2.0 * kShapes, 0.5));
    for (int k = 0; k < kShapes; ++k) {
        addClipped(input, clip, rectangle(2.0 * k, 0, 1, 1));
    }
    CHECK(areaOf(input) == doctest::Approx(0.5 * kShapes));

    ArrangementInput deep; // deeper than a recursion could go
    std::uint32_t within = kNoClip;
    constexpr int kClips = 100'000;
    for (int k = 0; k < kClips; ++k) {
        within = deep.addClip(within);
        addPart(deep, within, k + 1 < kClips ? rectangle(0, 0, 3, 3) : rectangle(1, 1, 5, 5));
    }
    addClipped(deep, within, rectangle(0, 0, 3, 3));
    CHECK(areaOf(deep) == doctest::Approx(4));
}
