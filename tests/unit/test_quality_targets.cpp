#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/pipeline.hpp"
#include "tests/bench/scenes.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;

// The quality that the two levels of improvement are held to, on scenes of the benchmark that take no time.

namespace {

MeshQuality qualityOf(const std::string &scene, double size, ImproveLevel level) {
    std::optional<bench::Scene> made = bench::makeScene(scene, size);
    REQUIRE(made);
    made->job.options.improve = level;
    const Result<MeshingOutcome> outcome = meshDomain(made->job);
    REQUIRE(outcome);
    return measureQuality(outcome->mesh, outcome->spacing.get());
}

} // namespace

TEST_CASE("Quality: a steeply graded mesh keeps shape and spacing on the default level") {
    const MeshQuality q = qualityOf("graded", 0.1, ImproveLevel::Default);
    CHECK(q.alphaMean >= 0.985);
    CHECK(q.alphaMin >= 0.80);
    CHECK(q.minAngle >= 35.0);
    CHECK(q.deltaMean >= 0.957);
}

TEST_CASE("Quality: a steeply graded mesh has better shapes and keeps the spacing better on the best level") {
    for (const double r : {0.1, 0.05}) {
        CAPTURE(r);
        const MeshQuality q = qualityOf("graded", r, ImproveLevel::Best);
        CHECK(q.alphaMean >= 0.990);
        CHECK(q.alphaMin >= 0.85);
        CHECK(q.minAngle >= 39.0);
        CHECK(q.deltaMean >= 0.960);
    }
}

TEST_CASE("Quality: a uniform mesh of a disc is nearly regular on the best level") {
    for (const double elements : {1e4, 1e5}) {
        CAPTURE(elements);
        const MeshQuality q = qualityOf("disc", elements, ImproveLevel::Best);
        CHECK(q.alphaMean >= 0.996);
        CHECK(q.minAngle >= 38.0);
        CHECK(q.deltaMean >= 0.970);
    }
}
