#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/run_estimate.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace forefront;

namespace {

MeshingJob squareToEstimate() {
    MeshingJob job;
    job.domain.nodes = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        job.domain.segments.push_back({k, (k + 1) % 4});
    }
    return job;
}

void checkEstimate(const MeshingJob &job, double bound) {
    const Result<RunEstimate> estimate = estimateRun(job);
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE(estimate.ok());
    REQUIRE(outcome.ok());
    CHECK(std::fabs(estimate->elements / static_cast<double>(outcome->mesh.elementCount()) - 1.0) < bound);
    CHECK(std::fabs(estimate->nodes / static_cast<double>(outcome->mesh.nodes.size()) - 1.0) < bound);
    CHECK(estimate->seconds >= estimate->secondsPrepare);
    CHECK(estimate->bytes > 0.0);
}

} // namespace

TEST_CASE("RunEstimate: elements and nodes are within 15 % for uniform and graded sizes") {
    MeshingJob job = squareToEstimate();
    job.spacing.size = 0.1;
    checkEstimate(job, 0.15);
    job.options.order = ElementOrder::Second;
    checkEstimate(job, 0.15);
    job.spacing.size.reset();
    job.spacing.expression = "0.03+0.1*dist(1,1)";
    checkEstimate(job, 0.15);
}

TEST_CASE("RunEstimate: few elements are exact, also where the size would allow larger ones than the boundary does") {
    MeshingJob job = squareToEstimate();
    job.spacing.expression = "0.05+4*dist(0,0)";
    checkEstimate(job, 1e-12);
    job.options.elements = Elements::Quads;
    checkEstimate(job, 1e-12);
}

TEST_CASE("RunEstimate: many elements are within 15 %") {
    MeshingJob job = squareToEstimate();
    job.spacing.size = 0.025;
    checkEstimate(job, 0.15);
}

TEST_CASE("RunEstimate: quadrilaterals are within 15 % for a uniform size") {
    MeshingJob job = squareToEstimate();
    job.spacing.size = 0.1;
    job.options.elements = Elements::Quads;
    checkEstimate(job, 0.15);
}

TEST_CASE("RunEstimate: a job that cannot be prepared has its faults") {
    MeshingJob job = squareToEstimate();
    job.spacing.size = 1e-6;
    const Result<RunEstimate> estimate = estimateRun(job);
    REQUIRE_FALSE(estimate.ok());
    CHECK(estimate.faults().front().code == "too-many-elements");
}
