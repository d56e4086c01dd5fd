#include "core/improve/improve.hpp"
#include "core/improve/shape_polish.hpp"
#include "core/mesh/quality.hpp"
#include "core/mesh/verify.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

using namespace forefront;

namespace {

/// An improved mesh of a square with constraints, which no further smoothing changes much.
Mesh improved(double jitter, std::uint64_t seed) {
    Mesh mesh = samples::constrainedSquare(30, jitter, {}, seed);
    improve(mesh);
    return mesh;
}

double worst(const Mesh &mesh) {
    return measure(mesh, nullptr).alphaMin;
}

double geometricMean(const Mesh &mesh) {
    return measure(mesh, nullptr).alphaGeometricMean;
}

} // namespace

TEST_CASE("polishShapes: raises the geometric mean of α, keeps the floor, and moves free nodes only") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Mesh before = improved(0.2, seed);
        Mesh mesh = before;
        ThreadPool pool(1);
        ImproveWorkspace work(mesh, pool);
        const double floor = std::max(0.75, worst(before));
        CHECK(polishShapes(work, floor, {}) > 0);
        CHECK(verify(mesh).empty());
        CHECK(geometricMean(mesh) > geometricMean(before));
        CHECK(worst(mesh) >= worst(before));
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            CHECK((work.isFree(n) || mesh.nodes[n] == before.nodes[n]));
        }
    }
}

TEST_CASE("polishShapes: elements below the floor do not get worse") {
    const Mesh before = samples::square(20, 20, 0.24, {}, 9);
    Mesh mesh = before;
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    polishShapes(work, 0.9, {});
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto alpha = [e](const Mesh &of) {
            const Element &n = of.elements[e];
            return shapeFactor(of.nodes[index(n[0])], of.nodes[index(n[1])], of.nodes[index(n[2])]);
        };
        CHECK((alpha(mesh) >= 0.9 || alpha(mesh) >= alpha(before)));
    }
}

TEST_CASE("polishShapes: a free node goes to the middle of a regular polygon") {
    constexpr double kTurn = 6.283185307179586;
    Mesh mesh;
    for (int k = 0; k < 6; ++k) {
        mesh.nodes.push_back({std::cos(kTurn * k / 6), std::sin(kTurn * k / 6)});
        mesh.elements.push_back({samples::node(6), samples::node(k), samples::node((k + 1) % 6)});
        mesh.edges.push_back({samples::node(k), samples::node((k + 1) % 6), 1});
    }
    mesh.nodes.push_back({0.3, -0.2});
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    CHECK(polishShapes(work, 0.0, {}) > 0);
    CHECK(length(mesh.nodes[6]) < 1e-2);
}

TEST_CASE("polishShapes: leaves a valid mesh when cancelled") {
    const Mesh before = improved(0.2, 4);
    Mesh mesh = before;
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    std::stop_source source;
    source.request_stop();
    CHECK(polishShapes(work, 0.75, {{}, source.get_token()}) == 0);
    CHECK(meshHash(mesh) == meshHash(before));
}
