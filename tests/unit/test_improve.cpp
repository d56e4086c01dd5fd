#include "core/improve/improve.hpp"
#include "core/improve/repair.hpp"
#include "core/improve/smooth.hpp"
#include "core/improve/swap.hpp"
#include "core/mesh/edge_table.hpp"
#include "core/mesh/quality.hpp"
#include "core/mesh/topology.hpp"
#include "core/mesh/verify.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace forefront;
using samples::node;

namespace {

/// Square whose right half is another region, with a tagged inner line and a tagged inner point.
Mesh constrainedSquare(std::size_t n, double jitter, Vec2 offset, std::uint64_t seed) {
    Mesh mesh = samples::square(n, n, jitter, offset, seed);
    for (const Element &e : mesh.elements) {
        const std::size_t column = std::min({index(e[0]) % (n + 1), index(e[1]) % (n + 1), index(e[2]) % (n + 1)});
        mesh.regions.push_back(column < n / 2 ? 1 : 2);
    }
    for (std::size_t i = 0; i < n / 3; ++i) {
        const std::size_t row = n / 3;
        mesh.edges.push_back({node(row * (n + 1) + i), node(row * (n + 1) + i + 1), 8});
    }
    mesh.points = {{node((n - 2) * (n + 1) + n - 2), 3}};
    return mesh;
}

std::map<std::int32_t, double> areasByRegion(const Mesh &mesh) {
    std::map<std::int32_t, double> areas;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element &n = mesh.elements[e];
        const Vec2 a = mesh.nodes[index(n[0])];
        areas[mesh.region(e)] += 0.5 * cross(mesh.nodes[index(n[1])] - a, mesh.nodes[index(n[2])] - a);
    }
    return areas;
}

} // namespace

TEST_CASE("improve: keeps a mesh valid, its tags, held nodes, regions and least α, whatever it starts from") {
    std::uint64_t seed = 0;
    for (const double jitter : {0.0, 0.1, 0.24}) {
        for (const Vec2 offset : {Vec2{}, Vec2{1e5, -1e5}}) {
            for (const std::size_t n : {3U, 5U, 12U, 40U}) {
                const Mesh before = constrainedSquare(n, jitter, offset, ++seed);
                Mesh mesh = before;
                const ImproveReport report = improve(mesh);
                const Diagnostics faults = verify(mesh);
                REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
                const double least = measure(mesh, nullptr).alphaMin;
                CHECK(report.alphaMinBefore == measure(before, nullptr).alphaMin);
                CHECK(report.alphaMinAfter == least);
                CHECK(least >= report.alphaMinBefore);
                CHECK(mesh.nodes.size() == before.nodes.size());
                CHECK(mesh.elements.size() == before.elements.size());
                for (const TaggedEdge &edge : before.edges) {
                    CHECK(mesh.nodes[index(edge.a)] == before.nodes[index(edge.a)]);
                    CHECK(mesh.nodes[index(edge.b)] == before.nodes[index(edge.b)]);
                }
                CHECK(mesh.nodes[index(before.points[0].node)] == before.nodes[index(before.points[0].node)]);
                const auto was = areasByRegion(before), is = areasByRegion(mesh);
                for (const auto &[region, area] : was) {
                    CHECK(is.at(region) == doctest::Approx(area).epsilon(1e-9));
                }
                CHECK(EdgeTable(mesh).find(before.edges.back().a, before.edges.back().b).size() == 2);
            }
        }
    }
}

TEST_CASE("improve: a distorted lattice with diagonals by chance becomes a good mesh") {
    Mesh mesh = samples::square(60, 60, 0.24);
    CHECK(measure(mesh, nullptr).alphaGeometricMean < 0.82);
    improve(mesh);
    const MeshQuality q = measure(mesh, nullptr);
    CHECK(q.alphaGeometricMean > 0.965);
    CHECK(q.alphaMin > 0.7);
}

TEST_CASE("improve: improving again does not lower the least α") {
    Mesh mesh = samples::square(30, 30, 0.24, {}, 5);
    improve(mesh);
    for (int i = 0; i < 4; ++i) {
        const double least = measure(mesh, nullptr).alphaMin;
        const ImproveReport report = improve(mesh);
        CHECK(report.alphaMinAfter >= least);
    }
}

TEST_CASE("improve: the same mesh gives the same result bit for bit") {
    Mesh a = constrainedSquare(25, 0.24, {3.0, 4.0}, 77);
    Mesh b = a;
    improve(a);
    improve(b);
    CHECK(meshHash(a) == meshHash(b));
}

TEST_CASE("improve: nearly flat elements along a line are mended without any sign going wrong") {
    // Inner nodes lie 1e-13 above the bottom edge: elements with α near 0 whose sign only exact arithmetic tells.
    Mesh mesh = samples::square(10, 10);
    for (std::size_t i = 1; i < 10; ++i) {
        mesh.nodes[11 + i].y = 1e-13;
    }
    REQUIRE(verify(mesh).empty());
    improve(mesh);
    const Diagnostics faults = verify(mesh);
    CHECK_MESSAGE(faults.empty(), samples::list(faults));
    CHECK(measure(mesh, nullptr).alphaMin > 0.5);
}

TEST_CASE("improve: a cancelled improvement leaves a valid mesh") {
    for (int stopAt = 0; stopAt < 8; ++stopAt) {
        Mesh mesh = constrainedSquare(20, 0.24, {}, 9);
        std::stop_source stop;
        Progress progress;
        progress.stop = stop.get_token();
        int calls = 0;
        progress.report = [&](std::string_view, double) {
            if (++calls > stopAt) {
                stop.request_stop();
            }
        };
        if (stopAt == 0) {
            stop.request_stop();
        }
        const ImproveReport report = improve(mesh, {}, progress);
        CHECK(verify(mesh).empty());
        CHECK(report.alphaMinAfter >= report.alphaMinBefore);
    }
}

TEST_CASE("improve: an empty mesh and a single element are left as they are") {
    Mesh empty;
    improve(empty);
    CHECK(empty.elements.empty());
    Mesh one;
    one.nodes = {{0, 0}, {1, 0}, {0, 1}};
    one.elements = {{node(0), node(1), node(2)}};
    const std::uint64_t before = meshHash(one);
    improve(one);
    CHECK(meshHash(one) == before);
}

TEST_CASE("improve: a node with more elements than can be counted stays in place and the mesh valid") {
    Mesh mesh;
    mesh.nodes.push_back({0.3, 0.2});
    constexpr std::size_t kSpokes = 400;
    for (std::size_t i = 0; i < kSpokes; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(kSpokes);
        mesh.nodes.push_back({std::cos(angle), std::sin(angle)});
        mesh.elements.push_back({node(0), node(1 + i), node(1 + (i + 1) % kSpokes)});
    }
    improve(mesh);
    CHECK_MESSAGE(verify(mesh).empty(), samples::list(verify(mesh)));
}

TEST_CASE("turnEdge: neighbours and locks stay those of the mesh") {
    Mesh mesh = samples::square(12, 12, 0.2);
    mesh.edges.push_back({mesh.elements[100][0], mesh.elements[100][1], 5});
    ImproveWorkspace work(mesh);
    const std::size_t swaps = swapEdges(work, false, {});
    CHECK(swaps > 20);
    const auto expected = elementNeighbours(mesh);
    CHECK(work.neighbours == expected);
    const ImproveWorkspace fresh(mesh);
    CHECK(work.locked == fresh.locked);
    CHECK(work.valence == fresh.valence);
    CHECK(work.fixed == fresh.fixed);
}

TEST_CASE("swapEdges: of the two diagonals of a kite the short one is taken, unless it is tagged") {
    Mesh mesh;
    mesh.nodes = {{-2, 0}, {0, -0.5}, {2, 0}, {0, 0.5}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(2), node(3)}};
    Mesh tagged = mesh;
    ImproveWorkspace work(mesh);
    CHECK(swapEdges(work, false, {}) == 1);
    CHECK(EdgeTable(mesh).find(node(1), node(3)).size() == 2);
    tagged.edges = {{node(0), node(2), 1}};
    ImproveWorkspace held(tagged);
    CHECK(swapEdges(held, false, {}) == 0);
}

TEST_CASE("NodeSmoother: no element falls below the floor unless it was below and does not lose") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Mesh mesh = samples::square(15, 15, 0.24, {}, seed);
        ImproveWorkspace work(mesh);
        NodeSmoother smoother(work);
        for (const double floor : {0.0, 0.5, 0.9}) {
            const std::vector<float> before = shapeFactors(mesh);
            smoother.sweep(floor);
            const std::vector<float> after = shapeFactors(mesh);
            for (std::size_t e = 0; e < after.size(); ++e) {
                CHECK(after[e] >= std::min(before[e], static_cast<float>(floor)) - 1e-6F);
            }
        }
    }
}

TEST_CASE("repairWorst: raises the least α where smoothing has left it") {
    Mesh mesh = samples::square(30, 30, 0.24, {}, 11);
    ImproveWorkspace work(mesh);
    const double before = measure(mesh, nullptr).alphaMin;
    const RepairCounts counts = repairWorst(work, 0.8, {});
    CHECK(counts.moves > 0);
    CHECK(counts.swaps > 0);
    CHECK(measure(mesh, nullptr).alphaMin > before + 0.2);
    CHECK(verify(mesh).empty());
}
