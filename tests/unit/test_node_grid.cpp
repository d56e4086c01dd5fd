#include "core/drawing/arrangement/snapping/node_grid.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <set>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("NodeGrid: visits all nodes within reach, and few others") {
    constexpr double kReach = 0.01;
    constexpr std::uint32_t kNodes = 2000;
    RandomSource random(21);
    NodeGrid grid(kReach, kNodes / 2);
    std::vector<Vec2> places;
    for (std::uint32_t node = 0; node < kNodes; ++node) {
        places.push_back({random.between(-1.0, 1.0), random.between(-1.0, 1.0)});
        grid.add(node, places.back());
        grid.add(node, places.back()); // changes nothing
    }
    std::size_t visits = 0;
    for (const Vec2 p : places) {
        std::set<std::uint32_t> found;
        grid.visitNear(p, [&](std::uint32_t node) {
            found.insert(node);
            ++visits;
        });
        for (std::uint32_t node = 0; node < kNodes; ++node) {
            REQUIRE((found.count(node) == 1 || distance(places[node], p) > kReach));
        }
    }
    CHECK(visits < 20 * kNodes);
}
