#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/topology.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace forefront;
using samples::node;

TEST_CASE("Mesh: bounds enclose all nodes and are empty without nodes") {
    CHECK(TriMesh{}.bounds().empty());
    const TriMesh mesh = samples::square(3, 2, 0.2, {10.0, -5.0});
    CHECK(mesh.bounds() == Box2{{10.0, -5.0}, {11.0, -4.0}});
}

TEST_CASE("meshHash: any change of coordinates, elements, regions, edges, points or tags changes it") {
    TriMesh mesh = samples::square(4, 4, 0.2);
    mesh.regions.assign(mesh.elements.size(), 1);
    mesh.points = {{node(7), 1}};
    const std::uint64_t before = meshHash(mesh);
    CHECK(meshHash(TriMesh(mesh)) == before);

    const auto differs = [&](auto &&change) {
        TriMesh other = mesh;
        change(other);
        return meshHash(other) != before;
    };
    CHECK(differs([](TriMesh &m) { m.nodes[3].x = std::nextafter(m.nodes[3].x, 9.0); }));
    CHECK(differs([](TriMesh &m) { m.nodes.push_back({}); }));
    CHECK(differs([](TriMesh &m) {
        m.elements.push_back(m.elements[0]);
        m.regions.push_back(m.regions[0]);
    }));
    CHECK(differs([](TriMesh &m) { std::swap(m.elements[0][0], m.elements[0][1]); }));
    CHECK(differs([](TriMesh &m) { m.regions[5] = 2; }));
    CHECK(differs([](TriMesh &m) { m.edges[2].tag = 9; }));
    CHECK(differs([](TriMesh &m) { m.edges.pop_back(); }));
    CHECK(differs([](TriMesh &m) { m.points[0].tag = 3; }));
    CHECK(differs([](TriMesh &m) { m.points[0].node = node(8); }));
}

TEST_CASE("meshHash: it does not depend on the numbers of nodes and elements, nor on the first node of an element") {
    TriMesh mesh = samples::square(4, 4, 0.2);
    mesh.regions.assign(mesh.elements.size(), 1);
    mesh.regions[3] = 2;
    mesh.points = {{node(7), 1}};
    TriMesh other = mesh;
    const std::size_t last = mesh.nodes.size() - 1;
    const auto reversed = [&](NodeId id) { return static_cast<NodeId>(last - index(id)); };
    std::reverse(other.nodes.begin(), other.nodes.end());
    for (Element &element : other.elements) {
        element = {reversed(element[1]), reversed(element[2]), reversed(element[0])};
    }
    for (TaggedEdge &edge : other.edges) {
        edge = {reversed(edge.a), reversed(edge.b), edge.tag};
    }
    other.points[0].node = reversed(node(7));
    std::reverse(other.elements.begin(), other.elements.end());
    std::reverse(other.regions.begin(), other.regions.end());
    std::reverse(other.edges.begin(), other.edges.end());
    CHECK(meshHash(other) == meshHash(mesh));
    std::swap(other.regions.front(), other.regions[other.regions.size() - 4]);
    CHECK(meshHash(other) != meshHash(mesh));
}

TEST_CASE("meshHash: absent regions are the same as region 1 everywhere") {
    TriMesh mesh = samples::square(2, 2);
    const std::uint64_t before = meshHash(mesh);
    mesh.regions.assign(mesh.elements.size(), 1);
    CHECK(meshHash(mesh) == before);
}

namespace {

/// Finds the sides across by comparing all pairs of sides.
std::vector<HalfEdge> oppositeByPairs(const MeshView &mesh) {
    const HalfEdges sides(mesh);
    std::vector<HalfEdge> result(sides.count(), kNoHalfEdge);
    for (HalfEdge h = 0; h < sides.count(); ++h) {
        for (HalfEdge g = 0; g < sides.count(); ++g) {
            if (sides.startOf(h) == sides.endOf(g) && sides.endOf(h) == sides.startOf(g)) {
                result[h] = g;
            }
        }
    }
    return result;
}

/// Returns n triangles about node 0 in random order.
TriMesh fan(std::size_t n) {
    TriMesh mesh;
    mesh.nodes.push_back({});
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
        mesh.nodes.push_back({std::cos(angle), std::sin(angle)});
        mesh.elements.push_back({node(0), node(1 + i), node(1 + (i + 1) % n)});
    }
    samples::Random random(3);
    for (std::size_t i = n; i > 1; --i) {
        std::swap(mesh.elements[i - 1], mesh.elements[random.below(i)]);
    }
    return mesh;
}

} // namespace

TEST_CASE("oppositeHalfEdges: agrees with a comparison of all pairs of sides") {
    const TriMesh mesh = samples::square(9, 7, 0.2);
    CHECK(oppositeHalfEdges(EdgeTable(mesh)) == oppositeByPairs(mesh));
    const Mesh blocks = samples::allKindsSample();
    CHECK(oppositeHalfEdges(EdgeTable(blocks)) == oppositeByPairs(blocks));
}

TEST_CASE("oppositeHalfEdges: joins the elements of a node of very high valence in any order") {
    const TriMesh mesh = fan(500);
    CHECK(oppositeHalfEdges(EdgeTable(mesh)) == oppositeByPairs(mesh));
    const TriMesh large = fan(200'000);
    const std::vector<HalfEdge> opposite = oppositeHalfEdges(EdgeTable(large));
    CHECK(std::count(opposite.begin(), opposite.end(), kNoHalfEdge) == 200'000);
}

TEST_CASE("oppositeHalfEdges: joins the first two elements of an edge with three") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {0, 1}, {0, -1}, {1, 1}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(1), node(0), node(3)}, {node(0), node(1), node(4)}};
    const std::vector<HalfEdge> opposite = oppositeHalfEdges(EdgeTable(mesh));
    CHECK(opposite[0] == 3);
    CHECK(opposite[3] == 0);
    CHECK(opposite[6] == kNoHalfEdge);
}

TEST_CASE("HalfEdges: sides of all kinds of cells are numbered in turn and know their nodes") {
    const Mesh mesh = samples::allKindsSample();
    const MeshView view(mesh);
    const HalfEdges sides(view);
    HalfEdge h = 0;
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        const CellTraits &traits = traitsOf(view.kindOf(e));
        const auto nodes = view.nodesOf(e);
        CHECK(sides.sidesOf(e) == traits.corners);
        for (unsigned k = 0; k < traits.corners; ++k, ++h) {
            const unsigned next = (k + 1U) % traits.corners;
            CHECK(sides.of(e, k) == h);
            CHECK(sides.elementOf(h) == e);
            CHECK(sides.sideOf(h) == k);
            CHECK(sides.next(h) == sides.of(e, next));
            CHECK(sides.startOf(h) == nodes[k]);
            CHECK(sides.endOf(h) == nodes[next]);
            CHECK(sides.middleOf(h) == (traits.order == 2 ? nodes[traits.corners + k] : kNoNode));
        }
    }
    CHECK(h == sides.count());
    CHECK(HalfEdges(Mesh()).count() == 0);
}

TEST_CASE("EdgeTable: visits each edge once, in order, with the half-edges that run along it") {
    const TriMesh mesh = samples::square(6, 5, 0.2);
    std::map<std::pair<NodeId, NodeId>, std::size_t> expected;
    for (const Element &e : mesh.elements) {
        for (unsigned k = 0; k < 3; ++k) {
            ++expected[std::minmax(e[k], e[(k + 1) % 3])];
        }
    }
    auto next = expected.begin();
    const EdgeTable table(mesh);
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        REQUIRE(next != expected.end());
        CHECK(next->first == std::pair(a, b));
        CHECK(next->second == sides.size());
        CHECK(table.find(b, a).data() == sides.data());
        ++next;
    });
    CHECK(next == expected.end());
    CHECK(table.find(node(0), node(41)).empty());
    CHECK(table.find(node(0), node(4000)).empty());
}

TEST_CASE("nodeElements: lists for each node exactly the elements that contain it") {
    const TriMesh mesh = samples::square(5, 5, 0.2);
    const NodeElements rows = nodeElements(mesh);
    REQUIRE(rows.offsets.size() == mesh.nodes.size() + 1);
    CHECK(rows.offsets.back() == 3 * mesh.elements.size());
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        std::vector<ElementId> expected;
        for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
            if (std::count(mesh.elements[e].begin(), mesh.elements[e].end(), node(n)) > 0) {
                expected.push_back(ElementId{static_cast<std::uint32_t>(e)});
            }
        }
        const std::vector<ElementId> got(rows.elements.begin() + rows.offsets[n],
                                         rows.elements.begin() + rows.offsets[n + 1]);
        CHECK(got == expected);
    }
}

TEST_CASE(
    "shapeFactor: 1 if equilateral, √3/2 if right isosceles, 0 if flat, negative if clockwise, independent of size") {
    const double h = std::sqrt(3.0) / 2.0;
    CHECK(shapeFactor({0, 0}, {1, 0}, {0.5, h}) == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(shapeFactor({0, 0}, {1, 0}, {0, 1}) == doctest::Approx(h).epsilon(1e-14));
    CHECK(shapeFactor({0, 0}, {0, 1e-9}, {1e-9, 0}) == doctest::Approx(-h).epsilon(1e-14));
    CHECK(shapeFactor({0, 0}, {1, 1}, {2, 2}) == 0.0);
    CHECK(shapeFactor({3, 3}, {3, 3}, {3, 3}) == 0.0);
}

TEST_CASE("spacingConformity: 1 at the target length, symmetric for too long and too short") {
    CHECK(spacingConformity(0.5, 0.5) == 1.0);
    CHECK(spacingConformity(1.0, 4.0) == 0.25);
    CHECK(spacingConformity(4.0, 1.0) == 0.25);
}

namespace {

class ConstantSpacing : public SpacingField {
  public:
    explicit ConstantSpacing(double rho) : rho_(rho) {}
    double at(Vec2) const override { return rho_; }
    void atMany(std::span<const Vec2>, std::span<double> rho) const override {
        std::fill(rho.begin(), rho.end(), rho_);
    }
    SpacingSample sample(Vec2) const override { return {rho_, SpacingOrigin::Constant, 0, "constant"}; }
    double minimum() const override { return rho_; }
    double maximum() const override { return rho_; }

  private:
    double rho_;
};

} // namespace

TEST_CASE("measure: a grid of right triangles has known figures") {
    const TriMesh mesh = samples::square(20, 20, 0.0, {1e5, -1e5});
    const MeshQuality q = measureQuality(mesh, nullptr);
    CHECK(q.nodes == 441);
    CHECK(q.elements == 800);
    CHECK(q.edges == 441 + 800 - 1);
    CHECK(q.area == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(q.alphaMean == doctest::Approx(std::sqrt(3.0) / 2.0).epsilon(1e-6));
    CHECK(q.alphaGeometricMean == doctest::Approx(std::sqrt(3.0) / 2.0).epsilon(1e-6));
    CHECK(q.minAngle == doctest::Approx(45.0).epsilon(1e-6));
    CHECK(q.maxAngle == doctest::Approx(90.0).epsilon(1e-6));
    CHECK(q.deltaMean == 0.0);
    CHECK(q.alphaHistogram[34] == 800);
    std::uint64_t inner = 0;
    for (const std::uint64_t n : q.valence) {
        inner += n;
    }
    CHECK(inner == 19 * 19);
}

TEST_CASE("measure: conformity is the mean over all segments") {
    const TriMesh mesh = samples::square(8, 8);
    const ConstantSpacing spacing(0.125);
    // 2·8·9 segments of length 1/8, 64 diagonals that are √2 too long.
    const double expected = (144.0 + 64.0 / std::sqrt(2.0)) / 208.0;
    CHECK(measureQuality(mesh, &spacing).deltaMean == doctest::Approx(expected).epsilon(1e-12));
}

TEST_CASE("measure: means, minimum and percentiles agree with their definitions") {
    const TriMesh mesh = samples::square(30, 30, 0.24);
    const MeshQuality q = measureQuality(mesh, nullptr);
    std::vector<float> alpha = shapeFactors(mesh);
    CHECK(alpha[index(q.worst)] == doctest::Approx(q.alphaMin).epsilon(1e-6));
    double sum = 0.0, logs = 0.0;
    for (const float a : alpha) {
        sum += static_cast<double>(a);
        logs += std::log(static_cast<double>(a));
    }
    const auto count = static_cast<double>(alpha.size());
    CHECK(q.alphaMean == doctest::Approx(sum / count).epsilon(1e-6));
    CHECK(q.alphaGeometricMean == doctest::Approx(std::exp(logs / count)).epsilon(1e-6));
    CHECK(q.alphaGeometricMean < q.alphaMean);
    std::sort(alpha.begin(), alpha.end());
    CHECK(q.alpha1 == static_cast<double>(alpha[static_cast<std::size_t>(0.01 * (count - 1))]));
    CHECK(q.alpha5 == static_cast<double>(alpha[static_cast<std::size_t>(0.05 * (count - 1))]));
    CHECK(q.alpha50 == static_cast<double>(alpha[static_cast<std::size_t>(0.50 * (count - 1))]));
}

TEST_CASE("measure: a flat element makes minimum angle and geometric mean 0; an empty mesh has no figures") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {2, 0}, {1, 1}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(2), node(3)}};
    const MeshQuality q = measureQuality(mesh, nullptr);
    CHECK(q.minAngle == 0.0);
    CHECK(q.maxAngle == 180.0);
    CHECK(q.alphaMin == 0.0);
    CHECK(q.alphaGeometricMean == 0.0);
    CHECK(measureQuality(TriMesh{}, nullptr).elements == 0);
}
