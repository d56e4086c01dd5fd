#include "core/engine/mesh/mesh_extent.hpp"
#include "core/engine/mesh/quality.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <initializer_list>

using namespace forefront;

namespace {

/// Returns unit squares, of two elements each, at places of a grid of 10 by 10; squares share nodes.
TriMesh squares(std::initializer_list<std::array<std::uint32_t, 2>> places) {
    TriMesh mesh;
    const auto node = [&](std::uint32_t x, std::uint32_t y) {
        const Vec2 at{static_cast<double>(x), static_cast<double>(y)};
        std::uint32_t n = 0;
        while (n < mesh.nodes.size() && mesh.nodes[n] != at) {
            ++n;
        }
        if (n == mesh.nodes.size()) {
            mesh.nodes.push_back(at);
        }
        return NodeId{n};
    };
    for (const auto [x, y] : places) {
        const NodeId a = node(x, y), b = node(x + 1, y), c = node(x + 1, y + 1), d = node(x, y + 1);
        mesh.elements.push_back({a, b, c});
        mesh.elements.push_back({a, c, d});
    }
    return mesh;
}

MeshExtent extent(const TriMesh &mesh) {
    return extentOf(mesh, measureQuality(mesh, nullptr).edges);
}

} // namespace

TEST_CASE("Mesh extent: parts and holes") {
    const MeshExtent ring = extent(squares({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}));
    CHECK(ring.parts == 1);
    CHECK(ring.holes == 1);
    const MeshExtent apart = extent(squares({{0, 0}, {1, 0}, {4, 0}, {4, 4}}));
    CHECK(apart.parts == 3);
    CHECK(apart.holes == 0);
    const MeshExtent corners = extent(squares({{1, 0}, {0, 1}, {2, 1}, {1, 2}, {5, 5}})); // around a hole
    CHECK(corners.parts == 2);
    CHECK(corners.holes == 1);
    TriMesh unused = squares({{0, 0}});
    unused.nodes.push_back({9, 9});
    CHECK(extent(unused).parts == 1);
    CHECK(extent(unused).holes == 0);
    CHECK(extent(TriMesh{}).parts == 0);
}

TEST_CASE("Mesh extent: regions have their name, elements and area") {
    TriMesh mesh = squares({{0, 0}, {1, 0}, {2, 0}});
    mesh.regions = {7, 7, 3, 3, 7, 7};
    mesh.regionNames = {{7, "steel"}};
    const MeshExtent found = extent(mesh);
    REQUIRE(found.regions.size() == 2);
    CHECK(found.regions[0].tag == 3);
    CHECK(found.regions[0].name.empty());
    CHECK(found.regions[0].area == 1.0);
    CHECK(found.regions[1].name == "steel");
    CHECK(found.regions[1].elements == 4);
    CHECK(found.regions[1].area == 2.0);
}
