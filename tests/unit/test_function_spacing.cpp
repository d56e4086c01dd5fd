#include "core/drawing/document/document.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace forefront {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double sizeAt(Vec2 p) {
    return 0.05 + 0.1 * std::fabs(p.x - 2.0);
}

void sizesAt(std::span<const Vec2> points, std::span<double> sizes) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        sizes[i] = sizeAt(points[i]);
    }
}

MeshingJob rectangleJob() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    return job;
}

std::uint64_t runHash(const MeshingJob &job) {
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE(outcome);
    return meshHash(outcome->mesh);
}

} // namespace

TEST_CASE("Function spacing: a function, a bulk function and an expression of the same values give the same mesh") {
    MeshingJob job = rectangleJob();
    job.spacing.expression = "0.05 + 0.1*abs(x - 2)";
    job.spacing.gradation = 0.3;
    const std::uint64_t expected = runHash(job);
    job.spacing.expression.reset();
    job.spacing.function = sizeAt;
    CHECK(runHash(job) == expected);
    job.spacing.function = nullptr;
    job.spacing.bulkFunction = sizesAt;
    CHECK(runHash(job) == expected);
}

TEST_CASE("Function spacing: is combined by minimum, limited and explained like an expression") {
    MeshingJob job = rectangleJob();
    job.spacing.function = [](Vec2 p) { return p.x < 2.0 ? 0.1 : 1.0; };
    job.spacing.minimum = 0.2;
    job.spacing.maximum = 0.9;
    job.spacing.gradation = 0.25;
    SizeSource corner;
    corner.a = {4, 3};
    corner.size = 0.3;
    job.spacing.sources = {corner};
    const auto field = SpacingField::build(job.spacing, job.domain);
    REQUIRE(field);
    CHECK((*field)->at({1, 1}) == 0.2);
    CHECK((*field)->sample({1, 1}).origin == SpacingOrigin::Minimum);
    CHECK((*field)->at({4, 3}) == doctest::Approx(0.3));
    CHECK((*field)->sample({4, 3}).origin == SpacingOrigin::Source);
    CHECK((*field)->at({2.8, 0.5}) == doctest::Approx(0.4).epsilon(0.03)); // limited growth from the step at x = 2
    const SpacingSample sample = (*field)->sample({2.8, 0.5});
    CHECK(sample.origin == SpacingOrigin::Gradation);
    CHECK(sample.describe.find("from the size function at (") != std::string::npos);
    job.spacing.gradation.reset();
    job.spacing.minimum.reset();
    const auto free = SpacingField::build(job.spacing, job.domain);
    REQUIRE(free);
    CHECK((*free)->sample({1, 1}).describe == "size function");
    CHECK((*free)->sample({1, 1}).origin == SpacingOrigin::Function);
    CHECK((*free)->minimum() == 0.1);
    std::vector<Vec2> places;
    for (int k = 0; k < 300; ++k) {
        places.push_back({0.0137 * k, 3.0 - 0.0093 * k});
    }
    std::vector<double> many(places.size());
    for (const auto &each : {*field, *free}) {
        each->atMany(places, many);
        for (std::size_t k = 0; k < places.size(); ++k) {
            REQUIRE(many[k] == each->at(places[k]));
        }
    }
}

TEST_CASE("Function spacing: values that are no sizes are refused with the place, unless a limit covers them") {
    for (const double bad : {0.0, -1.0, kInfinite, -kInfinite, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(bad);
        MeshingJob job = rectangleJob();
        job.spacing.function = [bad](Vec2 p) { return p.x > 3.0 && p.y > 2.0 ? bad : 0.5; };
        const Result<MeshingOutcome> refused = meshDomain(job);
        REQUIRE_FALSE(refused);
        CHECK(refused.faults().front().code == "function-value");
        REQUIRE(refused.faults().front().at);
        CHECK(refused.faults().front().at->x > 3.0);
        CHECK(refused.faults().front().at->y > 2.0);
        job.spacing.minimum = 0.4;
        job.spacing.maximum = 0.6;
        CHECK(meshDomain(job).ok() == !std::isnan(bad));
    }
}

TEST_CASE("Function spacing: a value that no probe finds does no harm") {
    MeshingJob job = rectangleJob();
    job.spacing.function = [](Vec2 p) {
        const bool probed = std::fmod(p.x * 16.0, 1.0) == 0.0 && std::fmod(p.y * 64.0 / 3.0, 1.0) == 0.0;
        return probed ? 0.5 : std::numeric_limits<double>::quiet_NaN();
    };
    job.spacing.maximum = 0.5;
    CHECK(meshDomain(job));
}

TEST_CASE("Function spacing: a function and a bulk function together are refused") {
    MeshingJob job = rectangleJob();
    job.spacing.function = sizeAt;
    job.spacing.bulkFunction = sizesAt;
    const Result<MeshingOutcome> refused = meshDomain(job);
    REQUIRE_FALSE(refused);
    CHECK(refused.faults().front().code == "two-functions");
}

TEST_CASE("Function spacing: only the calling thread calls it unless it is thread-safe; the mesh is the same") {
    MeshingJob job = rectangleJob();
    std::mutex mutex;
    std::set<std::thread::id> callers;
    job.spacing.function = [&](Vec2 p) {
        const std::lock_guard lock(mutex);
        callers.insert(std::this_thread::get_id());
        return 0.15 * sizeAt(p);
    };
    const std::uint64_t expected = runHash(job);
    job.options.threads = 3;
    CHECK(job.usableThreads() == 1);
    CHECK(runHash(job) == expected);
    CHECK(callers == std::set{std::this_thread::get_id()});
    job.spacing.functionThreadSafe = true;
    CHECK(job.usableThreads() == 3);
    CHECK(runHash(job) == expected);
}

TEST_CASE("Function spacing: what a function throws reaches the caller, from any thread and at any moment") {
    for (const bool threads : {false, true}) {
        MeshingJob job = rectangleJob();
        job.spacing.functionThreadSafe = threads;
        job.options.threads = 3;
        std::atomic<std::uint64_t> calls = 0;
        job.spacing.function = [&](Vec2 p) {
            ++calls;
            return 0.15 * sizeAt(p);
        };
        CHECK(runHash(job) != 0);
        const std::uint64_t all = calls;
        for (const std::uint64_t last : {std::uint64_t{1}, std::uint64_t{4000}, all / 20, all / 4, all / 2}) {
            CAPTURE(last);
            calls = 0;
            job.spacing.function = [&calls, last](Vec2 p) {
                return ++calls == last ? throw std::runtime_error("no more") : 0.15 * sizeAt(p);
            };
            CHECK_THROWS_AS(static_cast<void>(meshDomain(job)), std::runtime_error);
        }
    }
}

TEST_CASE("Progress: what it throws reaches the caller, on one thread and on several") {
    for (const unsigned threads : {1U, 3U}) {
        MeshingJob job = rectangleJob();
        job.spacing.size = 0.012;
        job.options.threads = threads;
        int reports = 0;
        REQUIRE(meshDomain(job, {[&](std::string_view, double) { ++reports; }, {}}));
        REQUIRE(reports > 5);
        for (int last = 1; last < reports; last += 1 + reports / 10) {
            int count = 0;
            const auto report = [&](std::string_view, double) {
                if (++count == last) {
                    throw 7;
                }
            };
            const Progress progress{report, {}};
            CHECK_THROWS_AS(static_cast<void>(meshDomain(job, progress)), int);
        }
    }
}

TEST_CASE("Function spacing: a session reports what the function throws, and can start again") {
    auto job = std::make_shared<MeshingJob>(rectangleJob());
    std::atomic<std::uint64_t> calls = 0, last = 0;
    job->spacing.function = [&](Vec2 p) {
        return ++calls == last ? throw std::runtime_error("no more") : 0.3 * sizeAt(p);
    };
    REQUIRE(runHash(*job) != 0);
    last = calls - calls / 20; // after the preparation, which calls it most
    calls = 0;
    MeshingSession session;
    session.start(job, StartMode::Run);
    const auto failed = session.wait();
    CHECK(failed->state == RunState::Failed);
    REQUIRE(failed->diagnostics.size() == 1);
    CHECK(failed->diagnostics.front().code == "callback-failed");
    CHECK(failed->diagnostics.front().message.find("no more") != std::string::npos);
    auto good = std::make_shared<MeshingJob>(rectangleJob());
    good->spacing.function = sizeAt;
    session.start(good, StartMode::Run);
    CHECK(session.wait()->meshHash == runHash(*good));

    calls = 0;
    Result<MeshStepper> stepper = MeshStepper::create(*job);
    REQUIRE(stepper);
    CHECK_THROWS_AS(stepper->finish(), std::runtime_error);
    CHECK(stepper->empty());
}

TEST_CASE("Function spacing: a project with a function is not saved, and the fault says so") {
    const testing::TemporaryFolder folder;
    Document document;
    document.spacing.function = sizeAt;
    const Status refused = writeProject(folder / "plate.json", document);
    REQUIRE_FALSE(refused.empty());
    CHECK(refused.front().code == "not-storable");
    CHECK(refused.front().message.find("size function") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "plate.json"));
    document.spacing.function = nullptr;
    CHECK(writeProject(folder / "plate.json", document).empty());
}

TEST_CASE("Function spacing: functions never count as the same content") {
    SpacingSpec a, b;
    CHECK(sameContent(a, b));
    a.function = sizeAt;
    CHECK_FALSE(sameContent(a, b));
    b = a;
    CHECK_FALSE(sameContent(a, b)); // they cannot be compared
}

} // namespace forefront
