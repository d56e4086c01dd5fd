#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/breakpoint_watch.hpp"
#include "core/engine/session/timeline_travel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <limits>

using namespace forefront;

namespace {

/// A square with two holes: fronts join, split and close.
std::unique_ptr<Mesher> mesherWithHoles(Method method, double size = 0.11) {
    MeshingJob job;
    const auto addSquare = [&](Vec2 corner, double side) {
        const auto first = static_cast<std::uint32_t>(job.domain.nodes.size());
        for (const Vec2 step : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
            job.domain.nodes.push_back(corner + side * step);
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            job.domain.segments.push_back({first + i, first + (i + 1) % 4, 1, SegmentRole::Boundary});
        }
    };
    addSquare({0, 0}, 4);
    addSquare({0.7, 0.9}, 0.8);
    addSquare({2.3, 2.1}, 0.9);
    job.spacing.size = size;
    job.options.method = method;
    Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    return Mesher::create(prepared->boundary, prepared->spacing, job.options);
}

constexpr Method kMethods[] = {Method::Fast, Method::Classic};

void travelOn(TimelineTravel &travel) {
    for (int batch = 0; batch < 1'000'000 && !travel.resting(); ++batch) {
        travel.work();
    }
    REQUIRE(travel.resting());
}

std::size_t loopsOf(const GenerationFront &front) {
    std::vector<bool> seen(front.capacity());
    std::size_t loops = 0;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        if (!front[SlotId{i}].alive || seen[i]) {
            continue;
        }
        ++loops;
        for (SlotId id{i}; !seen[index(id)]; id = front.next(id)) {
            seen[index(id)] = true;
        }
    }
    return loops;
}

/// The facts about an advance without breakpoints: from its delta, its explanation and the states around it.
struct Record {
    AdvanceDelta delta;
    AdvanceExplanation explanation;
    std::size_t loopsBefore = 0, loopsAfter = 0, segmentsBefore = 0, segmentsAfter = 0;
    std::vector<Element> elements;
};

std::vector<Record> recordsOf(Method method) {
    Timeline timeline(mesherWithHoles(method));
    std::vector<Record> records;
    while (!timeline.mesher().finished()) {
        Record record;
        const FrontState &state = timeline.mesher().state();
        record.explanation = timeline.mesher().explainNext();
        record.loopsBefore = loopsOf(state.front);
        record.segmentsBefore = state.front.segments();
        const std::size_t elements = state.elements.size();
        timeline.forward(1);
        record.delta = timeline.delta(timeline.position() - 1);
        record.loopsAfter = loopsOf(state.front);
        record.segmentsAfter = state.front.segments();
        record.elements.assign(state.elements.begin() + static_cast<std::ptrdiff_t>(elements), state.elements.end());
        records.push_back(std::move(record));
    }
    return records;
}

/// Runs to every stop of a kind and returns their positions.
std::vector<std::uint64_t> stopsOf(Method method, const Breakpoints &breakpoints) {
    TimelineTravel travel(mesherWithHoles(method));
    travel.setBreakpoints(breakpoints);
    std::vector<std::uint64_t> stops;
    for (;;) {
        travel.reachStop(true);
        travelOn(travel);
        if (!travel.stop()) {
            CHECK(travel.atEnd());
            return stops;
        }
        stops.push_back(travel.timeline().position());
    }
}

Breakpoints only(StopKind kind) {
    Breakpoints breakpoints;
    breakpoints.set(kind, true);
    return breakpoints;
}

std::vector<std::uint64_t> where(const std::vector<Record> &records, const std::function<bool(const Record &)> &holds) {
    std::vector<std::uint64_t> positions;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (holds(records[i])) {
            positions.push_back(i + 1);
        }
    }
    return positions;
}

bool rejects(const Record &record) {
    const auto &candidates = record.explanation.candidates;
    return std::any_of(candidates.begin(), candidates.end(), [&](const CandidateTrace &c) {
        const auto i = static_cast<std::uint32_t>(&c - candidates.data());
        const bool tested =
            std::any_of(record.explanation.events.begin(), record.explanation.events.end(),
                        [i](const TraceEvent &event) { return event.step == Step::Test && event.candidate == i; });
        return tested && c.verdict != Verdict::Accepted && c.verdict != Verdict::NotTried;
    });
}

} // namespace

TEST_CASE("Breakpoints: each kind stops exactly where the advance fulfils it") {
    for (const Method method : kMethods) {
        CAPTURE(static_cast<int>(method));
        const std::vector<Record> records = recordsOf(method);
        REQUIRE(records.size() > 500);
        const auto stops = [method](const Breakpoints &b) { return stopsOf(method, b); };
        CHECK(stops(only(StopKind::Rejection)) == where(records, rejects));
        CHECK(stops(only(StopKind::Deferral)) ==
              where(records, [](const Record &r) { return r.explanation.deferred; }));
        CHECK(stops(only(StopKind::Forced)) == where(records, [](const Record &r) { return r.delta.forced; }));
        const auto joins = where(records, [](const Record &r) {
            return r.loopsAfter < r.loopsBefore && r.segmentsAfter > r.segmentsBefore;
        });
        const auto splits = where(records, [](const Record &r) { return r.loopsAfter > r.loopsBefore; });
        CHECK(joins.size() >= 2); // both holes
        CHECK_FALSE(splits.empty());
        CHECK(stops(only(StopKind::Join)) == joins);
        CHECK(stops(only(StopKind::Split)) == splits);
        const auto closures = where(records, [](const Record &r) { return r.segmentsAfter + 3 == r.segmentsBefore; });
        CHECK(closures.size() >= splits.size());
        CHECK(stops(only(StopKind::Closure)) == closures);
        Breakpoints length = only(StopKind::FrontLength);
        length.segments = 90;
        CHECK(stops(length) ==
              where(records, [](const Record &r) { return (r.segmentsBefore < 90) != (r.segmentsAfter < 90); }));
    }
}

TEST_CASE("Breakpoints: an element below the limit of alpha stops the run, and the value is that of the element") {
    for (const Method method : kMethods) {
        Breakpoints low = only(StopKind::LowAlpha);
        low.alphaBelow = 0.75;
        TimelineTravel travel(mesherWithHoles(method));
        travel.setBreakpoints(low);
        travel.reachStop(true);
        travelOn(travel);
        REQUIRE(travel.stop());
        const FrontState &state = travel.timeline().mesher().state();
        const unsigned made = travel.timeline().delta(travel.timeline().position() - 1).elements();
        double alpha = 1.0;
        for (std::size_t e = 0; e < state.elements.size(); ++e) {
            const Element &n = state.elements[e];
            const double value =
                shapeFactor(state.nodes[index(n[0])], state.nodes[index(n[1])], state.nodes[index(n[2])]);
            if (e + made < state.elements.size()) {
                CHECK(value >= 0.75);
            } else {
                alpha = std::min(alpha, value);
            }
        }
        CHECK(alpha < 0.75);
        CHECK(travel.stop()->value == alpha);
    }
}

TEST_CASE("Breakpoints: running back stops at the same advances in reverse") {
    Breakpoints breakpoints = only(StopKind::Closure);
    breakpoints.set(StopKind::Join, true);
    std::vector<std::uint64_t> forward = stopsOf(Method::Classic, breakpoints);
    REQUIRE(forward.size() >= 3);
    TimelineTravel travel(mesherWithHoles(Method::Classic));
    travel.setBreakpoints(breakpoints);
    travel.reachEnd();
    travelOn(travel);
    REQUIRE(travel.timeline().position() == forward.back()); // the last element closes a front
    forward.pop_back();
    std::vector<std::uint64_t> back;
    for (travel.reachStop(false), travelOn(travel); travel.stop(); travel.reachStop(false), travelOn(travel)) {
        back.push_back(travel.timeline().position());
    }
    CHECK(travel.timeline().position() == 0);
    std::reverse(back.begin(), back.end());
    CHECK(back == forward);
}

TEST_CASE("Breakpoints: steps and layers stop at them, but seeking and running to the end do not") {
    const std::vector<std::uint64_t> closures = stopsOf(Method::Fast, only(StopKind::Closure));
    REQUIRE_FALSE(closures.empty());
    TimelineTravel travel(mesherWithHoles(Method::Fast));
    travel.setBreakpoints(only(StopKind::Closure));
    travel.step(Granularity::Advance, 1'000'000);
    travelOn(travel);
    CHECK(travel.timeline().position() == closures.front());
    REQUIRE(travel.stop());
    CHECK(travel.stop()->kind == StopKind::Closure);
    travel.reach(closures.front() + 1);
    travelOn(travel);
    CHECK_FALSE(travel.stop());
    travel.reach(0);
    travelOn(travel);
    for (int layer = 0; layer < 10'000 && !travel.stop(); ++layer) {
        travel.step(Granularity::Layer, 1);
        travelOn(travel);
    }
    CHECK(travel.timeline().position() == closures.front());
    travel.reachEnd();
    travelOn(travel);
    CHECK(travel.atEnd());
    CHECK_FALSE(travel.stop());
}

TEST_CASE("Breakpoints: a visited cell of the grid stops the run exactly where the search visited it") {
    for (const Method method : kMethods) {
        const std::vector<Record> records = recordsOf(method);
        // A cell that is visited late, so that there is something to skip.
        const Record &late = records[2 * records.size() / 3];
        REQUIRE_FALSE(late.explanation.cells.empty());
        Breakpoints breakpoints = only(StopKind::Cell);
        breakpoints.cell = late.explanation.cells.back();
        const auto visits = [&](const Record &record) {
            const auto &cells = record.explanation.cells;
            return std::any_of(cells.begin(), cells.end(), [&](const Box2 &box) {
                return breakpoints.cell->contains(box.min) && breakpoints.cell->contains(box.max);
            });
        };
        CHECK(stopsOf(method, breakpoints) == where(records, visits));
    }
}

TEST_CASE("Birth: every element, edge and node leads to the advance that made it") {
    for (const Method method : kMethods) {
        TimelineTravel travel(mesherWithHoles(method));
        travel.reachEnd();
        travelOn(travel);
        const std::vector<Record> records = recordsOf(method);
        const FrontState &state = travel.timeline().mesher().state();
        const std::vector<Vec2> nodes = state.nodes;
        std::size_t looked = 0;
        for (std::size_t advance = 1; advance <= records.size(); advance += 7) {
            for (const Element &n : records[advance - 1].elements) {
                const Vec2 a = nodes[index(n[0])], b = nodes[index(n[1])], c = nodes[index(n[2])];
                const std::optional<Birth> element = birthAt(travel.timeline(), (1.0 / 3.0) * (a + b + c), 1e-6);
                REQUIRE(element);
                CHECK(element->kind == Birth::Kind::Triangle);
                CHECK(element->advance == advance);
                const std::optional<Birth> node = birthAt(travel.timeline(), a, 1e-6);
                REQUIRE(node);
                CHECK(node->kind == Birth::Kind::Node);
                CHECK(node->a == n[0]);
                CHECK(node->advance <= advance);
                const std::optional<Birth> edge = birthAt(travel.timeline(), midpoint(a, b), 1e-6);
                REQUIRE(edge);
                CHECK(edge->kind == Birth::Kind::Edge);
                CHECK(edge->advance <= advance);
                ++looked;
            }
        }
        CHECK(looked > 100);
    }
}

TEST_CASE("Birth: seeking goes to the advance; where nothing is made yet it runs until the place is covered") {
    TimelineTravel travel(mesherWithHoles(Method::Classic));
    const Vec2 place{2.0137, 1.9731};
    CHECK(unmeshed(travel.timeline().mesher().state().front, place));
    CHECK_FALSE(unmeshed(travel.timeline().mesher().state().front, {1.1, 1.3})); // in a hole
    CHECK_FALSE(unmeshed(travel.timeline().mesher().state().front, {5, 5}));
    travel.reachBirth(place, 1e-9);
    travelOn(travel);
    REQUIRE(travel.stop());
    CHECK(travel.stop()->kind == StopKind::Place);
    const std::uint64_t covered = travel.timeline().position();
    CHECK_FALSE(unmeshed(travel.timeline().mesher().state().front, place));
    travel.reachEnd();
    travelOn(travel);
    travel.reachBirth(place, 1e-9);
    travelOn(travel);
    REQUIRE(travel.birth());
    CHECK(travel.birth()->advance == covered);
    CHECK(travel.timeline().position() == covered);
    travel.reachBirth({5, 5}, 1e-9); // outside: stays where it is
    travelOn(travel);
    CHECK_FALSE(travel.birth());
    CHECK(travel.timeline().position() == covered);
}
