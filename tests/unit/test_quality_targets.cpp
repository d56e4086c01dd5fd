#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/bench/scenes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>

using namespace forefront;

// The quality that the levels of improvement reach on scenes of the benchmark that take little time. The figures are
// recorded: a change beyond the tolerance, up or down, is reported in the commit that makes it, and recorded anew.

namespace {

struct Recorded {
    const char *scene;
    double size;
    ImproveLevel level;
    double alphaMean, alphaMin, minAngle, deltaMean;
};

constexpr double kMeanTolerance = 0.001; ///< of the means of α and δ
constexpr double kMinTolerance = 0.02;   ///< of the minimum α, which one element decides
constexpr double kAngleTolerance = 1.5;  ///< degrees, likewise

constexpr Recorded kRecorded[] = {
    {"square", 1e4, ImproveLevel::Default, 0.9979, 0.865, 39.0, 0.9885},
    {"disc", 1e4, ImproveLevel::Default, 0.9898, 0.842, 39.9, 0.9496},
    {"ramp", 2e4, ImproveLevel::Default, 0.9949, 0.199, 6.6, 0.9688},
    {"graded", 0.1, ImproveLevel::Default, 0.9866, 0.820, 35.7, 0.9605},
    {"graded", 0.1, ImproveLevel::Best, 0.9906, 0.862, 39.0, 0.9618},
    {"graded", 0.05, ImproveLevel::Best, 0.9908, 0.863, 39.1, 0.9618},
    {"disc", 1e4, ImproveLevel::Best, 0.9962, 0.919, 43.8, 0.9742},
    {"disc", 1e5, ImproveLevel::Best, 0.9981, 0.918, 42.4, 0.9787},
};

void checkNear(const char *what, double value, double recorded, double tolerance) {
    CHECK_MESSAGE(std::abs(value - recorded) <= tolerance, what, " is ", value, "; recorded was ", recorded);
}

} // namespace

TEST_CASE("Quality: shape and spacing of the standard scenes are those recorded, neither worse nor better") {
    for (const Recorded &recorded : kRecorded) {
        CAPTURE(std::string(recorded.scene));
        CAPTURE(recorded.size);
        CAPTURE(std::string(wordOf(recorded.level)));
        std::optional<bench::Scene> made = bench::makeScene(recorded.scene, recorded.size);
        REQUIRE(made);
        made->job.options.improve = recorded.level;
        const Result<MeshingOutcome> outcome = meshDomain(made->job);
        REQUIRE(outcome);
        const MeshQuality q = measureQuality(outcome->mesh, outcome->spacing.get());
        checkNear("the mean of α", q.alphaMean, recorded.alphaMean, kMeanTolerance);
        checkNear("the minimum α", q.alphaMin, recorded.alphaMin, kMinTolerance);
        checkNear("the minimum angle", q.minAngle, recorded.minAngle, kAngleTolerance);
        checkNear("the mean of δ", q.deltaMean, recorded.deltaMean, kMeanTolerance);
        CHECK(q.flat == 0);
    }
}
