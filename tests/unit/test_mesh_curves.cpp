#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/random_curves.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the number of random domains to mesh: FOREFRONT_CURVE_DOMAINS, or as many as take a few seconds.
std::uint64_t curvedDomains() {
    constexpr std::uint64_t kDefault = 210;
    const char *const requested = std::getenv("FOREFRONT_CURVE_DOMAINS");
    return requested != nullptr ? std::strtoull(requested, nullptr, 10) : kDefault;
}

/// Returns the code of the first fault of a mesh against a domain.
std::string faultOf(const TriMesh &mesh, const Domain &domain, SegmentElements elements = {}) {
    const Diagnostics faults = verifyAgainst(mesh, domain, elements);
    return faults.empty() ? "" : faults.front().code;
}

/// A mesh of triangles over the given nodes, its outline with the tag 1.
TriMesh fan(std::vector<Vec2> nodes) {
    TriMesh mesh;
    mesh.nodes = std::move(nodes);
    const auto count = static_cast<std::uint32_t>(mesh.nodes.size());
    for (std::uint32_t n = 0; n < count; ++n) {
        mesh.edges.push_back({NodeId{n}, NodeId{(n + 1) % count}, 1});
        if (n > 0 && n + 1 < count) {
            mesh.elements.push_back({NodeId{0}, NodeId{n}, NodeId{n + 1}});
        }
    }
    return mesh;
}

/// Meshes a domain and checks the result against it.
MeshingOutcome meshedCurves(const MeshingJob &job) {
    auto outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
    const Diagnostics faults = verifyAgainst(outcome->mesh, job.domain, job.spacing.placed.elements);
    REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
    return std::move(*outcome);
}

} // namespace

TEST_CASE("Meshing curves: one valid mesh for all grids and numbers of threads, by either method") {
    for (std::uint64_t seed = 0; seed < 42; seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job;
        job.domain = randomCurvedDomain(seed);
        job.spacing.size = job.domain.bounds().diagonal() / 12.0;
        for (const Method method : {Method::Fast, Method::Classic}) {
            job.options.method = method;
            job.options.grid = GridKind::Uniform;
            job.options.threads = 1;
            const std::uint64_t hash = meshHash(meshedCurves(job).mesh);
            for (const GridKind grid : {GridKind::None, GridKind::Hierarchical}) {
                job.options.grid = grid;
                CHECK(meshHash(meshedCurves(job).mesh) == hash);
            }
            for (const int threads : {2, 3, 8}) {
                job.options.threads = threads;
                CHECK(meshHash(meshedCurves(job).mesh) == hash);
            }
        }
    }
}

TEST_CASE("Meshing curves: random domains of curves give valid meshes on their curves") {
    for (std::uint64_t seed = 1000; seed < 1000 + curvedDomains(); seed += kSeedStep) {
        CAPTURE(seed);
        MeshingJob job;
        job.domain = randomCurvedDomain(seed);
        job.options.keepBoundary = seed % 5 == 0;
        job.options.improve = static_cast<ImproveLevel>(seed % 3);
        job.options.method = seed % 4 < 3 ? Method::Fast : Method::Classic;
        job.options.grid = static_cast<GridKind>(seed / 7 % 3);
        job.options.threads = 1 + static_cast<int>(seed % 8);
        if (seed % 11 != 0) { // the rest by the automatic spacing
            job.spacing.size = job.domain.bounds().diagonal() / 15.0;
        }
        const MeshingOutcome outcome = meshedCurves(job);
        REQUIRE(outcome.mesh.edgeStretches.size() == outcome.mesh.edges.size());
        const double size = job.domain.bounds().diagonal();
        for (std::size_t e = 0; e < outcome.mesh.edges.size(); ++e) {
            const CurveStretch &stretch = outcome.mesh.edgeStretches[e];
            if (stretch.follows()) {
                const Curve &curve = outcome.mesh.curves[stretch.curve];
                const Vec2 a = outcome.mesh.nodes[index(outcome.mesh.edges[e].a)];
                const Vec2 b = outcome.mesh.nodes[index(outcome.mesh.edges[e].b)];
                REQUIRE(distance(curve.point(stretch.t0), a) <= 1e-9 * size);
                REQUIRE(distance(curve.point(stretch.t1), b) <= 1e-9 * size);
                if (!job.options.keepBoundary) { // that keeps the chords of the drawing
                    REQUIRE(curve.deviation(stretch.t0, stretch.t1) <= 1.001 * chordTolerance(job.domain));
                }
            }
        }
    }
}

TEST_CASE("Meshing curves: a check follows each side of a needle between two curves") {
    // Both sides touch the x axis in the origin; near it they are less than the tolerance of the check apart.
    const Curve low = Curve::quadratic({0, 0}, {0.5, 0}, {1, 1}),
                high = Curve::quadratic({1, 1.0002}, {0.5, 0}, {0, 0});
    MeshingJob job;
    job.domain = curvedDomain({{low, Curve::line({1, 1}, {1, 1.0002}), high}}, 1e-3);
    job.spacing.maximum = 0.1;
    for (const double size : {2e-5, 3e-5, 4e-5, 5e-5, 7e-5}) { // either side may have the first node
        job.spacing.sources = {{SourceShape::Point, {0, 0}, {}, 0.0, size, 0.2, ""}};
        CHECK(meshedCurves(job).mesh.edges.size() > 80);
    }
}

TEST_CASE("Meshing curves: where curves touch, or nearly do, a cusp ends in few elements and the rest is well shaped") {
    const auto circle = [](Vec2 centre, double radius) { return Curve::arc(centre, {radius, 0}, {0, radius}, 0.35); };
    const auto box = [](Vec2 low, Vec2 high) {
        const Vec2 right{high.x, low.y}, left{low.x, high.y};
        return CurveLoop{Curve::line(low, right), Curve::line(right, high), Curve::line(high, left),
                         Curve::line(left, low)};
    };
    for (const double gap : {0.0, 5e-7, -5e-7, 1e-5, 1e-4}) {
        CAPTURE(gap);
        const std::pair<std::vector<CurveLoop>, Vec2> cases[] = {
            {{box({-3, -3}, {3, 1 + gap}), {circle({0, 0}, 1)}}, {0, 1}},
            {{{circle({0, 0}, 1)}, {circle({0.5 - gap, 0}, 0.5)}}, {1, 0}},
            {{box({-3, -3}, {5, 3}), {circle({0, 0}, 1)}, {circle({2 + gap, 0}, 1)}}, {1, 0}}};
        for (const auto &[loops, cusp] : cases) {
            MeshingJob job;
            job.domain = curvedDomain(loops, 0.003, 1e-6);
            const TriMesh mesh = takeTriMesh(meshedCurves(job).mesh);
            CHECK(mesh.elements.size() < 4000);
            for (const Element &element : mesh.elements) {
                const Vec2 a = mesh.nodes[index(element[0])], b = mesh.nodes[index(element[1])],
                           c = mesh.nodes[index(element[2])];
                if (distance((1.0 / 3.0) * (a + b + c), cusp) > 0.1) {
                    REQUIRE(shapeFactor(a, b, c) > 0.75); // 30 degrees and more
                }
            }
        }
    }
}

TEST_CASE("Meshing curves: a short chord where curves cross has elements of its size around it") {
    // A disc in a square, with a slit 1e-4 wide around it. Its sides cross as curves, so their chords are taken, among
    // them one that is far shorter than the elements around it.
    MeshingJob job;
    Domain &domain = job.domain;
    const auto polygon = [&domain](const std::vector<double> &parameters, double radius) {
        const auto first = static_cast<std::uint32_t>(domain.nodes.size());
        const auto count = static_cast<std::uint32_t>(parameters.size());
        const auto curve = static_cast<std::uint32_t>(domain.curves.size());
        domain.curves.push_back(Curve::circle({0, 0}, {radius, 0}));
        for (std::uint32_t i = 0; i < count; ++i) {
            domain.nodes.push_back(domain.curves.back().point(parameters[i]));
            const double end = i + 1 < count ? parameters[i + 1] : 1.0;
            domain.segments.push_back({first + i, first + (i + 1) % count, 1, SegmentRole::Boundary,
                                       CurveStretch{curve, parameters[i], end}});
        }
    };
    std::vector<double> twelfths;
    for (int i = 0; i < 12; ++i) {
        twelfths.push_back(i / 12.0);
    }
    std::vector<double> withShort = twelfths;
    withShort.insert(withShort.begin() + 4, 0.2502);
    polygon(withShort, 1.0);
    polygon(twelfths, 0.9999);
    domain.curves[1] = Curve::arc({0, 0}, {0.9999, 0}, {0, 1.0001}); // leaves the circle at the top and the bottom
    domain.nodes.insert(domain.nodes.end(), {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
    for (std::uint32_t i = 0; i < 4; ++i) {
        domain.segments.push_back({25 + i, 25 + (i + 1) % 4, 1});
    }
    job.spacing.segmentsPerTurn = 200;
    const MeshingOutcome outcome = meshedCurves(job);
    const double chord = distance(domain.nodes[3], domain.nodes[4]);
    CHECK(chord < 0.002);
    CHECK_FALSE(outcome.boundary->straightened.empty());
    CHECK(outcome.spacing->at({0.0, -1.0}) < 1.01 * 2.0 * std::numbers::pi / 200.0); // curvature counts everywhere
    CHECK(outcome.spacing->at(domain.nodes[4]) < 1.5 * chord);
    CHECK(measureQuality(outcome.mesh, nullptr).minAngle > 20.0);
}

TEST_CASE("Meshing curves: a check follows a circle of few elements whose first node is a little off it") {
    // The last node is on the circle, which makes it the better first step, but leads nowhere from there.
    MeshingJob job;
    job.domain.curves.push_back(Curve::circle({0, 0}, {1, 0}));
    for (std::uint32_t i = 0; i < 24; ++i) {
        job.domain.nodes.push_back(job.domain.curves[0].point(i / 24.0));
        job.domain.segments.push_back(
            {i, (i + 1) % 24, 1, SegmentRole::Boundary, CurveStretch{0, i / 24.0, (i + 1) / 24.0}});
    }
    job.spacing.placed.elements.assign(24, 6);
    TriMesh mesh = takeTriMesh(meshedCurves(job).mesh);
    const auto first = std::min_element(mesh.nodes.begin(), mesh.nodes.end(), [](Vec2 p, Vec2 q) {
        return distance(p, {0.5, std::sqrt(0.75)}) < distance(q, {0.5, std::sqrt(0.75)});
    });
    CHECK(distance(*first, {0.5, std::sqrt(0.75)}) < 1e-9);
    *first = (1.0 + 1e-11) * *first;
    CHECK(faultOf(mesh, job.domain, job.spacing.placed.elements).empty());
}

TEST_CASE("Meshing curves: a check refuses a mesh whose edges cut a curve off") {
    const Domain disc = curvedDomain({{Curve::circle({0, 0}, {1, 0})}}, 1e-3);
    std::vector<Vec2> corners;
    for (const int sides : {3, 12, 100, 400}) {
        corners.clear();
        for (int k = 0; k < sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            corners.push_back(k == 0 ? Vec2{1, 0} : Vec2{std::cos(angle), std::sin(angle)});
        }
        CHECK(faultOf(fan(corners), disc) == (sides < 100 ? "missing-segment" : ""));
    }
    const Curve top = Curve::arc({1, 0}, {1, 0}, {0, 1}, 0.0, std::numbers::pi);
    const Domain arched = curvedDomain(
        {{Curve::line({0, -2}, {2, -2}), Curve::line({2, -2}, {2, 0}), top, Curve::line({0, 0}, {0, -2})}}, 1e-3);
    CHECK(arched.bounds().max.y > 0.99);
    CHECK(faultOf(fan({{0, -2}, {2, -2}, top.point(0.0), top.point(1.0)}), arched) == "missing-segment");
}
