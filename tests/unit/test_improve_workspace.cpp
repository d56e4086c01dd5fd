#include "core/engine/geometry/predicates.hpp"
#include "core/engine/improve/edge_swap.hpp"
#include "core/engine/improve/improve_workspace.hpp"
#include "core/engine/improve/swap_pass.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/topology.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <random>

using namespace forefront;
using samples::node;

namespace {

std::vector<NodeId> ringOf(const ImproveWorkspace &work, std::size_t n) {
    std::vector<NodeId> ring;
    work.ringOfFree(n, [&](NodeId m) { ring.push_back(m); });
    return ring;
}

/// Returns the same mesh with its nodes numbered at random, so that neighbours lie anywhere in memory.
TriMesh shuffled(TriMesh mesh, std::uint64_t seed) {
    std::vector<std::uint32_t> place(mesh.nodes.size());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), std::mt19937_64(seed));
    const std::vector<Vec2> nodes = mesh.nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        mesh.nodes[place[n]] = nodes[n];
    }
    for (Element &e : mesh.elements) {
        for (NodeId &n : e) {
            n = NodeId{place[index(n)]};
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.a = NodeId{place[index(edge.a)]};
        edge.b = NodeId{place[index(edge.b)]};
    }
    return mesh;
}

} // namespace

TEST_CASE("ImproveWorkspace: neighbours are those of the mesh except across fixed edges") {
    TriMesh mesh = samples::constrainedSquare(12, 0.2, {}, 3);
    ThreadPool pool(1);
    const ImproveWorkspace work(mesh, pool);
    const std::vector<HalfEdge> expected = oppositeHalfEdges(EdgeTable(mesh));
    std::size_t held = 0;
    for (HalfEdge h = 0; h < work.twin.size(); ++h) {
        const HalfEdge across = expected[h];
        if (work.twin[h] != kNoHalfEdge) {
            CHECK(across == work.twin[h]);
            CHECK(work.from(work.twin[h]) == work.to(h));
            CHECK(work.to(work.twin[h]) == work.from(h));
            CHECK(mesh.region(elementOf(h)) == mesh.region(elementOf(across)));
        } else if (across != kNoHalfEdge) {
            ++held;
            CHECK((!work.isFree(work.from(h)) && !work.isFree(work.to(h))));
        }
    }
    CHECK(held == 2 * (12 / 3 + 12)); // the inner line and the interface, from both sides
}

TEST_CASE(
    "ImproveWorkspace: rings go once around each free node, counter-clockwise, in the same order for any threads") {
    TriMesh mesh = samples::square(150, 150, 0.2);
    ThreadPool one(1), three(3);
    const ImproveWorkspace work(mesh, one), again(mesh, three);
    CHECK(work.twin == again.twin);
    CHECK(work.valence == again.valence);
    const NodeElements around = nodeElements(mesh);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (!work.isFree(n)) {
            continue;
        }
        CHECK(work.rings[n] == again.rings[n]);
        REQUIRE(work.valence[n] == around.offsets[n + 1] - around.offsets[n]);
        const std::vector<NodeId> ring = ringOf(work, n);
        REQUIRE(ring.size() == work.valence[n]);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const NodeId a = ring[k], b = ring[(k + 1) % ring.size()];
            CHECK(orientation(mesh.nodes[n], work.at(a), work.at(b)) > 0);
        }
    }
}

TEST_CASE("swapEdge: keeps neighbours, valences and rings up to date") {
    TriMesh mesh = samples::square(12, 12, 0.2);
    mesh.edges.push_back({mesh.elements[100][0], mesh.elements[100][1], 5});
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    work.measureAlpha();
    const std::size_t swaps = swapEdges(work, {}, {});
    CHECK(swaps > 20);
    const ImproveWorkspace fresh(mesh, pool);
    CHECK(work.twin == fresh.twin);
    CHECK(work.fixed == fresh.fixed);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (work.isFree(n)) {
            CHECK(work.valence[n] == fresh.valence[n]);
            const std::vector<NodeId> ring = ringOf(work, n), expected = ringOf(fresh, n);
            REQUIRE(ring.size() == expected.size());
            CHECK(std::is_permutation(ring.begin(), ring.end(), expected.begin()));
        }
    }
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        CHECK(work.alpha[e] == static_cast<float>(work.alphaOf(e)));
    }
}

TEST_CASE("ImproveWorkspace: rings are the same where neighbours lie too far apart in memory to be stored") {
    const TriMesh near = samples::square(300, 300, 0.2), far = shuffled(near, 1);
    TriMesh meshes[2] = {near, far};
    ThreadPool pool(1);
    const ImproveWorkspace a(meshes[0], pool), b(meshes[1], pool);
    std::size_t walked = 0;
    for (std::size_t e = 0; e < near.elements.size(); ++e) {
        for (unsigned k = 0; k < 3; ++k) {
            const std::size_t n = index(near.elements[e][k]), m = index(far.elements[e][k]);
            if (!a.isFree(n)) {
                continue;
            }
            walked += b.rings[m][0] == 0 ? 1 : 0;
            const std::vector<NodeId> ring = ringOf(a, n), same = ringOf(b, m);
            REQUIRE(ring.size() == same.size());
            for (std::size_t i = 0; i < ring.size(); ++i) {
                CHECK(a.at(ring[i]) == b.at(same[i]));
            }
        }
    }
    CHECK(walked > 0);
}

TEST_CASE("swapEdges: several threads swap the same edges in the same order as one") {
    // In seeds 13 and 30 swaps near the edges of blocks of elements depend on each other in chains.
    for (const std::uint64_t seed : {1U, 2U, 13U, 30U}) {
        TriMesh raw = samples::square(150, 150, 0.24, {}, seed);
        if (seed % 2 == 0) {
            std::shuffle(raw.elements.begin(), raw.elements.end(), std::mt19937_64(seed));
        }
        TriMesh meshes[2] = {raw, raw};
        ThreadPool one(1), three(3);
        ImproveWorkspace a(meshes[0], one), b(meshes[1], three);
        a.measureAlpha();
        b.measureAlpha();
        for (const double floor : {0.2, 0.5}) {
            const SwapRule rule{true, floor};
            CHECK(swapEdges(a, rule, {}) == swapEdges(b, rule, {}));
            CHECK(meshes[0].elements == meshes[1].elements);
            CHECK(a.twin == b.twin);
            CHECK(a.valence == b.valence);
            CHECK(a.alpha == b.alpha);
            for (std::size_t n = 0; n < raw.nodes.size(); ++n) {
                CHECK((!a.isFree(n) || a.rings[n] == b.rings[n]));
            }
        }
    }
}

TEST_CASE("swapEdges: takes the short diagonal of a kite unless the long one is tagged") {
    TriMesh mesh;
    mesh.nodes = {{-2, 0}, {0, -0.5}, {2, 0}, {0, 0.5}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(2), node(3)}};
    TriMesh tagged = mesh;
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    work.measureAlpha();
    CHECK(swapEdges(work, {}, {}) == 1);
    CHECK(EdgeTable(mesh).find(node(1), node(3)).size() == 2);
    tagged.edges = {{node(0), node(2), 1}};
    ImproveWorkspace held(tagged, pool);
    held.measureAlpha();
    CHECK(swapEdges(held, {}, {}) == 0);
}

TEST_CASE("undoSwap: restores elements, neighbours and α after a swap") {
    TriMesh mesh = samples::square(6, 6, 0.2);
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    work.measureAlpha();
    for (HalfEdge h = 0; h < work.twin.size(); ++h) {
        if (!canSwap(work, h)) {
            continue;
        }
        const std::size_t e = elementOf(h), f = elementOf(work.twin[h]);
        const auto elements = mesh.elements;
        const auto twin = work.twin;
        const auto valence = work.valence;
        const auto alpha = work.alpha;
        swapEdgeAndRings(work, h);
        CHECK(mesh.elements != elements);
        undoSwap(work, e, f, {elements[e], elements[f]});
        CHECK(mesh.elements == elements);
        CHECK(work.twin == twin);
        CHECK(work.valence == valence);
        CHECK(work.alpha == alpha);
        for (const NodeId n : elements[e]) {
            CHECK(work.from(work.start[index(n)]) == n);
        }
    }
}
