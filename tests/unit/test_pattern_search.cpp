#include "core/engine/improve/pattern_search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

using namespace forefront;

namespace {

constexpr ShapeGoal kGoal{0.8, 35.0, 6};

/// Returns the triangles around node 0, with the other nodes at random distances; some triangles are clockwise.
TriMesh randomStar(std::mt19937 &random, std::uint32_t count) {
    std::uniform_real_distribution<double> unit;
    const double least = unit(random), shift = unit(random) < 0.2 ? 2.0 : 0.3;
    TriMesh mesh;
    mesh.nodes = {{shift * (unit(random) - 0.5), shift * (unit(random) - 0.5)}};
    for (std::uint32_t k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + 0.5 * unit(random)) / count;
        const double radius = std::lerp(least, 1.0, unit(random));
        mesh.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        mesh.elements.push_back({NodeId{0}, NodeId{1 + k}, NodeId{1 + (k + 1) % count}});
    }
    return mesh;
}

/// Returns the lowest measure of the elements of a star with its node moved.
double worst(const TriMesh &star, const ShapeMeasure &measure, Vec2 by) {
    double lowest = 1e300;
    for (const Element &n : star.elements) {
        const Vec2 a = star.nodes[index(n[1])] - star.nodes[0], b = star.nodes[index(n[2])] - star.nodes[0];
        lowest = std::min(lowest, measure.of(a - by, b - by, distanceSquared(a, b)));
    }
    return lowest;
}

/// Searches place by place, as the definition says.
Vec2 plainSearch(const TriMesh &star, const ShapeMeasure &measure, const PatternSearch::Limits &limits) {
    constexpr double kDiagonal = 0.7071067811865476;
    constexpr std::array<Vec2, 8> kPattern = {{{1, 0},
                                               {0, 1},
                                               {-1, 0},
                                               {0, -1},
                                               {kDiagonal, kDiagonal},
                                               {-kDiagonal, kDiagonal},
                                               {-kDiagonal, -kDiagonal},
                                               {kDiagonal, -kDiagonal}}};
    double farthest = 0.0;
    for (const Vec2 p : star.nodes) {
        farthest = std::max(farthest, distanceSquared(p, star.nodes[0]));
    }
    const double reach = std::sqrt(farthest);
    Vec2 best;
    double bestMeasure = worst(star, measure, best), step = 0.16;
    for (int tries = 0;
         tries < limits.patterns && step > limits.minStep && bestMeasure < 1.0 + (tries > 0 ? 0.02 : 0.0); ++tries) {
        const Vec2 from = best;
        for (const Vec2 direction : kPattern) {
            const Vec2 p = from + (step * reach) * direction;
            if (const double here = worst(star, measure, p); here > bestMeasure) {
                bestMeasure = here;
                best = p;
            }
        }
        step *= best == from ? 0.5 : 1.0;
    }
    return best;
}

} // namespace

TEST_CASE("ShapeMeasure: without branches, positive measures have the same bits and no other is positive") {
    const ShapeMeasure measure(kGoal);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (int k = 0; k < 10000; ++k) {
        const Vec2 u{place(random), place(random)};
        Vec2 v{place(random), k % 7 == 0 ? 1e-9 * place(random) : place(random)};
        if (k % 11 == 0) {
            v = k % 2 == 0 ? u : -2.0 * u; // flat
        }
        const double third = k % 11 == 0 && k % 2 == 0 ? 1.0 : distanceSquared(u, v);
        const double plain = measure.of(u, v, third), fast = measure.ifPositive(u, v, third);
        CHECK((plain > 0.0 ? fast == plain : !(fast > 0.0) && !std::isnan(fast)));
    }
    CHECK(measure.ifPositive({}, {1, 0}, 1.0) == 0.0); // a side without a length
}

TEST_CASE("PatternSearch: finds the place, bit for bit, that a search place by place finds") {
    const ShapeMeasure measure(kGoal);
    std::mt19937 random(3);
    PatternSearch search(measure);
    int moved = 0, clockwise = 0;
    for (int k = 0; k < 2000; ++k) {
        TriMesh star = randomStar(random, 3 + static_cast<std::uint32_t>(k % 7));
        ThreadPool pool(1);
        const ImproveWorkspace work(star, pool);
        REQUIRE(work.isFree(NodeId{0}));
        const PatternSearch::Limits limits =
            k % 2 == 0 ? PatternSearch::Limits{24, 0.008} : PatternSearch::Limits{60, 0.0005};
        const Vec2 by = search.bestMove(work, NodeId{0}, limits);
        CHECK(by == plainSearch(star, measure, limits));
        CHECK(search.elements().size() == star.elements.size());
        const double before = worst(star, measure, {});
        clockwise += before < 0.0 ? 1 : 0;
        if (!(by == Vec2{})) {
            ++moved;
            CHECK(worst(star, measure, by) > before);
        }
    }
    CHECK(moved > 1000);
    CHECK(clockwise > 50);
}
