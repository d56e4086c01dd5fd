#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/refine/least_angle.hpp"
#include "tests/support/random_curves.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/least_angle_checks.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

MeshingJob leastAngleJob(Domain domain, double angle) {
    MeshingJob job;
    job.domain = std::move(domain);
    job.options.leastAngle = angle;
    return job;
}

/// Returns the least angle between two tagged edges at a place, in degrees.
double sharpestCorner(const Mesh &mesh, Vec2 at) {
    std::vector<Vec2> rays;
    for (const TaggedEdge &edge : mesh.edges) {
        const Vec2 a = mesh.nodes[index(edge.a)], b = mesh.nodes[index(edge.b)];
        if (a == at || b == at) {
            rays.push_back(a == at ? b - a : a - b);
        }
    }
    double least = 180.0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t j = i + 1; j < rays.size(); ++j) {
            const double angle = std::atan2(std::abs(cross(rays[i], rays[j])), dot(rays[i], rays[j]));
            least = std::min(least, angle * 180.0 / std::numbers::pi);
        }
    }
    return least;
}

/// Meshes a domain and judges the mesh by its own elements: it must be valid, and its elements with smaller angles as
/// many as the report names, each with a node at the named corner or inside its two lines.
MeshingOutcome meshedToAngle(const MeshingJob &job) {
    MeshingOutcome outcome = verifiedJob(job);
    const std::size_t smaller = elementsBelow(outcome.mesh, *job.options.leastAngle);
    std::size_t named = 0;
    for (const ForcedAngle &place : outcome.leastAngle.forced) {
        named += place.elements;
        if (place.reason == ForcedBy::Corner) {
            CHECK(sharpestCorner(outcome.mesh, place.at) <= *job.options.leastAngle);
        }
    }
    CHECK(smaller <= named);
    CHECK(outcome.leastAngle.reached >= *job.options.leastAngle * (1.0 - 1e-9));
    return outcome;
}

/// A right-angled triangle with one sharp corner at the origin.
Domain sharpTriangle(double degrees) {
    Domain domain;
    addLoop(domain, std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10 * std::tan(degrees * std::numbers::pi / 180.0)}});
    return domain;
}

/// A rectangle with nodes very close together on its lower side.
Domain closeNodes() {
    Domain domain;
    addLoop(domain, std::vector<Vec2>{{0, 0}, {5, 0}, {5.01, 0}, {10, 0}, {10, 6}, {0, 6}});
    return domain;
}

} // namespace

TEST_CASE("least angle: the mesh of a square keeps what is well, a mesh with close nodes gains nodes") {
    Domain square;
    addLoop(square, std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const MeshingOutcome easy = meshedToAngle(leastAngleJob(square, 25.0));
    CHECK(easy.leastAngle.addedNodes <= 4);
    CHECK(easy.leastAngle.forced.empty());
    MeshingJob job = leastAngleJob(closeNodes(), 30.0);
    job.spacing.size = 1.0;
    const MeshingOutcome outcome = meshedToAngle(job);
    CHECK(outcome.leastAngle.addedNodes > 0);
    CHECK(outcome.leastAngle.forced.empty());
    job.options.leastAngle.reset();
    const Result<MeshingOutcome> without = meshDomain(job);
    REQUIRE(without);
    CHECK(outcome.mesh.elementCount() > without->mesh.elementCount());
    CHECK(outcome.mesh.elementCount() < 3 * without->mesh.elementCount());
}

TEST_CASE("least angle: a sharp corner is named, and only its elements have smaller angles") {
    for (const double degrees : {1.0, 5.0, 12.0, 25.0, 29.0}) {
        CAPTURE(degrees);
        MeshingJob job = leastAngleJob(sharpTriangle(degrees), 30.0);
        job.spacing.size = 0.5;
        const MeshingOutcome outcome = meshedToAngle(job);
        REQUIRE(outcome.leastAngle.forced.size() == 1);
        const ForcedAngle &forced = outcome.leastAngle.forced.front();
        CHECK(forced.reason == ForcedBy::Corner);
        CHECK(forced.at == Vec2{0, 0});
        CHECK(forced.angle <= degrees + 1e-9);
        // In the sharpest one, nodes at distances of powers of two face one another; see AcuteLines.
        CHECK(forced.elements <= (degrees < 2.0 ? 40 : 1));
    }
    CHECK(meshedToAngle(leastAngleJob(sharpTriangle(31.0), 30.0)).leastAngle.forced.empty());
}

TEST_CASE("least angle: segments that must stay are not divided, and places beside them are named") {
    MeshingJob job = leastAngleJob(closeNodes(), 30.0);
    job.spacing.size = 1.0;
    job.options.keepBoundary = true;
    const MeshingOutcome outcome = meshedToAngle(job);
    CHECK(outcome.leastAngle.dividedEdges == 0);
    for (const ForcedAngle &forced : outcome.leastAngle.forced) {
        CHECK(forced.reason == ForcedBy::KeptEdge);
    }
}

TEST_CASE("least angle: new nodes lie on the curves") {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        const MeshingJob job = leastAngleJob(randomCurvedDomain(seed), 30.0);
        const MeshingOutcome outcome = meshedToAngle(job);
        const Mesh &mesh = outcome.mesh;
        REQUIRE(mesh.edgeStretches.size() == (mesh.curves.empty() ? 0 : mesh.edges.size()));
        for (std::size_t i = 0; i < mesh.edgeStretches.size(); ++i) {
            if (const CurveStretch &stretch = mesh.edgeStretches[i]; stretch.follows()) {
                const double scale = 1e-9 * mesh.bounds().diagonal();
                CHECK(distance(mesh.nodes[index(mesh.edges[i].a)], mesh.curves[stretch.curve].point(stretch.t0)) <
                      scale);
                CHECK(distance(mesh.nodes[index(mesh.edges[i].b)], mesh.curves[stretch.curve].point(stretch.t1)) <
                      scale);
            }
        }
    }
}

TEST_CASE("least angle: random domains reach 30 degrees") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        meshedToAngle(leastAngleJob(randomDomain(seed), 30.0));
    }
}

TEST_CASE("least angle: 2,000 random domains reach 30 degrees" * doctest::test_suite("slow")) {
    for (std::uint64_t seed = 1000; seed < 3000; ++seed) {
        CAPTURE(seed);
        meshedToAngle(leastAngleJob(seed % 4 == 0 ? randomCurvedDomain(seed) : randomDomain(seed), 30.0));
    }
}

TEST_CASE("least angle: refused where it cannot be promised") {
    for (const double angle : {0.0, -1.0, 34.0, std::nan("")}) {
        const Result<MeshingOutcome> outcome = meshDomain(leastAngleJob(closeNodes(), angle));
        REQUIRE_FALSE(outcome);
        CHECK(outcome.faults().front().code == "least-angle");
    }
    MeshingJob quads = leastAngleJob(closeNodes(), 20.0);
    quads.options.elements = Elements::Quads;
    REQUIRE_FALSE(meshDomain(quads));
}
