#include "core/engine/grid/hierarchical_grid.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/mesher/classic_advancer.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/mesher/timeline.hpp"
#include "tests/support/discrete_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace forefront;
using namespace forefront::testing;

namespace {

constexpr Method kMethods[] = {Method::Fast, Method::Classic};
constexpr auto kGrids = valuesOf<GridKind>();

std::unique_ptr<Mesher> mesherOn(std::shared_ptr<const DiscreteDomain> domain, double rho,
                                 GridKind grid = GridKind::Hierarchical, Method method = Method::Classic) {
    MeshingOptions options;
    options.grid = grid;
    options.method = method;
    return Mesher::create(std::move(domain), spacingOf([rho](Vec2) { return rho; }), options);
}

std::string faultsOf(const Diagnostics &faults) {
    std::string text;
    for (const Diagnostic &fault : faults) {
        text += toString(fault) + '\n';
    }
    return text;
}

} // namespace

TEST_CASE("Advance: fills a disc with nearly equilateral elements") {
    for (const Method method : kMethods) {
        auto mesher = mesherOn(discreteDisc(0.1), 0.1, GridKind::Hierarchical, method);
        while (mesher->advance(100) == 100) {
        }
        CHECK(mesher->finished());
        const TriMesh mesh = toMesh(mesher->state(), mesher->boundary());
        CHECK(faultsOf(verifyAgainst(mesh, mesher->boundary())) == "");
        CHECK(measureQuality(mesh, &mesher->spacing()).alphaMean > 0.95);
    }
}

TEST_CASE("Advance: corners are not closed by a segment far longer than the node spacing") {
    // A triangle with corners of 60 degrees and sides of three segments of length 1, each 2.5 node spacings long.
    const Vec2 corners[] = {{0, 0}, {3, 0}, {1.5, 1.5 * std::numbers::sqrt3}};
    std::vector<Vec2> nodes;
    for (int k = 0; k < 3; ++k) {
        for (int part = 0; part < 3; ++part) {
            nodes.push_back(lerp(corners[k], corners[(k + 1) % 3], part / 3.0));
        }
    }
    auto mesher = mesherOn(DiscreteBuilder().loop(nodes).region(1, 2.25 * std::numbers::sqrt3).build(), 0.4,
                           GridKind::Hierarchical, Method::Fast);
    mesher->advance(~std::uint64_t{0});
    const TriMesh mesh = toMesh(mesher->state(), mesher->boundary());
    CHECK(faultsOf(verifyAgainst(mesh, mesher->boundary())) == "");
    CHECK(mesh.elements.size() > 16); // with all corners closed, it is 13
}

TEST_CASE("Advance: a slit, a hole and an isolated point are all in the mesh") {
    for (const Method method : kMethods) {
        for (const double h : {0.05, 0.1, 0.3}) {
            auto mesher = mesherOn(discretePlate(h), h, GridKind::Hierarchical, method);
            mesher->advance(~std::uint64_t{0});
            const TriMesh mesh = toMesh(mesher->state(), mesher->boundary());
            CHECK(faultsOf(verifyAgainst(mesh, mesher->boundary())) == "");
        }
    }
}

TEST_CASE("Advance: the front closes with existing nodes once no further small nodes are allowed") {
    // The node spacing is far above the lengths of the boundary, so every new node counts as small and none is left.
    // A small hole far from the outline, its segments first, as if they had been deferred already: they find no partner
    // nearby.
    for (const int n : {24, 100}) {
        const auto domain = DiscreteBuilder()
                                .loop(circleNodes({0, 0}, 1.0, n))
                                .loop(circleNodes({0.1, 0}, 0.02, n / 4, false))
                                .point({-0.3, 0.2})
                                .region(1, 0.5 * n * std::sin(2.0 * std::numbers::pi / n) -
                                               0.5 * (n / 4) * std::sin(8.0 * std::numbers::pi / n) * 0.0004)
                                .build();
        const Box2 bounds = domain->bounds();
        const auto spacing = spacingOf([](Vec2) { return 1e9; });
        FrontState state(*domain);
        state.smallNodesLeft = 0;
        for (std::uint32_t i = 0; i < state.front.capacity(); ++i) {
            state.front.setFailureClass(SlotId{i}, state.front[SlotId{i}].length < 0.03 ? 1 : 2);
        }
        state.order.rebuild(state.front);
        HierarchicalGrid grid(bounds, 4.0);
        for (std::uint32_t i = 0; i < state.front.capacity(); ++i) {
            grid.insert(state.front, SlotId{i});
        }
        ClassicAdvancer<HierarchicalGrid, NoTrace> advancer(state, grid, *spacing, NoTrace{});
        AdvanceDelta delta;
        while (advancer.advance(delta)) {
        }
        CHECK(state.front.empty());
        CHECK(state.work.newNodes == 0);
        CHECK(state.work.forced > 0);
        CHECK(faultsOf(verifyAgainst(toMesh(state, *domain), *domain)) == "");
    }
}

TEST_CASE("Advance: the front closes however much the spacing differs from the boundary lengths") {
    auto mesher = mesherOn(discretePlate(0.2), 1e9);
    mesher->advance(~std::uint64_t{0});
    REQUIRE(mesher->finished());
    CHECK(faultsOf(verifyAgainst(toMesh(mesher->state(), mesher->boundary()), mesher->boundary())) == "");
}

TEST_CASE("Advance: the caption never names a withdrawn ideal point as the best candidate") {
    auto mesher = mesherOn(discretePlate(0.08), 0.08);
    std::size_t withdrawn = 0;
    while (!mesher->finished()) {
        const AdvanceExplanation explanation = mesher->explainNext();
        for (std::size_t cursor = 0; cursor < explanation.events.size(); ++cursor) {
            const TraceEvent &event = explanation.events[cursor];
            if (event.step == Step::Sort && event.candidate != kNoIndex) {
                const CandidateTrace &best = explanation.candidates[event.candidate];
                REQUIRE(best.verdict != Verdict::Withdrawn);
                REQUIRE(caption(explanation, cursor).find(best.node == kNoNode ? "ideal point" : "node ") !=
                        std::string::npos);
            }
        }
        withdrawn += static_cast<std::size_t>(
            std::count_if(explanation.candidates.begin(), explanation.candidates.end(),
                          [](const CandidateTrace &c) { return c.verdict == Verdict::Withdrawn; }));
        mesher->advance(1);
    }
    CHECK(withdrawn > 0);
}

TEST_CASE("Timeline: the work counters return to zero after moving back and forth") {
    for (const Method method : kMethods) {
        Timeline timeline(mesherOn(discretePlate(0.05), 0.05, GridKind::Hierarchical, method));
        timeline.forward(~std::uint64_t{0});
        const WorkCounters first = timeline.mesher().state().work;
        timeline.back(timeline.known());
        timeline.forward(timeline.known());
        CHECK(timeline.mesher().state().work.candidates == first.candidates);
        if (method == Method::Classic) {
            CHECK(timeline.mesher().state().work.tested == first.tested);
        }
        timeline.back(timeline.known());
        const WorkCounters &work = timeline.mesher().state().work;
        for (const std::uint64_t sum :
             {work.advances, work.elements, work.frontSum, work.delivered, work.tested, work.cellsVisited,
              work.candidates, work.newNodes, work.deferrals, work.forced}) {
            CHECK(sum == 0);
        }
    }
}

TEST_CASE("Advance: the grid changes the work, never the mesh") {
    std::vector<std::uint64_t> meshes;
    std::vector<std::uint64_t> tests;
    std::vector<std::uint64_t> delivered;
    for (const GridKind grid : kGrids) {
        auto mesher = mesherOn(discretePlate(0.04), 0.04, grid);
        mesher->advance(~std::uint64_t{0});
        meshes.push_back(meshHash(toMesh(mesher->state(), mesher->boundary())));
        tests.push_back(mesher->state().work.tested);
        delivered.push_back(mesher->state().work.delivered);
    }
    CHECK(meshes[0] == meshes[1]);
    CHECK(meshes[0] == meshes[2]);
    CHECK(tests[0] == tests[1]);
    CHECK(tests[0] == tests[2]);
    CHECK(delivered[1] * 4 < delivered[0]);
    CHECK(delivered[2] * 4 < delivered[0]);
}

TEST_CASE(
    "Advance: a classic run over several batches of the order is the same with every grid, and after going back") {
    std::vector<std::uint64_t> states;
    for (const GridKind grid : {GridKind::Uniform, GridKind::Hierarchical}) {
        Timeline timeline(mesherOn(discretePlate(0.009), 0.009, grid, Method::Classic));
        const std::uint64_t advances = timeline.forward(~std::uint64_t{0});
        REQUIRE(timeline.mesher().state().work.elements > 20'000);
        states.push_back(timeline.mesher().state().hash());
        timeline.back(advances / 2);
        states.push_back(timeline.mesher().state().hash());
        timeline.back(advances / 4);
        timeline.forward(advances / 4);
        CHECK(timeline.mesher().state().hash() == states.back());
        timeline.forward(~std::uint64_t{0});
        CHECK(timeline.mesher().state().hash() == states[states.size() - 2]);
    }
    CHECK(states[0] == states[2]);
    CHECK(states[1] == states[3]);
}

TEST_CASE("Advance: N advances forward and N back lead to the same state") {
    for (const GridKind grid : kGrids)
        for (const Method method : kMethods) {
            Timeline timeline(mesherOn(discretePlate(0.06), 0.06, grid, method));
            std::vector<std::uint64_t> states{timeline.mesher().state().hash()};
            while (timeline.forward(1) == 1) {
                states.push_back(timeline.mesher().state().hash());
            }
            CHECK(timeline.complete());
            while (timeline.back(1) == 1) {
                REQUIRE(timeline.mesher().state().hash() == states[timeline.position()]);
                REQUIRE(timeline.mesher().state().front.consistent());
            }
            CHECK(timeline.position() == 0);
            std::uint64_t p = 0;
            while (timeline.forward(37) > 0) {
                p = timeline.position();
                REQUIRE(timeline.mesher().state().hash() == states[p]);
            }
            CHECK(p == timeline.known());
        }
}

TEST_CASE("Advance: explaining an advance predicts it and leaves the run unchanged") {
    for (const Method method : kMethods) {
        auto mesher = mesherOn(discretePlate(0.08), 0.08, GridKind::Hierarchical, method);
        while (!mesher->finished()) {
            const std::uint64_t before = mesher->state().hash();
            const AdvanceExplanation explanation = mesher->explainNext();
            REQUIRE(mesher->state().hash() == before);
            const std::size_t elements = mesher->state().elements.size();
            mesher->advance(1);
            REQUIRE(explanation.advance == mesher->state().work.advances);
            REQUIRE(explanation.deferred == (mesher->state().elements.size() == elements));
            REQUIRE(explanation.events.size() >= 6);
            const auto accepted = std::count_if(explanation.candidates.begin(), explanation.candidates.end(),
                                                [](const CandidateTrace &c) { return c.verdict == Verdict::Accepted; });
            REQUIRE(accepted == (explanation.deferred ? 0 : 1));
            const auto rejected = std::count_if(
                explanation.candidates.begin(), explanation.candidates.end(), [](const CandidateTrace &c) {
                    return c.verdict != Verdict::NotTried && c.verdict != Verdict::Accepted &&
                           c.verdict != Verdict::Withdrawn;
                });
            const std::string whole = caption(explanation, explanation.events.size());
            REQUIRE((whole.find(std::to_string(rejected) + " candidate") != std::string::npos) == (rejected > 0));
            for (std::size_t cursor = 0; cursor <= explanation.events.size(); ++cursor) {
                REQUIRE_FALSE(caption(explanation, cursor).empty());
            }
        }
    }
}

TEST_CASE("Advance: the α of an accepted candidate is the minimum of the elements it makes") {
    for (const Method method : kMethods) {
        auto mesher = mesherOn(discretePlate(0.08), 0.08, GridKind::Hierarchical, method);
        std::size_t groups = 0;
        for (; !mesher->finished(); mesher->advance(1)) {
            const AdvanceExplanation e = mesher->explainNext();
            std::uint32_t seen = 0;
            for (const TraceEvent &event : e.events) {
                REQUIRE(event.candidatesSeen >= seen);
                REQUIRE((event.candidate == kNoIndex || event.candidate < event.candidatesSeen));
                seen = event.candidatesSeen;
            }
            REQUIRE(seen == e.candidates.size());
            const auto accepted = std::find_if(e.candidates.begin(), e.candidates.end(),
                                               [](const CandidateTrace &c) { return c.verdict == Verdict::Accepted; });
            if (accepted == e.candidates.end()) {
                continue;
            }
            double minimum = 1.0;
            for (const auto &[p, q, r] : e.made) {
                minimum = std::min(minimum, shapeFactor(p, q, r));
            }
            REQUIRE(accepted->alpha == doctest::Approx(minimum));
            REQUIRE(accepted->score > 0.0);
            REQUIRE((accepted->node == kNoNode || (accepted->node != e.nodeA && accepted->node != e.nodeB)));
            REQUIRE(accepted->score == doctest::Approx(accepted->alpha * accepted->deltaAC * accepted->deltaCB));
            const bool several = e.elements > 1;
            REQUIRE((caption(e, e.events.size()).find("minimum α") != std::string::npos) == several);
            groups += several ? 1 : 0;
        }
        CHECK((groups > 0) == (method == Method::Fast));
    }
}

TEST_CASE("Advance: the work per element does not grow with the mesh") {
    double tests[2];
    double neighbours[2];
    int k = 0;
    for (const double h : {0.05, 0.0125}) {
        auto mesher = mesherOn(discreteDisc(h), h);
        mesher->advance(~std::uint64_t{0});
        tests[k] = mesher->state().work.testsMean();
        neighbours[k] = mesher->state().work.neighboursMean();
        CHECK(mesher->state().work.forced * 1000 <= mesher->state().work.elements);
        ++k;
    }
    CHECK(tests[1] < 2.0);
    CHECK(neighbours[1] < 60.0);
    CHECK(neighbours[0] < 60.0);
}

TEST_CASE("Timeline: a layer is once around the front") {
    Timeline timeline(mesherOn(discreteDisc(0.1), 0.1));
    const std::size_t boundary = timeline.mesher().state().front.segments();
    timeline.forward(~std::uint64_t{0});
    const std::vector<std::uint64_t> &ends = timeline.layerEnds();
    REQUIRE(ends.size() >= 3);
    CHECK(ends.front() == boundary);
    CHECK(std::is_sorted(ends.begin(), ends.end()));
    CHECK(ends.back() == timeline.known());
    timeline.back(timeline.known() - ends.front());
    const std::size_t second = timeline.mesher().state().front.segments();
    CHECK(ends[1] == ends[0] + second);
}
