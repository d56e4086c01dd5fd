#include "core/domain/node_welder.hpp"

#include <doctest/doctest.h>

using namespace forefront;

namespace {

constexpr Box2 kUnit{{0, 0}, {1, 1}};

} // namespace

TEST_CASE("NodeWelder: the tolerance follows the extent, and the distance from the origin") {
    std::vector<Vec2> nodes;
    CHECK(NodeWelder(nodes, {{0, 0}, {3, 4}}).tolerance() == doctest::Approx(5e-12));
    CHECK(NodeWelder(nodes, {{1e6, 0}, {1e6 + 3, 4}}).tolerance() == doctest::Approx(4e-9));
    CHECK(NodeWelder(nodes, {{0, 0}, {0, 0}}).tolerance() > 0.0);
}

TEST_CASE("NodeWelder: a crossing takes the nearest end within the tolerance") {
    std::vector<Vec2> nodes{{0, 0}, {1, 1}, {0.5, 0.5}, {0.5, 0.5 + 1e-12}};
    NodeWelder welder(nodes, kUnit);
    CHECK(welder.nodeAt({0.5, 0.5 + 0.9e-12}, {0, 2, 3, 1}) == 3);
    CHECK(nodes.size() == 4);
}

TEST_CASE("NodeWelder: a crossing away from the ends gets a node, which later ones share") {
    std::vector<Vec2> nodes{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
    NodeWelder welder(nodes, kUnit);
    const Vec2 at{0.5, 0.5};
    CHECK(welder.nodeAt(at, {0, 1, 2, 3}) == 4);
    CHECK(nodes.size() == 5);
    CHECK(nodes[4] == at);
    // Within the tolerance in every direction, also across the cells of the search.
    const double step = 0.9 * welder.tolerance();
    for (const Vec2 shift : {Vec2{step, 0}, Vec2{-step, 0}, Vec2{0, step}, Vec2{0, -step}}) {
        CHECK(welder.nodeAt(at + shift, {0, 1, 2, 3}) == 4);
    }
    CHECK(nodes.size() == 5);
    CHECK(welder.nodeAt(at + Vec2{2.5 * welder.tolerance(), 0}, {0, 1}) == 5);
    CHECK(nodes.size() == 6);
}

TEST_CASE("NodeWelder: does not reuse given nodes that are not ends") {
    std::vector<Vec2> nodes{{0, 0}, {1, 1}, {0.5, 0.5}};
    NodeWelder welder(nodes, kUnit);
    CHECK(welder.nodeAt({0.5, 0.5}, {0, 1}) == 3);
}

TEST_CASE("NodeWelder: moves the later node onto the earlier one, once, and only on request") {
    std::vector<Vec2> nodes{{0.5, 0.5}, {0.5 + 1e-12, 0.5}, {0.5, 0.5 + 1e-12}, {0.7, 0.7}};
    NodeWelder welder(nodes, kUnit);
    CHECK(welder.weld(1, 0));
    CHECK(welder.weld(0, 1));
    CHECK(welder.weld(2, 0));
    CHECK(welder.weld(3, 3));
    CHECK_FALSE(welder.weld(3, 0));
    REQUIRE(welder.welds().size() == 2);
    CHECK(welder.welds()[0] == std::pair<std::uint32_t, std::uint32_t>{1, 0});
    CHECK(welder.welds()[1] == std::pair<std::uint32_t, std::uint32_t>{2, 0});
    CHECK(nodes[1] != nodes[0]);
    welder.move();
    CHECK(nodes[1] == nodes[0]);
    CHECK(nodes[2] == nodes[0]);
    CHECK(nodes[3] == Vec2{0.7, 0.7});
    CHECK(welder.welds().empty());
}
