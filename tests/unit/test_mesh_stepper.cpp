#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/engine/session/meshing_session.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

MeshingJob frameJob(double size, Method method = Method::Fast) {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    addLoop(job.domain, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, 2);
    job.spacing.size = size;
    job.options.method = method;
    return job;
}

MeshStepper stepperOf(MeshingJob job) {
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job));
    REQUIRE(stepper);
    return *std::move(stepper);
}

} // namespace

TEST_CASE("MeshStepper: stepping to the end gives the mesh of meshDomain") {
    for (const Method method : {Method::Fast, Method::Classic}) {
        const MeshingJob job = frameJob(0.2, method);
        const Result<MeshingOutcome> batch = meshDomain(job);
        REQUIRE(batch);
        MeshStepper stepper = stepperOf(job);
        CHECK(stepper.position() == 0);
        CHECK_FALSE(stepper.complete());
        std::uint64_t steps = 0;
        while (!stepper.atEnd()) {
            REQUIRE(stepper.advance() == 1);
            ++steps;
        }
        CHECK(stepper.position() == steps);
        CHECK(stepper.complete());
        CHECK(stepper.advance() == 0);
        CHECK(stepper.statistics().advances == steps);
        CHECK(stepper.front().empty());
        CHECK(verify(stepper.mesh()).empty());
        CHECK(meshHash(stepper.mesh()) != meshHash(batch->mesh)); // not improved yet
        CHECK(stepper.finish());
        CHECK(meshHash(stepper.mesh()) == meshHash(batch->mesh));
        CHECK(stepper.snapshot()->state == RunState::Finished);
        CHECK(stepper.snapshot()->meshHash == meshHash(batch->mesh));
    }
}

TEST_CASE("MeshStepper: the way to a position does not matter") {
    MeshStepper stepper = stepperOf(frameJob(0.1));
    const std::uint64_t start = stepper.snapshot()->stateHash;
    CHECK(stepper.advance(150) == 150);
    const std::uint64_t there = stepper.snapshot()->stateHash;
    const std::vector<FrontSegmentView> front = stepper.front();
    CHECK(front.size() == stepper.snapshot()->frontSegments);
    CHECK(there != start);
    CHECK(stepper.advance(300) == 300);
    CHECK(stepper.retreat(300) == 300);
    CHECK(stepper.snapshot()->stateHash == there);
    CHECK(stepper.retreat(1000) == 150);
    CHECK(stepper.snapshot()->stateHash == start);
    CHECK(stepper.seek(150));
    CHECK(stepper.snapshot()->stateHash == there);
    CHECK(stepper.known() == 450);
    CHECK(stepper.finish());
    CHECK(stepper.seek(150));
    CHECK(stepper.snapshot()->stateHash == there);
    CHECK(stepper.snapshot()->state == RunState::Paused);
}

TEST_CASE("MeshStepper: shows what MeshingSession shows") {
    const auto job = std::make_shared<const MeshingJob>(frameJob(0.2));
    const SnapshotLayers all{true, true, true, true};
    MeshingSession session;
    session.want(all);
    session.start(job, StartMode::Pause);
    MeshStepper stepper = stepperOf(*job);
    CHECK(stepper.explanation() == nullptr);
    for (const std::uint64_t position : {0U, 1U, 57U, 20U, 9999U}) {
        session.seek(position);
        const auto theirs = session.wait();
        position > 1000 ? stepper.finish() : stepper.seek(position);
        const auto ours = stepper.snapshot(all);
        CHECK(ours->advance == theirs->advance);
        CHECK(ours->state == theirs->state);
        CHECK(ours->stateHash == theirs->stateHash);
        CHECK(ours->frontSegments == theirs->frontSegments);
        CHECK(ours->cells->size() == theirs->cells->size());
        CHECK(ours->work.tested == theirs->work.tested);
        // A session looks ahead, so that its timeline has its length from the start; the stepper's is as long as it
        // got.
        REQUIRE(ours->marks->size() <= theirs->marks->size());
        CHECK(std::equal(
            ours->marks->begin(), ours->marks->end(), theirs->marks->begin(),
            [](const TimelineMark &a, const TimelineMark &b) { return a.advance == b.advance && a.kind == b.kind; }));
        CHECK(meshHash(ours->mesh->mesh) == meshHash(theirs->mesh->mesh));
        REQUIRE((ours->explanation == nullptr) == (theirs->explanation == nullptr));
        if (ours->explanation) {
            CHECK(stepper.explanation()->advance == ours->advance);
            CHECK(caption(*ours->explanation, ours->eventCursor) == caption(*theirs->explanation, theirs->eventCursor));
        }
    }
}

TEST_CASE("MeshStepper: steps by events and layers, and stops at conditions") {
    MeshStepper stepper = stepperOf(frameJob(0.2, Method::Classic));
    stepper.step(Granularity::Layer, 1);
    CHECK(stepper.position() == stepper.snapshot()->boundary->segments.size());
    stepper.step(Granularity::Layer, -1);
    CHECK(stepper.position() == 0);
    stepper.step(Granularity::Event, 3);
    CHECK(stepper.position() == 0);
    CHECK(stepper.explanation()->advance == 1);
    Breakpoints closures;
    closures.set(StopKind::Join, true);
    stepper.stopAt(closures);
    const std::optional<Stop> stop = stepper.seekStop(true);
    REQUIRE(stop);
    CHECK(stop->kind == StopKind::Join);
    const std::uint64_t joined = stepper.position();
    CHECK_FALSE(stepper.atEnd());
    stepper.finish();
    CHECK(stepper.seekStop(false));
    CHECK(stepper.position() == joined);
    stepper.seek(0);
    CHECK_FALSE(stepper.seekBirth({0.1, 0.1}, 0.0)); // it is made by this move
    const std::uint64_t made = stepper.position();
    CHECK(made > 0);
    stepper.finish();
    const std::optional<Birth> birth = stepper.seekBirth({0.1, 0.1}, 0.0);
    REQUIRE(birth);
    CHECK(birth->advance == made);
    CHECK(stepper.position() == made);
}

TEST_CASE("MeshStepper: a refused job says why, and cancelling keeps the position") {
    MeshingJob crossing = frameJob(0.2);
    std::swap(crossing.domain.nodes[1], crossing.domain.nodes[2]);
    const Result<MeshStepper> refused = MeshStepper::create(crossing);
    REQUIRE_FALSE(refused);
    CHECK(refused.faults().front().at.has_value());

    MeshStepper stepper = stepperOf(frameJob(0.02));
    std::stop_source stop;
    const Progress progress{[&](std::string_view, double) { stop.request_stop(); }, stop.get_token()};
    CHECK_FALSE(stepper.finish(progress));
    const std::uint64_t reached = stepper.position();
    CHECK(reached > 0);
    CHECK_FALSE(stepper.atEnd());
    CHECK(stepper.retreat(10) == 10);
    CHECK(stepper.finish());
    CHECK(stepper.atEnd());
}

TEST_CASE("MeshStepper: an exception of a callback reaches the caller and discards the run") {
    MeshStepper stepper = stepperOf(frameJob(0.05));
    CHECK_THROWS_AS(stepper.finish({[](std::string_view, double) { throw std::string("stop"); }, {}}), std::string);
    CHECK(stepper.empty());
    CHECK_THROWS_AS(
        static_cast<void>(MeshStepper::create(frameJob(0.05), {[](std::string_view, double) { throw 1; }, {}})), int);
}

TEST_CASE("MeshingSession: wait() returns what the last command led to") {
    MeshingSession session;
    CHECK(session.wait()->state == RunState::Empty);
    const auto job = std::make_shared<const MeshingJob>(frameJob(0.1));
    session.start(job, StartMode::Run);
    const auto end = session.wait();
    CHECK(end->state == RunState::Finished);
    CHECK_FALSE(session.busy());
    session.seek(10);
    CHECK(session.wait()->advance == 10);
    session.play(1e4); // to the end
    CHECK(session.wait()->state == RunState::Finished);
    std::set<std::uint64_t> seen;
    session.start(job, StartMode::Run);
    for (auto news = session.latest(); session.busy(); news = session.waitForNews(news->sequence)) {
        seen.insert(news->sequence);
    }
    CHECK(seen.size() > 1);
    const auto last = session.latest();
    CHECK(session.waitForNews(last->sequence) == last); // there will be none
}

} // namespace forefront
