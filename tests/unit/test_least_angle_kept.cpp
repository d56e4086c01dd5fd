#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/refine/least_angle.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/least_angle_checks.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace kept_edges_test {

double leastAngle(const Mesh &mesh) {
    double least = 180.0;
    for (const Element &e : mesh.triangles()) {
        least = std::min(least, leastAngleOf(mesh, e));
    }
    return least;
}

/// A rectangle of 4 x 2 with 16 elements on its lower side, of which the last is `bias` times as long as the first.
MeshingJob biasedRectangle(double bias) {
    MeshingJob job;
    addLoop(job.domain, std::vector<Vec2>{{0, 0}, {4, 0}, {4, 2}, {0, 2}});
    job.spacing.size = 0.1;
    job.spacing.placed.elements = {16, 0, 0, 0};
    job.spacing.placed.biases = {{bias, false}, {}, {}, {}};
    return job;
}

/// Compares a mesh with one that has a least angle: no place that forces smaller angles is sharper than before.
void checkNotWorse(MeshingJob job, double angle) {
    CAPTURE(angle);
    job.options.leastAngle.reset();
    const double before = leastAngle(verifiedJob(job).mesh);
    job.options.leastAngle = angle;
    const MeshingOutcome refined = verifiedJob(job);
    const std::size_t smaller = elementsBelow(refined.mesh, angle);
    std::size_t named = 0;
    for (const ForcedAngle &place : refined.leastAngle.forced) {
        named += place.elements;
        if (place.reason == ForcedBy::KeptEdge) {
            CHECK(place.angle >= before * (1.0 - 1e-9));
        }
    }
    CHECK(smaller <= named);
    CHECK((refined.leastAngle.reached == 0.0 || refined.leastAngle.reached >= angle * (1.0 - 1e-9)));
}

/// Gives about half of the segments of a domain a number of elements.
MeshingJob countedJob(std::uint64_t seed) {
    RandomSource random(seed);
    MeshingJob job;
    job.domain = randomDomain(seed);
    for (std::size_t i = 0; i < job.domain.segments.size(); ++i) {
        job.spacing.placed.elements.push_back(random.chance(0.5) ? static_cast<std::uint32_t>(random.integer(1, 6))
                                                                 : 0);
    }
    return job;
}

} // namespace kept_edges_test

using namespace kept_edges_test;

TEST_CASE("least angle: beside a biased side with a number of elements, no angle becomes smaller") {
    for (const double bias : {0.125, 0.5, 8.0, 40.0}) {
        CAPTURE(bias);
        for (const double angle : {28.0, 30.0, 33.0}) {
            checkNotWorse(biasedRectangle(bias), angle);
        }
    }
}

TEST_CASE("least angle: beside a biased side, what can gain does, and the rest is named") {
    MeshingJob job = biasedRectangle(40.0);
    job.options.leastAngle = 33.0;
    const MeshingOutcome outcome = verifiedJob(job);
    CHECK(outcome.leastAngle.addedNodes > 0);
    REQUIRE_FALSE(outcome.leastAngle.forced.empty());
    for (const ForcedAngle &place : outcome.leastAngle.forced) {
        CHECK(place.reason == ForcedBy::KeptEdge);
        CHECK(place.angle > 22.0);
    }
}

TEST_CASE("least angle: segments of random domains that stay leave no place worse than it was") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        checkNotWorse(countedJob(seed), 30.0);
        MeshingJob whole;
        whole.domain = randomDomain(seed);
        whole.options.keepBoundary = true;
        checkNotWorse(whole, 33.0);
    }
}
