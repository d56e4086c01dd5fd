#include "core/engine/mesh/numbering.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace forefront {

namespace {

bool isPermutation(std::vector<NodeId> numbers) {
    std::ranges::sort(numbers, {}, [](NodeId n) { return index(n); });
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (index(numbers[k]) != k) {
            return false;
        }
    }
    return true;
}

/// Numbers the nodes of a mesh at random.
Mesh shuffled(const MeshView &mesh, std::uint64_t seed) {
    samples::Random random(seed);
    std::vector<NodeId> numbers(mesh.nodes.size());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        numbers[n] = samples::node(n);
    }
    for (std::size_t n = numbers.size(); n > 1; --n) {
        std::swap(numbers[n - 1], numbers[random.below(n)]);
    }
    return renumbered(mesh, numbers);
}

} // namespace

TEST_CASE("Numbering: a strip gets the bandwidth of its width however it was numbered, and the same hash") {
    const TriMesh strip = samples::square(100, 5, 0.2);
    const Mesh mixed = shuffled(strip, 7);
    CHECK(bandwidth(mixed) > 400);
    CHECK(meshHash(mixed) == meshHash(strip));
    const std::vector<NodeId> numbers = reverseCuthillMcKee(mixed);
    CHECK(isPermutation(numbers));
    const Mesh narrow = renumbered(mixed, numbers);
    CHECK(bandwidth(narrow) <= 12); // two columns of 6 nodes; 7 with the best numbers
    CHECK(meshHash(narrow) == meshHash(strip));
    const auto leastOf = [&](std::size_t element) {
        return index(
            *std::ranges::min_element(MeshView(narrow).nodesOf(element), {}, [](NodeId n) { return index(n); }));
    };
    for (std::size_t e = 1; e < narrow.elementCount(); ++e) {
        CHECK(leastOf(e - 1) <= leastOf(e));
    }
}

TEST_CASE("Numbering: parts, nodes without elements, tags and all kinds of cells keep what they are") {
    samples::BlockMaker maker({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 0}, {6, 0}, {5, 1}, {9, 9}, {2, 0}, {2, 1}});
    const auto node = samples::node;
    maker.add(CellKind::Quadrilateral8, {node(0), node(1), node(2), node(3)}, 3);
    maker.add(CellKind::Quadrilateral9, {node(1), node(8), node(9), node(2)}, 4);
    maker.add(CellKind::Triangle3, {node(4), node(5), node(6)}, 5);
    maker.tag(node(0), node(1), 7);
    maker.tag(node(4), node(5), 8);
    maker.mesh.points.push_back({node(7), 9});
    maker.mesh.regionNames[3] = "left";
    const std::vector<NodeId> numbers = reverseCuthillMcKee(maker.mesh);
    CHECK(isPermutation(numbers));
    CHECK(index(numbers[7]) + 1 == maker.mesh.nodes.size());
    const Mesh other = renumbered(maker.mesh, numbers);
    CHECK(meshHash(other) == meshHash(maker.mesh));
    CHECK(other.regionNames == maker.mesh.regionNames);
    CHECK(other.points.front().node == numbers[7]);
    CHECK(other.edges.front().middle == numbers[index(maker.mesh.edges.front().middle)]);
    CHECK(other.edges.back().middle == kNoNode);
    CHECK(bandwidth(other) < bandwidth(maker.mesh));
}

TEST_CASE("Numbering: an empty mesh and one without elements") {
    Mesh mesh;
    CHECK(reverseCuthillMcKee(mesh).empty());
    CHECK(bandwidth(mesh) == 0);
    mesh.nodes = {{0, 0}, {1, 1}};
    CHECK(isPermutation(reverseCuthillMcKee(mesh)));
    CHECK(renumbered(mesh, reverseCuthillMcKee(mesh)).nodes == mesh.nodes);
}

} // namespace forefront
