#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;

namespace {

/// A rectangle of 200 x 2 with a node at every unit step, one corner of which is mistyped; turned by quarter turns.
MeshingJob mistyped(double height, int quarterTurns) {
    std::vector<Vec2> loop;
    for (int i = 0; i <= 200; ++i) {
        loop.push_back({static_cast<double>(i), 0.0});
    }
    loop.push_back({200, height});
    for (int i = 199; i >= 0; --i) {
        loop.push_back({static_cast<double>(i), 2.0});
    }
    for (Vec2 &p : loop) {
        for (int k = 0; k < quarterTurns; ++k) {
            p = leftNormal(p);
        }
    }
    MeshingJob job;
    addLoop(job.domain, loop);
    return job;
}

} // namespace

TEST_CASE("Needles: one node far away does not make the work per element grow") {
    for (const Method method : {Method::Fast, Method::Classic}) {
        for (int turns = 0; turns < 4; ++turns) {
            const auto near = [&] {
                MeshingJob job = mistyped(2.0, turns);
                job.options.method = method;
                return meshDomain(job);
            }();
            REQUIRE(near);
            for (const double height : {1e6, 1e10, 1e14}) {
                CAPTURE(height);
                CAPTURE(turns);
                CAPTURE(std::string(wordOf(method)));
                MeshingJob job = mistyped(height, turns);
                job.options.method = method;
                const auto outcome = meshDomain(job);
                REQUIRE(outcome);
                CHECK(outcome->mesh.triangles().size() >= 400);
                const auto perElement = [](const MeshingOutcome &of) {
                    return static_cast<double>(of.work.delivered) / static_cast<double>(of.mesh.triangles().size());
                };
                CHECK(perElement(*outcome) < 4.0 * perElement(*near));
                const Diagnostics faults = verifyAgainst(outcome->mesh, *outcome->boundary);
                CHECK_MESSAGE(!hasErrors(faults), samples::list(faults));
            }
        }
    }
}

TEST_CASE("Needles: the mesh does not depend on the grid") {
    for (int turns = 0; turns < 4; ++turns) {
        MeshingJob job = mistyped(1e14, turns);
        job.options.grid = GridKind::None;
        const auto none = meshDomain(job);
        REQUIRE(none);
        for (const GridKind grid : valuesOf<GridKind>()) {
            job.options.grid = grid;
            const auto outcome = meshDomain(job);
            REQUIRE(outcome);
            CHECK(meshHash(outcome->mesh) == meshHash(none->mesh));
        }
    }
}
