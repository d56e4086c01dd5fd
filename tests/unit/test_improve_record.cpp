#include "core/engine/improve/improve.hpp"
#include "core/engine/improve/improve_record.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace forefront;

namespace recorded {

std::uint64_t hashOf(const TriMesh &mesh) {
    return meshHash(Mesh(mesh));
}

/// Returns the job of a plate with a hole, meshed by the classic method.
std::shared_ptr<MeshingJob> plate(double size, ImproveLevel level) {
    auto job = std::make_shared<MeshingJob>();
    job->domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        job->domain.segments.push_back({i, (i + 1) % 4, 1, SegmentRole::Boundary});
        job->domain.segments.push_back({4 + i, 4 + (i + 1) % 4, 2, SegmentRole::Boundary});
    }
    job->spacing.size = size;
    job->options.method = Method::Classic;
    job->options.improve = level;
    return job;
}

/// Improves a sample with a record of it.
ImproveRecord recordOf(TriMesh &mesh, ImproveLevel level, std::size_t maxBytes = ImproveRecord::kMaxBytes) {
    ImproveRecord record(mesh, maxBytes);
    improve(mesh, {.level = level, .threads = 2, .spacing = nullptr, .watch = &record});
    return record;
}

} // namespace recorded

TEST_CASE("Improvement record: leads from the mesh before to the improved one, and back over the same meshes") {
    for (const ImproveLevel level : {ImproveLevel::Default, ImproveLevel::Best}) {
        const TriMesh before = samples::constrainedSquare(14, 0.24, {}, 5);
        TriMesh alone = before, mesh = before;
        const ImproveReport report = improve(alone, {level, 1, nullptr});
        ImproveRecord record = recorded::recordOf(mesh, level);
        CHECK(recorded::hashOf(mesh) == recorded::hashOf(alone)); // nobody notices that he is watched
        REQUIRE(record.steps() > 10);
        CHECK(record.position() == record.steps());
        CHECK(recorded::hashOf(record.mesh()) == recorded::hashOf(mesh));
        std::vector<std::uint64_t> hashes;
        std::multiset<ImproveChange> changes;
        for (std::size_t step = 0; step <= record.steps(); ++step) {
            record.moveTo(step);
            const TriMesh shown = record.mesh();
            hashes.push_back(recorded::hashOf(shown));
            CHECK((step == 0 || hashes[step] != hashes[step - 1]));
            if (step > 0) {
                const ImproveStep done = record.step();
                changes.insert(done.change);
                CHECK(done.number == step);
                CHECK(done.after.alphaMin == figuresOf(shown).alphaMin);
                for (const ImproveStep::Move &move : done.moves) {
                    REQUIRE(shown.nodes[index(move.node)] == move.to);
                }
            }
        }
        CHECK(hashes.front() == recorded::hashOf(before));
        for (std::size_t step = record.steps(); step-- > 0;) {
            record.moveTo(step);
            REQUIRE(recorded::hashOf(record.mesh()) == hashes[step]);
        }
        CHECK(changes.count(ImproveChange::Merge) == report.merges);
        CHECK(changes.count(ImproveChange::Divide) == report.divisions);
        CHECK(changes.count(ImproveChange::Swap) + changes.count(ImproveChange::RelaxedSwap) <= report.swaps);
        CHECK(changes.count(ImproveChange::Remainder) == 0);
        CHECK(changes.count(ImproveChange::Sweep) >= 8);
        CHECK(record.passEnds().back() == record.steps());
        CHECK(std::ranges::is_sorted(record.passEnds()));
        CHECK(record.passEnds().size() < record.steps());
    }
}

TEST_CASE("Improvement record: tells what a step changes") {
    TriMesh mesh = samples::constrainedSquare(14, 0.24, {}, 5);
    ImproveRecord record = recorded::recordOf(mesh, ImproveLevel::Best);
    bool merged = false, divided = false, swapped = false;
    for (std::size_t number = 1; number <= record.steps(); ++number) {
        record.moveTo(number - 1);
        const std::size_t nodes = record.mesh().nodes.size(), elements = record.mesh().elements.size();
        record.moveTo(number);
        const ImproveStep step = record.step();
        const std::size_t added = step.addedNodes.size(), removed = step.removedNodes.size();
        REQUIRE(record.mesh().nodes.size() == nodes + added - removed);
        REQUIRE(record.mesh().elements.size() == elements + 2 * added - 2 * removed);
        switch (step.change) {
        case ImproveChange::Swap:
            swapped = true;
            REQUIRE(step.addedEdges.size() == 1);
            REQUIRE(step.removedEdges.size() == 1);
            REQUIRE(step.elements.size() == 2);
            REQUIRE(step.moves.empty());
            break;
        case ImproveChange::Merge:
            merged = true;
            REQUIRE(removed == 1);
            REQUIRE(added == 0);
            break;
        case ImproveChange::Divide:
            divided = true;
            REQUIRE(added == 1);
            REQUIRE(removed == 0);
            break;
        case ImproveChange::Sweep:
        case ImproveChange::Restore:
        case ImproveChange::Polish:
            REQUIRE(step.addedEdges.empty());
            REQUIRE_FALSE(step.moves.empty());
            break;
        default:
            break;
        }
    }
    CHECK(merged);
    CHECK(divided);
    CHECK(swapped);
    record.moveTo(1);
    CHECK(caption(record.step(), record.steps()).starts_with("Improvement 1 of " + std::to_string(record.steps())));
}

TEST_CASE("Improvement record: what does not fit its memory is one step, which ends at the same mesh") {
    TriMesh mesh = samples::constrainedSquare(14, 0.24, {}, 5);
    const TriMesh before = mesh;
    ImproveRecord record = recorded::recordOf(mesh, ImproveLevel::Best, 20'000);
    REQUIRE(record.steps() > 2);
    CHECK(record.step().change == ImproveChange::Remainder);
    CHECK(recorded::hashOf(record.mesh()) == recorded::hashOf(mesh));
    record.moveTo(record.steps() - 1);
    CHECK(record.step().change != ImproveChange::Remainder);
    CHECK(verify(record.mesh()).empty());
    record.moveTo(0);
    CHECK(recorded::hashOf(record.mesh()) == recorded::hashOf(before));
}

TEST_CASE("MeshingSession: the finished front, then the improvement step by step, forward and back") {
    for (const ImproveLevel level : {ImproveLevel::Default, ImproveLevel::Best}) {
        const auto job = recorded::plate(0.4, level);
        MeshingSession session;
        session.want({.mesh = true, .front = false, .cells = false, .explanation = true});
        session.start(job, StartMode::Run);
        const auto end = session.wait();
        REQUIRE(end->state == RunState::Finished);
        REQUIRE(end->improved);
        CHECK(end->improvement == nullptr); // it was not stepped to
        REQUIRE(end->improveSteps > 5);
        CHECK(end->atEnd());
        auto unimproved = *job;
        unimproved.options.improve = ImproveLevel::None;
        const auto raw = meshDomain(unimproved);
        const auto batch = meshDomain(*job);
        REQUIRE(raw);
        REQUIRE(batch);
        CHECK(end->meshHash == meshHash(batch->mesh));

        session.seek(end->known);
        auto now = session.wait();
        CHECK(now->state == RunState::Paused);
        CHECK(now->frontDone());
        CHECK_FALSE(now->atEnd());
        CHECK_FALSE(now->improved);
        CHECK(now->explanation != nullptr);
        CHECK(meshHash(now->mesh->view()) == meshHash(raw->mesh));
        std::vector<std::uint64_t> hashes;
        while (!now->atEnd()) {
            hashes.push_back(meshHash(now->mesh->view()));
            session.step(Granularity::Advance, 1);
            const auto next = session.wait();
            REQUIRE(next->improveStep == now->improveStep + 1);
            REQUIRE(next->improvement);
            CHECK(next->advance == end->known);
            CHECK(next->improvement->number == next->improveStep);
            CHECK(next->improvement->before.alphaMean == doctest::Approx(now->quality.alphaMean));
            CHECK(next->improvement->after.alphaMean == doctest::Approx(next->quality.alphaMean));
            now = next;
        }
        CHECK(now->state == RunState::Finished);
        CHECK(now->meshHash == end->meshHash);
        CHECK(meshHash(now->mesh->view()) == end->meshHash);
        for (std::size_t back = hashes.size(); back-- > 0;) {
            session.step(Granularity::Event, -1);
            now = session.wait();
            REQUIRE(now->improveStep == back);
            REQUIRE(meshHash(now->mesh->view()) == hashes[back]);
        }
        session.step(Granularity::Advance, -1);
        CHECK(session.wait()->advance == end->known - 1);
    }
}

TEST_CASE("MeshingSession: passes of the improvement are its layers, and play goes through it") {
    MeshingSession session;
    session.start(recorded::plate(0.4, ImproveLevel::Default), StartMode::Pause);
    session.seek(std::uint64_t{1} << 40U);
    const auto end = session.wait();
    REQUIRE(end->state == RunState::Finished);
    session.step(Granularity::Layer, -1);
    const auto before = session.wait();
    CHECK(before->improveStep < end->improveSteps);
    session.step(Granularity::Layer, -1000);
    CHECK(session.wait()->improveStep == 0);
    CHECK(session.wait()->frontDone());
    std::size_t passes = 0;
    for (; !session.wait()->atEnd() && passes < 1000; ++passes) {
        session.step(Granularity::Layer, 1);
    }
    CHECK(passes > 2);
    CHECK(passes < end->improveSteps);
    session.seek(end->known - 3);
    session.play(1e5);
    const auto played = session.wait();
    CHECK(played->state == RunState::Finished);
    CHECK(played->meshHash == end->meshHash);
    session.step(Granularity::Event, -2);
    CHECK(session.wait()->improveStep == end->improveSteps - 2);
    session.step(Granularity::Event, 1000);
    CHECK(session.wait()->atEnd());
}

TEST_CASE("MeshStepper: events and layers that lead beyond the front make the improvement first, then its steps") {
    const auto make = [] {
        auto stepper = MeshStepper::create(*recorded::plate(0.4, ImproveLevel::Default));
        REQUIRE(stepper);
        stepper->stepImprovement();
        return *std::move(stepper);
    };
    MeshStepper first = make();
    first.finish();
    const std::uint64_t last = first.known();
    const std::size_t steps = first.snapshot()->improveSteps;
    MeshStepper events = make();
    events.seek(last - 1);
    events.step(Granularity::Event, 100'000);
    CHECK(events.atEnd());
    CHECK(events.snapshot()->improveStep == steps);
    first.seek(last);
    first.step(Granularity::Layer, 2);
    MeshStepper layers = make();
    layers.seek(last - 1);
    layers.step(Granularity::Layer, 3); // the rest of the last layer, and two passes
    CHECK(layers.snapshot()->improveStep == first.snapshot()->improveStep);
    CHECK(layers.snapshot()->improvement != nullptr);
}

TEST_CASE("MeshingSession: a step that follows a seek into an improvement yet to be made starts at its target") {
    MeshingSession whole;
    whole.start(recorded::plate(0.4, ImproveLevel::Default), StartMode::Run);
    const std::uint64_t last = whole.wait()->known;
    for (const bool inOnePass : {true, false}) {
        MeshingSession session;
        session.start(recorded::plate(0.4, ImproveLevel::Default), StartMode::Pause);
        session.seek(last + 4);
        session.step(Granularity::Event, 3);
        if (!inOnePass) {
            session.step(Granularity::Event, -2);
        }
        CHECK(session.wait()->improveStep == (inOnePass ? 7 : 5));
    }
    MeshingSession session;
    session.start(recorded::plate(0.4, ImproveLevel::Default), StartMode::Pause);
    session.seek(last);
    session.step(Granularity::Layer, 1);
    const auto pass = session.wait();
    CHECK(pass->improveStep > 0);
    CHECK(pass->improveStep < pass->improveSteps);
}

TEST_CASE("MeshingSession: a quiet run has the steps of its improvement once it is moved along its timeline") {
    const auto job = recorded::plate(0.4, ImproveLevel::Best);
    MeshingSession session, stepped;
    stepped.start(job, StartMode::Run);
    session.start(job, StartMode::RunQuiet);
    const auto quiet = session.wait();
    CHECK(quiet->state == RunState::Finished);
    CHECK(quiet->improveSteps == 0);
    CHECK(quiet->improved);
    const auto known = stepped.wait();
    CHECK(quiet->meshHash == known->meshHash);
    session.step(Granularity::Advance, -1);
    const auto back = session.wait();
    CHECK(back->improveSteps == known->improveSteps);
    CHECK(back->improveStep == known->improveSteps - 1);
    CHECK(back->meshHash == known->meshHash);
    CHECK(back->quality.elements == back->mesh->mesh.elements.size());
    CHECK(back->quality.nodes == back->mesh->mesh.nodes.size());
    session.want({.mesh = false, .front = false});
    const auto bare = session.wait();
    CHECK(bare->mesh == nullptr);
    CHECK(bare->quality.elements == back->quality.elements);
    CHECK(bare->quality.nodes == back->quality.nodes);
    session.finish();
    CHECK(session.wait()->atEnd());
}

TEST_CASE("Improvement record: nodes and elements that are renumbered after the last step have these numbers there") {
    TriMesh mesh = samples::constrainedSquare(4, 0.2, {}, 5);
    ImproveRecord record(mesh);
    Vec2 &inner = mesh.nodes.back();
    inner = inner + Vec2{0.001, 0.002};
    record.changed(ImproveChange::Sweep, mesh, mesh.nodes, {});
    const std::size_t count = mesh.nodes.size();
    std::ranges::reverse(mesh.nodes);
    const auto turn = [count](NodeId &node) { node = NodeId{static_cast<std::uint32_t>(count - 1 - index(node))}; };
    for (Element &element : mesh.elements) {
        std::ranges::for_each(element, turn);
    }
    for (TaggedEdge &edge : mesh.edges) {
        turn(edge.a);
        turn(edge.b);
    }
    for (TaggedNode &point : mesh.points) {
        turn(point.node);
    }
    record.changed(ImproveChange::Renumber, mesh, mesh.nodes, {});
    REQUIRE(record.steps() == 1);
    record.moveTo(0);
    record.moveTo(1);
    CHECK(recorded::hashOf(record.mesh()) == recorded::hashOf(mesh));
    const ImproveStep step = record.step();
    REQUIRE(step.moves.size() == 1);
    CHECK(index(step.moves[0].node) == 0);
    CHECK(step.moves[0].to == mesh.nodes[0]);
    CHECK(recorded::hashOf(record.mesh()) == recorded::hashOf(mesh));
}

TEST_CASE("MeshingSession: without improvement the finished front is the end; a second order follows in one step") {
    auto job = recorded::plate(0.4, ImproveLevel::None);
    MeshingSession session;
    session.start(job, StartMode::Run);
    const auto plain = session.wait();
    CHECK(plain->improveSteps == 0);
    CHECK(plain->atEnd());
    CHECK(plain->state == RunState::Finished);
    auto second = std::make_shared<MeshingJob>(*job);
    second->options.order = ElementOrder::Second;
    session.start(second, StartMode::Run);
    CHECK(session.wait()->improveSteps == 1);
    session.step(Granularity::Advance, -1);
    const auto front = session.wait();
    CHECK(front->advance == front->known);
    CHECK(front->order == nullptr);
    session.step(Granularity::Advance, 1);
    const auto end = session.wait();
    REQUIRE(end->improvement);
    CHECK(end->improvement->change == ImproveChange::Completion);
    CHECK(end->order != nullptr);
}
