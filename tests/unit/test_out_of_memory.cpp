#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/unit/failing_new.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using namespace forefront;
using forefront::testing::FailingNew;

namespace {

MeshingJob smallJob() {
    MeshingJob job;
    addLoop(job.domain, std::vector<Vec2>{{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    job.spacing.size = 0.7;
    return job;
}

/// Calls `call` again and again, and lets each of its allocations fail once: it must report that and not throw. Returns
/// the number of its allocations.
long failAtEach(const std::function<Diagnostics()> &call) {
    for (long allowed = 0;; allowed += 1 + allowed / 20) {
        Diagnostics faults;
        bool threw = false;
        try {
            const FailingNew failing(allowed);
            faults = call();
        } catch (const std::bad_alloc &) {
            threw = true;
        }
        CAPTURE(allowed);
        REQUIRE_FALSE(threw);
        if (faults.empty()) {
            return allowed;
        }
        REQUIRE(faults.front().code == "out-of-memory");
    }
}

/// Runs `run` in a process of its own and returns what it printed to stderr; `signal` receives what ended it.
std::string lastWords(const std::function<void()> &run, int &signal) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        std::signal(SIGABRT, SIG_DFL); // not that of the test program
        run();
        _exit(0);
    }
    close(ends[1]);
    std::string text;
    char buffer[256];
    for (ssize_t n = read(ends[0], buffer, sizeof buffer); n > 0; n = read(ends[0], buffer, sizeof buffer)) {
        text.append(buffer, static_cast<std::size_t>(n));
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return text;
}

} // namespace

TEST_CASE("Out of memory: validate, repair, verify, mesh and adapt report it wherever it happens" *
          doctest::skip(forefront::testing::kSanitized)) {
    const MeshingJob job = smallJob();
    const auto outcome = meshDomain(job);
    REQUIRE(outcome);
    CHECK(failAtEach([&] { return validate(job.domain); }) > 10);
    CHECK(failAtEach([&] {
              const auto result = repair(job.domain);
              return result ? Diagnostics{} : result.faults();
          }) > 10);
    CHECK(failAtEach([&] { return verify(outcome->mesh); }) > 5);
    CHECK(failAtEach([&] { return verifyAgainst(outcome->mesh, *outcome->boundary); }) > 5);
    CHECK(failAtEach([&] { return verifyAgainst(outcome->mesh, job.domain); }) > 10);
    CHECK(failAtEach([&] {
              const auto result = meshDomain(job);
              return result ? Diagnostics{} : result.faults();
          }) > 10);
    const std::vector<double> values(outcome->mesh.nodes.size(), 1.0);
    const TriMesh triangles = takeTriMesh(outcome->mesh);
    CHECK(failAtEach([&] {
              const auto result = adaptMeshOnce(job, triangles, values, {});
              return result ? Diagnostics{} : result.faults();
          }) > 10);
}

TEST_CASE("Result: the value of a failed one prints the fault and aborts") {
    MeshingJob empty;
    int signal = 0;
    const std::string words = lastWords([&] { static_cast<void>(meshDomain(empty)->mesh); }, signal);
    CHECK(signal == SIGABRT);
    CHECK(words.find("empty-domain") != std::string::npos);
    CHECK(words.find("check the result first") != std::string::npos);
    const std::string other = lastWords([&] { static_cast<void>(meshDomain(smallJob()).faults()); }, signal);
    CHECK(signal == SIGABRT);
    CHECK(other.find("successful result") != std::string::npos);
    CHECK(lastWords([&] { static_cast<void>(meshDomain(smallJob())->mesh); }, signal).empty());
    CHECK(signal == 0);
}
