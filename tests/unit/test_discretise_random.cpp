#include "core/engine/boundary/discretise.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/discrete_checks.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// The spacing fields each domain is cut with, by the size of the domain.
std::vector<SpacingFunction> spacings(const Domain &domain) {
    const Box2 box = domain.bounds();
    const double size = box.diagonal();
    return {constantSpacing(0.3 * size), constantSpacing(0.013 * size), spacingAround(box.min, 1e-3 * size, 0.15),
            spacingAround(domain.nodes[0], 1e-5 * size, 0.3)};
}

/// Checks the pieces of each domain segment: a chain of nodes from its a to its b, straight within rounding.
void checkChains(const Domain &domain, const DiscreteDomain &discrete) {
    const Box2 box = domain.bounds();
    const double magnitude =
        std::max({std::fabs(box.min.x), std::fabs(box.max.x), std::fabs(box.min.y), std::fabs(box.max.y)});
    REQUIRE(discrete.nodes.size() >= domain.nodes.size());
    REQUIRE(std::equal(domain.nodes.begin(), domain.nodes.end(), discrete.nodes.begin()));
    std::vector<std::vector<std::size_t>> pieces(domain.segments.size());
    for (std::size_t s = 0; s < discrete.segments.size(); ++s) {
        REQUIRE(discrete.segments[s].source < domain.segments.size());
        pieces[discrete.segments[s].source].push_back(s);
    }
    for (std::size_t source = 0; source < pieces.size(); ++source) {
        const DomainSegment &whole = domain.segments[source];
        const Vec2 a = domain.nodes[whole.a], b = domain.nodes[whole.b];
        std::map<std::uint32_t, const DiscreteSegment *> from;
        for (const std::size_t s : pieces[source]) {
            const DiscreteSegment &piece = discrete.segments[s];
            REQUIRE(piece.tag == whole.tag);
            REQUIRE(from.emplace(piece.a, &piece).second);
            REQUIRE(distanceToSegment(a, b, discrete.nodes[piece.b]) <= 1e-15 * magnitude);
        }
        std::uint32_t at = whole.a;
        double way = 0.0;
        for (std::size_t steps = 0; steps < pieces[source].size(); ++steps) {
            REQUIRE(from.contains(at));
            const DiscreteSegment &piece = *from[at];
            way += distance(discrete.nodes[piece.a], discrete.nodes[piece.b]);
            at = piece.b;
        }
        REQUIRE(at == whole.b);
        REQUIRE(way == doctest::Approx(distance(a, b)).epsilon(1e-9)); // never back and forth
    }
}

/// Computes ∫ds/ρ by brute force.
double spacingLength(const SpacingField &spacing, Vec2 a, Vec2 b) {
    constexpr int kSteps = 400;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        sum += 1.0 / spacing.at(lerp(a, b, (i + 0.5) / kSteps));
    }
    return sum * distance(a, b) / kSteps;
}

using Places = std::vector<std::pair<double, double>>;

Places sortedPlaces(const DiscreteDomain &discrete) {
    Places places;
    for (const Vec2 p : discrete.nodes) {
        places.emplace_back(p.x, p.y);
    }
    std::sort(places.begin(), places.end());
    return places;
}

} // namespace

TEST_CASE("discretise: random domains stay simple, with correct chains, regions and areas") {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        for (const SpacingFunction &spacing : spacings(domain)) {
            const auto discrete = discretise(domain, spacing, false);
            REQUIRE(discrete.ok());
            checkChains(domain, *discrete);
            checkRegions(domain, *discrete);
            checkAreas(*discrete);
        }
    }
}

TEST_CASE("discretise: kept boundaries are kept exactly") {
    for (std::uint64_t seed = 600; seed < 900; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        const auto discrete = discretise(domain, constantSpacing(1e-4 * domain.bounds().diagonal()), true);
        REQUIRE(discrete.ok());
        REQUIRE(discrete->nodes == domain.nodes);
        REQUIRE(discrete->segments.size() == domain.segments.size());
        checkChains(domain, *discrete);
        checkRegions(domain, *discrete);
        checkAreas(*discrete);
    }
}

TEST_CASE("discretise: every piece of a cut segment has nearly the same share of the integral of 1/spacing") {
    std::size_t cut = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        for (const SpacingFunction &spacing : spacings(domain)) {
            const auto discrete = discretise(domain, spacing, false);
            REQUIRE(discrete.ok());
            std::vector<int> pieces(domain.segments.size(), 0);
            for (const DiscreteSegment &piece : discrete->segments) {
                ++pieces[piece.source];
            }
            for (const DiscreteSegment &piece : discrete->segments) {
                const double share = spacingLength(spacing, discrete->nodes[piece.a], discrete->nodes[piece.b]);
                if (pieces[piece.source] > 1) {
                    REQUIRE(share > 0.6);
                    ++cut;
                }
                REQUIRE(share < 1.6);
            }
        }
    }
    CHECK(cut > 10000);
}

TEST_CASE("discretise: order and direction of segments change neither positions nor areas") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        Domain other = domain;
        std::reverse(other.segments.begin(), other.segments.end());
        for (DomainSegment &segment : other.segments) {
            std::swap(segment.a, segment.b);
        }
        const SpacingFunction spacing = spacingAround(domain.nodes[0], 1e-3 * domain.bounds().diagonal(), 0.2);
        const auto first = discretise(domain, spacing, false), second = discretise(other, spacing, false);
        REQUIRE(first.ok());
        REQUIRE(second.ok());
        REQUIRE(sortedPlaces(*first) == sortedPlaces(*second));
        REQUIRE(first->regions.size() == second->regions.size());
        for (std::size_t i = 0; i < first->regions.size(); ++i) {
            REQUIRE(first->regions[i].tag == second->regions[i].tag);
            REQUIRE(first->regions[i].area == doctest::Approx(second->regions[i].area).epsilon(1e-10));
        }
    }
}

TEST_CASE("discretise: absurdly small spacing is refused at once with an estimate") {
    Domain domain;
    domain.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    for (const double rho : {1e-9, 1e-15, 1e-300}) {
        const auto refused = discretise(domain, constantSpacing(rho), false);
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.faults()[0].code == "too-many-nodes");
        CHECK_FALSE(refused.faults()[0].advice.empty());
    }
    CHECK(discretise(domain, constantSpacing(1e-9), true).ok());
}

TEST_CASE("discretise: a requested stop is reported as cancelled") {
    const Domain domain = randomDomain(DomainFamily::SeveralOutlines, 3);
    std::stop_source source;
    source.request_stop();
    const auto stopped =
        discretise(domain, constantSpacing(0.01 * domain.bounds().diagonal()), false, {nullptr, source.get_token()});
    REQUIRE_FALSE(stopped.ok());
    CHECK(stopped.faults()[0].code == "cancelled");
}
