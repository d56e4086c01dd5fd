#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/curve_drawing.hpp"
#include "tests/support/curved_area.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/arrangement_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>
#include <utility>

using namespace forefront;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

/// Closed curves that cross, touch, coincide and run along each other, with a tolerance and a scale and place in the
/// plane.
class RandomCurves {
  public:
    explicit RandomCurves(RandomSource &random) : random_(random) {
        constexpr std::array kSizes{1.0, 1e8, 1e-8, 37.0};
        size = kSizes[static_cast<std::size_t>(random.integer(0, 3))];
        offset = random.chance(0.3) ? Vec2{1e5 * size, -3e4 * size} : Vec2{};
        constexpr std::array kTolerances{0.0, 1e-6, 1e-6, 1e-4, 1e-2};
        const double tolerance = kTolerances[static_cast<std::size_t>(random.integer(0, 4))];
        unit_ = tolerance > 0.0 ? tolerance : 1e-9;
        deviation = size * std::pow(10.0, random.between(-4.0, -1.5));
        drawing_ = CurveDrawing(deviation);
        drawing_.input.tolerance = size * tolerance;
        for (int count = random.integer(2, 5); count > 0; --count) {
            addFeature();
        }
        if (random.chance(0.4)) {
            addLine();
        }
    }

    const ArrangementInput &input() const { return drawing_.input; }

    double size = 1.0;
    Vec2 offset;
    double deviation = 0.0;
    std::vector<CurveLoop> loops; ///< per feature

    Vec2 place(Vec2 p) const { return offset + size * p; }

  private:
    Vec2 lattice() { return {0.1 * random_.integer(2, 8), 0.1 * random_.integer(2, 8)}; }
    Vec2 anywhere() { return {random_.unit(), random_.unit()}; }
    /// A circle in two to four arcs that begin anywhere.
    CurveLoop arcs(Vec2 centre, Vec2 u, Vec2 v) {
        const int count = random_.integer(1, 4);
        const double first = random_.chance(0.5) ? 0.0 : random_.between(0.0, 6.0);
        CurveLoop loop;
        for (int k = 0; k < count; ++k) {
            loop.push_back(Curve::arc(centre, u, v, first + 2.0 * pi * k / count, 2.0 * pi / count));
        }
        return loop;
    }

    CurveLoop loop() {
        switch (random_.integer(0, loops.empty() ? 3 : 6)) {
        case 0: { // tangencies with circles of the same lattice
            const double radius = 0.1 * random_.integer(1, 4);
            return arcs(lattice(), {radius, 0}, {0, radius});
        }
        case 1: {
            const Vec2 low = lattice(), high = low + Vec2{0.1 * random_.integer(1, 4), 0.1 * random_.integer(1, 4)};
            return {Curve::line(low, {high.x, low.y}), Curve::line({high.x, low.y}, high),
                    Curve::line(high, {low.x, high.y}), Curve::line({low.x, high.y}, low)};
        }
        case 2: {
            const Vec2 u{0.1 * random_.integer(1, 4), 0}, v{0, 0.1 * random_.integer(1, 4)};
            return random_.chance(0.5) ? arcs(lattice(), u, v) : arcs(lattice(), u + 0.5 * v, v - 0.2 * u);
        }
        case 3: { // with loops and cusps, too
            const Vec2 a = anywhere(), b = anywhere();
            return {Curve::cubic(a, anywhere(), anywhere(), b), Curve::cubic(b, anywhere(), anywhere(), a)};
        }
        default:
            return again(loops[static_cast<std::size_t>(random_.integer(0, static_cast<int>(loops.size()) - 1))]);
        }
    }

    /// Returns an earlier loop, reversed, divided differently and moved by about the tolerance.
    CurveLoop again(const CurveLoop &earlier) {
        const double step = random_.chance(0.5) ? 0.0 : unit_ * random_.between(0.1, 3.0);
        const Vec2 move{step * random_.between(-1.0, 1.0), step * random_.between(-1.0, 1.0)};
        const bool backward = random_.chance(0.5), parted = random_.chance(0.7);
        CurveLoop loop;
        for (const Curve &given : earlier) {
            const Curve curve = given.mapped([&](Vec2 p) { return p + move; });
            const double middle = parted ? random_.between(0.1, 0.9) : 1.0;
            loop.push_back(curve.part(0.0, middle));
            if (parted) {
                loop.push_back(curve.part(middle, 1.0));
            }
        }
        if (backward) {
            std::reverse(loop.begin(), loop.end());
            for (Curve &curve : loop) {
                curve = curve.part(1.0, 0.0);
            }
        }
        return loop;
    }

    CurveLoop placed(const CurveLoop &loop) const {
        CurveLoop result;
        for (const Curve &curve : loop) {
            result.push_back(curve.mapped([&](Vec2 p) { return place(p); }));
        }
        return result;
    }

    void addFeature() {
        loops.push_back(loop());
        drawing_.feature(placed(loops.back()));
    }
    void addLine() {
        const Vec2 a = anywhere(), b = anywhere();
        drawing_.line(placed({Curve::line(a, b), Curve::cubic(b, anywhere(), anywhere(), anywhere())}), 9);
    }

    RandomSource &random_;
    double unit_ = 0.0;
    CurveDrawing drawing_{1.0};
};

/// Returns true if the place is inside the loop by the even-odd rule; `near` if it is about as near as `reach`.
bool insideLoop(const CurveLoop &loop, Vec2 p, double reach, bool &near) {
    bool inside = false;
    for (const Curve &curve : loop) {
        const double t = curve.nearest(p);
        near = near || distance(curve.point(t), p) <= reach;
        Vec2 a = curve.point(0.0);
        for (const double to : curve.flatten(0.25 * reach)) {
            const Vec2 b = curve.point(to);
            near = near || (distance(a, p) + distance(p, b) <= distance(a, b) + reach);
            if ((a.y <= p.y) != (b.y <= p.y)) {
                inside = inside != (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x);
            }
            a = b;
        }
    }
    return inside;
}

/// Compares the faces of the result with the loops at places away from all of them.
void compareAtSamples(RandomSource &random, const RandomCurves &drawn, const Domain &result) {
    const double reach = (2.0 * drawn.deviation + 2.0 * drawn.input().tolerance) / drawn.size;
    Domain domain = result;
    std::vector<std::set<std::int32_t>> expected;
    for (int k = 0; k < 25; ++k) {
        const Vec2 p{random.between(-0.1, 1.1), random.between(-0.1, 1.1)};
        std::set<std::int32_t> features;
        bool near = false;
        for (std::size_t f = 0; f < drawn.loops.size(); ++f) {
            if (insideLoop(drawn.loops[f], p, reach, near)) {
                features.insert(static_cast<std::int32_t>(f) + 1);
            }
        }
        if (!near) {
            domain.holeMarkers.push_back(drawn.place(p)); // only to find their faces
            expected.push_back(features);
        }
    }
    const DomainGraph graph = graphOf(domain);
    const Faces faces = findFaces(graph.points, graph.edges, sweepPlane(graph.points, graph.edges));
    const FaceLabels labels = labelFaces(domain, graph, faces);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        CAPTURE(domain.holeMarkers[k].x);
        CAPTURE(domain.holeMarkers[k].y);
        const std::uint32_t face = faces.ofPoint[graph.holeMarker[k]];
        CHECK((labels.inside[face] != 0) == !expected[k].empty());
        if (!expected[k].empty() && labels.inside[face] != 0) {
            CHECK(expected[k].count(labels.tag[face]) == 1);
        }
    }
}

/// Arranges the result again.
void checkRepeatable(const Arrangement &result) {
    ArrangementInput again;
    again.tolerance = result.radius;
    again.curves = result.domain.curves;
    const std::uint32_t contour = again.addContour(again.addShape(again.addFeature(1)), FillRule::EvenOdd);
    for (const DomainSegment &segment : result.domain.segments) {
        again.pieces.push_back({result.domain.nodes[segment.a], result.domain.nodes[segment.b], contour, 1,
                                segment.role == SegmentRole::Boundary ? PieceRole::Outline : PieceRole::Constraint,
                                segment.stretch});
    }
    const Result<Arrangement> twice = arrange(again);
    REQUIRE(twice.ok());
    CHECK(segmentSet(twice->domain) == segmentSet(result.domain));
    CHECK(twice->changes.empty());
}

/// Arranges the pieces in another order.
void checkOrder(RandomSource &random, ArrangementInput input) {
    input.overlap = OverlapRule::Smaller;
    const Result<Arrangement> ordered = arrange(input);
    for (std::size_t i = input.pieces.size(); i > 1; --i) {
        std::swap(input.pieces[i - 1],
                  input.pieces[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
    }
    const Result<Arrangement> shuffled = arrange(input);
    REQUIRE(shuffled.ok());
    CHECK(segmentSet(shuffled->domain) == segmentSet(ordered->domain));
}

/// Converts the result to a document and back, which moves curves whose ends joining has moved.
void checkDrawn(const Arrangement &result, double tolerance) {
    const Domain drawn = toDomain(fromDomain(result.domain));
    for (const Diagnostic &fault : validate(drawn)) {
        FAIL_CHECK(toString(fault));
    }
    double perimeter = 0.0;
    for (const DomainSegment &segment : result.domain.segments) {
        perimeter += distance(result.domain.nodes[segment.a], result.domain.nodes[segment.b]);
    }
    const std::map<std::int32_t, double> before = curvedAreas(result.domain), after = curvedAreas(drawn);
    REQUIRE(before.size() == after.size());
    for (const auto &entry : after) {
        const std::int32_t tag = entry.first;
        CAPTURE(tag);
        CHECK(std::fabs(entry.second - before.at(tag)) <= 4.0 * tolerance * perimeter);
    }
}

} // namespace

TEST_CASE("arrange: random curves become valid domains with the faces that the curves bound") {
    const char *wanted = std::getenv("FOREFRONT_ARRANGEMENTS"); // 2,000 outside of quick runs
    const int runs = wanted != nullptr ? std::atoi(wanted) : 100;
    for (int run = 0; run < runs; ++run) {
        CAPTURE(run);
        RandomSource random(static_cast<std::uint64_t>(run) + 4242);
        const RandomCurves drawn(random);
        ArrangementInput input = drawn.input();
        input.markRegions = true;
        const Result<Arrangement> result = arrange(input);
        REQUIRE(result.ok());
        if (result->domain.segments.empty()) {
            continue;
        }
        for (const Diagnostic &fault : validate(result->domain)) {
            FAIL_CHECK(toString(fault));
        }
        for (const ArrangementChange &change : result->changes) {
            if (change.kind != ChangeKind::OverlapsDecided) {
                CHECK(change.displacement <= std::max(input.tolerance * (1.0 + 1e-9), 4e-9 * drawn.size));
            }
        }
        compareAtSamples(random, drawn, result->domain);
        checkRepeatable(*result);
        checkDrawn(*result, std::max(input.tolerance, 4e-9 * drawn.size));
        checkOrder(random, drawn.input());
    }
}
