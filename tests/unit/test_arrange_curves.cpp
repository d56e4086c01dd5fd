#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/curves/joined_lines.hpp"
#include "core/drawing/arrangement/curves/snap_report.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/curve_drawing.hpp"
#include "tests/support/curved_area.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

Curve circle(Vec2 centre, double radius, double firstAngle = 0.0) {
    return Curve::arc(centre, {radius, 0}, {0, radius}, firstAngle);
}

CurveLoop box(Vec2 low, Vec2 high) {
    const Vec2 right{high.x, low.y}, left{low.x, high.y};
    return {Curve::line(low, right), Curve::line(right, high), Curve::line(high, left), Curve::line(left, low)};
}

/// Area of a circle on one side of a line at the distance `d` from its centre, the smaller part for d > 0.
double capArea(double radius, double d) {
    return radius * radius * std::acos(d / radius) - d * std::sqrt(radius * radius - d * d);
}

Arrangement arrangedWithin(ArrangementInput input, double tolerance) {
    input.tolerance = tolerance;
    input.markRegions = true;
    Result<Arrangement> result = arrange(input);
    REQUIRE(result.ok());
    for (const Diagnostic &fault : validate(result->domain)) {
        FAIL_CHECK(toString(fault));
    }
    return std::move(*result);
}

std::size_t count(const Arrangement &arrangement, ChangeKind kind) {
    const auto found = std::find_if(arrangement.changes.begin(), arrangement.changes.end(),
                                    [&](const ArrangementChange &change) { return change.kind == kind; });
    return found == arrangement.changes.end() ? 0 : found->count;
}

/// Returns the greatest distance of a segment's end from its curve.
double greatestOffset(const Domain &domain) {
    double greatest = 0.0;
    for (const DomainSegment &segment : domain.segments) {
        if (segment.stretch.follows()) {
            const Curve &curve = domain.curves[segment.stretch.curve];
            greatest = std::max({greatest, distance(curve.point(segment.stretch.t0), domain.nodes[segment.a]),
                                 distance(curve.point(segment.stretch.t1), domain.nodes[segment.b])});
        }
    }
    return greatest;
}

std::size_t degreeAt(const Domain &domain, Vec2 at, double reach) {
    std::size_t degree = 0;
    for (const DomainSegment &segment : domain.segments) {
        degree += distance(domain.nodes[segment.a], at) <= reach ? 1 : 0;
        degree += distance(domain.nodes[segment.b], at) <= reach ? 1 : 0;
    }
    return degree;
}

} // namespace

TEST_CASE("arrange: a line that crosses a circle less deeply than the chords deviate divides it all the same") {
    for (const double d : {29.9, 29.99, 29.9999, 29.0, 3.0}) {
        CAPTURE(d);
        CurveDrawing drawing(0.045);
        drawing.feature({circle({0, 0}, 30)});
        drawing.feature(box({-50, d}, {50, 60}));
        const Arrangement result = arrangedWithin(drawing.input, 1e-6);
        const double cap = capArea(30, d);
        const auto areas = curvedAreas(result.domain);
        CHECK(areas.at(1) == doctest::Approx(900 * pi - cap).epsilon(1e-12));
        CHECK(areas.at(2) == doctest::Approx(100 * (60 - d)).epsilon(1e-12));
        CHECK(greatestOffset(result.domain) < 1e-13);
        CHECK(count(result, ChangeKind::CrossingSegments) == 2);
    }
}

TEST_CASE("arrange: crossings of curves of all kinds lie on both curves") {
    struct Pair {
        Curve first, second;
        std::size_t crossings;
    };
    const Curve wave = Curve::cubic({-2, 0}, {0, 3}, {0, -3}, {2, 0});
    const Pair pairs[] = {{circle({0, 0}, 1), circle({1, 0}, 1, 2.0), 2},
                          {circle({0, 0}, 1), circle({0, 0.001}, 1, 2.0), 2},
                          {circle({0, 0}, 1), Curve::arc({0, 0}, {1.2, 0}, {0, 0.8}), 4},
                          {circle({0, 0}, 1), Curve::arc({0, 0}, {1.0001, 0}, {0, 0.9999}, 0.3), 4}};
    for (const Pair &pair : pairs) {
        CurveDrawing drawing(1e-3);
        drawing.feature({pair.first});
        drawing.feature({pair.second});
        const Arrangement result = arrangedWithin(drawing.input, 1e-9);
        CHECK(count(result, ChangeKind::CrossingSegments) == pair.crossings);
        CHECK(greatestOffset(result.domain) < 1e-14);
    }
    CurveDrawing drawing(1e-3);
    drawing.feature({circle({0, 0}, 1)});
    drawing.line({wave}, 7);
    drawing.line({Curve::line({-2, 0.02}, {2, -0.01})}, 8);
    const Arrangement result = arrangedWithin(drawing.input, 1e-9);
    CHECK(count(result, ChangeKind::CrossingSegments) == 7); // each line and the circle twice, the lines thrice
    CHECK(greatestOffset(result.domain) < 1e-14);
}

TEST_CASE("arrange: curves that come closer than their chords deviate, but not together, stay apart") {
    CurveDrawing drawing(0.02);
    drawing.feature({circle({0, 0}, 1)});
    drawing.feature({circle({0, 0}, 0.999, 0.1)});
    drawing.feature({circle({2.0005, 0}, 1, 0.2)});
    drawing.feature(box({-2, 1.0003}, {2, 2}));
    const Arrangement result = arrangedWithin(drawing.input, 1e-6);
    CHECK(result.changes.empty());
    const auto areas = curvedAreas(result.domain);
    CHECK(areas.at(1) == doctest::Approx(pi * (1 - 0.999 * 0.999)).epsilon(1e-12));
    CHECK(areas.at(2) == doctest::Approx(pi * 0.999 * 0.999).epsilon(1e-12));
    CHECK(areas.at(3) == doctest::Approx(pi).epsilon(1e-12));
}

TEST_CASE("arrange: curves that touch, or nearly do, are joined at one node") {
    const double gaps[] = {0.0, 5e-7, -5e-7};
    for (const double gap : gaps) {
        CAPTURE(gap);
        struct Case {
            CurveLoop first, second;
            Vec2 at;
        };
        const Curve ellipse = Curve::arc({0, 2 + gap}, {3, 0}, {0, 1}, 0.4);
        const Case cases[] = {{{circle({0, 0}, 1, 0.35)}, box({-3, 1 + gap}, {3, 2}), {0, 1}},
                              {{circle({0, 0}, 1, 0.35)}, {circle({2 + gap, 0}, 1, 0.35)}, {1, 0}},
                              {{circle({0, 0}, 1, 0.35)}, {circle({0.5 - gap, 0}, 0.5, 0.35)}, {1, 0}},
                              {{circle({0, 0}, 1, 0.35)}, {ellipse}, {0, 1}}};
        for (const Case &drawn : cases) {
            CurveDrawing drawing(0.003);
            drawing.feature(drawn.first);
            drawing.feature(drawn.second);
            const Arrangement result = arrangedWithin(drawing.input, 1e-6);
            CHECK(count(result, ChangeKind::TouchingCurves) == 1);
            CHECK(result.changes.size() == 1);
            CHECK(degreeAt(result.domain, drawn.at, 2e-6) == 4);
            CHECK(degreeAt(result.domain, drawn.at, 0.003) == 4); // no sliver beside it
            CHECK(greatestOffset(result.domain) < 1e-6);
        }
    }
}

TEST_CASE("arrange: a Bézier that touches itself is joined where it does") {
    // Symmetric in x; its sides meet in x = 0, where both run straight up.
    const auto touching = [](double gap) {
        const double w = 4.0 / 3.0;
        const Curve right = Curve::cubic({1, -1}, {1.0 / 3.0 - w + gap, 0}, {1.0 / 3.0 - w + gap, 0}, {1, 1});
        const auto mirrored = [](Vec2 p) { return Vec2{-p.x, p.y}; };
        const Curve left = right.mapped(mirrored);
        return CurveLoop{right.part(0.0, 0.3), right.part(0.3, 1.0), Curve::line({1, 1}, {-1, 1}),
                         left.part(1.0, 0.6),  left.part(0.6, 0.0),  Curve::line({-1, -1}, {1, -1})};
    };
    CurveDrawing drawing(1e-3);
    drawing.feature(touching(2.0 / 3.0));
    const Arrangement result = arrangedWithin(drawing.input, 1e-6);
    CHECK(count(result, ChangeKind::TouchingCurves) == 1);
    CHECK(degreeAt(result.domain, {0, 0}, 0.003) == 4);
}

TEST_CASE("arrange: a circle drawn twice with other ends is one circle") {
    CurveDrawing drawing(1e-3);
    const std::uint32_t shape = drawing.input.addShape(drawing.input.addFeature(1));
    const std::uint32_t contour = drawing.input.addContour(shape, FillRule::NonZero);
    drawing.loop({circle({3, 4}, 1)}, contour, 1);
    drawing.loop({Curve::arc({3, 4}, {0, 1}, {-1, 0}, 0.123, 2.0), Curve::arc({3, 4}, {0, 1}, {-1, 0}, 2.123, 1.0),
                  Curve::arc({3, 4}, {0, 1}, {-1, 0}, 3.123, 2 * pi - 3.0)},
                 contour, 1);
    const Arrangement result = arrangedWithin(drawing.input, 1e-6);
    CHECK(curvedAreas(result.domain).at(1) == doctest::Approx(pi).epsilon(1e-6));
    CHECK(count(result, ChangeKind::CrossingSegments) == 0);
    std::size_t boundaries = 0;
    for (const DomainSegment &segment : result.domain.segments) {
        boundaries += segment.role == SegmentRole::Boundary ? 1 : 0;
    }
    CHECK(boundaries == result.domain.segments.size());
    CHECK(boundaries == result.domain.nodes.size());
}

TEST_CASE("arrange: a curve that runs along part of another one becomes one with it") {
    const Curve round = circle({0, 0}, 1);
    CurveDrawing drawing(1e-3);
    drawing.feature({round});
    const Curve arc = round.part(0.05, 0.3); // with other numbers than the circle's
    drawing.feature(
        {arc, Curve::line(arc.point(1.0), {0, 3}), Curve::line({0, 3}, {3, 0}), Curve::line({3, 0}, arc.point(0.0))});
    const Arrangement result = arrangedWithin(drawing.input, 1e-7);
    const auto areas = curvedAreas(result.domain);
    CHECK(areas.at(1) == doctest::Approx(pi).epsilon(1e-6));
    double outer = 0.0; // of the second feature
    for (const Curve &curve :
         {Curve::line(arc.point(1.0), {0, 3}), Curve::line({0, 3}, {3, 0}), Curve::line({3, 0}, arc.point(0.0)), arc}) {
        outer += sweptArea(curve, 0.0, 1.0, {0, 0});
    }
    CHECK(areas.at(2) == doctest::Approx(std::fabs(outer)).epsilon(1e-6));
    CHECK(count(result, ChangeKind::CrossingSegments) == 0);

    const Curve wave = Curve::cubic({-2, 0}, {0, 3}, {0, -3}, {2, 0});
    CurveDrawing waves(1e-3);
    waves.feature({wave, Curve::line({2, 0}, {0, 5}), Curve::line({0, 5}, {-2, 0})});
    const Curve piece = wave.part(0.7, 0.2);
    waves.feature({piece, Curve::line(piece.point(1.0), {0, -5}), Curve::line({0, -5}, piece.point(0.0))});
    const Arrangement both = arrangedWithin(waves.input, 1e-7);
    CHECK(count(both, ChangeKind::CrossingSegments) == 0);
    CHECK(both.domain.segments.size() < 200);
}

TEST_CASE("joinLines: chords left undivided because of a limit are reported, each once and with its place") {
    // Two circles of four chords each, the second a third of a radius to the right.
    const std::vector<Curve> curves{circle({0, 0}, 1.0), circle({0.3, 0}, 1.0)};
    std::vector<SnapLine> lines;
    std::vector<CurveStretch> stretches;
    for (std::uint32_t c = 0; c < 2; ++c) {
        for (int k = 0; k < 4; ++k) {
            const CurveStretch stretch{c, 0.25 * k, 0.25 * (k + 1)};
            lines.push_back({curves[c].point(stretch.t0), curves[c].point(k == 3 ? 0.0 : stretch.t1)});
            stretches.push_back(stretch);
        }
    }
    const double tolerance = 1e-6;
    CHECK(joinLines(lines, stretches, curves, tolerance).left.empty());
    for (const bool byParts : {false, true}) {
        CAPTURE(byParts);
        DivisionLimits limits;
        if (byParts) {
            limits.partsPerLine = limits.spareParts = 0;
        } else {
            limits.rounds = limits.repeats = 0;
        }
        const JoinedLines joined = joinLines(lines, stretches, curves, tolerance, {}, limits);
        REQUIRE_FALSE(joined.left.empty());
        for (std::size_t k = 1; k < joined.left.size(); ++k) {
            CHECK(joined.left[k - 1].chord < joined.left[k].chord);
        }
        ChangeList changes;
        noteJoining(joined, changes);
        const ArrangementChange *change = changes.find(ChangeKind::UndividedCurves);
        REQUIRE(change != nullptr);
        CHECK(change->count == joined.left.size());
        CHECK(std::fabs(distance(change->places.front(), {0, 0}) - 1.0) < 0.31);
        CHECK(altersInput(change->kind));
        const Diagnostics notes = notesOf({*change});
        CHECK(notes.front().code == "undivided-curves");
    }
}
