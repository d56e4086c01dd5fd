#include "core/engine/base/ids.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/discrete_checks.hpp"
#include "tests/support/random_curves.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace forefront;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

/// Checks that the nodes between the ends of chains are those of the curve, and that edges stay near it.
void checkOnCurves(const Domain &domain, const DiscreteDomain &discrete) {
    REQUIRE(discrete.stretches.size() == discrete.segments.size());
    const double size = domain.bounds().diagonal();
    const double tolerance = domain.curveTolerance > 0.0 ? domain.curveTolerance : size / 2000.0;
    for (std::size_t s = 0; s < discrete.segments.size(); ++s) {
        const CurveStretch &stretch = discrete.stretches[s];
        if (!stretch.follows()) {
            continue;
        }
        const Curve &curve = discrete.curves[stretch.curve];
        const Vec2 a = discrete.nodes[discrete.segments[s].a], b = discrete.nodes[discrete.segments[s].b];
        const bool atEnd = std::find(domain.nodes.begin(), domain.nodes.end(), a) != domain.nodes.end();
        REQUIRE((atEnd || a == curve.point(stretch.t0)));
        REQUIRE(distance(a, curve.point(stretch.t0)) <= 1e-9 * size);
        REQUIRE(distance(b, curve.point(stretch.t1)) <= 1e-9 * size);
        REQUIRE(curve.deviation(stretch.t0, stretch.t1) <= 1.001 * tolerance);
    }
}

std::size_t countFollowing(const DiscreteDomain &discrete) {
    return static_cast<std::size_t>(std::count_if(discrete.stretches.begin(), discrete.stretches.end(),
                                                  [](const CurveStretch &stretch) { return stretch.follows(); }));
}

Domain circleDomain(double tolerance = 1e-3) {
    return curvedDomain({{Curve::circle({0, 0}, {1, 0})}}, tolerance);
}

} // namespace

TEST_CASE("discretise: random domains of curves stay simple, with nodes on the curves, regions and areas") {
    std::size_t curved = 0, straightened = 0;
    for (std::uint64_t seed = 0; seed < 420; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomCurvedDomain(seed);
        REQUIRE(validate(domain).empty());
        const double size = domain.bounds().diagonal();
        const SpacingFunction fields[] = {constantSpacing(0.3 * size), constantSpacing(0.013 * size),
                                          spacingAround(domain.bounds().min, 1e-3 * size, 0.15),
                                          spacingAround(domain.nodes[0], 1e-4 * size, 0.3)};
        for (const SpacingFunction &spacing : fields) {
            const auto discrete = discretise(domain, spacing, false);
            REQUIRE(discrete.ok());
            checkRegions(domain, *discrete);
            checkAreas(*discrete);
            checkOnCurves(domain, *discrete);
            curved += countFollowing(*discrete);
            straightened += discrete->segments.size() - countFollowing(*discrete);
        }
    }
    CHECK(curved > 20 * straightened / 10); // straight parts of rounded polygons among them
}

TEST_CASE("discretise: curves of random domains get the numbers of elements that they ask for") {
    std::size_t asked = 0, exact = 0;
    for (std::uint64_t seed = 0; seed < 210; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomCurvedDomain(seed);
        RandomSource random(seed);
        std::vector<std::uint32_t> wanted(domain.curves.size());
        for (std::uint32_t &count : wanted) {
            count = random.chance(0.5) ? static_cast<std::uint32_t>(random.integer(1, 60)) : 0;
        }
        std::vector<std::uint32_t> elements;
        for (const DomainSegment &segment : domain.segments) {
            elements.push_back(segment.stretch.follows() ? wanted[segment.stretch.curve] : 0);
        }
        const double size = domain.bounds().diagonal();
        for (const double rho : {0.3 * size, 0.005 * size}) {
            const auto discrete =
                discretise(domain, constantSpacing(rho), false, {}, nullptr, NarrowTips::Divided, elements);
            REQUIRE(discrete.ok());
            checkRegions(domain, *discrete);
            checkAreas(*discrete);
            std::vector<std::uint32_t> made(wanted.size());
            for (const CurveStretch &stretch : discrete->stretches) {
                if (stretch.follows()) {
                    ++made[stretch.curve];
                }
            }
            for (const CurveChain &chain : curveChains(domain).list) {
                const bool whole = chain.t0 == 0.0 && chain.t1 == 1.0;
                if (whole && wanted[chain.curve] >= 3) {
                    ++asked;
                    exact += made[chain.curve] == wanted[chain.curve] ? 1 : 0;
                }
            }
        }
    }
    CHECK(asked > 1000);
    CHECK(10 * exact > 9 * asked); // the others would meet something
}

TEST_CASE("discretise: a circle is divided by the spacing, regardless of its chords") {
    for (const double tolerance : {0.02, 1e-3, 1e-5}) {
        for (const double rho : {0.02, 0.05, 0.11}) {
            Domain domain = circleDomain(tolerance);
            domain.curveTolerance = 0.01;
            const auto discrete = discretise(domain, constantSpacing(rho), false);
            REQUIRE(discrete.ok());
            const double ideal = 2.0 * pi / rho;
            CHECK(std::fabs(static_cast<double>(discrete->segments.size()) - ideal) <= 1.0);
            const double chord = 2.0 * std::sin(pi / static_cast<double>(discrete->segments.size()));
            for (const DiscreteSegment &s : discrete->segments) {
                CHECK(distance(discrete->nodes[s.a], discrete->nodes[s.b]) == doctest::Approx(chord).epsilon(1e-6));
            }
            CHECK(countFollowing(*discrete) == discrete->segments.size());
        }
    }
}

TEST_CASE("discretise: edges stay within the curve tolerance however large the spacing") {
    for (const double tolerance : {0.1, 1e-2, 1e-3, 1e-4}) {
        Domain domain = circleDomain();
        domain.curveTolerance = tolerance;
        const auto discrete = discretise(domain, constantSpacing(100.0), false);
        REQUIRE(discrete.ok());
        const auto n = static_cast<double>(discrete->segments.size());
        CHECK(1.0 - std::cos(pi / n) <= tolerance);
        CHECK(n <= std::max(10.0, 1.3 * pi / std::acos(1.0 - tolerance) + 1.0));
    }
}

TEST_CASE("discretise: nodes between a coarse edge and its curve stay on the right side") {
    // A hole and constraint points closer to the circle than the sagitta of the edges that the spacing calls for.
    Domain domain = curvedDomain({{Curve::circle({0, 0}, {1, 0})},
                                  {Curve::circle({0.0, 0.985}, {0.003, 0.985})},
                                  {Curve::circle({-0.7, -0.69}, {-0.702, -0.69})}},
                                 1e-4);
    domain.curveTolerance = 0.2;
    domain.points.push_back({static_cast<std::uint32_t>(domain.nodes.size()), 1});
    domain.nodes.push_back({std::cos(0.2) * 0.999, std::sin(0.2) * 0.999});
    REQUIRE(validate(domain).empty());
    const auto discrete = discretise(domain, constantSpacing(2.0), false);
    REQUIRE(discrete.ok());
    checkRegions(domain, *discrete);
    checkAreas(*discrete);
    CHECK(countFollowing(*discrete) == discrete->segments.size());
    CHECK(discrete->segments.size() < 60); // only refined where something is near
}

TEST_CASE("discretise: curves that cross although their chords do not are taken as their chords there") {
    // Two circles 1e-4 apart, of chords much coarser than that which lie beside each other.
    const auto polygon = [](Domain &domain, double radius, std::uint32_t curve) {
        const auto first = static_cast<std::uint32_t>(domain.nodes.size());
        domain.curves.push_back(Curve::circle({0, 0}, {radius, 0}));
        for (std::uint32_t i = 0; i < 12; ++i) {
            domain.nodes.push_back(domain.curves.back().point(i / 12.0));
            domain.segments.push_back(
                {first + i, first + (i + 1) % 12, 1, SegmentRole::Boundary, {curve, i / 12.0, (i + 1) / 12.0}});
        }
    };
    Domain domain;
    polygon(domain, 1.0, 0);
    polygon(domain, 0.9999, 1);
    domain.curves[1] = Curve::arc({0, 0}, {0.9999, 0}, {0, 0.9999 + 2e-4}); // an ellipse that leaves the circle
    for (std::uint32_t i = 0; i < 12; ++i) {
        const double angle = i * pi / 6.0;
        domain.nodes[12 + i] = {0.9999 * std::cos(angle), 0.9999 * std::sin(angle)};
    }
    REQUIRE(validate(domain).empty());
    for (const double rho : {1.0, 0.05, 0.004}) {
        const auto discrete = discretise(domain, constantSpacing(rho), false);
        REQUIRE(discrete.ok());
        checkRegions(domain, *discrete);
        checkAreas(*discrete);
    }
}

TEST_CASE("discretise: an invisibly small hook at the end of a curve gets no separate edge") {
    for (const double hook : {3e-4, 1e-3, 3e-3}) {
        CAPTURE(hook);
        // The last control point lies beyond the end, so that the curve turns back within a fraction of the hook.
        const Domain domain = curvedDomain({{Curve::cubic({0, 0}, {1, 0}, {3.0 + hook, 3.0}, {3, 3}),
                                             Curve::line({3, 3}, {0, 3}), Curve::line({0, 3}, {0, 0})}},
                                           4e-3);
        REQUIRE(validate(domain).empty());
        for (const double size : {0.1, 0.3}) {
            const auto discrete = discretise(domain, constantSpacing(size), false);
            REQUIRE(discrete.ok());
            checkOnCurves(domain, *discrete);
            for (const DiscreteSegment &piece : discrete->segments) {
                CHECK(distance(discrete->nodes[piece.a], discrete->nodes[piece.b]) > 0.2 * size);
            }
        }
    }
}

TEST_CASE("discretise: imperceptible bends do not cause a run of ever shorter edges") {
    struct Sample {
        Curve curve;
        double size, tolerance;
    };
    // Both bend most at their start: one by a right angle, the other gradually over several edges.
    for (const Sample &sample :
         {Sample{Curve::cubic({0, 0}, {0, 0.13}, {12.5, 1.8}, {12.5, 1.8}), 0.14, 0.0157},
          Sample{Curve::cubic({0, 0}, {-0.025, 0.028}, {1.207, 4.396}, {1.257, 4.449}), 0.36, 0.017}}) {
        CAPTURE(sample.size);
        const Vec2 end = sample.curve.point(1.0);
        Domain domain = curvedDomain({{sample.curve, Curve::line(end, {end.x, -2}), Curve::line({end.x, -2}, {0, -2}),
                                       Curve::line({0, -2}, {0, 0})}},
                                     sample.tolerance);
        domain.curveTolerance = sample.tolerance;
        REQUIRE(validate(domain).empty());
        const auto discrete = discretise(domain, constantSpacing(sample.size), false);
        REQUIRE(discrete.ok());
        checkOnCurves(domain, *discrete);
        for (const DiscreteSegment &piece : discrete->segments) {
            CHECK(distance(discrete->nodes[piece.a], discrete->nodes[piece.b]) > 0.25 * sample.size);
        }
    }
}

TEST_CASE("discretise: beside a bend at the end of a curve, edges grow gradually by the automatic spacing") {
    // Turns by a right angle, nearly all of it within a tenth of its length.
    const Curve hook = Curve::cubic({0, 0}, {0, 1.55}, {21.3, 0.16}, {23.3, 0.16});
    const Domain domain =
        curvedDomain({{hook, Curve::line({23.3, 0.16}, {250, 0.16}), Curve::line({250, 0.16}, {250, -250}),
                       Curve::line({250, -250}, {0, -250}), Curve::line({0, -250}, {0, 0})}},
                     2.0);
    const auto spacing = SpacingField::build({}, domain);
    REQUIRE(spacing.ok());
    const auto discrete = discretise(domain, **spacing, false);
    REQUIRE(discrete.ok());
    std::vector<double> lengths;
    for (const DiscreteSegment &piece : discrete->segments) {
        lengths.push_back(distance(discrete->nodes[piece.a], discrete->nodes[piece.b]));
    }
    for (std::size_t s = 0; s < lengths.size(); ++s) {
        const double next = lengths[(s + 1) % lengths.size()];
        CHECK(std::max(lengths[s], next) < 5.0 * std::min(lengths[s], next));
    }
}

TEST_CASE("discretise: a dot far smaller than the spacing keeps its shape") {
    Domain domain = circleDomain();
    const Domain dot = curvedDomain({{Curve::circle({0.2, 0.1}, {0.201, 0.1})}}, 1e-3);
    for (DomainSegment segment : dot.segments) {
        segment.a += static_cast<std::uint32_t>(domain.nodes.size());
        segment.b += static_cast<std::uint32_t>(domain.nodes.size());
        segment.stretch.curve += 1;
        domain.segments.push_back(segment);
    }
    domain.nodes.insert(domain.nodes.end(), dot.nodes.begin(), dot.nodes.end());
    domain.curves.push_back(dot.curves.front());
    const auto discrete = discretise(domain, constantSpacing(0.2), false);
    REQUIRE(discrete.ok());
    std::size_t edges = 0;
    for (const DiscreteSegment &piece : discrete->segments) {
        edges += distance(discrete->nodes[piece.a], {0.2, 0.1}) < 0.01 ? 1 : 0;
    }
    CHECK(edges >= 3);
}

TEST_CASE("discretise: a kept boundary keeps the chords and remembers their curve") {
    const Domain domain = circleDomain();
    const auto discrete = discretise(domain, constantSpacing(1.0), true);
    REQUIRE(discrete.ok());
    CHECK(discrete->nodes == domain.nodes);
    REQUIRE(discrete->stretches.size() == domain.segments.size());
    for (std::size_t s = 0; s < domain.segments.size(); ++s) {
        CHECK(discrete->stretches[s] == domain.segments[s].stretch);
    }
}

TEST_CASE("discretise: curves give the same nodes in any order and direction of the segments") {
    for (std::uint64_t seed = 0; seed < 42; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomCurvedDomain(seed);
        Domain other = domain;
        std::reverse(other.segments.begin(), other.segments.end());
        for (std::size_t s = 0; s < other.segments.size(); s += 2) {
            std::swap(other.segments[s].a, other.segments[s].b);
            other.segments[s].stretch = other.segments[s].stretch.reversed();
        }
        const SpacingFunction spacing = spacingAround(domain.bounds().min, 0.01 * domain.bounds().diagonal(), 0.1);
        const auto first = discretise(domain, spacing, false), second = discretise(other, spacing, false);
        REQUIRE(first.ok());
        REQUIRE(second.ok());
        const auto sorted = [](std::vector<Vec2> nodes) {
            std::sort(nodes.begin(), nodes.end(), [](Vec2 p, Vec2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
            return nodes;
        };
        CHECK(sorted(first->nodes) == sorted(second->nodes));
    }
}

TEST_CASE("validate: segments refer to curves that exist, with finite numbers and parameters between 0 and 1") {
    const Domain domain = circleDomain();
    REQUIRE(validate(domain).empty());
    const auto codeOf = [](const Domain &bad) {
        const Diagnostics faults = validate(bad);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].at.has_value());
        return faults[0].code;
    };
    Domain bad = domain;
    bad.segments[2].stretch.curve = 7;
    CHECK(codeOf(bad) == "bad-index");
    bad = domain;
    bad.segments[2].stretch.t1 = 1.5;
    CHECK(codeOf(bad) == "bad-parameter");
    bad.segments[2].stretch.t1 = std::numeric_limits<double>::quiet_NaN();
    CHECK(codeOf(bad) == "bad-parameter");
    bad = domain;
    bad.curves.push_back(Curve::circle({0, 0}, {std::numeric_limits<double>::infinity(), 0}));
    bad.segments[2].stretch.curve = 1;
    CHECK(codeOf(bad) == "non-finite");
    bad.curves[1] = Curve::arc({0, 0}, {1, 0}, {0, 1}, 0.0, 2.1 * pi);
    CHECK(codeOf(bad) == "bad-curve");
}

TEST_CASE("curveChains: a chain ends where something else meets it, or the curve does not continue") {
    Domain domain = circleDomain(1e-2);
    const std::size_t chords = domain.segments.size();
    CHECK(curveChains(domain).list.size() == 1);
    CHECK(curveChains(domain).list[0].segments.size() == chords);
    CHECK(curveChains(domain).list[0].start == curveChains(domain).list[0].end);

    Domain tagged = domain;
    tagged.segments[3].tag = 7;
    CHECK(curveChains(tagged).list.size() == 3); // the start of the circle, too
    Domain pointed = domain;
    pointed.points.push_back({pointed.segments[4].b, 1});
    CHECK(curveChains(pointed).list.size() == 2);
    Domain moved = domain;
    moved.nodes[moved.segments[4].b] += Vec2{1e-5, 0};
    CHECK(curveChains(moved).list.size() == 2);
    Domain wrong = domain;
    wrong.segments[2].stretch = {0, 0.5, 0.9};
    wrong.segments[5].stretch.curve = 9;
    const CurveChains chains = curveChains(wrong);
    CHECK(chains.ofSegment[2] == kNoIndex);
    CHECK(chains.ofSegment[5] == kNoIndex);
    domain.curves.clear();
    CHECK(curveChains(domain).list.empty());
}
