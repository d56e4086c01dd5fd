#include "core/engine/mesh/triangulated.hpp"
#include "tests/unit/block_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace forefront;

namespace {

using NodePair = std::pair<NodeId, NodeId>;

double polygonArea(std::span<const Vec2> places, const std::vector<NodeId> &loop) {
    double twice = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        twice += cross(places[index(loop[k])], places[index(loop[(k + 1) % loop.size()])]);
    }
    return 0.5 * twice;
}

/// Returns the nodes around an element, those in the middles of its edges between its corners.
std::vector<NodeId> loopAround(const MeshView &mesh, std::size_t element) {
    const CellTraits &traits = traitsOf(mesh.kindOf(element));
    const std::span<const NodeId> nodes = mesh.nodesOf(element);
    std::vector<NodeId> loop;
    for (std::size_t k = 0; k < traits.corners; ++k) {
        loop.push_back(nodes[k]);
        if (traits.order == 2) {
            loop.push_back(nodes[traits.corners + k]);
        }
    }
    return loop;
}

/// Checks that the triangles of each element fill it, that their real edges are those around it, and that each other
/// edge lies between two of them.
void checkParts(const MeshView &mesh, const Triangulated &parts) {
    const TriMesh &split = parts.mesh;
    REQUIRE(split.regions.size() == split.elements.size());
    REQUIRE(std::equal(mesh.nodes.begin(), mesh.nodes.end(), split.nodes.begin(), split.nodes.end()));
    std::vector<double> areas(mesh.elementCount(), 0.0);
    std::vector<std::set<NodePair>> real(mesh.elementCount());
    std::vector<std::map<NodePair, int>> inner(mesh.elementCount());
    for (std::size_t t = 0; t < split.elements.size(); ++t) {
        const Element &nodes = split.elements[t];
        const std::size_t e = parts.element(t);
        REQUIRE(e < mesh.elementCount());
        CHECK(split.regions[t] == mesh.region(e));
        const double area = polygonArea(split.nodes, {nodes[0], nodes[1], nodes[2]});
        CHECK(area > 0.0);
        areas[e] += area;
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeId a = nodes[k], b = nodes[(k + 1) % 3];
            if (parts.isReal(t, k)) {
                CHECK(real[e].emplace(a, b).second);
            } else {
                inner[e][std::minmax(a, b)] += a < b ? 1 : 100;
            }
        }
    }
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::vector<NodeId> loop = loopAround(mesh, e);
        CHECK(areas[e] == doctest::Approx(polygonArea(mesh.nodes, loop)));
        std::set<NodePair> around;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            around.emplace(loop[k], loop[(k + 1) % loop.size()]);
        }
        CHECK(real[e] == around);
        for (const auto &[edge, count] : inner[e]) {
            CHECK(count == 101); // once in each direction
        }
    }
}

/// A quadrilateral of 4 nodes.
Mesh quadrilateral(const std::vector<Vec2> &corners) {
    samples::BlockMaker maker(corners);
    maker.add(CellKind::Quadrilateral4, {samples::node(0), samples::node(1), samples::node(2), samples::node(3)});
    return std::move(maker.mesh);
}

} // namespace

TEST_CASE("triangulated: the triangles of each element fill it, and real edges are those around it") {
    std::vector<Mesh> meshes = {samples::mixedSample(), samples::secondOrderSample(), samples::allKindsSample()};
    for (const CellKind kind : kElementKinds) {
        meshes.push_back(samples::sampleMesh(kind));
        meshes.push_back(samples::bent(samples::sampleMesh(kind), 0.1));
    }
    for (const Mesh &mesh : meshes) {
        const Triangulated parts = triangulated(mesh);
        checkParts(mesh, parts);
        const Triangulated taken = takeTriangulated(mesh);
        CHECK(taken.mesh.elements == parts.mesh.elements);
        CHECK(taken.mesh.regions == parts.mesh.regions);
        CHECK(taken.mesh.nodes == parts.mesh.nodes);
        CHECK(taken.mesh.edges.size() == parts.mesh.edges.size());
        CHECK(taken.elementOf == parts.elementOf);
        CHECK(taken.realEdges == parts.realEdges);
        CHECK(parts.mesh.boundaryNames == mesh.boundaryNames);
        CHECK(parts.mesh.regionNames == mesh.regionNames);
        CHECK(parts.mesh.points.size() == mesh.points.size());
    }
}

TEST_CASE("triangulated: a mesh of triangles stays as it is") {
    const TriMesh mesh = samples::square(4, 3);
    const Triangulated parts = triangulated(mesh);
    CHECK(parts.mesh.elements == mesh.elements);
    CHECK(parts.elementOf.empty());
    CHECK(parts.realEdges.empty());
    CHECK(parts.element(5) == 5);
    CHECK(parts.isReal(5, 2));
    Mesh blocks = mesh;
    const NodeId *const nodes = blocks.blocks.front().connectivity().data();
    const Triangulated taken = takeTriangulated(std::move(blocks));
    CHECK(taken.mesh.elements.front().data() == nodes); // nothing was copied
    CHECK(triangulated(Mesh()).mesh.elements.empty());
}

TEST_CASE("triangulated: a quadrilateral is split along the diagonal inside it, or the better one") {
    const auto firstOf = [](const std::vector<Vec2> &corners) {
        const Mesh mesh = quadrilateral(corners);
        const Triangulated parts = triangulated(mesh);
        checkParts(mesh, parts);
        const Element &first = parts.mesh.elements.front();
        return first[2] == samples::node(2) ? 2 : 3; // 2: along 0 and 2; 3: along 1 and 3
    };
    CHECK(firstOf({{0, 0}, {2, 0}, {2, 2}, {0, 2}}) == 2); // both are as good
    CHECK(firstOf({{0, 0}, {2, 0}, {3, 2}, {1, 2}}) == 3);
    CHECK(firstOf({{0, 0}, {2, 0}, {1, 2}, {-1, 2}}) == 2);
    CHECK(firstOf({{0, 0}, {4, 0}, {1, 1}, {0, 4}}) == 2); // the corner 2 is reflex
    CHECK(firstOf({{0, 0}, {4, 0}, {4, 4}, {3, 1}}) == 3); // the corner 3 is reflex
}

TEST_CASE("triangulated: a tagged edge of 3 nodes becomes two, and values of elements follow") {
    samples::BlockMaker maker({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {6, 2}});
    const auto at = samples::node;
    maker.add(CellKind::Quadrilateral8, {at(0), at(1), at(2), at(3)}, 3);
    maker.add(CellKind::Triangle6, {at(1), at(4), at(2)}, 5);
    maker.tag(at(0), at(1), 7);
    maker.tag(at(4), at(2), 9);
    const Triangulated parts = triangulated(maker.mesh);
    REQUIRE(parts.mesh.edges.size() == 4);
    const std::vector<TaggedEdge> &edges = parts.mesh.edges;
    CHECK(edges[0].a == at(0));
    CHECK(edges[0].b == edges[1].a);
    CHECK(edges[1].b == at(1));
    CHECK(edges[1].tag == 7);
    CHECK(edges[2].tag == 9);
    CHECK(edges[3].b == at(2));
    for (const TaggedEdge &edge : edges) {
        CHECK(edge.middle == kNoNode);
    }
    const std::vector<double> values = parts.ofTriangles(std::vector<double>{1.5, -2.0});
    CHECK(std::count(values.begin(), values.end(), 1.5) == 6);
    CHECK(std::count(values.begin(), values.end(), -2.0) == 4);
}
