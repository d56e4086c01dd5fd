#include "core/engine/base/hash.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/geometry/half_length.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/even_jacobians.hpp"
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/outer_bulges.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/airfoil.hpp"
#include "tests/support/quadratic_poisson.hpp"
#include "tests/support/random_curves.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

MeshingJob secondOrderJob(Domain domain, Elements elements = Elements::Triangles,
                          QuadNodes quadNodes = QuadNodes::Eight) {
    MeshingJob job;
    job.domain = std::move(domain);
    job.options.elements = elements;
    job.options.order = ElementOrder::Second;
    job.options.quadNodes = quadNodes;
    return job;
}

/// Meshes a domain and checks the result against it.
MeshingOutcome meshedInOrder(const MeshingJob &job) {
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
    Diagnostics faults = verifyAgainst(outcome->mesh, job.domain, job.spacing.placed.elements);
    std::erase_if(faults, [](const Diagnostic &fault) { return fault.severity != Severity::Error; });
    REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
    return *std::move(outcome);
}

/// Returns the least ratio of the least Jacobian determinant to the greatest over all elements.
double leastUniformity(const Mesh &mesh) {
    double least = 1.0;
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t) { least = std::min(least, jacobianUniformity(cell)); });
    return least;
}

/// Returns the greatest distance of the middle nodes of tagged edges from where their curves say, over the length of
/// their chords; those of `straight` from the middles of their chords.
double farthestMiddle(const Mesh &mesh, const SecondOrderReport &report) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
        const TaggedEdge &edge = mesh.edges[i];
        const Vec2 a = mesh.nodes[index(edge.a)], b = mesh.nodes[index(edge.b)], m = mesh.nodes[index(edge.middle)];
        const bool straight =
            std::ranges::any_of(report.straight, [&](const StraightEdge &each) { return each.middle == edge.middle; });
        if (straight || mesh.edgeStretches.empty() || !mesh.edgeStretches[i].follows()) {
            farthest = std::max(farthest, distance(m, midpoint(a, b)) / distance(a, b));
            continue;
        }
        const CurveStretch &stretch = mesh.edgeStretches[i];
        const Curve &curve = mesh.curves[stretch.curve];
        // Beside a tight bend, the nearest place found may be on the wrong side of it.
        double off = std::numeric_limits<double>::infinity();
        for (const double t : {curve.nearest(m, std::min(stretch.t0, stretch.t1), std::max(stretch.t0, stretch.t1)),
                               halfLength(curve, stretch.t0, stretch.t1)}) {
            const double before = curve.length(stretch.t0, t), after = curve.length(t, stretch.t1);
            off = std::min(off, std::max(distance(curve.point(t), m) / distance(a, b),
                                         std::abs(before - after) / (before + after)));
        }
        farthest = std::max(farthest, off);
    }
    return farthest;
}

Domain squareOfFourSides() {
    Domain domain;
    addLoop(domain, std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    return domain;
}

/// A disc in a square, as a region of its own.
Domain discInSquare() {
    const CurveLoop outline = {Curve::line({-2, -2}, {2, -2}), Curve::line({2, -2}, {2, 2}),
                               Curve::line({2, 2}, {-2, 2}), Curve::line({-2, 2}, {-2, -2})};
    Domain domain = curvedDomain({outline, {Curve::circle({0, 0}, {1, 0})}}, 1e-3);
    for (DomainSegment &segment : domain.segments) {
        const bool straight = domain.curves[segment.stretch.curve].kind() == CurveKind::Line;
        segment.role = straight ? SegmentRole::Boundary : SegmentRole::Constraint;
    }
    domain.regionMarkers = {{{0, 0}, 2}, {{1.5, 1.5}, 1}};
    return domain;
}

} // namespace

TEST_CASE("halfLength: halves every kind of curve, the same for either direction") {
    const Curve circle = Curve::circle({1, 2}, {4, 2});
    CHECK(halfLength(circle, 0.25, 0.5) == 0.375);
    const std::vector<Curve> curves = {
        Curve::line({0, 0}, {3, 1}),
        circle,
        Curve::arc({0, 0}, {3, 0}, {0, 1}, 0.2, 4.0),
        Curve::cubic({0, 0}, {5, 0}, {5, 1}, {5, 4}),
        Curve::cubic({0, 0}, {0, 0}, {0, 1}, {4, 4}),
        Curve::cubic({0, 0}, {2, 1}, {0, 1}, {2, 0})}; // the last one with a cusp or near it
    for (std::size_t k = 0; k < curves.size(); ++k) {
        CAPTURE(k);
        for (const auto &[t0, t1] : {std::pair{0.0, 1.0}, std::pair{0.1, 0.9}, std::pair{0.7, 0.2}}) {
            const double t = halfLength(curves[k], t0, t1);
            CHECK(curves[k].length(t0, t) == doctest::Approx(curves[k].length(t, t1)).epsilon(1e-9));
            CHECK(halfLength(curves[k], t1, t0) == t);
        }
    }
}

TEST_CASE("raiseOrder: straight edges get their exact middles, shared by both elements") {
    MeshingJob job = secondOrderJob(squareOfFourSides());
    job.spacing.size = 0.25;
    const MeshingOutcome outcome = meshedInOrder(job);
    job.options.order = ElementOrder::First;
    const Mesh first = meshedInOrder(job).mesh;
    REQUIRE(outcome.mesh.blocks.size() == 1);
    CHECK(outcome.mesh.blocks[0].kind() == CellKind::Triangle6);
    CHECK(outcome.mesh.elementCount() == first.elementCount());
    std::size_t edges = 0;
    EdgeTable(MeshView(first)).forEach([&](NodeId, NodeId, std::span<const HalfEdge>) { ++edges; });
    CHECK(outcome.mesh.nodes.size() == first.nodes.size() + edges);
    for (std::size_t n = 0; n < first.nodes.size(); ++n) {
        CHECK(outcome.mesh.nodes[n] == first.nodes[n]);
    }
    CHECK(outcome.order == SecondOrderReport{});
    CHECK(leastUniformity(outcome.mesh) > 1.0 - 1e-9);
    forEachCell(outcome.mesh, [](const PlacedCell &cell, std::size_t) { CHECK(cell.isStraight()); });
    for (const TaggedEdge &edge : outcome.mesh.edges) {
        CHECK(outcome.mesh.nodes[index(edge.middle)] ==
              midpoint(outcome.mesh.nodes[index(edge.a)], outcome.mesh.nodes[index(edge.b)]));
    }
}

TEST_CASE(
    "raiseOrder: disc and aerofoil follow their curves, with least Jacobians of a fifth of the greatest at least") {
    for (const bool airfoil : {false, true}) {
        CAPTURE(airfoil);
        for (const Elements elements : valuesOf<Elements>()) {
            for (const QuadNodes nodes : valuesOf<QuadNodes>()) {
                if (elements == Elements::Triangles && nodes == QuadNodes::Nine) {
                    continue;
                }
                CAPTURE(wordOf(elements));
                CAPTURE(wordOf(nodes));
                const MeshingOutcome outcome =
                    meshedInOrder(secondOrderJob(airfoil ? airfoilDomain() : discDomain(), elements, nodes));
                CHECK(outcome.order.straight.empty());
                CHECK(outcome.order.curvedEdges > 30);
                CHECK(farthestMiddle(outcome.mesh, outcome.order) < 1e-9);
                MESSAGE("least over greatest Jacobian: ", leastUniformity(outcome.mesh));
                CHECK(leastUniformity(outcome.mesh) >= 0.2);
            }
        }
    }
}

TEST_CASE("raiseOrder: corners move where the Jacobian varies too much, whatever the size") {
    // An aerofoil of short chords, which is coarse soon beside it.
    Domain chords;
    addLoop(chords, std::vector<Vec2>{{-2, -2}, {3, -2}, {3, 2}, {-2, 2}});
    constexpr int kChords = 25;
    std::vector<Vec2> airfoil;
    for (int i = -kChords; i < kChords; ++i) {
        const double s = std::abs(i) / static_cast<double>(kChords);
        airfoil.push_back({s * s, i < 0 ? halfThickness(s) : -halfThickness(s)});
    }
    addLoop(chords, airfoil);
    std::size_t moved = 0;
    for (const Domain &domain : {discDomain(), airfoilDomain(), chords}) {
        for (const double size : {0.5, 0.4, 0.25, 0.15, 0.1, 0.06, 0.03}) {
            CAPTURE(domain.segments.size());
            CAPTURE(size);
            MeshingJob job = secondOrderJob(domain, Elements::Quads);
            job.spacing.size = size;
            const MeshingOutcome outcome = meshedInOrder(job);
            CHECK(outcome.order.straight.empty());
            CHECK(leastUniformity(outcome.mesh) >= 0.2);
            moved += outcome.order.movedCorners;
        }
    }
    CHECK(moved > 0);
}

TEST_CASE("raiseOrder: corners move only if they may, and boundaries and lines stay") {
    // Two quadrilaterals beside a third one whose corner in the middle is nearly flat.
    Mesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {4, 0}, {0, 2}, {0.3, 0.3}, {4, 2}, {0, 4}, {2, 4}, {4, 4}};
    CellBlock &block = mesh.block(CellKind::Quadrilateral4);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        block.add(std::array{NodeId{a}, NodeId{b}, NodeId{c}, NodeId{d}});
        block.regions.push_back(1);
    };
    add(0, 1, 4, 3);
    add(1, 2, 5, 4);
    add(3, 4, 7, 6);
    add(4, 5, 8, 7);
    const Mesh given = mesh;
    SecondOrderReport report;
    REQUIRE(raiseOrder(mesh, {}, report));
    CHECK(report.movedCorners == 0);
    CHECK(mesh.nodes[4] == given.nodes[4]);
    REQUIRE(report.uneven.size() == 3);
    CHECK(report.uneven[0].element == 0); // not convex
    CHECK(report.uneven[0].ratio == doctest::Approx(-0.7));
    std::vector<bool> movable(given.nodes.size(), true);
    mesh = given;
    REQUIRE(raiseOrder(mesh, {.movable = &movable}, report));
    CHECK(report.movedCorners == 1);
    for (std::size_t n = 0; n < given.nodes.size(); ++n) {
        CHECK((mesh.nodes[n] == given.nodes[n]) == (n != 4));
    }
    CHECK(leastUniformity(mesh) >= kSoughtUniformity - 1e-4);
    CHECK(report.uneven.empty());
    mesh = given;
    mesh.points.push_back({NodeId{4}, 1});
    REQUIRE(raiseOrder(mesh, {.movable = &movable}, report));
    CHECK(report.movedCorners == 0);
    mesh = given;
    movable[4] = false;
    REQUIRE(raiseOrder(mesh, {.movable = &movable}, report));
    CHECK(report.movedCorners == 0);
}

TEST_CASE("raiseOrder: an interface is curved once for both of its sides") {
    for (const Elements elements : {Elements::Triangles, Elements::Quads}) {
        const MeshingOutcome outcome = meshedInOrder(secondOrderJob(discInSquare(), elements));
        CHECK(outcome.order.straight.empty());
        CHECK(farthestMiddle(outcome.mesh, outcome.order) < 1e-9);
        double inside = 0.0;
        const MeshView view(outcome.mesh);
        forEachCell(view, [&](const PlacedCell &cell, std::size_t e) {
            inside += view.region(e) == 2 ? 0.5 * twiceArea(cell) : 0.0;
        });
        CHECK(inside == doctest::Approx(std::numbers::pi).epsilon(2e-5)); // chords: 4e-3
    }
}

TEST_CASE("raiseOrder: where an element would fold, its edge is straight and reported") {
    // One triangle in a disc, all three of its edges bent outwards.
    MeshingJob job = secondOrderJob(discDomain());
    job.spacing.placed.elements.assign(job.domain.segments.size(), 3);
    const MeshingOutcome three = meshedInOrder(job);
    CHECK(farthestMiddle(three.mesh, three.order) < 1e-9);
    // A hole with a square of chords: edges that bend far into the elements beside them.
    const CurveLoop outline = {Curve::line({-1.2, -1.2}, {1.2, -1.2}), Curve::line({1.2, -1.2}, {1.2, 1.2}),
                               Curve::line({1.2, 1.2}, {-1.2, 1.2}), Curve::line({-1.2, 1.2}, {-1.2, -1.2})};
    MeshingJob hole = secondOrderJob(curvedDomain({outline, {Curve::circle({0, 0}, {1, 0})}}, 1e-3));
    hole.spacing.size = 1.0;
    hole.spacing.placed.elements.resize(hole.domain.segments.size(), 0);
    for (std::size_t s = 0; s < hole.domain.segments.size(); ++s) {
        hole.spacing.placed.elements[s] = hole.domain.segments[s].stretch.follows() ? 4 : 0;
    }
    const MeshingOutcome outcome = meshedInOrder(hole);
    CHECK_FALSE(outcome.order.straight.empty());
    CHECK(farthestMiddle(outcome.mesh, outcome.order) < 1e-9);
    for (const StraightEdge &edge : outcome.order.straight) {
        CHECK(edge.reason == StraightReason::Folded);
        CHECK(edge.at == outcome.mesh.nodes[index(edge.middle)]);
    }
}

TEST_CASE("meetingBulges: finds what bulges over another edge, however small the gap, and nothing beside common ends") {
    const auto bulge = [](Vec2 a, Vec2 b, double height) {
        const Vec2 out = (1.0 / distance(a, b)) * Vec2{b.y - a.y, a.x - b.x}; // to the right, where the outside is
        return OuterEdge{a, midpoint(a, b) + 2.0 * height * out, b, height > 0.0};
    };
    const auto found = [](const std::vector<OuterEdge> &edges) { return meetingBulges(edges); };
    using List = std::vector<std::uint32_t>;
    // Two edges with a gap of 0.2 between them.
    const auto across = [&](double lower, double upper) {
        return found({bulge({1, 0}, {0, 0}, lower), bulge({0, 0.2}, {1, 0.2}, upper)});
    };
    CHECK(across(0.0999, 0.0999) == List{});
    CHECK(across(0.1001, 0.1001) == List{0, 1});
    CHECK(across(0.201, 0.0) == List{0});
    CHECK(across(0.3, -0.11) == List{}); // the other one bends away
    CHECK(across(0.3, -0.09) == List{0});
    // Common ends: an outline with two bulges of half a turn, and a wedge that is closed by them.
    CHECK(found({bulge({0, 0}, {1, 0}, 0.5), bulge({1, 0}, {0, 0}, 0.5)}) == List{});
    CHECK(found({bulge({0, 0}, {1, 0.1}, 0.01), bulge({1, -0.1}, {0, 0}, 0.01)}) == List{});
    CHECK(found({bulge({0, 0}, {1, 0.1}, 0.1), bulge({1, -0.1}, {0, 0}, 0.1)}) == List{0, 1});
}

TEST_CASE("raiseOrder: kept chords of curves that cross stay straight where the curves would meet") {
    // Two half discs, flat sides apart, with a chord each; their arcs overlap.
    Domain domain;
    domain.nodes = {{-1, -2}, {-1, 2}, {-3, 0}, {1, -2}, {1, 2}, {3, 0}};
    domain.curves = {Curve::quadratic({-1, -2}, {2, 0}, {-1, 2}), Curve::quadratic({1, -2}, {-2, 0}, {1, 2})};
    domain.segments = {{0, 1, 1, SegmentRole::Boundary, {0, 0.0, 1.0}}, {1, 2}, {2, 0},
                       {3, 4, 1, SegmentRole::Boundary, {1, 0.0, 1.0}}, {4, 5}, {5, 3}};
    MeshingJob job = secondOrderJob(domain);
    job.options.keepBoundary = true;
    const MeshingOutcome outcome = meshedInOrder(job);
    REQUIRE(outcome.order.straight.size() == 2);
    CHECK(outcome.order.straight[0].reason == StraightReason::Meeting);
    CHECK(outcome.order.straight[1].reason == StraightReason::Meeting);
    CHECK(outcome.order.curvedEdges == 0);
    job.domain.nodes = {{-1, -2}, {-1, 2}, {-3, 0}, {2, -2}, {2, 2}, {4, 0}};
    job.domain.curves[1] = Curve::quadratic({2, -2}, {-0.9, 0}, {2, 2});
    CHECK(meshedInOrder(job).order.curvedEdges == 2); // now they pass
}

TEST_CASE("raiseOrder: a stretch that lies elsewhere, or is a point, bends nothing") {
    for (const CurveStretch &stretch : {CurveStretch{0, 0.0, 1.0}, CurveStretch{0, 0.4, 0.4}}) {
        MeshingJob job = secondOrderJob(squareOfFourSides());
        job.domain.curves = {Curve::quadratic({5, 5}, {6, 7}, {7, 5})};
        job.domain.segments[0].stretch = stretch;
        job.options.keepBoundary = true;
        const MeshingOutcome outcome = meshedInOrder(job);
        CHECK(outcome.order == SecondOrderReport{});
        forEachCell(outcome.mesh, [](const PlacedCell &cell, std::size_t) { CHECK(cell.isStraight()); });
    }
}

TEST_CASE("raiseOrder: where curves cross, so that the mesh follows chords, edges are straight and reported") {
    // A ring between two polygons of twelve chords, the inner one along an ellipse that leaves the circle of the outer.
    Domain domain;
    domain.curves = {Curve::circle({0, 0}, {1, 0}), Curve::arc({0, 0}, {0.9999, 0}, {0, 1.0001})};
    for (std::uint32_t ring = 0; ring < 2; ++ring) {
        const std::uint32_t first = 12 * ring;
        for (std::uint32_t i = 0; i < 12; ++i) {
            const Vec2 node = Curve::circle({0, 0}, {ring == 0 ? 1.0 : 0.9999, 0}).point(i / 12.0);
            domain.nodes.push_back(i % 6 == 3 && ring == 1 ? Vec2{0.0, i == 3 ? 0.9999 : -0.9999} : node);
            domain.segments.push_back({first + i, first + (i + 1) % 12, 1, SegmentRole::Boundary,
                                       CurveStretch{ring, i / 12.0, (i + 1) / 12.0}});
        }
    }
    addLoop(domain, std::vector<Vec2>{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    MeshingJob job = secondOrderJob(domain);
    job.spacing.segmentsPerTurn = 200;
    const MeshingOutcome outcome = meshedInOrder(job);
    REQUIRE_FALSE(outcome.boundary->straightened.empty());
    std::size_t crossing = 0;
    for (std::size_t i = 0; i < outcome.mesh.edges.size(); ++i) {
        const std::uint32_t source = outcome.boundary->segments[i].source;
        const auto &list = outcome.boundary->straightened;
        if (std::ranges::find(list, source) != list.end()) {
            ++crossing;
            const TaggedEdge &edge = outcome.mesh.edges[i];
            CHECK(outcome.mesh.nodes[index(edge.middle)] ==
                  midpoint(outcome.mesh.nodes[index(edge.a)], outcome.mesh.nodes[index(edge.b)]));
        }
    }
    CHECK(crossing > 0);
    CHECK(std::ranges::count(outcome.order.straight, StraightReason::Crossing, &StraightEdge::reason) ==
          static_cast<std::ptrdiff_t>(crossing));
}

namespace {

MeshingJob randomOrderJob(std::uint64_t seed) {
    MeshingJob job = secondOrderJob(seed % 4 == 3 ? randomDomain(seed) : randomCurvedDomain(seed),
                                    seed % 5 == 1   ? Elements::Quads
                                    : seed % 5 == 2 ? Elements::Mixed
                                                    : Elements::Triangles,
                                    seed % 2 == 0 ? QuadNodes::Eight : QuadNodes::Nine);
    job.options.keepBoundary = seed % 11 == 5;
    if (seed % 3 == 0) {
        job.spacing.size = job.domain.bounds().diagonal() / 12.0;
    }
    return job;
}

/// Meshes random domains and checks that they are valid, with every edge on its curve or reported. Every
/// `gridsEvery`-th is meshed with all grids and several threads.
void checkRandomOrder(std::uint64_t from, std::uint64_t to, std::uint64_t gridsEvery) {
    std::size_t curved = 0, straight = 0;
    for (std::uint64_t seed = from; seed < to; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job = randomOrderJob(seed);
        const Result<MeshingOutcome> outcome = meshDomain(job);
        REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
        const Diagnostics faults = verifyAgainst(outcome->mesh, job.domain);
        MeshingJob straightJob = job;
        straightJob.options.order = ElementOrder::First;
        const Diagnostics ofFirst = verifyAgainst(meshDomain(straightJob)->mesh, job.domain);
        CHECK_MESSAGE((faults.empty() || !ofFirst.empty()), samples::list(faults));
        CHECK(std::ranges::none_of(faults, [](const Diagnostic &fault) { return fault.code == "folded-element"; }));
        CHECK(farthestMiddle(outcome->mesh, outcome->order) < 1e-6);
        curved += outcome->order.curvedEdges;
        straight += outcome->order.straight.size();
        if (seed % gridsEvery == 1 % gridsEvery) {
            job.options.threads = 3;
            for (const GridKind grid : valuesOf<GridKind>()) {
                job.options.grid = grid;
                CHECK(meshHash(meshDomain(job)->mesh) == meshHash(outcome->mesh));
            }
        }
    }
    MESSAGE(curved, " curved edges, ", straight, " straight ones along curves");
    CHECK(straight * 20 < curved);
}

} // namespace

TEST_CASE("raiseOrder: random domains are valid, with every edge on its curve or reported") {
    checkRandomOrder(0, 200, 10);
}

TEST_CASE("raiseOrder: 2,000 random domains, all grids" * doctest::test_suite("slow")) {
    checkRandomOrder(200, 2200, 2);
}

TEST_CASE("raiseOrder: the same bits for any number of threads and after any steps") {
    for (std::uint64_t seed = 0; seed < 14; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job = secondOrderJob(randomCurvedDomain(seed));
        const MeshingOutcome one = meshedInOrder(job);
        for (const unsigned threads : {2U, 5U}) {
            job.options.threads = threads;
            const MeshingOutcome many = meshedInOrder(job);
            CHECK(meshHash(many.mesh) == meshHash(one.mesh));
            CHECK(many.order.straight.size() == one.order.straight.size());
        }
        Result<MeshStepper> stepper = MeshStepper::create(job);
        REQUIRE(stepper);
        stepper->advance(20);
        stepper->retreat(7);
        REQUIRE(stepper->finish());
        CHECK(meshHash(stepper->mesh()) == meshHash(one.mesh));
    }
}

TEST_CASE("raiseOrder: cancelling leaves the mesh unchanged") {
    MeshingJob job = secondOrderJob(discDomain());
    job.options.order = ElementOrder::First;
    Mesh mesh = meshedInOrder(job).mesh;
    const std::uint64_t hash = meshHash(mesh);
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    SecondOrderReport report;
    CHECK_FALSE(raiseOrder(mesh, {}, report, progress));
    CHECK(meshHash(mesh) == hash);
}

TEST_CASE("raiseOrder: errors of finite elements fall with the third power of the size, with chords the second") {
    std::vector<double> curved, chords;
    for (const double size : {0.2, 0.1, 0.05}) {
        MeshingJob job = secondOrderJob(discDomain());
        job.spacing.size = size;
        job.spacing.segmentsPerTurn = 0.0;
        job.domain.curveTolerance = 1.0;
        curved.push_back(quadraticPoissonError(meshedInOrder(job).mesh));
        job.options.order = ElementOrder::First;
        Mesh straight = meshedInOrder(job).mesh;
        straight.edgeStretches.clear();
        SecondOrderReport report;
        REQUIRE(raiseOrder(straight, {}, report));
        chords.push_back(quadraticPoissonError(straight));
    }
    for (std::size_t k = 0; k + 1 < curved.size(); ++k) {
        const double order = std::log2(curved[k] / curved[k + 1]), ofChords = std::log2(chords[k] / chords[k + 1]);
        MESSAGE("orders ", order, " and ", ofChords, ", errors ", curved[k + 1], " and ", chords[k + 1]);
        CHECK(order == doctest::Approx(3.0).epsilon(0.2 / 3.0));
        CHECK(ofChords == doctest::Approx(2.0).epsilon(0.1));
    }
}

TEST_CASE("raiseOrder: the bits of some meshes") {
    struct Pinned {
        const char *name;
        MeshingJob job;
        std::uint64_t hash;
    };
    const std::vector<Pinned> all = {
        {"disc", secondOrderJob(discDomain()), 0x98f74c12dc6510e6},
        {"aerofoil", secondOrderJob(airfoilDomain()), 0x2178c87376a827d3},
        {"disc of 8 nodes", secondOrderJob(discDomain(), Elements::Quads), 0x7b3f6491ca7d2668},
        {"disc of 9 nodes", secondOrderJob(discDomain(), Elements::Quads, QuadNodes::Nine), 0x87f7d42d75e53cc9},
        {"interface", secondOrderJob(discInSquare(), Elements::Mixed), 0x0af43da6775e1b3c},
        {"blob", secondOrderJob(randomCurvedDomain(CurveFamily::Blobs, 3)), 0x8215467098659321}};
    for (const Pinned &pinned : all) {
        const std::string name = pinned.name;
        CAPTURE(name);
        CHECK(toHex(meshHash(meshedInOrder(pinned.job).mesh)) == toHex(pinned.hash));
    }
}
