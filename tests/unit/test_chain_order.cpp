#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/hole_markers.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/chains/chain_order.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/random_curves.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Gives a domain names, markers, points and a node that nothing refers to.
void addOrderExtras(Domain &domain, RandomSource &random) {
    domain.boundaryNames[1] = "coast";
    domain.regionNames[2] = "shelf";
    domain.regionMarkers.push_back({domain.bounds().centre(), 2});
    domain.curveTolerance = 1e-3;
    for (DomainSegment &segment : domain.segments) {
        if (random.chance(0.1)) {
            segment.tag = random.integer(1, 4);
        }
        if (random.chance(0.05)) {
            segment.role = SegmentRole::Constraint;
        }
    }
    const auto last = static_cast<int>(domain.nodes.size()) - 1;
    for (int k = 0; k < 3; ++k) {
        domain.points.push_back({static_cast<std::uint32_t>(random.integer(0, last)), 1 + k});
    }
    domain.nodes.push_back(domain.bounds().min - Vec2{1, 1});
}

/// Calls `check` with straight and curved domains, valid ones and ones in which chains are broken up.
template <class Check>
void forRandomOrders(const Check &check) {
    for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        for (const bool curved : {false, true}) {
            for (const bool extras : {false, true}) {
                CAPTURE(seed);
                CAPTURE(curved);
                CAPTURE(extras);
                RandomSource random(seed);
                Domain domain = curved ? randomCurvedDomain(seed) : randomDomain(seed);
                if (extras) {
                    addOrderExtras(domain, random);
                }
                check(domain, random);
            }
        }
    }
}

auto fieldsOf(const DomainSegment &s) {
    return std::tuple(s.a, s.b, s.tag, s.role, s.stretch.curve, s.stretch.t0, s.stretch.t1);
}

/// Checks that two domains are equal bit by bit.
void checkSameOrder(const Domain &first, const Domain &second) {
    REQUIRE(first.nodes == second.nodes);
    REQUIRE(std::equal(first.segments.begin(), first.segments.end(), second.segments.begin(), second.segments.end(),
                       [](const auto &a, const auto &b) { return fieldsOf(a) == fieldsOf(b); }));
    REQUIRE(std::equal(first.points.begin(), first.points.end(), second.points.begin(), second.points.end(),
                       [](const auto &a, const auto &b) { return a.node == b.node && a.tag == b.tag; }));
    REQUIRE(first.curves == second.curves);
    REQUIRE(first.regionMarkers == second.regionMarkers);
    REQUIRE(first.holeMarkers == second.holeMarkers);
    REQUIRE(first.insideRule == second.insideRule);
    REQUIRE(first.curveTolerance == second.curveTolerance);
    REQUIRE(first.boundaryNames == second.boundaryNames);
    REQUIRE(first.regionNames == second.regionNames);
}

using PlacedEdge = std::tuple<double, double, double, double, std::int32_t, SegmentRole>;

/// Returns the segments by the places of their ends, regardless of order and direction.
std::vector<PlacedEdge> placedEdges(const Domain &domain) {
    std::vector<PlacedEdge> edges;
    for (const DomainSegment &s : domain.segments) {
        std::array ends{std::pair(domain.nodes[s.a].x, domain.nodes[s.a].y),
                        std::pair(domain.nodes[s.b].x, domain.nodes[s.b].y)};
        std::sort(ends.begin(), ends.end());
        edges.emplace_back(ends[0].first, ends[0].second, ends[1].first, ends[1].second, s.tag, s.role);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

template <class Item>
void shuffleItems(std::vector<Item> &items, RandomSource &random) {
    for (std::size_t k = items.size(); k > 1; --k) {
        std::swap(items[k - 1], items[static_cast<std::size_t>(random.integer(0, static_cast<int>(k) - 1))]);
    }
}

/// Numbers the nodes of a domain in another order.
Domain renumbered(const Domain &domain, RandomSource &random) {
    std::vector<std::uint32_t> old;
    for (std::uint32_t n = 0; n < domain.nodes.size(); ++n) {
        old.push_back(n);
    }
    shuffleItems(old, random);
    Domain result = domain;
    std::vector<std::uint32_t> number(old.size());
    for (std::uint32_t n = 0; n < old.size(); ++n) {
        result.nodes[n] = domain.nodes[old[n]];
        number[old[n]] = n;
    }
    for (DomainSegment &segment : result.segments) {
        segment.a = number[segment.a];
        segment.b = number[segment.b];
    }
    for (ConstraintPoint &point : result.points) {
        point.node = number[point.node];
    }
    return result;
}

} // namespace

TEST_CASE("Order of chains: the same as that of the document that shows the domain") {
    std::size_t curves = 0;
    forRandomOrders([&](const Domain &domain, RandomSource &) {
        const Domain ordered = inChainOrder(domain);
        checkSameOrder(ordered, toDomain(fromDomain(domain)));
        curves += ordered.curves.size();
    });
    CHECK(curves > 100);
}

TEST_CASE("Order of chains: a domain with hole markers keeps them; a document needs even-odd roles") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    addLoop(domain, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    addLoop(domain, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}, 6);
    addLoop(domain, {{6, 6}, {8, 6}, {8, 8}, {6, 8}});
    domain.holeMarkers = {{7, 7}};
    const Domain ordered = inChainOrder(domain);
    CHECK(ordered.insideRule == InsideRule::HoleMarkers);
    CHECK(ordered.holeMarkers == domain.holeMarkers);
    CHECK(placedEdges(ordered) == placedEdges(domain));
    checkSameOrder(inChainOrder(withEvenOddRoles(domain)), toDomain(fromDomain(domain)));
}

TEST_CASE("Order of chains: the numbers of nodes have no influence") {
    forRandomOrders([](const Domain &domain, RandomSource &random) {
        checkSameOrder(inChainOrder(renumbered(domain, random)), inChainOrder(domain));
    });
}

TEST_CASE("Order of chains: shuffled segments give the same segments along the same paths") {
    forRandomOrders([](const Domain &domain, RandomSource &random) {
        Domain shuffled = domain;
        shuffleItems(shuffled.segments, random);
        const Domain one = inChainOrder(domain), other = inChainOrder(shuffled);
        REQUIRE(one.segments.size() == other.segments.size());
        REQUIRE(one.curves.size() == other.curves.size());
        if (domain.curves.empty()) { // the parts of a curve are rounded in the direction of the path
            REQUIRE(placedEdges(one) == placedEdges(other));
            REQUIRE(placedEdges(one) == placedEdges(domain));
        }
    });
}

TEST_CASE("Order of chains: it says where each part comes from") {
    forRandomOrders([](const Domain &domain, RandomSource &) {
        ChainOrder order;
        const Domain ordered = inChainOrder(domain, &order);
        REQUIRE(order.nodes.size() == ordered.nodes.size());
        REQUIRE(order.segments.size() == ordered.segments.size());
        REQUIRE(order.points.size() == ordered.points.size());
        const double reach = 1e-7 * domain.bounds().diagonal();
        for (std::size_t n = 0; n < ordered.nodes.size(); ++n) {
            REQUIRE(distance(ordered.nodes[n], domain.nodes[order.nodes[n]]) <= reach);
        }
        for (std::size_t s = 0; s < ordered.segments.size(); ++s) {
            const DomainSegment &segment = ordered.segments[s], &from = domain.segments[order.segments[s]];
            REQUIRE(segment.tag == from.tag);
            REQUIRE(segment.role == from.role);
            const auto ends = std::minmax(order.nodes[segment.a], order.nodes[segment.b]);
            REQUIRE(ends == std::minmax(from.a, from.b));
        }
        for (std::size_t p = 0; p < ordered.points.size(); ++p) {
            REQUIRE(domain.points[order.points[p]].tag == ordered.points[p].tag);
        }
    });
}

TEST_CASE("Order of chains: a loop along a flat ellipse stays, for validation to report") {
    Domain domain;
    domain.curves = {Curve::arc({0, 0}, {1, 0}, {0.5, 0})};
    for (std::uint32_t k = 0; k < 4; ++k) {
        domain.nodes.push_back(domain.curves[0].point(k / 4.0));
        domain.segments.push_back({k, (k + 1) % 4, 1, SegmentRole::Boundary, {0, k / 4.0, (k + 1) / 4.0}});
    }
    const Domain ordered = inChainOrder(domain);
    CHECK(ordered.segments.size() == 4);
    CHECK_FALSE(validate(ordered).empty());
    checkSameOrder(ordered, toDomain(fromDomain(domain)));
}
