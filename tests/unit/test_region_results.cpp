#include "core/mesher/region_results.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace forefront;

namespace {

constexpr std::size_t kRegions = 6;

/// A whole of four nodes and as many regions with nodes, elements and faces by chance.
struct Sample {
    explicit Sample(std::uint64_t seed, bool manyFaces) : whole(square(manyFaces)) {
        std::mt19937_64 random(seed);
        states.reserve(kRegions);
        for (std::size_t k = 0; k < kRegions; ++k) {
            FrontState &state = states.emplace_back(whole, GenerationFront{}, 1);
            const std::size_t nodes = random() % 40;
            for (std::size_t n = 0; n < nodes; ++n) {
                state.nodes.push_back({static_cast<double>(k), static_cast<double>(n)});
            }
            const std::size_t elements = random() % 80;
            for (std::size_t e = 0; e < elements; ++e) {
                const auto any = [&] { return NodeId{static_cast<std::uint32_t>(random() % (4 + nodes))}; };
                state.elements.push_back({any(), any(), any()});
                if (manyFaces) {
                    state.elementRegions.push_back(static_cast<std::uint32_t>(random() % 2));
                }
            }
        }
    }

    static DiscreteDomain square(bool manyFaces) {
        DiscreteDomain domain;
        domain.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (std::uint32_t i = 0; i < 4; ++i) {
            domain.segments.push_back({i, (i + 1) % 4, 1, 0, kOutside, i});
        }
        domain.regions.resize(manyFaces ? 2 : 1);
        return domain;
    }

    FrontState whole;
    std::vector<FrontState> states;
};

/// The plain way, one region after the other.
FrontState expected(const Sample &sample) {
    FrontState whole = sample.whole;
    for (const FrontState &state : sample.states) {
        const auto shift = static_cast<std::uint32_t>(whole.nodes.size() - sample.whole.nodes.size());
        whole.nodes.insert(whole.nodes.end(), state.nodes.begin(), state.nodes.end());
        for (Element e : state.elements) {
            for (NodeId &n : e) {
                n = index(n) < 4 ? n : NodeId{static_cast<std::uint32_t>(index(n)) + shift};
            }
            whole.elements.push_back(e);
        }
        whole.elementRegions.insert(whole.elementRegions.end(), state.elementRegions.begin(),
                                    state.elementRegions.end());
    }
    return whole;
}

} // namespace

TEST_CASE("RegionResults: the whole is the same whatever has been gathered early, and in which order regions finish") {
    std::size_t early = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        Sample sample(seed, seed % 2 == 0);
        const FrontState wanted = expected(sample);
        if (seed % 3 != 0) { // else there is no room, and nothing can be done early
            sample.whole.nodes.reserve(1000);
            sample.whole.elements.reserve(1000);
        }
        std::mt19937_64 random(seed);
        std::vector<std::size_t> order(kRegions);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), random);
        RegionResults results(sample.whole, kRegions);
        const auto someEarly = [&] {
            for (std::size_t task = 0; task < results.earlyTasks(); ++task) {
                if (random() % 2 == 0) {
                    results.early(task);
                }
            }
        };
        for (const std::size_t k : order) {
            results.begun();
            results.finished(k, sample.states[k]);
            someEarly();
        }
        early += sample.whole.elements.empty() ? 0 : 1;
        for (std::size_t k = 0, nodes = 0; k < kRegions; ++k) {
            CHECK(results.shift(k) == nodes);
            const double place = static_cast<double>(k);
            nodes += static_cast<std::size_t>(
                std::count_if(wanted.nodes.begin() + 4, wanted.nodes.end(), [place](Vec2 p) { return p.x == place; }));
        }
        ThreadPool pool(static_cast<unsigned>(1 + seed % 3));
        results.gather(pool);
        CHECK(sample.whole.nodes == wanted.nodes);
        CHECK(sample.whole.elements == wanted.elements);
        CHECK(sample.whole.elementRegions == wanted.elementRegions);
    }
    CHECK(early > 50);
}

TEST_CASE("RegionResults: nothing is moved while a region may still read the whole") {
    Sample sample(1, false);
    sample.whole.nodes.reserve(1000);
    sample.whole.elements.reserve(1000);
    RegionResults results(sample.whole, kRegions);
    for (std::size_t k = 0; k + 1 < kRegions; ++k) {
        results.begun();
        results.finished(k, sample.states[k]);
    }
    for (std::size_t task = 0; task < results.earlyTasks(); ++task) {
        results.early(task);
    }
    CHECK(sample.whole.nodes.size() == 4);
    CHECK(sample.whole.elements.empty());
}
