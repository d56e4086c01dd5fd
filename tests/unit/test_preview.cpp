#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/meshing_session.hpp"

#include <doctest/doctest.h>

#include <memory>

using namespace forefront;

namespace {

/// A square of side 4 with a square hole and a point source in one corner.
MeshingJob gradedSquare(double size) {
    MeshingJob job;
    job.domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        job.domain.segments.push_back({i, (i + 1) % 4, 1, SegmentRole::Boundary});
        job.domain.segments.push_back({4 + i, 4 + (i + 1) % 4, 2, SegmentRole::Boundary});
    }
    job.spacing.size = size;
    SizeSource corner;
    corner.a = {4, 4};
    corner.size = 0.2 * size;
    corner.growth = 0.3;
    job.spacing.sources.push_back(corner);
    return job;
}

} // namespace

TEST_CASE("Preview: a budget multiplies the spacing by one factor, down to about that many elements") {
    const MeshingJob job = gradedSquare(0.05);
    const Result<PreparedJob> whole = prepare(job);
    REQUIRE(whole);
    CHECK(whole->coarsening == 1.0);
    CHECK(whole->requestedElements == whole->estimatedElements);
    const Result<PreparedJob> coarse = prepare(job, {}, 1000.0);
    REQUIRE(coarse);
    CHECK(coarse->requestedElements == whole->estimatedElements);
    CHECK(coarse->coarsening > 1.0);
    CHECK(coarse->estimatedElements == doctest::Approx(1000.0).epsilon(0.02));
    CHECK(coarse->boundary->nodes.size() < whole->boundary->nodes.size());
    for (const Vec2 p : {Vec2{0.5, 0.5}, Vec2{3, 3.5}, Vec2{4, 4}}) {
        CHECK(coarse->spacing->at(p) == coarse->coarsening * whole->spacing->at(p));
        CHECK(coarse->spacing->sample(p).rho == coarse->spacing->at(p));
        CHECK(coarse->spacing->sample(p).describe == whole->spacing->sample(p).describe);
    }
    CHECK(coarse->spacing->minimum() == coarse->coarsening * whole->spacing->minimum());
    CHECK(coarse->spacing->maximum() == coarse->coarsening * whole->spacing->maximum());
}

TEST_CASE("Preview: a budget that suffices changes nothing, bit for bit") {
    const MeshingJob job = gradedSquare(0.2);
    const Result<PreparedJob> whole = prepare(job), within = prepare(job, {}, whole->estimatedElements);
    REQUIRE(within);
    CHECK(within->coarsening == 1.0);
    CHECK(within->boundary->nodes == whole->boundary->nodes);
    CHECK(within->estimatedElements == whole->estimatedElements);
}

TEST_CASE("Preview: a session says that the mesh is a preview until the whole mesh replaces it") {
    MeshingSession session;
    const auto job = std::make_shared<MeshingJob>(gradedSquare(0.05));
    session.start(job, StartMode::RunQuiet, 800.0);
    const auto preview = session.wait();
    REQUIRE(preview->state == RunState::Finished);
    CHECK(preview->coarsening > 1.0);
    CHECK(preview->requestedElements > 4.0 * 800.0);
    CHECK(preview->quality.elements < 1200);
    CHECK(verify(preview->mesh->mesh).empty());
    session.start(job, StartMode::RunQuiet);
    const auto whole = session.wait();
    CHECK(whole->coarsening == 1.0);
    CHECK(whole->requestedElements == preview->requestedElements);
    CHECK(whole->meshHash == meshHash(meshDomain(*job)->mesh));
}

TEST_CASE("Preview: a job that is too large stays refused") {
    const Result<PreparedJob> refused = prepare(gradedSquare(2e-5), {}, 1000.0);
    REQUIRE_FALSE(refused);
    CHECK(refused.faults().front().code == "too-many-elements");
}
