#include "core/engine/session/lockstep.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace forefront {

namespace {

MeshingJob squareJob() {
    MeshingJob job;
    job.domain.nodes = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    job.domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    job.spacing.size = 1.0;
    return job;
}

void settle(Lockstep &runs, std::uint64_t advance, bool end) {
    runs.wait();
    runs.follow(advance, end);
    runs.wait();
}

} // namespace

TEST_CASE("Lockstep: a run's variants are the other grids, or the other method") {
    const RunVariant shown{Method::Classic, GridKind::Uniform};
    CHECK(variantsBeside(shown, Comparison::Grids) ==
          std::vector<RunVariant>{{Method::Classic, GridKind::None}, {Method::Classic, GridKind::Hierarchical}});
    CHECK(variantsBeside(shown, Comparison::Methods) == std::vector<RunVariant>{{Method::Fast, GridKind::Uniform}});
    CHECK(shown.name() == "classic, uniform grid");
    CHECK(RunVariant{Method::Fast, GridKind::None}.name() == "fast, no grid");
}

TEST_CASE("Lockstep: runs with other grids make the same mesh at each advance with different work") {
    const RunVariant shown{Method::Classic, GridKind::Hierarchical};
    Lockstep runs(squareJob(), variantsBeside(shown, Comparison::Grids), {});
    REQUIRE(runs.size() == 2);
    for (const std::uint64_t advance : {5U, 60U, 20U}) {
        settle(runs, advance, false);
        CHECK(runs.latest(0)->advance == advance);
        CHECK(runs.latest(1)->advance == advance);
        CHECK(runs.latest(0)->stateHash == runs.latest(1)->stateHash);
        CHECK(samePosition(*runs.latest(0), *runs.latest(1)));
    }
    settle(runs, 0, true);
    const RunFigures none = figuresOf(*runs.latest(0)), uniform = figuresOf(*runs.latest(1));
    CHECK(none.elements == uniform.elements);
    CHECK(none.tests == uniform.tests); // the classic method tests the same segments with every grid
    CHECK(none.considered == uniform.considered);
    CHECK(none.considered > none.tests);
    CHECK(none.neighbours > uniform.neighbours);
    CHECK(none.cells < uniform.cells);
    CHECK(none.front == uniform.front);
}

TEST_CASE("Lockstep: a shorter run waits at its end") {
    Lockstep runs(squareJob(), {{Method::Fast, GridKind::Hierarchical}, {Method::Classic, GridKind::Hierarchical}}, {});
    settle(runs, 1000000, false);
    const auto fast = runs.latest(0), classic = runs.latest(1);
    CHECK(fast->complete);
    CHECK(classic->complete);
    CHECK(fast->advance < classic->advance); // it makes up to three elements per advance
    CHECK(samePosition(*fast, *classic));    // both at their ends
    for (const auto &end :
         {fast, classic}) { // far beyond the last advance lies the improved mesh, not one of its steps
        CHECK(end->improved);
        CHECK(end->improveSteps == 0);
        CHECK(end->state == RunState::Finished);
    }
    settle(runs, fast->known + 2, false);
    CHECK(runs.latest(0)->improved);
    CHECK(runs.latest(1)->advance == fast->known + 2);
    SessionSnapshot before = *classic;
    before.advance = fast->advance - 1;
    CHECK_FALSE(samePosition(*fast, before));
}

} // namespace forefront
