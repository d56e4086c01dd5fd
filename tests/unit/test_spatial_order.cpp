#include "core/engine/improve/improve.hpp"
#include "core/engine/improve/spatial_order.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "tests/support/stop_at.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

using namespace forefront;

namespace {

/// Returns the same mesh with its nodes and elements in random order.
TriMesh shuffled(const TriMesh &mesh, std::uint64_t seed) {
    samples::Random random(seed);
    const auto order = [&](std::size_t count) {
        std::vector<std::uint32_t> numbers(count);
        std::iota(numbers.begin(), numbers.end(), 0U);
        for (std::size_t k = count; k > 1; --k) {
            std::swap(numbers[k - 1], numbers[random.below(k)]);
        }
        return numbers;
    };
    const std::vector<std::uint32_t> nodes = order(mesh.nodes.size()), elements = order(mesh.elements.size());
    TriMesh result = mesh;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        result.nodes[nodes[n]] = mesh.nodes[n];
    }
    const auto moved = [&](NodeId n) { return NodeId{nodes[index(n)]}; };
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const Element &n = mesh.elements[e];
        result.elements[elements[e]] = {moved(n[0]), moved(n[1]), moved(n[2])};
        if (!mesh.regions.empty()) {
            result.regions[elements[e]] = mesh.regions[e];
        }
    }
    for (TaggedEdge &edge : result.edges) {
        edge.a = moved(edge.a);
        edge.b = moved(edge.b);
    }
    for (TaggedNode &point : result.points) {
        point.node = moved(point.node);
    }
    return result;
}

/// Returns the mean distance in memory of the nodes of an element, in nodes.
double meanSpan(const TriMesh &mesh) {
    double sum = 0.0;
    for (const Element &n : mesh.elements) {
        sum += std::fabs(static_cast<double>(index(n[0])) - static_cast<double>(index(n[1])));
    }
    return sum / static_cast<double>(mesh.elements.size());
}

} // namespace

TEST_CASE("SpatialOrder: sorts what is close together, and restores the mesh exactly") {
    for (const unsigned threads : {1U, 3U}) {
        const TriMesh before = shuffled(samples::constrainedSquare(120, 0.2, {3e5, -7.0}, 3), 4);
        REQUIRE(!before.regions.empty());
        REQUIRE(!before.points.empty());
        TriMesh mesh = before;
        ThreadPool pool(threads);
        SpatialOrder order(mesh, pool);
        CHECK(verify(mesh).empty());
        CHECK(mesh.nodes != before.nodes);
        CHECK(meanSpan(mesh) < meanSpan(before) / 20.0);
        CHECK(measureQuality(mesh, nullptr).alphaMin == measureQuality(before, nullptr).alphaMin);
        for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
            CHECK(mesh.nodes[index(mesh.edges[k].a)] == before.nodes[index(before.edges[k].a)]);
            CHECK(mesh.nodes[index(mesh.edges[k].b)] == before.nodes[index(before.edges[k].b)]);
        }
        order.restore();
        CHECK(meshHash(mesh) == meshHash(before));
    }
}

TEST_CASE("SpatialOrder: helps where nodes of elements lie far apart in memory") {
    const TriMesh mesh = samples::square(250, 250);
    CHECK_FALSE(SpatialOrder::helps(mesh));
    CHECK(SpatialOrder::helps(shuffled(mesh, 1)));
    CHECK_FALSE(SpatialOrder::helps(TriMesh()));
}

TEST_CASE("improve: a large mesh in random order keeps its numbers, and the result does not depend on threads") {
    const TriMesh before = shuffled(samples::constrainedSquare(240, 0.24, {}, 5), 6);
    REQUIRE(before.elements.size() > 100'000);
    REQUIRE(SpatialOrder::helps(before));
    std::vector<std::uint64_t> hashes;
    for (const unsigned threads : {1U, 2U, 5U}) {
        TriMesh mesh = before;
        const ImproveReport report = improve(mesh, {ImproveLevel::Default, threads, nullptr});
        const Diagnostics faults = verify(mesh);
        REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
        CHECK(report.alphaMinAfter == measureQuality(mesh, nullptr).alphaMin);
        CHECK(report.alphaMinAfter > 0.7);
        for (std::size_t k = 0; k < mesh.edges.size(); ++k) { // the nodes of tagged edges stay where they are
            REQUIRE(mesh.edges[k].a == before.edges[k].a);
            REQUIRE(mesh.nodes[index(mesh.edges[k].a)] == before.nodes[index(before.edges[k].a)]);
        }
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            REQUIRE(distance(mesh.nodes[n], before.nodes[n]) < 2.0 / 240.0);
        }
        hashes.push_back(meshHash(mesh));
    }
    CHECK(hashes[0] == hashes[1]);
    CHECK(hashes[0] == hashes[2]);
}

TEST_CASE("improve: cancelled at any stage, a large mesh in random order keeps its numbers") {
    const TriMesh before = shuffled(samples::square(250, 250, 0.24), 2);
    for (int report = 0; report <= 6; ++report) {
        TriMesh mesh = before;
        const testing::StopAt stop(report);
        improve(mesh, {}, stop.progress());
        CHECK(verify(mesh).empty());
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            REQUIRE(distance(mesh.nodes[n], before.nodes[n]) < 2.0 / 250.0);
        }
    }
}
