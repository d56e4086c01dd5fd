#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/flat_corners.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/support/quad_jobs.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>

using namespace forefront;
using namespace forefront::testing;

namespace layer_cases {

constexpr std::int32_t kWall = 2;

void setTags(Domain &domain, std::size_t from, std::int32_t tag) {
    for (std::size_t s = from; s < domain.segments.size(); ++s) {
        domain.segments[s].tag = tag;
    }
}

/// A square of side 10 around a hole with the tag kWall.
MeshingJob squareAround(const std::vector<Vec2> &hole, double size) {
    MeshingJob job;
    addLoop(job.domain, {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}});
    const std::size_t outside = job.domain.segments.size();
    addLoop(job.domain, hole);
    setTags(job.domain, outside, kWall);
    job.spacing.size = size;
    job.options.verify = true;
    return job;
}

LayerSpec layersOf(std::int32_t tag, double first, double growth, std::uint32_t count) {
    LayerSpec spec;
    spec.tag = tag;
    spec.first = first;
    spec.growth = growth;
    spec.count = count;
    return spec;
}

/// A random job: a domain of any family, layers on some of its parts.
MeshingJob randomJob(std::uint64_t seed) {
    RandomSource random(seed + 77);
    MeshingJob job;
    job.domain = randomDomain(seed);
    job.options.elements = static_cast<Elements>(seed % 3);
    job.options.verify = true;
    job.options.order = seed % 5 == 4 ? ElementOrder::Second : ElementOrder::First;
    const double diagonal = job.domain.bounds().diagonal();
    std::set<std::int32_t> tags;
    for (DomainSegment &segment : job.domain.segments) {
        if (random.unit() < 0.1) {
            segment.tag = random.integer(1, 4);
        }
        tags.insert(segment.tag);
    }
    for (const std::int32_t tag : tags) {
        if (tag != *tags.begin() && random.unit() < 0.4) {
            continue;
        }
        const auto count = static_cast<std::uint32_t>(random.integer(1, 12));
        const double growth = random.between(1.0, 1.6);
        LayerSpec spec = layersOf(tag, diagonal * std::pow(10.0, random.between(-6.0, -2.0)), growth, count);
        if (random.unit() < 0.5) {
            spec.count.reset();
            spec.growth = std::max(spec.growth, 1.1);
        }
        spec.cells = random.unit() < 0.5 ? LayerCells::Quads : LayerCells::Triangles;
        job.layers.push_back(spec);
    }
    return job;
}

/// Meshes random jobs and checks them against their domains, and that no element is flat beyond rounding, reflex at a
/// corner or clockwise. Every `othersEvery`-th is meshed with all grids and several threads, and stepped.
void checkRandom(std::uint64_t from, std::uint64_t to, std::uint64_t othersEvery) {
    for (std::uint64_t seed = from; seed < to; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job = randomJob(seed);
        const Result<MeshingOutcome> outcome = meshDomain(job);
        REQUIRE_MESSAGE(outcome, toString(outcome ? Diagnostic() : outcome.faults().front()));
        REQUIRE(outcome->layers.rays > 0);
        CHECK_FALSE(unforcedFlatPlace(outcome->mesh));
        for (const Diagnostic &fault : verifyAgainst(outcome->mesh, job.domain)) {
            CHECK_MESSAGE(fault.severity != Severity::Error, toString(fault));
        }
        if (seed % othersEvery == 0) {
            const std::uint64_t hash = meshHash(outcome->mesh);
            job.options.threads = 2;
            for (const GridKind grid : valuesOf<GridKind>()) {
                job.options.grid = grid;
                CHECK(meshHash(meshedJob(job).mesh) == hash);
            }
            Result<MeshStepper> stepper = MeshStepper::create(job);
            REQUIRE(stepper);
            REQUIRE(stepper->finish());
            CHECK(meshHash(stepper->mesh()) == hash);
        }
    }
}

} // namespace layer_cases

using namespace layer_cases;

TEST_CASE("boundary layers: a smooth wall has the heights asked for on every ray") {
    MeshingJob job = squareAround(discOutline(64, 1.0), 0.1);
    job.layers = {layersOf(kWall, 0.001, 1.2, 12)};
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.layers.shortened.empty());
    CHECK(outcome.layers.fewest == 12);
    CHECK(outcome.layers.quadrilaterals == 12 * outcome.layers.rays);
    CHECK(outcome.layers.triangles == 0);
    // Every node near the wall lies at one of the heights over one of the edges of the ring.
    const double apothem = std::cos(std::numbers::pi / 64);
    std::vector<std::size_t> found(13, 0);
    for (const Vec2 p : outcome.mesh.nodes) {
        const double sector = 2.0 * std::numbers::pi / 64;
        const double angle = std::fmod(std::atan2(p.y, p.x) + 2.0 * std::numbers::pi, sector) - 0.5 * sector;
        const double height = length(p) * std::cos(angle) - apothem;
        double top = 0.0, step = 0.001;
        for (std::size_t k = 0; k <= 12; ++k, top += step, step *= 1.2) {
            found[k] += std::abs(height - top) < 1e-9 ? 1 : 0;
        }
    }
    for (const std::size_t count : found) {
        CHECK(count >= outcome.layers.rays);
    }
    for (const TaggedEdge &edge : outcome.mesh.edges) {
        CHECK((length(outcome.mesh.nodes[index(edge.a)]) < 1.001) == (edge.tag == kWall));
    }
}

TEST_CASE("boundary layers: a thickness, and layers until they are isotropic") {
    MeshingJob job = squareAround(discOutline(64, 1.0), 0.1);
    LayerSpec spec = layersOf(kWall, 0.001, 1.0, 1);
    spec.count.reset();
    spec.thickness = 0.0107;
    job.layers = {spec};
    CHECK(meshedJob(job).layers.most == 11);
    spec.thickness.reset();
    spec.growth = 1.5;
    job.layers = {spec};
    // Wall edges of 2 sin(π/64) = 0.0981: the last layer below 0.7 times that is 0.001·1.5^10 = 0.0577.
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.layers.most == 11);
    CHECK(outcome.layers.fewest == 11);
}

TEST_CASE("boundary layers: a cross has fans at convex corners and full layers in concave ones") {
    MeshingJob job = squareAround(
        {{1, 3}, {-1, 3}, {-1, 1}, {-3, 1}, {-3, -1}, {-1, -1}, {-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1}, {1, 1}},
        0.1);
    job.layers = {layersOf(kWall, 0.002, 1.2, 14)};
    for (const LayerCells cells : {LayerCells::Quads, LayerCells::Triangles}) {
        job.layers[0].cells = cells;
        const MeshingOutcome outcome = meshedJob(job);
        CHECK(outcome.layers.fans == 8);
        CHECK(outcome.layers.shortened.empty());
        CHECK(outcome.mesh.isTriangular() == (cells == LayerCells::Triangles));
    }
}

TEST_CASE("boundary layers: the ends slide along straight neighbours, also slanted ones") {
    for (const double slant : {-2.0, 0.0, 2.0}) {
        CAPTURE(slant);
        MeshingJob job;
        addLoop(job.domain, {{0, 0}, {10, 0}, {10 + slant, 4}, {-slant, 4}});
        job.domain.segments[0].tag = kWall;
        job.spacing.size = 0.2;
        job.options.verify = true;
        job.layers = {layersOf(kWall, 0.01, 1.2, 10)};
        const MeshingOutcome outcome = meshedJob(job);
        CHECK(outcome.layers.shortened.empty());
        CHECK(outcome.layers.triangles == 0);
        CHECK(std::any_of(outcome.mesh.nodes.begin(), outcome.mesh.nodes.end(), [&](Vec2 p) {
            return std::abs(p.y - 0.01) < 1e-12 && std::abs(p.x + slant * p.y / 4.0) < 1e-12;
        }));
    }
}

TEST_CASE("boundary layers: a wall that ends beside a part in its line ends with one layer less a node") {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {5, 0}, {10, 0}, {10, 4}, {0, 4}});
    job.domain.segments[1].tag = kWall;
    job.domain.segments[4].tag = 3;
    job.spacing.size = 0.1;
    job.options.verify = true;
    job.layers = {layersOf(kWall, 0.01, 1.2, 5)};
    const MeshingOutcome outcome = meshedJob(job);
    REQUIRE(outcome.layers.shortened.size() == 5);
    for (std::uint32_t k = 0; k < 5; ++k) {
        const ShortenedRay &ray = outcome.layers.shortened[k];
        CHECK(ray.made == k);
        CHECK(ray.stop == LayerStop::End);
        CHECK(ray.stoppedBy == 1);
        CHECK(ray.base.x == doctest::Approx(5.0 + 0.1 * k));
    }
    CHECK(outcome.layers.triangles == 5);
}

TEST_CASE("boundary layers: walls that face each other share their distance, and are named") {
    MeshingJob job = squareAround({{-2, 0.1}, {-2, 2}, {2, 2}, {2, 0.1}}, 0.1);
    const std::size_t upper = job.domain.segments.size();
    addLoop(job.domain, {{-2, -2}, {-2, -0.1}, {2, -0.1}, {2, -2}});
    setTags(job.domain, upper, 3);
    job.domain.boundaryNames = {{2, "flap"}, {3, "wing"}};
    job.layers = {layersOf(2, 0.002, 1.2, 20), layersOf(3, 0.002, 1.2, 20)};
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.layers.fewest > 10);
    CHECK(outcome.layers.most == 20);
    std::size_t inGap = 0;
    for (const ShortenedRay &ray : outcome.layers.shortened) {
        CHECK(ray.stoppedBy == 5 - ray.tag);
        CHECK(ray.stop == LayerStop::Wall);
        if (std::abs(ray.base.y) < 0.11 && std::abs(ray.base.x) < 1.9) {
            CHECK(distance(ray.base, ray.end) <= 0.42 * 0.2 + 1e-9);
            ++inGap;
        }
    }
    CHECK(inGap >= 2 * 37);
    const Diagnostics notes = shortenedLayers(outcome.layers, outcome.mesh.boundaryNames);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].message.find("layers on flap reach fewer layers") != std::string::npos);
    CHECK(notes[0].message.find("too near to wing") != std::string::npos);
}

TEST_CASE("boundary layers: the size grows from their tops") {
    MeshingJob job = squareAround(discOutline(256, 1.0), 0.5);
    job.layers = {layersOf(kWall, 0.001, 1.2, 12)};
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.spacing->at({1.05, 0.0}) == doctest::Approx(2.0 * std::numbers::pi / 256).epsilon(0.3));
    CHECK(outcome.spacing->at({2.0, 0.0}) < 0.24);
}

TEST_CASE("boundary layers: quadrilaterals and second order have them, too") {
    MeshingJob job = squareAround(discOutline(64, 1.0), 0.2);
    job.layers = {layersOf(kWall, 0.005, 1.3, 8)};
    job.options.elements = Elements::Quads;
    CHECK(meshedJob(job).mesh.block(CellKind::Quadrilateral4).size() > 64 * 8);
    job.options.elements = Elements::Triangles;
    job.options.order = ElementOrder::Second;
    CHECK(meshedJob(job).mesh.block(CellKind::Quadrilateral8).size() == 64 * 8);
}

TEST_CASE("boundary layers: a wall inside the domain has them on both sides") {
    MeshingJob job;
    addLoop(job.domain, {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}});
    job.domain.nodes.insert(job.domain.nodes.end(), {{-1, 0}, {1, 0}});
    job.domain.segments.push_back({4, 5, kWall, SegmentRole::Constraint});
    job.spacing.size = 0.2;
    job.options.verify = true;
    job.layers = {layersOf(kWall, 0.01, 1.2, 8)};
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.layers.fans == 2);
    CHECK(outcome.layers.shortened.empty());
    CHECK(outcome.layers.triangles == 2 * 9);
    CHECK(outcome.layers.quadrilaterals == 8 * 20 + 2 * 9 * 7);
}

TEST_CASE("boundary layers: too many of them are refused before they are made, and building them can be cancelled") {
    MeshingJob job = squareAround(discOutline(200, 1.0), 0.1);
    job.layers = {layersOf(kWall, 1e-4, 1.0, 1000)};
    job.options.maxElements = 50'000;
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "too-many-elements");
    CHECK(outcome.faults().front().message.find("boundary layers need about 2e+05") != std::string::npos);
    job.layers = {layersOf(kWall, 1e-3, 1.2, 5)};
    CHECK(meshDomain(job));
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    progress.report = [&](std::string_view stage, double) {
        if (stage == "building boundary layers") {
            stop.request_stop();
        }
    };
    outcome = meshDomain(job, progress);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "cancelled");
}

TEST_CASE("boundary layers: kept segments have all of them, and no nodes beside crowded segments are in the way") {
    MeshingJob job;
    addLoop(job.domain, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, kWall);
    job.spacing.size = 0.1;
    job.options.keepBoundary = true;
    job.options.verify = true;
    REQUIRE(meshedJob(job).boundary->gradedNodes > 0);
    job.layers = {layersOf(kWall, 0.02, 1.3, 8)};
    for (const Elements elements : {Elements::Triangles, Elements::Quads}) {
        job.options.elements = elements;
        const MeshingOutcome made = meshedJob(job);
        CHECK(made.layers.shortened.empty());
        CHECK(made.layers.fewest == 8);
        CHECK(made.mesh.points.empty());
        CHECK(verify(made.mesh).empty()); // no node is unused
    }
}

TEST_CASE("checkLayers: invalid numbers, unknown and repeated parts are refused") {
    MeshingJob job = squareAround(discOutline(16, 1.0), 0.5);
    job.domain.boundaryNames[kWall] = "wing";
    const auto refused = [&](const LayerSpec &spec) {
        job.layers = {spec};
        const Result<MeshingOutcome> outcome = meshDomain(job);
        return outcome ? std::string() : outcome.faults().front().code;
    };
    LayerSpec good = layersOf(kWall, 0.01, 1.2, 3);
    CHECK(refused(good).empty());
    CHECK(refused(layersOf(kWall, 0.0, 1.2, 3)) == "bad-layer");
    CHECK(refused(layersOf(kWall, 0.01, 0.9, 3)) == "bad-layer");
    CHECK(refused(layersOf(kWall, 0.01, 1.2, 0)) == "bad-layer");
    CHECK(refused(layersOf(9, 0.01, 1.2, 3)) == "unknown-boundary");
    good.thickness = 0.1;
    CHECK(refused(good) == "bad-layer");
    good = layersOf(kWall, 0.01, 1.0, 1);
    good.count.reset();
    CHECK(refused(good) == "bad-layer");
    job.layers = {layersOf(kWall, 0.01, 1.2, 3), layersOf(kWall, 0.01, 1.2, 4)};
    CHECK(meshDomain(job).faults().front().code == "repeated-layer");
    CHECK(checkLayers(std::vector{layersOf(9, 0.01, 1.2, 3)}, job.domain).front().message.find("boundary_1, wing") !=
          std::string::npos);
}

TEST_CASE("boundary layers: random domains are valid, and the same for all grids and threads") {
    checkRandom(0, 200, 10);
}

TEST_CASE("boundary layers: 2,000 random domains, all grids" * doctest::test_suite("slow")) {
    checkRandom(200, 2200, 2);
}
