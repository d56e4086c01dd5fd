#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/quads/recombine.hpp"
#include "tests/support/meshed_job.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <tuple>

using namespace forefront;
using namespace forefront::testing;

namespace recombine_cases {

/// A plate with a hole and two regions.
MeshingJob holedPlate() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 2}, {0, 2}});
    addLoop(job.domain, {{1, 0.6}, {1, 1.4}, {1.6, 1.4}, {1.6, 0.6}}, 2);
    job.domain.nodes.insert(job.domain.nodes.end(), {{2.4, 0.3}, {3.6, 0.3}, {3.6, 1.5}, {2.4, 1.5}});
    for (std::uint32_t k = 0; k < 4; ++k) {
        job.domain.segments.push_back({8 + k, 8 + (k + 1) % 4, 3, SegmentRole::Constraint});
    }
    job.domain.regionMarkers = {{{0.1, 0.1}, 1}, {{3, 1}, 7}};
    job.spacing.size = 0.12;
    return job;
}

using PlacedEdge = std::tuple<double, double, double, double, std::int32_t>;

/// Returns the tagged edges of a mesh by their places.
std::set<PlacedEdge> placedEdges(const Mesh &mesh) {
    std::set<PlacedEdge> edges;
    for (const TaggedEdge &edge : mesh.edges) {
        Vec2 a = mesh.nodes[index(edge.a)], b = mesh.nodes[index(edge.b)];
        if (comesBefore(b, a)) {
            std::swap(a, b);
        }
        edges.insert({a.x, a.y, b.x, b.y, edge.tag});
    }
    return edges;
}

} // namespace recombine_cases

using namespace recombine_cases;

TEST_CASE("Recombine: quadrilaterals with the same boundary, interfaces and regions") {
    const MeshingJob job = holedPlate();
    const Mesh triangles = meshedJob(job).mesh;
    Mesh mesh = triangles;
    const Result<QuadReport> report = recombine(mesh);
    REQUIRE(report);
    CHECK_FALSE(hasErrors(verifyAgainst(mesh, job.domain)));
    CHECK(placedEdges(mesh) == placedEdges(triangles));
    CHECK(report->triangles <= 2); // one for each face
    CHECK(report->triangles + report->quadrilaterals == mesh.elementCount());
    CHECK(mesh.elementCount() < 0.6 * static_cast<double>(triangles.elementCount()));
    CHECK(mesh.elementCount() > 0.4 * static_cast<double>(triangles.elementCount()));
    CHECK(report->irregularShare() < 0.2);
    CHECK(measureQuality(mesh, nullptr).minScaledJacobian > 0.3);
    Mesh again = triangles;
    REQUIRE(recombine(again));
    CHECK(meshHash(again) == meshHash(mesh));
    Mesh raw = triangles;
    const Result<QuadReport> pairs = recombine(raw, ImproveLevel::None);
    REQUIRE(pairs);
    CHECK(pairs->changes == 0);
    CHECK(placedEdges(raw) == placedEdges(triangles));
}

TEST_CASE("Recombine: a face with an odd number of edges keeps one triangle") {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {3, 0}, {0, 3}});
    job.options.keepBoundary = true;
    job.spacing.size = 3;
    Mesh mesh = meshedJob(job).mesh;
    const Result<QuadReport> report = recombine(mesh);
    REQUIRE(report);
    CHECK(report->triangles == 1);
}

TEST_CASE("Recombine: cracks, clockwise meshes, and what cannot be recombined") {
    MeshingJob job = holedPlate();
    job.cracks = {3};
    Mesh mesh = meshedJob(job).mesh;
    REQUIRE(recombine(mesh));
    const std::int32_t cracks[] = {3};
    CHECK_FALSE(hasErrors(verifyAgainst(mesh, job.domain, {}, kMaxListedFaults, {}, true, cracks)));
    Mesh other = turned(meshedJob(holedPlate()).mesh);
    REQUIRE(recombine(other));
    CHECK_FALSE(isClockwise(other));
    job.options.order = ElementOrder::Second;
    mesh = meshedJob(job).mesh;
    const std::uint64_t before = meshHash(mesh);
    REQUIRE_FALSE(recombine(mesh));
    CHECK(meshHash(mesh) == before);
    mesh = meshedJob(holedPlate()).mesh;
    std::swap(mesh.nodes[20], mesh.nodes[60]);
    CHECK_FALSE(recombine(mesh));
}

TEST_CASE("Recombine: random domains") {
    std::mt19937_64 random(3);
    for (int round = 0; round < 12; ++round) {
        MeshingJob job;
        std::vector<Vec2> loop;
        std::uniform_real_distribution<double> radius(0.7, 1.3);
        for (int k = 0; k < 9; ++k) {
            const double angle = 2.0 * 3.14159265358979 * k / 9.0, r = radius(random);
            loop.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
        addLoop(job.domain, loop);
        job.spacing.expression = "0.08 + 0.05*x*x";
        Mesh mesh = meshedJob(job).mesh;
        const auto edges = placedEdges(mesh);
        const Result<QuadReport> report = recombine(mesh);
        REQUIRE(report);
        CHECK_FALSE(hasErrors(verifyAgainst(mesh, job.domain)));
        CHECK(placedEdges(mesh) == edges);
        CHECK(report->triangles == edges.size() % 2);
    }
}
