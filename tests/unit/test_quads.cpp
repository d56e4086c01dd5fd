#include "core/engine/base/hash.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/quads/even_boundary.hpp"
#include "core/engine/quads/pairing.hpp"
#include "core/engine/quads/quad_changes.hpp"
#include "core/engine/quads/quad_smooth.hpp"
#include "core/engine/quads/walk_triangles.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "tests/support/flat_corners.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/support/quad_jobs.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <numeric>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

MeshingJob quadJob(Domain domain, const std::string &spacing) {
    MeshingJob job;
    job.domain = std::move(domain);
    job.spacing.expression = spacing;
    job.options.elements = Elements::Quads;
    return job;
}

Domain polygon(const std::vector<Vec2> &nodes) {
    Domain domain;
    addLoop(domain, nodes);
    return domain;
}

/// Returns the codes of errors and warnings of a mesh against its domain. `hostile`: a domain so narrow or so far away
/// that elements may be flat within rounding.
std::set<std::string> faultsOf(const Mesh &mesh, const Domain &domain, bool hostile = false) {
    std::set<std::string> codes;
    for (const Diagnostic &fault : verifyAgainst(mesh, domain)) {
        if (fault.severity != Severity::Note && !(hostile && fault.code == "flat-element")) {
            codes.insert(fault.code);
        }
    }
    return codes;
}

std::vector<double> scaledJacobians(const Mesh &mesh) {
    std::vector<double> shapes;
    const MeshView view(mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        const auto corners = view.cornersOf(e);
        REQUIRE(corners.size() == 4);
        QuadCell cell{};
        for (unsigned k = 0; k < 4; ++k) {
            cell[k] = static_cast<std::uint32_t>(corners[k]);
        }
        shapes.push_back(scaledJacobian(cell, mesh.nodes));
    }
    return shapes;
}

double leastScaledJacobian(const Mesh &mesh) {
    const std::vector<double> shapes = scaledJacobians(mesh);
    return *std::min_element(shapes.begin(), shapes.end());
}

double meanScaledJacobian(const Mesh &mesh) {
    const std::vector<double> shapes = scaledJacobians(mesh);
    return std::accumulate(shapes.begin(), shapes.end(), 0.0) / static_cast<double>(shapes.size());
}

/// Returns the mean spacing conformity of the edges.
double conformityOf(const MeshingOutcome &outcome) {
    return measureQuality(outcome.mesh, outcome.spacing.get()).deltaMean;
}

} // namespace

TEST_CASE("quads: a square of even sides is a lattice of squares") {
    const MeshingOutcome outcome = meshedJob(quadJob(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), "0.05"));
    CHECK(outcome.mesh.elementCount() == 400);
    CHECK(outcome.quads.irregularNodes == 0);
    CHECK(outcome.quads.triangles == 0);
    CHECK(leastScaledJacobian(outcome.mesh) > 0.999);
    CHECK(faultsOf(outcome.mesh, polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})).empty());
}

TEST_CASE("quads: a disc has quadrilaterals alone, few irregular nodes, and no poor shape") {
    const Domain domain = polygon(discOutline(178, 1.0));
    const MeshingOutcome outcome = meshedJob(quadJob(domain, "0.0353"));
    CHECK(faultsOf(outcome.mesh, domain).empty());
    CHECK(outcome.quads.triangles == 0);
    CHECK(outcome.quads.notConvex == 0);
    CHECK(outcome.quads.irregularShare() < 0.06);
    CHECK(leastScaledJacobian(outcome.mesh) > 0.6);
}

TEST_CASE("quads: shapes, irregular nodes and spacing of a disc, a graded domain, and a plate with a hole") {
    Domain plate = polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    std::vector<Vec2> hole = discOutline(166, 1.0);
    std::reverse(hole.begin(), hole.end());
    addLoop(plate, hole);
    struct Case {
        const char *name;
        MeshingJob job;
        double meanShape, irregularShare, conformity;
    };
    const std::vector<Case> all = {
        {"disc", quadJob(polygon(discOutline(354, 1.0)), "0.01772"), 0.990, 0.022, 0.955},
        {"graded",
         quadJob(polygon({{0, 0}, {60, 0}, {60, 40}, {0, 40}}), "max(0.1, 0.232*abs(sqrt((x-30)^2+(y-20)^2)-12))"),
         0.955, 0.085, 0.900},
        {"plate", quadJob(plate, "0.0378"), 0.985, 0.025, 0.940}};
    for (const Case &c : all) {
        const std::string name = c.name;
        CAPTURE(name);
        const MeshingOutcome outcome = meshedJob(c.job);
        CHECK(outcome.quads.triangles == 0);
        CHECK(leastScaledJacobian(outcome.mesh) > 0.70);
        CHECK(meanScaledJacobian(outcome.mesh) > c.meanShape);
        CHECK(outcome.quads.irregularShare() < c.irregularShare);
        CHECK(conformityOf(outcome) > c.conformity);
    }
}

TEST_CASE("quads: three boundary nodes in line at one quadrilateral, beside a corner of 4 degrees, are lifted") {
    const Domain domain = polygon({{0, 0}, {10, -0.35}, {12, 0}, {10, 0.35}});
    const MeshingOutcome outcome = meshedJob(quadJob(domain, "0.5"));
    CHECK(outcome.quads.notConvex == 0);
    CHECK(outcome.quads.notConvexAt.empty());
    CHECK_FALSE(unforcedFlatPlace(outcome.mesh));
}

TEST_CASE("quads: an odd boundary gets one more node, a kept one keeps one triangle") {
    const Domain domain = polygon(discOutline(31, 1.0));
    MeshingJob job = quadJob(domain, "0.2");
    const MeshingOutcome even = meshedJob(job);
    CHECK(even.boundary->segments.size() % 2 == 0);
    CHECK(even.quads.triangles == 0);
    job.options.keepBoundary = true;
    const MeshingOutcome kept = meshedJob(job);
    CHECK(kept.boundary->segments.size() == 31);
    CHECK(kept.quads.oddEdges == 1);
    CHECK(kept.quads.triangles == 1);
    CHECK(faultsOf(kept.mesh, domain).empty());
}

TEST_CASE("quads: a line with a given number of elements keeps it") {
    const Domain domain = polygon({{0, 0}, {1, 0}, {0.5, 1}});
    MeshingJob job = quadJob(domain, "0.2");
    job.spacing.placed.elements = {3, 0, 0};
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.quads.triangles == 0);
    const auto &segments = outcome.boundary->segments;
    CHECK(std::count_if(segments.begin(), segments.end(), [](const auto &s) { return s.source == 0; }) == 3);
    CHECK(verifyAgainst(outcome.mesh, domain, job.spacing.placed.elements).empty());
}

TEST_CASE("colourBoundary: every edge joins two colours, with at most one new node for each cycle") {
    const MeshingJob job = quadJob(polygon(discOutline(7, 1.0)), "0.9");
    const Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    const ColouredBoundary even = colourBoundary(*prepared->boundary, *prepared->spacing, {&job.domain, {}, true});
    CHECK(even.oneColoured.empty());
    CHECK(even.added == prepared->boundary->segments.size() % 2);
    for (const DiscreteSegment &s : even.domain.segments) {
        CHECK(even.colours[s.a] != even.colours[s.b]);
    }
}

namespace {

/// The random domains with corners so sharp, or channels so narrow, that triangles take the place of quadrilaterals
/// that would not be convex.
const std::set<std::uint64_t> kTrianglesInTips = {34,   364,  424,  524,  544,  804,  826,  844,  924,
                                                  1124, 1134, 1164, 1234, 1246, 1304, 1364, 1504, 1626,
                                                  1684, 1744, 1856, 1987, 2084, 2104, 2154};

/// Meshes random domains and checks that they are closed, follow their boundaries, and that no element is flat beyond
/// rounding, reflex at a corner or clockwise. Every `gridsEvery`-th is meshed with all grids and several threads.
void checkRandomQuads(std::uint64_t from, std::uint64_t to, std::uint64_t gridsEvery) {
    for (std::uint64_t seed = from; seed < to; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job;
        job.domain = randomDomain(seed);
        job.options.elements = seed % 7 == 3 ? Elements::Mixed : Elements::Quads;
        job.options.keepBoundary = seed % 5 == 0;
        const MeshingOutcome outcome = meshedJob(job);
        CHECK(faultsOf(outcome.mesh, job.domain, true) == std::set<std::string>{});
        if (job.options.elements == Elements::Quads && !job.options.keepBoundary) {
            CHECK(outcome.quads.oddEdges == 0);
            CHECK((outcome.quads.triangles > 0) == kTrianglesInTips.contains(seed));
            CHECK(outcome.quads.trianglesAt.empty() == (outcome.quads.triangles == 0));
            CHECK_FALSE(unforcedFlatPlace(outcome.mesh));
        }
        if (seed % gridsEvery == 1 % gridsEvery) {
            job.options.threads = 3;
            for (const GridKind grid : valuesOf<GridKind>()) {
                job.options.grid = grid;
                CHECK(meshHash(meshedJob(job).mesh) == meshHash(outcome.mesh));
            }
        }
    }
}

} // namespace

TEST_CASE("quads: random domains are closed and follow their boundaries; all grids give the same bits") {
    checkRandomQuads(0, 200, 8);
}

TEST_CASE("quads: 2,000 random domains, all grids" * doctest::test_suite("slow")) {
    checkRandomQuads(200, 2200, 1);
}

TEST_CASE("quads: cancelling ends the run") {
    const MeshingJob job = quadJob(polygon(discOutline(178, 1.0)), "0.02");
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    progress.report = [&](std::string_view stage, double) {
        if (stage == "cleaning up quadrilaterals") {
            stop.request_stop();
        }
    };
    const Result<MeshingOutcome> outcome = meshDomain(job, progress);
    REQUIRE(!outcome);
    CHECK(outcome.faults().front().code == "cancelled");
}

TEST_CASE("quads: a session makes the same mesh as meshDomain and steps back from it") {
    auto job = std::make_shared<const MeshingJob>(quadJob(polygon(discOutline(40, 1.0)), "0.2"));
    const Result<MeshingOutcome> expected = meshDomain(*job);
    REQUIRE(expected);
    MeshingSession session;
    session.start(job, StartMode::Run);
    std::shared_ptr<const SessionSnapshot> snapshot = session.wait();
    CHECK(snapshot->state == RunState::Finished);
    CHECK(snapshot->complete);
    CHECK(snapshot->known > 10);
    CHECK(snapshot->meshHash == meshHash(expected->mesh));
    REQUIRE(snapshot->mesh);
    CHECK(snapshot->quality.elements == expected->mesh.elementCount());
    session.step(Granularity::Advance, -1);
    snapshot = session.wait();
    CHECK(snapshot->state == RunState::Paused);
    REQUIRE(snapshot->improvement);
    CHECK(snapshot->improvement->quads);
    CHECK(snapshot->improveStep + 1 == snapshot->improveSteps);
    session.seek(snapshot->known / 2);
    snapshot = session.wait();
    CHECK(snapshot->advance == snapshot->known / 2);
    CHECK(snapshot->frontSegments > 0);
    session.finish();
    snapshot = session.wait();
    CHECK(snapshot->state == RunState::Finished);
    CHECK(snapshot->meshHash == meshHash(expected->mesh));
}

TEST_CASE("quads: a cancelled session keeps the previous mesh") {
    auto job = std::make_shared<const MeshingJob>(quadJob(polygon(discOutline(40, 1.0)), "0.2"));
    MeshingSession session;
    session.start(job, StartMode::Run);
    const std::uint64_t hash = session.wait()->meshHash;
    auto large = std::make_shared<const MeshingJob>(quadJob(polygon(discOutline(400, 1.0)), "0.005"));
    session.start(large, StartMode::Run);
    session.cancel();
    const std::shared_ptr<const SessionSnapshot> snapshot = session.wait();
    CHECK(snapshot->state == RunState::Finished);
    CHECK(snapshot->shownRun == 1);
    CHECK(snapshot->meshHash == hash);
}

TEST_CASE("quads: no square opens over the end of a line just before its far side") {
    // Over the long kept side of the hole, the end of the line is in neither of the triangles of that side and a new
    // corner, and not near either corner.
    MeshingJob job = quadJob(polygon({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), "1.234375");
    addLoop(job.domain, {{5.6671875, 2.890625}, {4.76015625, 3.4143}, {4.76015625, 2.36695}}, 7);
    const auto addLine = [&](std::int32_t tag, std::initializer_list<Vec2> places) {
        for (const Vec2 at : places) {
            const auto node = static_cast<std::uint32_t>(job.domain.nodes.size());
            if (at != *places.begin()) {
                job.domain.segments.push_back({node - 1, node, tag, SegmentRole::Constraint});
            }
            job.domain.nodes.push_back(at);
        }
    };
    addLine(5, {{7.4375, 2.4375}, {6.25, 1.40625}, {6.46875, 3.78125}});
    addLine(6, {{4.21875, 2.796875}, {2.125, 0.921875}, {1.25, 0.34375}, {5.46875, 1.140625}});
    job.layers.push_back({.tag = 5, .first = 0.077});
    job.spacing.partSizes[7] = {.size = 0.1940625};
    job.options.keepBoundary = true;
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(faultsOf(outcome.mesh, job.domain).empty());
}

TEST_CASE("joinTriangles: two triangles at the ends of a strip become quadrilaterals") {
    // A triangle, two squares, a triangle.
    const std::vector<Vec2> nodes = {{0, 0}, {1, 0}, {2, 0}, {3, 0.5}, {2, 1}, {1, 1}, {0, 1}, {-1, 0.5}};
    const std::vector<QuadCell> cells = {{0, 6, 7, kNoIndex}, {0, 1, 5, 6}, {1, 2, 4, 5}, {2, 3, 4, kNoIndex}};
    const std::vector<std::array<std::uint32_t, 2>> tagged = {{0, 1}, {1, 2}, {2, 3}, {3, 4},
                                                              {4, 5}, {5, 6}, {6, 7}, {7, 0}};
    const MeshingJob job = quadJob(polygon({nodes[7], nodes[0], nodes[2], nodes[3], nodes[4], nodes[6]}), "1");
    const Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    QuadWorkspace mesh(nodes, cells, {}, tagged, {}, *prepared->spacing);
    CHECK(joinTriangles(mesh) == 0);
    CHECK(std::count_if(mesh.cells.begin(), mesh.cells.end(), isAlive) == 3);
}

TEST_CASE("joinTriangles: no way leads around the free end of an inner line, whose edges stay") {
    // Two elements meet at the end of the line from (1, 0) to (0, 0): across the line, and across the side beyond it.
    const std::vector<Vec2> nodes = {{0, 0}, {1, 0}, {-1, 0.3}, {0, -1}, {1, -1}};
    const std::vector<QuadCell> cells = {{0, 1, 2, kNoIndex}, {0, 2, 3, 1}, {3, 4, 1, kNoIndex}};
    const std::vector<std::array<std::uint32_t, 2>> tagged = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 1}};
    const MeshingJob job = quadJob(polygon({nodes[2], nodes[3], nodes[4], nodes[1]}), "1");
    const Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared);
    QuadWorkspace mesh(nodes, cells, {}, tagged, {}, *prepared->spacing);
    CHECK(joinTriangles(mesh) == 2);
    CHECK(mesh.cells == cells);
}

TEST_CASE("quads: the bits of some meshes") {
    struct Pinned {
        const char *name;
        MeshingJob job;
        std::uint64_t hash;
    };
    MeshingJob best = quadJob(polygon(discOutline(178, 1.0)), "0.0353");
    best.options.improve = ImproveLevel::Best;
    MeshingJob mixed = quadJob(polygon({{0, 0}, {3, 0.2}, {2.5, 2}, {1, 1.2}}), "0.1");
    mixed.options.elements = Elements::Mixed;
    const std::vector<Pinned> all = {
        {"disc", quadJob(polygon(discOutline(178, 1.0)), "0.0353"), 0xdcac60e9a4104e0d},
        {"disc, best", best, 0x67a0e58a8c2d24ff},
        {"corner", quadJob(polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), "0.05"), 0xadf76b6977e7197b},
        {"graded", quadJob(polygon({{0, 0}, {6, 0}, {6, 4}, {0, 4}}), "max(0.05, 0.2*abs(sqrt((x-3)^2+(y-2)^2)-1.2))"),
         0x108824da3099087e},
        {"mixed", mixed, 0x66c2d6e65b172173}};
    for (const Pinned &pinned : all) {
        const std::string name = pinned.name;
        CAPTURE(name);
        CHECK(toHex(meshHash(meshedJob(pinned.job).mesh)) == toHex(pinned.hash));
    }
}
