#include "core/engine/mesher/timeline.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/discrete_samples.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::unique_ptr<Mesher> mesherOn(std::shared_ptr<const DiscreteDomain> domain, double rho, GridKind grid,
                                 Method method) {
    MeshingOptions options;
    options.grid = grid;
    options.method = method;
    return Mesher::create(std::move(domain), spacingOf([rho](Vec2 p) { return rho * (1.0 + 0.5 * p.x * p.x); }),
                          options);
}

/// Everything about a position that must not depend on the way there.
struct Figures {
    std::uint64_t hash, delivered, tested, cells, elements;
    friend bool operator==(const Figures &, const Figures &) = default;
};

Figures figuresOf(const Timeline &timeline) {
    const FrontState &state = timeline.mesher().state();
    return {state.hash(), state.work.delivered, state.work.tested, state.work.cellsVisited, state.work.elements};
}

void goTo(Timeline &timeline, std::uint64_t target) {
    timeline.approach(target);
    if (target > timeline.position()) {
        timeline.forward(target - timeline.position());
    } else {
        timeline.back(timeline.position() - target);
    }
}

} // namespace

TEST_CASE("Checkpoints: any walk along the timeline meets the same states and work as the first run") {
    std::mt19937 random(20261);
    for (const Method method : {Method::Fast, Method::Classic}) {
        for (const GridKind grid : valuesOf<GridKind>()) {
            CAPTURE(static_cast<int>(method));
            CAPTURE(static_cast<int>(grid));
            Timeline timeline(mesherOn(discretePlate(0.05), 0.05, grid, method), 16);
            std::vector<Figures> figures{figuresOf(timeline)};
            while (timeline.forward(1) == 1) {
                figures.push_back(figuresOf(timeline));
            }
            REQUIRE(timeline.complete());
            REQUIRE(figures.size() == timeline.known() + 1);
            REQUIRE(timeline.known() > 300);
            CHECK(timeline.checkpoints() > 5);
            CHECK(timeline.checkpoints() <= Timeline::kMaxCheckpoints);
            for (int walk = 0; walk < 60; ++walk) {
                const std::uint64_t target = random() % figures.size();
                goTo(timeline, target);
                REQUIRE(timeline.position() == target);
                REQUIRE(figuresOf(timeline) == figures[target]);
                // Steps back lead across the checkpoint that it may have jumped to.
                for (unsigned back = 0; back < random() % 40 && timeline.position() > 0; ++back) {
                    REQUIRE(timeline.back(1) == 1);
                    REQUIRE(figuresOf(timeline) == figures[timeline.position()]);
                }
                timeline.forward(random() % 30);
                REQUIRE(figuresOf(timeline) == figures[timeline.position()]);
            }
            goTo(timeline, 0);
            CHECK(figuresOf(timeline) == figures[0]);
            goTo(timeline, timeline.known());
            CHECK(figuresOf(timeline) == figures.back());
        }
    }
}

TEST_CASE("Checkpoints: a jump before the end of the run is known does not change what follows") {
    for (const Method method : {Method::Fast, Method::Classic}) {
        Timeline straight(mesherOn(discretePlate(0.05), 0.05, GridKind::Hierarchical, method), 32);
        straight.forward(~std::uint64_t{0});
        Timeline jumping(mesherOn(discretePlate(0.05), 0.05, GridKind::Hierarchical, method), 32);
        for (int leg = 0; leg < 1000 && !jumping.complete(); ++leg) {
            jumping.forward(150);
            goTo(jumping, jumping.known() / 3);
            jumping.approach(jumping.known());
            jumping.forward(jumping.known() - jumping.position());
        }
        REQUIRE(jumping.complete());
        CHECK(figuresOf(jumping).hash == figuresOf(straight).hash);
        CHECK(jumping.known() == straight.known());
        CHECK(jumping.layerEnds() == straight.layerEnds());
    }
}

TEST_CASE("Checkpoints: jumps between the strips of a long run meet the same states as the first run") {
    constexpr std::uint64_t kBetween = 4000;
    Timeline timeline(mesherOn(discretePlate(0.004), 0.0016, GridKind::Hierarchical, Method::Fast));
    REQUIRE(timeline.mesher().state().strips->boxes.size() > 8);
    std::vector<std::uint64_t> hashes{timeline.mesher().state().hash()};
    while (timeline.forward(kBetween) == kBetween) {
        hashes.push_back(timeline.mesher().state().hash());
    }
    REQUIRE(hashes.size() > 60);
    // From the end on, so that later strips are entered before earlier ones of the same phase.
    for (std::size_t place = hashes.size() - 1; place-- > 0;) {
        CAPTURE(place);
        goTo(timeline, place * kBetween);
        REQUIRE(timeline.mesher().state().hash() == hashes[place]);
        timeline.forward(kBetween);
        REQUIRE(timeline.mesher().state().hash() == hashes[place + 1]);
        REQUIRE(timeline.back(1) == 1);
        REQUIRE(timeline.mesher().state().front.consistent());
    }
}

TEST_CASE("Checkpoints: their number and memory stay bounded, and the distance to the next one stays short") {
    Timeline timeline(mesherOn(discretePlate(0.02), 0.02, GridKind::Hierarchical, Method::Fast), 1);
    timeline.forward(~std::uint64_t{0});
    REQUIRE(timeline.known() > 20 * Timeline::kMaxCheckpoints);
    CHECK(timeline.checkpoints() <= Timeline::kMaxCheckpoints);
    CHECK(timeline.checkpoints() > Timeline::kMaxCheckpoints / 4);
    CHECK(timeline.checkpointBytes() <= Timeline::kMaxCheckpointBytes);
}
