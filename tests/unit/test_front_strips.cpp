#include "core/engine/grid/hierarchical_grid.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/mesher/fast_advancer.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/mesher/strip_runner.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/discrete_samples.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A run of the fast method with strips of about `perStrip` elements.
class FrontStripRun {
  public:
    FrontStripRun(const PreparedJob &job, double perStrip)
        : job_(job), bounds_(job.boundary->bounds()), state_(*job.boundary) {
        FastAdvancer<HierarchicalGrid, NoTrace>::prepare(state_, *job.boundary, *job.spacing, perStrip);
    }

    std::size_t strips() const { return state_.strips->boxes.size(); }

    void together(unsigned threads) {
        CHECK(runStrips(state_, *job_.spacing, threads, {}, job_.estimatedElements));
        CHECK(state_.front.consistent());
        inThem_ = state_.elements.size();
    }

    TriMesh finish() {
        HierarchicalGrid grid(bounds_, 4.0);
        for (std::uint32_t i = 0; i < state_.front.capacity(); ++i) {
            if (state_.front[SlotId{i}].alive) {
                grid.insert(state_.front, SlotId{i});
            }
        }
        FastAdvancer<HierarchicalGrid, NoTrace> advancer(state_, grid, *job_.spacing, NoTrace{});
        AdvanceDelta delta;
        while (advancer.advance(delta)) {
        }
        CHECK(state_.front.empty());
        return toMesh(state_, *job_.boundary);
    }

    std::size_t elementsInStrips() const { return inThem_; }
    const WorkCounters &work() const { return state_.work; }

  private:
    const PreparedJob &job_;
    Box2 bounds_;
    FrontState state_;
    std::size_t inThem_ = 0;
};

} // namespace

TEST_CASE("FrontStrips: few elements make one strip, many make strips that cover the plane and their seams") {
    const auto domain = discreteDisc(0.05);
    const auto spacing = spacingOf([](Vec2) { return 0.05; });
    CHECK(FrontStrips(*domain, *spacing, FrontStrips::kPerStrip).boxes.size() == 1);
    const FrontStrips found(*domain, *spacing, 200.0);
    REQUIRE(found.phases.size() == 5);
    CHECK(found.phases[1] == 1);
    const std::size_t strips = found.phases[2] - found.phases[1];
    CHECK(strips >= 8);
    for (const double perStrip : {150.0, 200.0, 230.0, 260.0, 300.0, 350.0}) {
        const FrontStrips some(*domain, *spacing, perStrip);
        CHECK((some.phases.size() < 5 || (some.phases[2] - some.phases[1]) % 2 == 0));
    }
    CHECK(found.phases[3] - found.phases[2] == strips - 1);
    for (double x = -1.0; x < 1.0; x += 0.01) {
        for (std::size_t phase = 0; phase < 4; ++phase) {
            std::size_t holding = 0;
            for (std::size_t k = found.phases[phase]; k < found.phases[phase + 1]; ++k) {
                holding += found.boxes[k].containsHalfOpen(Vec2{x, 0.0}) ? 1U : 0U;
            }
            REQUIRE(holding == 1);
            const std::size_t strip = found.stripAt(phase, {x, 0.0});
            REQUIRE(found.boxes[strip].containsHalfOpen(Vec2{x, 0.0}));
            REQUIRE(found.phaseOf(strip) == phase);
        }
    }
}

TEST_CASE("FrontStrips: many fine segments make more strips, unless these would be a few elements wide") {
    const auto stripsOf = [](const DiscreteDomain &domain, const SpacingField &spacing, double perStrip) {
        const FrontStrips strips(domain, spacing, perStrip);
        REQUIRE(strips.phases.size() == 5);
        return strips.phases[2] - strips.phases[1];
    };
    const auto smooth = discreteDisc(0.05), rough = discreteDisc(0.0002);
    const auto graded = spacingOf([](Vec2 p) { return 0.0002 + 0.3 * std::max(0.0, 1.0 - length(p)); });
    CHECK(stripsOf(*smooth, *graded, 16'000.0) == 34);
    CHECK(stripsOf(*rough, *graded, 16'000.0) == 64);
    const auto even = spacingOf([](Vec2) { return 0.03; });
    CHECK(stripsOf(*smooth, *even, 500.0) == 18);
    CHECK(stripsOf(*rough, *even, 500.0) == 18);
}

TEST_CASE("runStrips: the same mesh and work in sequence and on 1, 2, 3 and 8 threads") {
    std::size_t split = 0;
    for (std::uint64_t seed = 300; seed < 340; seed += kSanitized ? 7 : 1) {
        CAPTURE(seed);
        MeshingJob job;
        job.domain = randomDomain(seed);
        const Result<PreparedJob> prepared = prepare(job);
        REQUIRE(prepared);
        const double perStrip = std::max(20.0, prepared->estimatedElements / 14.0);
        FrontStripRun single(*prepared, perStrip);
        const TriMesh expected = single.finish();
        REQUIRE(verifyAgainst(expected, *prepared->boundary).empty());
        for (const unsigned threads : {1U, 2U, 3U, 8U}) {
            CAPTURE(threads);
            FrontStripRun run(*prepared, perStrip);
            run.together(threads);
            split += run.elementsInStrips();
            REQUIRE(meshHash(run.finish()) == meshHash(expected));
            REQUIRE(run.work().advances == single.work().advances);
            REQUIRE(run.work().frontSum == single.work().frontSum);
            REQUIRE(run.work().candidates == single.work().candidates);
        }
    }
    CHECK(split > (kSanitized ? 1'000 : 10'000));
}

TEST_CASE("runStrips: strips of a large mesh leave little to the end, and can be cancelled") {
    MeshingJob job;
    job.domain.nodes = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    job.domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    job.spacing.expression = "0.006 + 0.01*abs(x-1)";
    const Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    FrontStripRun run(*prepared, 6000.0);
    REQUIRE(run.strips() > 16);
    run.together(2);
    const std::size_t before = run.elementsInStrips();
    const TriMesh mesh = run.finish();
    CHECK(verifyAgainst(mesh, *prepared->boundary).empty());
    CHECK(static_cast<double>(before) > 0.98 * static_cast<double>(mesh.elements.size()));

    std::vector<double> fractions;
    Progress reporting;
    reporting.report = [&](std::string_view, double fraction) { fractions.push_back(fraction); };
    FrontState reported(*prepared->boundary);
    FastAdvancer<HierarchicalGrid, NoTrace>::prepare(reported, *prepared->boundary, *prepared->spacing, 6000.0);
    const double elements = static_cast<double>(mesh.elements.size());
    CHECK(runStrips(reported, *prepared->spacing, 1, reporting, elements));
    CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    CHECK(std::any_of(fractions.begin(), fractions.end(), [](double done) { return done > 0.4 && done < 0.6; }));

    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    stop.request_stop();
    FrontState state(*prepared->boundary);
    FastAdvancer<HierarchicalGrid, NoTrace>::prepare(state, *prepared->boundary, *prepared->spacing, 6000.0);
    CHECK_FALSE(runStrips(state, *prepared->spacing, 2, progress, 1e5));
}

TEST_CASE("FrontStrips: stepping back through the strips restores every state") {
    const auto domain = discreteDisc(0.05);
    const auto spacing = spacingOf([](Vec2) { return 0.05; });
    FrontState state(*domain);
    HierarchicalGrid grid(domain->bounds(), 4.0);
    using Advancer = FastAdvancer<HierarchicalGrid, NoTrace>;
    Advancer::prepare(state, *domain, *spacing, 150.0);
    REQUIRE(state.strips->boxes.size() > 8);
    for (std::uint32_t i = 0; i < state.front.capacity(); ++i) {
        grid.insert(state.front, SlotId{i});
    }
    Advancer advancer(state, grid, *spacing, NoTrace{});
    advancer.keepLog(true);
    std::vector<std::uint64_t> states{state.hash()};
    std::vector<AdvanceDelta> deltas;
    for (AdvanceDelta delta; advancer.advance(delta); deltas.push_back(delta)) {
        states.push_back(state.hash());
    }
    CHECK(state.strip + 1 == state.strips->boxes.size());
    for (std::size_t k = deltas.size(); k-- > 0;) {
        advancer.retreat(deltas[k]);
        REQUIRE(state.hash() == states[k]);
    }
    for (std::size_t k = 0; k < deltas.size(); ++k) {
        AdvanceDelta delta;
        REQUIRE(advancer.advance(delta));
        REQUIRE(state.hash() == states[k + 1]);
    }
}
