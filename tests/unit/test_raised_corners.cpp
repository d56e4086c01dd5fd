// Corners that move where a mesh becomes second order.
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/second_order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace forefront;

TEST_CASE("raiseOrder: no element turns concave for a neighbour that already is") {
    // The corner in the middle would have to lie beyond both of two parallel lines, from either side.
    Mesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {4, 0}, {0, 2}, {0.5, 0.5}, {1.2, 0.6}, {0, 4}, {0.6, 1.2}, {4, 4}};
    CellBlock &block = mesh.block(CellKind::Quadrilateral4);
    for (const std::array<std::uint32_t, 4> &n : {std::array{0U, 1U, 4U, 3U}, std::array{1U, 2U, 5U, 4U},
                                                  std::array{3U, 4U, 7U, 6U}, std::array{4U, 5U, 8U, 7U}}) {
        block.add(std::array{NodeId{n[0]}, NodeId{n[1]}, NodeId{n[2]}, NodeId{n[3]}});
        block.regions.push_back(1);
    }
    std::vector<double> before;
    for (std::size_t e = 0; e < 4; ++e) {
        before.push_back(scaledJacobian(PlacedCell(MeshView(mesh), e)));
    }
    REQUIRE(before[0] < 0.0);
    REQUIRE(*std::min_element(before.begin() + 1, before.end()) > 0.1);
    std::vector<bool> movable(mesh.nodes.size(), false);
    movable[4] = true;
    SecondOrderReport report;
    REQUIRE(raiseOrder(mesh, {.movable = &movable}, report));
    for (std::size_t e = 0; e < 4; ++e) {
        PlacedCell corners(MeshView(mesh), e);
        corners.kind = CellKind::Quadrilateral4;
        CHECK(scaledJacobian(corners) >= std::min(before[e], 0.1));
    }
}
