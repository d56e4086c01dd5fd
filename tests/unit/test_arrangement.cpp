#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/assembly/face_points.hpp"
#include "core/drawing/arrangement/change.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/arrangement_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("arrange: a path is filled by its fill rule") {
    const std::vector<std::vector<Vec2>> squares{rectangle(0, 0, 10, 10), rectangle(2, 2, 6, 6)};
    ArrangementInput nonZero, evenOdd;
    addPath(nonZero, FillRule::NonZero, squares);
    addPath(evenOdd, FillRule::EvenOdd, squares);
    CHECK(areas(arranged(nonZero).domain) == Areas{{1, 100.0}});
    CHECK(arranged(nonZero).domain.segments.size() == 4);
    CHECK(areas(arranged(evenOdd).domain) == Areas{{1, 64.0}});
}

// Comparing every pair of features to find which lies inside which would take minutes here.
TEST_CASE("arrange: a thousand features inside each other keep an area each") {
    constexpr int kDepth = 1000;
    for (const OverlapRule rule : {OverlapRule::Later, OverlapRule::Smaller}) {
        ArrangementInput input;
        input.overlap = rule;
        for (int i = 0; i < kDepth; ++i) { // every other one turned around, so that neither rule sees them in order
            const double half = i % 2 == 0 ? i + 1.0 : kDepth - i + 1.0;
            addPolygon(input, i + 1, {rectangle(-half, -half, 2.0 * half, 2.0 * half)});
        }
        const Arrangement result = arranged(input);
        CHECK(find(result, ChangeKind::OverlapsDecided) == nullptr);
        const Areas found = areas(result.domain);
        REQUIRE(found.size() == kDepth);
        for (const auto &[tag, area] : found) {
            const int i = tag - 1;
            const double half = i % 2 == 0 ? i + 1.0 : kDepth - i + 1.0;
            CHECK(area == doctest::Approx(4.0 * (half * half - (half - 1.0) * (half - 1.0))));
        }
    }
}

TEST_CASE("arrange: painted paths are united, and where they only touch their border stays") {
    ArrangementInput nested, beside;
    addPath(nested, FillRule::EvenOdd, {rectangle(0, 0, 10, 10)});
    addPath(nested, FillRule::EvenOdd, {rectangle(2, 2, 3, 3)});
    CHECK(areas(arranged(nested).domain) == Areas{{1, 100.0}});
    CHECK(arranged(nested).domain.segments.size() == 4);
    CHECK(find(arranged(nested), ChangeKind::InnerOutlines)->count == 4);
    addPath(beside, FillRule::NonZero, {rectangle(0, 0, 1, 1)});
    addPath(beside, FillRule::NonZero, {rectangle(1, 0, 1, 1)});
    const Arrangement both = arranged(beside);
    CHECK(both.domain.segments.size() == 7);
    CHECK(both.changes.empty());
    CHECK(std::count_if(both.domain.segments.begin(), both.domain.segments.end(),
                        [](const DomainSegment &s) { return s.role == SegmentRole::Constraint; }) == 1);
}

TEST_CASE("arrange: a polygon fills another one's hole, and a hole beside the outline opens it") {
    ArrangementInput covered, flush;
    addPolygon(covered, 1, {rectangle(0, 0, 10, 10), rectangle(4, 4, 2, 2)});
    addPolygon(covered, 1, {rectangle(3, 3, 4, 4)});
    CHECK(areas(arranged(covered).domain)[1] == doctest::Approx(100.0));
    addPolygon(flush, 1, {rectangle(0, 0, 4, 4), {{4, 0}, {4, 4}, {2, 3}, {2, 1}}});
    CHECK(areas(arranged(flush).domain)[1] == doctest::Approx(10.0));
}

TEST_CASE("arrange: where features overlap the later or the smaller one wins, and one inside another keeps its area") {
    ArrangementInput neighbours;
    addPolygon(neighbours, 1, {rectangle(0, 0, 4, 4)}, "A");
    addPolygon(neighbours, 2, {rectangle(3, 1, 3, 2)}, "B");
    const Arrangement later = arranged(neighbours);
    CHECK(areas(later.domain) == Areas{{1, 14.0}, {2, 6.0}});
    const ArrangementChange *overlap = find(later, ChangeKind::OverlapsDecided);
    REQUIRE(overlap != nullptr);
    CHECK(overlap->count == 1);
    CHECK(overlap->displacement == doctest::Approx(2.0));
    CHECK(overlap->names == "A and B");

    ArrangementInput turned;
    addPolygon(turned, 2, {rectangle(3, 1, 3, 2)}, "B");
    addPolygon(turned, 1, {rectangle(0, 0, 4, 4)}, "A");
    CHECK(areas(arranged(turned).domain) == Areas{{1, 16.0}, {2, 4.0}});
    turned.overlap = OverlapRule::Smaller;
    CHECK(areas(arranged(turned).domain) == Areas{{1, 14.0}, {2, 6.0}});

    for (const bool innerFirst : {false, true}) {
        ArrangementInput nest;
        addPolygon(nest, innerFirst ? 2 : 1, {innerFirst ? rectangle(1, 1, 2, 2) : rectangle(0, 0, 4, 4)});
        addPolygon(nest, innerFirst ? 1 : 2, {innerFirst ? rectangle(0, 0, 4, 4) : rectangle(1, 1, 2, 2)});
        CHECK(areas(arranged(nest).domain) == Areas{{1, 12.0}, {2, 4.0}});
        CHECK(arranged(nest).changes.empty());
    }

    ArrangementInput three;
    addPolygon(three, 1, {rectangle(0, 0, 2, 2)});
    addPolygon(three, 2, {rectangle(2, 0, 2, 2)});
    addPolygon(three, 3, {rectangle(1, -1, 2, 2)});
    CHECK(areas(arranged(three).domain) == Areas{{1, 3.0}, {2, 3.0}, {3, 4.0}});
}

TEST_CASE("arrange: overlaps are reported by area, the largest first, at places inside them") {
    ArrangementInput input;
    addPolygon(input, 1, {rectangle(0, 0, 10, 1)}, "A");
    addPolygon(input, 2, {rectangle(1, 0.5, 1, 1)}, "B");
    addPolygon(input, 3, {rectangle(4, 0.5, 4, 1)}, "C");
    const Arrangement result = arranged(input);
    const ArrangementChange *overlap = find(result, ChangeKind::OverlapsDecided);
    REQUIRE(overlap != nullptr);
    CHECK(overlap->count == 2);
    CHECK(overlap->displacement == doctest::Approx(2.5));
    CHECK(overlap->names == "A and C");
    REQUIRE(overlap->places.size() == 2);
    CHECK(Box2{{4, 0.5}, {8, 1}}.contains(overlap->places[0]));
    CHECK(Box2{{1, 0.5}, {2, 1}}.contains(overlap->places[1]));
}

TEST_CASE("arrange: a valid domain stays unchanged, in its order") {
    ArrangementInput input;
    addPolygon(input, 3, {rectangle(0.1, 0.2, 1.3, 0.7), rectangle(0.3, 0.4, 0.1, 0.2)});
    input.addChain(std::vector<Vec2>{{0.6, 0.4}, {1.1, 0.5}}, 5);
    input.addPoint({0.7, 0.7}, 6);
    input.tolerance = 1e-6;
    const Arrangement result = arranged(input);
    CHECK(result.changes.empty());
    REQUIRE(result.domain.nodes.size() == 11);
    REQUIRE(result.domain.segments.size() == 9);
    for (std::size_t s = 0; s < result.domain.segments.size(); ++s) {
        CHECK(result.domain.nodes[result.domain.segments[s].a] == input.pieces[s].a);
        CHECK(result.domain.nodes[result.domain.segments[s].b] == input.pieces[s].b);
        CHECK(result.domain.segments[s].tag == input.pieces[s].tag);
        CHECK(result.stretches[s].piece == s);
    }
    CHECK(result.domain.segments.back().role == SegmentRole::Constraint);
    CHECK(result.domain.points.size() == 1);
    CHECK(result.domain.points.front().tag == 6);
}

TEST_CASE("arrange: tags and curve parameters survive splitting") {
    ArrangementInput input;
    addPolygon(input, 7, {rectangle(0, 0, 4, 4)});
    input.curves = {Curve::line({0, 0}, {0, 1}), Curve::line({0, 0}, {8, 0})};
    input.pieces[0].stretch = {1, 0.0, 0.5};
    input.addChain(std::vector<Vec2>{{1, -1}, {1, 2}}, 9);
    const Arrangement result = arranged(input);
    CHECK(result.domain.segments.size() == 6);
    CHECK(result.domain.segments[0].tag == 7);
    REQUIRE(result.domain.curves.size() == 1); // without the one that nothing follows
    CHECK(result.domain.curves[0] == input.curves[1]);
    const CurveStretch first = result.domain.segments[0].stretch, second = result.domain.segments[1].stretch;
    CHECK(first.curve == 0);
    CHECK(first.t0 == 0.0);
    CHECK(first.t1 == doctest::Approx(0.125).epsilon(1e-9));
    CHECK(second.curve == 0);
    CHECK(second.t0 == first.t1); // exactly, so that the chain continues
    CHECK(second.t1 == 0.5);
    CHECK_FALSE(result.domain.segments[2].stretch.follows());
    CHECK(result.domain.segments.back().tag == 9);
    const ArrangementChange *outside = find(result, ChangeKind::OutsideLines);
    REQUIRE(outside != nullptr);
    CHECK(outside->count == 1);
    REQUIRE(find(result, ChangeKind::CrossingSegments) != nullptr);
}

TEST_CASE("arrange: slivers thinner than the tolerance collapse, and needles vanish") {
    ArrangementInput input;
    addPolygon(input, 1, {rectangle(0, 0, 1, 1)});
    addPolygon(input, 2, {{{1.0005, 0}, {2, 0}, {2, 1}, {1.0004, 1}, {1.0003, 0.5}}});
    addPolygon(input, 3, {{{0, 1}, {0.5, 1.4}, {0.5, 3}, {0.5005, 1.4}, {1, 1}}});
    input.tolerance = 1e-3;
    const Arrangement result = arranged(input);
    CHECK(find(result, ChangeKind::WeldedNodes)->count >= 2);
    CHECK(find(result, ChangeKind::FoldedOutlines) != nullptr);
    for (const ArrangementChange &change : result.changes) {
        CHECK(change.displacement <= 1e-3);
    }
    const Areas found = areas(result.domain);
    CHECK(found.at(1) == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(found.at(2) == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(found.at(3) == doctest::Approx(0.2).epsilon(5e-3));
    CHECK(FacesOf(result.domain).faces.count == 4);
}

TEST_CASE("arrange: an outline that is not closed is refused with its place") {
    ArrangementInput input;
    addPolygon(input, 1, {rectangle(0, 0, 1, 1)});
    input.pieces.pop_back();
    const Result<Arrangement> result = arrange(input);
    REQUIRE_FALSE(result.ok());
    CHECK(result.faults().front().code == "open-contour");
    CHECK(result.faults().front().at == Vec2{0, 1});
}

TEST_CASE("pointInFace: finds room in faces of awkward shape") {
    const std::vector<Vec2> comb{{0, 0}, {10, 0}, {10, 5}, {9, 0.1}, {8, 5}, {7, 0.1}, {6, 5}, {0, 1}};
    std::vector<FaceEdge> edges;
    for (std::size_t k = 0; k < comb.size(); ++k) {
        edges.push_back({comb[k], comb[(k + 1) % comb.size()]});
    }
    const auto at = pointInFace(edges);
    REQUIRE(at.has_value());
    CHECK(locate(comb, *at) == PointPlace::Inside);
    edges.push_back({{at->x, -0.1}, {at->x, 4.9}, true}); // a line through it
    const auto beside = pointInFace(edges);
    REQUIRE(beside.has_value());
    CHECK(beside->x != at->x);
    CHECK(locate(comb, *beside) == PointPlace::Inside);
    CHECK(!pointInFace(std::vector<FaceEdge>{{{0, 0}, {2, 0}}, {{2, 0}, {0, 0}}}));
    CHECK(!pointInFace({}));
}

TEST_CASE("notesOf: one line per kind, with count, displacement and places") {
    const std::vector<ArrangementChange> changes{{ChangeKind::WeldedNodes, 12, 8.3e-7, {{1, 2}, {3, 4}, {5, 6}}, 0, {}},
                                                 {ChangeKind::OverlapsDecided, 1, 2.0, {{1, 1}}, 0, "A and B"}};
    const Diagnostics notes = notesOf(changes);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].message == "moved 12 nodes onto others, at most 8.3e-07 away");
    CHECK(notes[0].at == Vec2{1, 2});
    CHECK(placesOf(changes[0]) == ", first at (1, 2), (3, 4), (5, 6)");
    CHECK(notes[0].severity == Severity::Note);
    CHECK(notes[1].message == "resolved 1 overlap of features, 2 in area, between A and B");
    CHECK(placesOf(changes[1]) == " at (1, 1)");
}

TEST_CASE("arrange: layers hide what they cover of earlier ones") {
    constexpr int kSize = 12, kLayers = 8;
    RandomSource random(41);
    for (int round = 0; round < 200; ++round) {
        ArrangementInput input;
        input.layered = true;
        input.markRegions = true;
        int top[kSize][kSize] = {};
        for (int layer = 1; layer <= kLayers; ++layer) {
            const int x = random.integer(0, kSize - 2), y = random.integer(0, kSize - 2);
            const int width = random.integer(1, kSize - x), height = random.integer(1, kSize - y);
            addPolygon(input, layer, {rectangle(x, y, width, height)});
            for (int k = 0; k < width * height; ++k) {
                top[x + k % width][y + k / width] = layer;
            }
        }
        std::map<std::int32_t, double> expected;
        for (int k = 0; k < kSize * kSize; ++k) {
            const int layer = top[k % kSize][k / kSize];
            expected[layer] += layer > 0 ? 1.0 : 0.0;
        }
        expected.erase(0);
        const Result<Arrangement> arranged = arrange(input);
        REQUIRE(arranged.ok());
        CHECK(validate(arranged->domain).empty());
        CHECK(areas(arranged->domain) == expected);
        CHECK(std::none_of(arranged->changes.begin(), arranged->changes.end(),
                           [](const auto &change) { return change.kind == ChangeKind::OverlapsDecided; }));
    }
}
