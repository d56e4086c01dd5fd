#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/mesher/strip_runner.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <thread>

using namespace forefront;

namespace {

MeshingJob squareJob(double size, std::uint64_t maxElements) {
    MeshingJob job;
    addLoop(job.domain, std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    job.spacing.size = size;
    job.options.maxElements = maxElements;
    return job;
}

Diagnostic refusal(const MeshingJob &job) {
    const auto outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    REQUIRE(outcome.faults().size() == 1);
    REQUIRE(outcome.faults().front().code == "too-many-elements");
    return outcome.faults().front();
}

/// Returns the number after some words of the advice.
double numberAfter(const Diagnostic &fault, const std::string &words) {
    const std::size_t at = fault.advice.find(words);
    REQUIRE_MESSAGE(at != std::string::npos, fault.advice);
    return std::stod(fault.advice.substr(at + words.size()));
}

} // namespace

TEST_CASE("Maximum number of elements: a finer uniform spacing is refused, and the advised size is accepted") {
    for (const std::uint64_t limit : {50ULL, 1000ULL, 20'000ULL}) {
        CAPTURE(limit);
        const Diagnostic fault = refusal(squareJob(0.002, limit));
        CHECK(fault.message.find("needs about 5.77e+05 elements") != std::string::npos);
        CHECK(fault.message.find("expected at most " + std::to_string(limit)) != std::string::npos);
        CHECK(fault.advice.find("raise the maximum number of elements") != std::string::npos);
        const auto again = meshDomain(squareJob(numberAfter(fault, "at least "), limit));
        REQUIRE(again);
        CHECK(again->mesh.triangles().size() > limit / 2);
        CHECK(again->mesh.triangles().size() <= limit + limit / 4);
    }
    REQUIRE(meshDomain(squareJob(0.1, 1000)));
}

TEST_CASE("Maximum number of elements: the advice for a graded spacing is a factor") {
    MeshingJob job = squareJob(1.0, 500);
    job.spacing.size.reset();
    job.spacing.expression = "0.002 + 0.02*x";
    const double factor = numberAfter(refusal(job), "at least ");
    job.spacing.expression = std::to_string(factor) + "*(0.002 + 0.02*x)";
    const auto again = meshDomain(job);
    REQUIRE(again);
    CHECK(again->mesh.triangles().size() <= 625);
}

TEST_CASE("Maximum number of elements: given segments count, too") {
    MeshingJob job;
    std::vector<Vec2> loop;
    for (int i = 0; i < 1000; ++i) {
        loop.push_back({0.001 * i, 0.0});
    }
    loop.insert(loop.end(), {{1, 0}, {1, 1}, {0, 1}});
    addLoop(job.domain, loop);
    job.spacing.size = 0.5;
    job.options.keepBoundary = true;
    job.options.maxElements = 500;
    refusal(job);
    job.options.maxElements = 3000;
    CHECK(meshDomain(job));
}

TEST_CASE("Maximum number of elements: beyond what can be numbered, no option helps") {
    const Diagnostic fault = refusal(squareJob(2e-5, 2 * kMaxElements));
    CHECK(fault.message.find("expected at most 700000000") != std::string::npos);
    CHECK(fault.advice.find("raise") == std::string::npos);
}

TEST_CASE("Maximum number of elements: a front that exceeds its estimate is stopped") {
    for (const Method method : {Method::Fast, Method::Classic}) {
        MeshingJob job = squareJob(0.01, kDefaultMaxElements);
        job.options.method = method;
        const auto prepared = prepare(job);
        REQUIRE(prepared);
        MeshingOptions options = job.options;
        options.maxElements = 2000; // as if the estimate had been below
        const auto mesher = Mesher::create(prepared->boundary, prepared->spacing, options);
        const Status faults = advanceToEnd(*mesher, *prepared, options, "", {});
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().code == "too-many-elements");
        CHECK(faults.front().message.find("expected at most 2000") != std::string::npos);
        CHECK(mesher->state().elements.size() > 2000);
        CHECK(mesher->state().elements.size() < 23'000);
    }
    const auto large = prepare(squareJob(0.002, kDefaultMaxElements));
    REQUIRE(large);
    const auto mesher = Mesher::create(large->boundary, large->spacing, {});
    CHECK_FALSE(mesher->advanceInParallel(2, {}, large->estimatedElements, 5000));
}

TEST_CASE("Maximum number of elements: a session stops a front that exceeds its estimate") {
    MeshingSession session;
    const auto job = std::make_shared<MeshingJob>(squareJob(0.01, 2000));
    session.start(job, StartMode::Run, 1e6); // with a budget, only the front counts
    while (session.busy()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const auto snapshot = session.latest();
    CHECK(snapshot->state == RunState::Failed);
    REQUIRE(snapshot->diagnostics.size() == 1);
    CHECK(snapshot->diagnostics.front().code == "too-many-elements");
}
