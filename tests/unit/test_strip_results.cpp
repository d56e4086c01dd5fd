#include "core/engine/base/thread_pool.hpp"
#include "core/engine/mesher/strip_results.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <random>
#include <thread>

using namespace forefront;

namespace {

constexpr std::size_t kStrips = 6;

/// A mesh of four nodes and the same number of strips with random nodes, elements and faces.
struct StripSample {
    explicit StripSample(std::uint64_t seed, bool manyFaces) : whole(square(manyFaces)) {
        std::mt19937_64 random(seed);
        states.reserve(kStrips);
        for (std::size_t k = 0; k < kStrips; ++k) {
            FrontState &state = states.emplace_back(whole, GenerationFront{}, 1, 4);
            const std::size_t nodes = random() % 40;
            for (std::size_t n = 0; n < nodes; ++n) {
                state.nodes.push_back({static_cast<double>(k), static_cast<double>(n)});
            }
            const std::size_t elements = random() % 80;
            for (std::size_t e = 0; e < elements; ++e) {
                const auto any = [&] { return NodeId{static_cast<std::uint32_t>(random() % (4 + nodes))}; };
                state.elements.push_back({any(), any(), any()});
                if (manyFaces) {
                    state.elementFaces.push_back(static_cast<std::uint32_t>(random() % 2));
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

/// Merges the strips in the obvious way, one after the other.
FrontState expected(const StripSample &sample) {
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
        whole.elementFaces.insert(whole.elementFaces.end(), state.elementFaces.begin(), state.elementFaces.end());
    }
    return whole;
}

void check(const StripSample &sample, const FrontState &reference, const StripResults &results) {
    CHECK(sample.whole.nodes == reference.nodes);
    CHECK(sample.whole.elements == reference.elements);
    CHECK(sample.whole.elementFaces == reference.elementFaces);
    CHECK(results.firstNew() == 4);
    for (std::size_t k = 0, nodes = 0; k < kStrips; ++k) {
        CHECK(results.shift(k) == nodes);
        CHECK(sample.states[k].nodes.capacity() == 0);
        CHECK(sample.states[k].elements.capacity() == 0);
        const double place = static_cast<double>(k);
        nodes += static_cast<std::size_t>(std::count_if(reference.nodes.begin() + 4, reference.nodes.end(),
                                                        [place](Vec2 p) { return p.x == place; }));
    }
}

} // namespace

TEST_CASE(
    "StripResults: the whole does not depend on the order in which strips finish, and grows as early as possible") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        StripSample sample(seed, seed % 2 == 0);
        const FrontState reference = expected(sample);
        std::vector<std::size_t> order(kStrips), ends(kStrips + 1, 0);
        for (std::size_t k = 0; k < kStrips; ++k) {
            ends[k + 1] = ends[k] + sample.states[k].elements.size();
        }
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), std::mt19937_64(seed));
        StripResults results(sample.whole, kStrips);
        std::array<bool, kStrips> done{};
        for (const std::size_t k : order) {
            results.finished(k, sample.states[k]);
            done[k] = true;
            const auto firstOpen = static_cast<std::size_t>(std::find(done.begin(), done.end(), false) - done.begin());
            CHECK(sample.whole.elements.size() == ends[firstOpen]);
        }
        check(sample, reference, results);
    }
}

TEST_CASE("StripResults: the merged state is the same when threads finish strips at the same time") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        StripSample sample(seed, seed % 2 == 0);
        const FrontState reference = expected(sample);
        StripResults results(sample.whole, kStrips);
        ThreadPool pool(3);
        std::atomic<unsigned> waiting = 0;
        pool.run(kStrips, [&](std::size_t k, unsigned) {
            const unsigned round = static_cast<unsigned>(k) / pool.threads(); // all threads go at once
            for (++waiting; waiting < (round + 1) * pool.threads();) {
                std::this_thread::yield();
            }
            results.finished(k, sample.states[k]);
        });
        check(sample, reference, results);
    }
}
