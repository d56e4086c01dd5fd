#include "core/engine/domain/add_loop.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

using namespace forefront;

namespace {

MeshingJob verifiedJob() {
    MeshingJob job;
    addLoop(job.domain, std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {0, 1}});
    job.spacing.size = 0.2;
    job.options.verify = true;
    return job;
}

} // namespace

TEST_CASE("verifyStage: a right mesh passes, a mesh with a node out of its place is refused") {
    const MeshingJob job = verifiedJob();
    auto outcome = meshDomain(job);
    REQUIRE(outcome);
    MeshingState state{.job = job};
    state.mesh = std::move(outcome->mesh);
    CHECK(verifyStage(state, {}).empty());
    state.mesh.nodes[0] = state.mesh.nodes[0] + Vec2{-0.5, -0.5};
    const Status faults = verifyStage(state, {});
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.front().message.starts_with("the finished mesh is wrong: "));
}

TEST_CASE("verifyStage: it is the last stage of a run that asks for it") {
    MeshingJob job = verifiedJob();
    const Stage &last = stagesAfterFront().back();
    CHECK((last.run == &verifyStage));
    CHECK(last.applies(job.options));
    job.options.verify = false;
    CHECK_FALSE(last.applies(job.options));
}
