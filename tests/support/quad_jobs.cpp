#include "tests/support/quad_jobs.hpp"

#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/quad_start.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace forefront::testing {

std::vector<Vec2> discOutline(unsigned count, double radius) {
    std::vector<Vec2> nodes;
    for (unsigned i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return nodes;
}

std::vector<Vec2> gearOutline() {
    std::vector<Vec2> nodes;
    for (unsigned tooth = 0; tooth < 5; ++tooth) {
        for (const auto &[part, radius] : {std::pair{-0.25, 1.0}, std::pair{-0.15, 1.24}, std::pair{-0.05, 1.4},
                                           std::pair{0.05, 1.4}, std::pair{0.15, 1.24}, std::pair{0.25, 1.0}}) {
            const double angle = 2.0 * std::numbers::pi * (tooth + part) / 5.0;
            nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
    }
    return nodes;
}

MeshingJob steppedQuads(const std::vector<Vec2> &outline, const std::string &spacing) {
    MeshingJob job;
    addLoop(job.domain, outline);
    job.spacing.expression = spacing;
    job.options.elements = Elements::Quads;
    return job;
}

std::map<std::string, MeshingJob> steppedJobs() {
    std::map<std::string, MeshingJob> jobs;
    jobs["disc"] = steppedQuads(discOutline(60, 1.0), "0.1");
    jobs["corner"] = steppedQuads({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, "0.1");
    jobs["graded"] = steppedQuads({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, "max(0.05, 0.2*abs(x-1))");
    MeshingJob holes = steppedQuads({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, "0.3");
    addLoop(holes.domain, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}, 2);
    jobs["regions"] = holes;
    MeshingJob kept = steppedQuads(discOutline(31, 1.0), "0.2");
    kept.options.keepBoundary = true;
    jobs["kept"] = kept;
    MeshingJob gear = steppedQuads(gearOutline(), "0.08");
    gear.options.keepBoundary = true;
    jobs["gear"] = gear;
    MeshingJob mixed = steppedQuads({{0, 0}, {3, 0.2}, {2.5, 2}, {1, 1.2}}, "0.15");
    mixed.options.elements = Elements::Mixed;
    jobs["mixed"] = mixed;
    MeshingJob raw = jobs["disc"];
    raw.options.improve = ImproveLevel::None;
    jobs["not improved"] = raw;
    MeshingJob second = jobs["disc"];
    second.options.order = ElementOrder::Second;
    jobs["second order"] = second;
    return jobs;
}

MeshStepper quadStepper(const MeshingJob &job) {
    Result<MeshStepper> stepper = MeshStepper::create(job);
    REQUIRE(stepper);
    return *std::move(stepper);
}

std::uint64_t hashOfMeshed(const MeshingJob &job) {
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE(outcome);
    return meshHash(outcome->mesh);
}

std::unique_ptr<ColouredMesher> colouredMesher(const MeshingJob &job, std::uint32_t rows,
                                               std::shared_ptr<const ColouredBoundary> &boundary) {
    Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    MeshingState state{.job = job, .prepared = *std::move(prepared)};
    const Result<QuadStart> start = chooseQuadFront(state, {});
    REQUIRE(start);
    boundary = start->boundary;
    return ColouredMesher::create(boundary, state.prepared.spacing, job.options, rows);
}

} // namespace forefront::testing
