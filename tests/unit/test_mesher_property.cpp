#include "core/engine/mesh/verify.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/mesher/timeline.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using forefront::testing::kSeedStep;
using forefront::testing::randomDomain;

namespace {

struct RunResult {
    std::uint64_t hash = 0;
    std::uint64_t tested = 0;
};

RunResult runOn(const PreparedJob &prepared, Method method, GridKind grid) {
    MeshingOptions options;
    options.method = method;
    options.grid = grid;
    auto mesher = Mesher::create(prepared.boundary, prepared.spacing, options);
    mesher->advance(~std::uint64_t{0});
    return {meshHash(toMesh(mesher->state(), *prepared.boundary)), mesher->state().work.tested};
}

/// Explains every other advance before it is done; does every seventh, undoes it and does it again.
RunResult runTracedAndStepped(const PreparedJob &prepared, Method method) {
    MeshingOptions options;
    options.method = method;
    Timeline timeline(Mesher::create(prepared.boundary, prepared.spacing, options));
    while (!timeline.complete()) {
        if (timeline.position() % 2 == 0) {
            timeline.mesher().explainNext();
        }
        timeline.forward(1);
        if (timeline.position() % 7 == 0) {
            timeline.back(std::min<std::uint64_t>(5, timeline.position()));
            timeline.forward(5);
        }
    }
    timeline.forward(timeline.known());
    return {meshHash(toMesh(timeline.mesher().state(), *prepared.boundary)), timeline.mesher().state().work.tested};
}

} // namespace

TEST_CASE("Meshing: the same mesh for every grid, traced or not, stepped or run, on 200 random domains") {
    for (std::uint64_t seed = 0; seed < 200; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job;
        job.domain = randomDomain(seed);
        const Result<PreparedJob> prepared = prepare(job);
        REQUIRE_MESSAGE(prepared, samples::list(prepared ? Diagnostics{} : prepared.faults()));
        for (const Method method : {Method::Fast, Method::Classic}) {
            const RunResult none = runOn(*prepared, method, GridKind::None);
            std::vector<RunResult> runs{runTracedAndStepped(*prepared, method)};
            for (const GridKind grid : valuesOf<GridKind>()) {
                runs.push_back(runOn(*prepared, method, grid));
            }
            for (const RunResult &run : runs) {
                REQUIRE(run.hash == none.hash);
                if (method == Method::Classic) { // the fast one stops at the first obstacle that the grid delivers
                    REQUIRE(run.tested == none.tested);
                }
            }
        }
    }
}

TEST_CASE("Meshing: 2,000 hostile random domains give valid meshes") {
    for (std::uint64_t seed = 1000; seed < 3000; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job;
        job.domain = randomDomain(seed);
        job.options.keepBoundary = seed % 3 == 0;
        job.options.improve = static_cast<ImproveLevel>(seed % 3);
        job.options.method = seed % 4 < 3 ? Method::Fast : Method::Classic;
        if (seed % 5 == 0) {
            job.spacing.size = job.domain.bounds().diagonal() / 20.0;
        }
        const Result<MeshingOutcome> outcome = meshDomain(job);
        REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
        const Diagnostics faults = verifyAgainst(outcome->mesh, *outcome->boundary);
        REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
    }
}
