#include "core/engine/improve/improve.hpp"
#include "core/engine/improve/shape_polish.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

using namespace forefront;

namespace {

/// An improved mesh of a square with constraints, which no further smoothing changes much.
TriMesh improved(double jitter, std::uint64_t seed) {
    TriMesh mesh = samples::constrainedSquare(30, jitter, {}, seed);
    improve(mesh);
    return mesh;
}

double worst(const TriMesh &mesh) {
    return measureQuality(mesh, nullptr).alphaMin;
}

double geometricMean(const TriMesh &mesh) {
    return measureQuality(mesh, nullptr).alphaGeometricMean;
}

/// Returns true if no α fell below the floor, and none that was below it fell.
bool noneWorse(const TriMesh &before, const TriMesh &after, double floor) {
    const auto alpha = [](const TriMesh &mesh, std::size_t e) {
        const Element &n = mesh.elements[e];
        return shapeFactor(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])]);
    };
    for (std::size_t e = 0; e < after.elements.size(); ++e) {
        if (alpha(after, e) < std::min(floor, alpha(before, e))) {
            return false;
        }
    }
    return true;
}

} // namespace

TEST_CASE("polishShapes: raises the geometric mean of α, keeps the floor, and moves free nodes only") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const TriMesh before = improved(0.2, seed);
        TriMesh mesh = before;
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
    const TriMesh before = samples::square(20, 20, 0.24, {}, 9);
    TriMesh mesh = before;
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    polishShapes(work, 0.9, {});
    CHECK(noneWorse(before, mesh, 0.9));
}

TEST_CASE("polishShapes: a free node goes to the middle of a regular polygon") {
    constexpr double kTurn = 6.283185307179586;
    TriMesh mesh;
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

TEST_CASE("polishShapes: the floor holds bit for bit, for any order of the nodes of an element") {
    const Vec2 ring[] = {{0.56643801018916384, 0.0},
                         {0.31631469067074219, 0.54787311538428807},
                         {-0.53731457982701702, 0.93065615203657603},
                         {-0.5614986094491895, 5.0418748144657003e-11},
                         {-0.58017447945826928, -1.0048916753987043},
                         {0.73256565675347285, -1.2688409378156069}};
    TriMesh mesh;
    mesh.nodes.assign(std::begin(ring), std::end(ring));
    mesh.nodes.push_back({-0.35168144713515359, -0.49687378331183235});
    for (int k = 0; k < 6; ++k) {
        mesh.elements.push_back({samples::node(k), samples::node((k + 1) % 6), samples::node(6)});
        mesh.edges.push_back({samples::node(k), samples::node((k + 1) % 6), 1});
    }
    const TriMesh before = mesh;
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    polishShapes(work, 0.95, {});
    CHECK(noneWorse(before, mesh, 0.95));
}

TEST_CASE("polishShapes: works in tiny and huge units and far from the origin") {
    for (const double unit : {1e-60, 1.0, 1e50}) { // coordinates may reach 1e60
        for (const double far : {0.0, 1e5}) {
            TriMesh before = samples::square(12, 12, 0.24, {far, -far}, 5);
            for (Vec2 &p : before.nodes) {
                p = unit * p;
            }
            TriMesh mesh = before;
            ThreadPool pool(1);
            ImproveWorkspace work(mesh, pool);
            CHECK(polishShapes(work, 0.2, {}) > 50);
            CHECK(verify(mesh).empty());
            CHECK(geometricMean(mesh) > geometricMean(before) + 0.05);
        }
    }
}

TEST_CASE("improve: a poor mesh becomes the same for any number of threads, and its minimum α is reported") {
    const TriMesh start = samples::constrainedSquare(40, 0.0, {}, 4);
    TriMesh one = start, three = start;
    const ImproveReport report = improve(one, {.threads = 1});
    improve(three, {.threads = 3});
    CHECK(meshHash(one) == meshHash(three));
    CHECK(report.alphaMinAfter == worst(one));
    CHECK(verify(one).empty());
}

TEST_CASE("polishShapes: leaves a valid mesh when cancelled") {
    const TriMesh before = improved(0.2, 4);
    TriMesh mesh = before;
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    std::stop_source source;
    source.request_stop();
    CHECK(polishShapes(work, 0.75, {{}, source.get_token()}) == 0);
    CHECK(meshHash(mesh) == meshHash(before));
}
