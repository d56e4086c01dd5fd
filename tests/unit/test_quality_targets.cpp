#include "core/mesh/quality.hpp"
#include "core/mesher/pipeline.hpp"
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
    return measure(outcome->mesh, outcome->spacing.get());
}

} // namespace

TEST_CASE("Quality: a steeply graded mesh keeps shape and spacing on the default level") {
    const MeshQuality q = qualityOf("graded", 0.1, ImproveLevel::Default);
    CHECK(q.alphaMean >= 0.984);
    CHECK(q.alphaMin >= 0.80);
    CHECK(q.minAngle >= 35.0);
    CHECK(q.deltaMean >= 0.950);
}

TEST_CASE("Quality: a steeply graded mesh has better shapes and keeps the spacing better on the best level") {
    for (const double r : {0.1, 0.05}) {
        CAPTURE(r);
        const MeshQuality q = qualityOf("graded", r, ImproveLevel::Best);
        CHECK(q.alphaMean >= 0.986);
        CHECK(q.alphaMin >= 0.85);
        CHECK(q.minAngle >= 39.0);
        CHECK(q.deltaMean >= 0.954);
    }
}

TEST_CASE("Quality: an even mesh of a disc is nearly regular on the best level") {
    const MeshQuality q = qualityOf("disc", 1e5, ImproveLevel::Best);
    CHECK(q.alphaMean >= 0.996);
    CHECK(q.minAngle >= 38.0);
    // The fewer the elements, the more of them lie where the layers along the edge meet each other: where 0.996 is
    // reached with 10⁴, δ has fallen to 0.95.
    const MeshQuality coarse = qualityOf("disc", 1e4, ImproveLevel::Best);
    CHECK(coarse.alphaMean >= 0.9935);
    CHECK(coarse.minAngle >= 38.0);
    CHECK(coarse.deltaMean >= 0.960);
}
