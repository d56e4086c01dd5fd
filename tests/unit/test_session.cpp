#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/meshing_session.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

using namespace forefront;
using namespace std::chrono_literals;

namespace {

std::shared_ptr<const MeshingJob> squareWithHole(double size, ImproveLevel improve = ImproveLevel::Default) {
    auto job = std::make_shared<MeshingJob>();
    job->domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        job->domain.segments.push_back({i, (i + 1) % 4, 1, SegmentRole::Boundary});
        job->domain.segments.push_back({4 + i, 4 + (i + 1) % 4, 2, SegmentRole::Boundary});
    }
    job->spacing.size = size;
    job->options.improve = improve;
    return job;
}

using SnapshotPtr = std::shared_ptr<const SessionSnapshot>;

/// Waits for a condition, however slow the machine is; a hang is left to the time limit of the test runner.
SnapshotPtr waitFor(const MeshingSession &session, const std::function<bool(const SessionSnapshot &)> &condition) {
    SnapshotPtr snapshot = session.latest();
    while (!condition(*snapshot)) {
        snapshot = session.waitForNews(snapshot->sequence);
    }
    return snapshot;
}

} // namespace

TEST_CASE("MeshingSession: meshes to the end and publishes the improved mesh") {
    std::atomic<int> wakes = 0;
    MeshingSession session([&] { ++wakes; });
    const auto job = squareWithHole(0.1);
    session.start(job, StartMode::Run);
    const SnapshotPtr end = waitFor(session, [](const SessionSnapshot &s) { return s.state == RunState::Finished; });
    CHECK(wakes > 0);
    CHECK(end->complete);
    CHECK(end->improved);
    CHECK(end->advance == end->known);
    CHECK(end->frontSegments == 0);
    REQUIRE(end->mesh);
    CHECK(verifyAgainst(end->mesh->mesh, *end->boundary).empty());
    const Result<MeshingOutcome> batch = meshDomain(*job);
    REQUIRE(batch);
    CHECK(end->meshHash == meshHash(batch->mesh));
}

TEST_CASE("MeshingSession: N advances forward and N back lead to the same state hash") {
    MeshingSession session;
    session.start(squareWithHole(0.1), StartMode::Pause);
    const SnapshotPtr start = session.wait();
    CHECK(start->state == RunState::Paused);
    CHECK(start->advance == 0);
    session.step(Granularity::Advance, 150);
    const SnapshotPtr there = session.wait();
    CHECK(there->advance == 150);
    CHECK(there->stateHash != start->stateHash);
    session.step(Granularity::Advance, 300);
    session.step(Granularity::Advance, -300);
    CHECK(session.wait()->stateHash == there->stateHash);
    session.seek(0);
    CHECK(session.wait()->stateHash == start->stateHash);
    session.seek(150);
    CHECK(session.wait()->stateHash == there->stateHash);
}

TEST_CASE("MeshingSession: stepping, playing and running give the same mesh") {
    std::uint64_t hashes[3];
    for (int way = 0; way < 3; ++way) {
        MeshingSession session;
        session.start(squareWithHole(0.2), way == 0 ? StartMode::Run : StartMode::Pause);
        if (way == 1) {
            for (int i = 0; i < 5000 && session.wait()->state != RunState::Finished; ++i) {
                session.step(Granularity::Advance, 1);
            }
        } else if (way == 2) {
            session.play(1e5);
        }
        const SnapshotPtr end =
            waitFor(session, [](const SessionSnapshot &s) { return s.state == RunState::Finished; });
        hashes[way] = end->meshHash;
    }
    CHECK(hashes[0] != 0);
    CHECK(hashes[0] == hashes[1]);
    CHECK(hashes[0] == hashes[2]);
}

TEST_CASE("MeshingSession: event steps move through one advance and back") {
    MeshingSession session;
    session.want({true, true, true, true});
    session.start(squareWithHole(0.2), StartMode::Pause);
    session.step(Granularity::Advance, 20);
    const SnapshotPtr rest = session.wait();
    REQUIRE(rest->explanation);
    CHECK(rest->explanation->advance == 20);
    CHECK(rest->eventCursor == rest->eventCount);
    CHECK_FALSE(rest->cells->empty());
    std::size_t steps = 0;
    SnapshotPtr now = rest;
    while (now->advance == 20 && steps < 1000) {
        session.step(Granularity::Event, 1);
        now = session.wait();
        ++steps;
        if (now->advance == 20) {
            REQUIRE(now->explanation->advance == 21);
            CHECK(now->eventCursor == steps - 1);
            CHECK(now->stateHash == rest->stateHash);
        }
    }
    CHECK(now->advance == 21);
    CHECK(steps >= 6);
    session.step(Granularity::Event, -static_cast<std::int64_t>(steps));
    const SnapshotPtr back = session.wait();
    CHECK(back->advance == 20);
    CHECK(back->stateHash == rest->stateHash);
    CHECK(back->explanation->advance == 20);
}

TEST_CASE("MeshingSession: layers lead forward and back over the same positions") {
    MeshingSession session;
    session.start(squareWithHole(0.1), StartMode::Pause);
    std::vector<std::uint64_t> positions;
    for (int layer = 0; layer < 4; ++layer) {
        session.step(Granularity::Layer, 1);
        positions.push_back(session.wait()->advance);
    }
    CHECK(positions[0] == session.wait()->boundary->segments.size());
    for (int layer = 2; layer >= 0; --layer) {
        session.step(Granularity::Layer, -1);
        CHECK(session.wait()->advance == positions[static_cast<std::size_t>(layer)]);
    }
    session.step(Granularity::Layer, -1);
    CHECK(session.wait()->advance == 0);
}

TEST_CASE("MeshingSession: cancelling stops promptly and keeps the partial mesh") {
    MeshingSession session;
    session.want({false, false, false, false});
    session.start(squareWithHole(0.004), StartMode::Run);
    waitFor(session, [](const SessionSnapshot &s) { return s.advance > 2000; });
    session.cancel();
    const SnapshotPtr stopped = session.wait();
    CHECK(stopped->state == RunState::Cancelled);
    CHECK(stopped->advance > 0);
    CHECK_FALSE(stopped->complete);
    session.want({true, true, false, false});
    session.step(Granularity::Advance, -10);
    const SnapshotPtr back = session.wait();
    CHECK(back->advance == stopped->advance - 10);
    CHECK_FALSE(back->mesh->mesh.elements.empty());
}

TEST_CASE("MeshingSession: reports why a domain is refused, and can start again") {
    auto crossing = std::make_shared<MeshingJob>(*squareWithHole(0.1));
    std::swap(crossing->domain.nodes[1], crossing->domain.nodes[2]);
    MeshingSession session;
    session.start(crossing, StartMode::Run);
    const SnapshotPtr failed = waitFor(session, [](const SessionSnapshot &s) { return s.state == RunState::Failed; });
    REQUIRE_FALSE(failed->diagnostics.empty());
    CHECK(failed->diagnostics.front().at.has_value());
    session.start(squareWithHole(0.3), StartMode::Run);
    waitFor(session, [](const SessionSnapshot &s) { return s.state == RunState::Finished && s.run == 2; });
}

TEST_CASE("MeshingSession: a refused start leaves the previous run unchanged") {
    auto crossing = std::make_shared<MeshingJob>(*squareWithHole(0.1));
    std::swap(crossing->domain.nodes[1], crossing->domain.nodes[2]);
    MeshingSession session;
    session.start(squareWithHole(0.1), StartMode::Pause);
    session.step(Granularity::Advance, 20);
    const SnapshotPtr before = session.wait();
    REQUIRE(before->advance == 20);
    CHECK(before->shownRun == 1);
    session.start(crossing, StartMode::Run);
    const SnapshotPtr after = session.wait();
    CHECK_FALSE(after->diagnostics.empty());
    CHECK(after->run == 2);
    CHECK(after->shownRun == 1);
    CHECK(after->stateHash != 0);
    session.seek(20);
    CHECK(session.wait()->stateHash == before->stateHash);
    session.start(squareWithHole(0.3), StartMode::Run);
    const SnapshotPtr next = session.wait();
    CHECK(next->state == RunState::Finished);
    CHECK(next->shownRun == 3);
    CHECK(next->diagnostics.empty());
}

TEST_CASE("MeshingSession: still works after any order of commands") {
    MeshingSession session;
    std::uint64_t random = 12345;
    const auto next = [&random] {
        random = random * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<std::uint32_t>(random >> 33);
    };
    const auto job = squareWithHole(0.05);
    for (int i = 0; i < 300; ++i) {
        switch (next() % 12) {
        case 0:
            session.start(job, next() % 2 == 0 ? StartMode::Run : StartMode::Pause);
            break;
        case 1:
            session.finish();
            break;
        case 2:
            session.play(next() % 2 == 0 ? 5e4 : -5e4);
            break;
        case 3:
            session.pause();
            break;
        case 4:
            session.step(Granularity::Event, static_cast<int>(next() % 41) - 20);
            break;
        case 5:
            session.step(Granularity::Advance, static_cast<int>(next() % 2001) - 1000);
            break;
        case 6:
            session.step(Granularity::Layer, static_cast<int>(next() % 3) - 1);
            break;
        case 7:
            session.seek(next() % 20'000);
            break;
        case 8:
            session.cancel();
            break;
        case 9:
            session.want({next() % 2 == 0, next() % 2 == 0, next() % 2 == 0, next() % 2 == 0});
            break;
        case 10:
            std::this_thread::sleep_for(1ms);
            break;
        default:
            CHECK(session.latest() != nullptr);
            break;
        }
    }
    session.want({});
    session.start(job, StartMode::Run);
    const SnapshotPtr end = waitFor(session, [](const SessionSnapshot &s) { return s.state == RunState::Finished; });
    const Result<MeshingOutcome> batch = meshDomain(*job);
    REQUIRE(batch);
    CHECK(end->meshHash == meshHash(batch->mesh));
}
