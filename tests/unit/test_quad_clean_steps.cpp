#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesher/timeline.hpp"
#include "core/engine/quads/coloured_mesher.hpp"
#include "core/engine/quads/quad_mesh.hpp"
#include "core/engine/quads/quad_record.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/quad_jobs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {

using namespace testing;

TEST_CASE("Quads stepped: the steps of the clean-up lead forward and back to the same meshes") {
    for (const auto &[name, job] : steppedJobs()) {
        CAPTURE(name);
        MeshStepper stepper = quadStepper(job);
        stepper.stepImprovement();
        REQUIRE(stepper.finish());
        const std::size_t steps = stepper.snapshot()->improveSteps;
        const std::uint64_t known = stepper.known();
        REQUIRE(steps >= 1);
        stepper.seek(known);
        std::vector<std::uint64_t> hashes{meshHash(stepper.mesh())};
        for (std::size_t k = 1; k <= steps; ++k) {
            stepper.step(Granularity::Advance, 1);
            const std::shared_ptr<const SessionSnapshot> here = stepper.snapshot();
            REQUIRE(here->improvement);
            CHECK(here->improvement->number == k);
            CHECK(here->improvement->quads);
            CHECK(caption(*here->improvement, steps).starts_with("Clean-up " + std::to_string(k) + " of "));
            hashes.push_back(meshHash(stepper.mesh()));
        }
        CHECK(stepper.atEnd());
        CHECK(hashes.back() == hashOfMeshed(job));
        for (std::size_t k = steps; k-- > 0;) {
            stepper.step(Granularity::Advance, -1);
            REQUIRE(meshHash(stepper.mesh()) == hashes[k]);
        }
        CHECK(stepper.position() == known);
        CHECK(stepper.snapshot()->improveStep == 0);
    }
}

TEST_CASE("Quads stepped: a step of the clean-up lists what it changed, and its figures are true") {
    MeshStepper stepper = quadStepper(steppedJobs()["disc"]);
    stepper.stepImprovement();
    REQUIRE(stepper.finish());
    const std::size_t steps = stepper.snapshot()->improveSteps;
    stepper.seek(stepper.known());
    std::map<ImproveChange, std::size_t> kinds;
    std::optional<QuadFigures> before;
    for (std::size_t k = 1; k <= steps; ++k) {
        const Mesh old = stepper.mesh();
        stepper.step(Granularity::Advance, 1);
        const std::shared_ptr<const SessionSnapshot> here = stepper.snapshot();
        const ImproveStep &step = *here->improvement;
        const Mesh now = stepper.mesh();
        ++kinds[step.change];
        if (before) {
            CHECK(step.quadsBefore.irregular == before->irregular);
            CHECK(step.quadsBefore.jacobianMin == before->jacobianMin);
        }
        before = step.quadsAfter;
        const auto grown =
            static_cast<std::ptrdiff_t>(now.nodes.size()) - static_cast<std::ptrdiff_t>(old.nodes.size());
        CHECK(grown == static_cast<std::ptrdiff_t>(step.addedNodes.size()) -
                           static_cast<std::ptrdiff_t>(step.removedNodes.size()));
        for (const ImproveStep::Move &move : step.moves) {
            CHECK(now.nodes[index(move.node)] == move.to);
            CHECK_FALSE(move.from == move.to);
        }
        switch (step.change) {
        case ImproveChange::Sweep:
        case ImproveChange::Polish:
            CHECK_FALSE(step.moves.empty());
            CHECK(step.elements.empty());
            break;
        case ImproveChange::Rotate:
            CHECK(step.elements.size() == 2);
            CHECK(step.addedEdges.size() == 1);
            CHECK(step.removedEdges.size() == 1);
            break;
        case ImproveChange::Collapse:
            CHECK(now.elementCount() + 1 == old.elementCount());
            CHECK(step.removedNodes.size() == 1);
            break;
        case ImproveChange::Split:
            CHECK(now.elementCount() == old.elementCount() + 1);
            CHECK(step.addedNodes.size() == 1);
            break;
        default:
            break;
        }
    }
    CHECK(kinds[ImproveChange::Pair] == 1);
    CHECK(kinds[ImproveChange::Sweep] > 3);
    CHECK(kinds[ImproveChange::Collapse] + kinds[ImproveChange::Rotate] + kinds[ImproveChange::Split] > 3);
    CHECK(before->irregular < 30);
}

TEST_CASE("QuadRecord: beyond its memory, and by passes, it ends with the same mesh") {
    const MeshingJob job = steppedJobs()["graded"];
    std::shared_ptr<const ColouredBoundary> boundary;
    const auto record = [&](QuadRecord::Detail detail, std::size_t bytes) {
        const std::unique_ptr<ColouredMesher> front = colouredMesher(job, rowsOfFront(true), boundary);
        front->advance(1'000'000, nullptr);
        QuadRecord result(front->joinedCells(), front->boundary(), detail, bytes);
        QuadMesh mesh = joinFront(front->triangles(), *front, job.options, &result);
        cleanUp(mesh, front->spacing(), job.options, {}, &result);
        result.moveTo(result.steps());
        QuadReport report;
        CHECK(meshHash(result.mesh()) == meshHash(toMesh(std::move(mesh), boundary->domain, report)));
        const std::size_t steps = result.steps();
        const std::uint64_t last = meshHash(result.mesh());
        result.moveTo(1);
        CHECK(meshHash(result.mesh()) != last);
        result.moveTo(steps);
        CHECK(meshHash(result.mesh()) == last);
        return std::pair{steps, result.bytes()};
    };
    const auto [steps, bytes] = record(QuadRecord::Detail::Changes, QuadRecord::kMaxBytes);
    CHECK(steps > 50);
    const auto [few, least] = record(QuadRecord::Detail::Changes, bytes / 2);
    CHECK(few < steps);
    CHECK(few > 3);
    CHECK(least < bytes);
    const auto [passes, perPass] = record(QuadRecord::Detail::Passes, QuadRecord::kMaxBytes);
    CHECK(passes > 3);
    CHECK(passes < 20);
    CHECK(perPass < bytes);
}

TEST_CASE("Quads stepped: the passes of the clean-up can be stepped, and a stop is found by its condition") {
    MeshStepper stepper = quadStepper(steppedJobs()["disc"]);
    stepper.stepImprovement();
    REQUIRE(stepper.finish());
    const std::size_t steps = stepper.snapshot()->improveSteps;
    stepper.seek(stepper.known());
    std::size_t passes = 0;
    while (!stepper.atEnd() && passes < 100) {
        stepper.step(Granularity::Layer, 1);
        ++passes;
    }
    CHECK(stepper.atEnd());
    CHECK(passes > 3);
    CHECK(passes < steps);
    stepper.seek(0);
    Breakpoints rejections;
    rejections.set(StopKind::Rejection, true);
    stepper.stopAt(rejections);
    const std::optional<Stop> stop = stepper.seekStop(true);
    REQUIRE(stop);
    CHECK(stop->kind == StopKind::Rejection);
    const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
    CHECK(std::ranges::any_of(told->candidates, [](const CandidateTrace &candidate) {
        return candidate.verdict != Verdict::Accepted && candidate.verdict != Verdict::NotTried;
    }));
}

} // namespace forefront
