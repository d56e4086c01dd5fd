#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/snapshot_builder.hpp"
#include "core/engine/session/timeline_travel.hpp"

#include <doctest/doctest.h>

using namespace forefront;

namespace {

std::unique_ptr<Mesher> mesherOfSquare(double size) {
    MeshingJob job;
    job.domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        job.domain.segments.push_back({i, (i + 1) % 4, 1, SegmentRole::Boundary});
    }
    job.spacing.size = size;
    Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    return Mesher::create(prepared->boundary, prepared->spacing, job.options);
}

void travelOn(TimelineTravel &travel) {
    for (int batch = 0; batch < 1'000'000 && !travel.resting(); ++batch) {
        travel.work();
    }
    REQUIRE(travel.resting());
}

} // namespace

TEST_CASE("SnapshotBuilder: shape figures are those of the partial mesh, moving forward and back") {
    Timeline timeline(mesherOfSquare(0.08));
    SnapshotBuilder builder(1);
    const auto check = [&] {
        SessionSnapshot snapshot;
        builder.fill(snapshot, timeline, {true, false, false, false}, false);
        REQUIRE(snapshot.mesh);
        const MeshQuality whole = measureQuality(snapshot.mesh->mesh, nullptr);
        CHECK(snapshot.quality.elements == whole.elements);
        CHECK(snapshot.quality.minAngle > 0.0);
        CHECK(snapshot.quality.minAngle == doctest::Approx(whole.minAngle));
        CHECK(snapshot.quality.maxAngle == doctest::Approx(whole.maxAngle));
        CHECK(snapshot.quality.alphaMean == doctest::Approx(whole.alphaMean));
        CHECK(snapshot.quality.alphaGeometricMean == doctest::Approx(whole.alphaGeometricMean));
        CHECK(snapshot.quality.area == doctest::Approx(whole.area));
        CHECK(snapshot.quality.worst == whole.worst);
        CHECK(snapshot.quality.alphaHistogram == whole.alphaHistogram);
    };
    for (const std::uint64_t count : {1, 700, 500, 1500}) {
        timeline.forward(count);
        check();
    }
    for (const std::uint64_t count : {300, 900, 1}) {
        timeline.back(count);
        check();
    }
    timeline.forward(1u << 20);
    check();
}

TEST_CASE("TimelineTravel: playing from the end starts again at the beginning") {
    TimelineTravel travel(mesherOfSquare(0.03));
    travel.reachEnd();
    travelOn(travel);
    REQUIRE(travel.atEnd());
    REQUIRE(travel.timeline().known() > 5000);
    travel.play(1.0);
    CHECK(travel.timeline().position() == 0);
    CHECK(travel.playing());
    REQUIRE(travel.workDue());
    CHECK(travel.work() != TimelineTravel::Outcome::Arrived);
    travel.rest();
    CHECK_FALSE(travel.workDue());
}

TEST_CASE("TimelineTravel: seeking far jumps to a checkpoint and repeats few advances") {
    TimelineTravel travel(mesherOfSquare(0.02));
    travel.reachEnd();
    travelOn(travel);
    const std::uint64_t end = travel.timeline().known();
    REQUIRE(end > 20'000);
    REQUIRE(travel.timeline().checkpoints() > 3);
    for (const std::uint64_t target : {end / 3, end - 10, std::uint64_t{7}, end / 2}) {
        travel.reach(target);
        const std::uint64_t position = travel.timeline().position();
        CHECK((position > target ? position - target : target - position) <= 4096);
        travelOn(travel);
        CHECK(travel.timeline().position() == target);
    }
}

TEST_CASE("TimelineTravel: a step ends playing") {
    TimelineTravel travel(mesherOfSquare(0.1));
    travel.reachEnd();
    travelOn(travel);
    travel.play(50.0);
    travel.step(Granularity::Advance, 3);
    travelOn(travel);
    CHECK(travel.timeline().position() == 3);
}
